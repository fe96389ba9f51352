"""Postures that differ by whole turns: counted once, and spread over the limits."""

from __future__ import annotations

import itertools

import numpy as np
import numpy.typing as npt

from sitewright.planning_twin.backends.kinematic_chain import TURN, Array

_SAME_POSTURE = 1e-4
"""Radians or metres; the closed form is far better, iterations end at 1e-10."""
_LIMIT_SLACK = 1e-9

Flags = npt.NDArray[np.bool_]


def distinct(postures: Array, is_prismatic: Flags | None = None) -> Array:
    """Return the postures without those that repeat an earlier one, whole turns aside.

    Args:
        postures: m x n.
        is_prismatic: Joints that slide; a shift of 2 pi metres is no whole turn. None = no joint.
    """
    differences = postures[:, None] - postures[None]
    turns = TURN * np.round(differences / TURN)
    differences -= turns if is_prismatic is None else np.where(is_prismatic, 0.0, turns)
    is_same = (np.abs(differences) < _SAME_POSTURE).all(axis=2)
    return np.asarray(postures[~np.tril(is_same, k=-1).any(axis=1)])


def wrapped(
    postures: Array, lower: Array, upper: Array, is_prismatic: Flags | None = None
) -> Array:
    """Return all postures inside the limits that differ from the given ones by whole turns.

    Args:
        postures: m x n.
        lower: Limits of the joints, radians or metres.
        upper: As `lower`.
        is_prismatic: Joints that slide: they have no turns. None = no joint.
    """
    turning = np.ones(len(lower), dtype=np.bool_) if is_prismatic is None else ~is_prismatic
    counts = np.where(turning, np.floor((upper - lower) / TURN), 0.0).astype(int) + 1
    turns = TURN * np.array(list(itertools.product(*(range(n) for n in counts))))
    lift = TURN * np.ceil((lower - _LIMIT_SLACK - postures) / TURN)
    rows = ((postures + np.where(turning, lift, 0.0))[:, None] + turns).reshape(-1, len(lower))
    inside = rows[((rows >= lower - _LIMIT_SLACK) & (rows <= upper + _LIMIT_SLACK)).all(axis=1)]
    return np.asarray(np.clip(inside, lower, upper))
