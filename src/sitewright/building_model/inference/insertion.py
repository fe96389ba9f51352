"""The way out: in which direction a component leaves what stands around it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
import numpy.typing as npt

from sitewright.building_model.inference.separation import Separation
from sitewright.foundation.pose import Vector, unit

PARTED_M = 0.011
"""A neighbour is left behind once it is this far off: the usual clearance and a little."""
NEAR_M = 0.030
"""Neighbours should be left behind within this much travel."""
AROUND_M = 0.20
"""Only what is nearer than this is looked at."""
_TRAVEL_M = (0.005, NEAR_M, 0.06, 0.12)
_SLIDES_M = tuple(0.01 * k for k in range(1, 101))
_OVERLAP_M = -1e-4
_TINY = 1e-6
Points = npt.NDArray[np.float64]
_STEPS = (-1.0, 0.0, 1.0)
_LATTICE: Points = np.array([unit(v) for v in product(_STEPS, _STEPS, _STEPS) if any(v)])


@dataclass(frozen=True, slots=True, kw_only=True)
class WayOut:
    """A straight way out of an assembly; the way in is its reverse.

    Attributes:
        direction: Unit vector in the model frame.
        slide_m: How far it still is within 11 mm of some neighbour, where that is more than
            30 mm; else 0.
    """

    direction: Vector
    slide_m: float


def way_out(around: Sequence[Separation], up: Vector, above_ground_m: float) -> WayOut | None:
    """Return the best straight way out, or None if neighbours block every tried direction.

    The first 120 mm are looked at; what comes after is for the motion planner to find.

    Args:
        around: Separations from the component to what stands around it.
        up: Unit vector against gravity.
        above_ground_m: Height of its lowest point above the ground.
    """
    directions = _directions(around)
    shifts = directions[:, None, :] * np.array(_TRAVEL_M)[:, None]
    gaps_m = _gaps_m(around, shifts.reshape(-1, 3)).reshape(-1, len(_TRAVEL_M))
    rises = directions @ np.array(up)
    # free at all first, then parting from all neighbours early, then upwards
    is_clear = gaps_m.min(axis=1) > _OVERLAP_M
    is_free = is_clear & (above_ground_m + rises * _TRAVEL_M[-1] > _OVERLAP_M)
    parted_m = np.minimum(gaps_m[:, 1:].min(axis=1).round(6), PARTED_M)
    ranked = zip(
        is_free.tolist(),
        parted_m.tolist(),
        rises.round(6).tolist(),
        directions.tolist(),
        gaps_m[:, _TRAVEL_M.index(NEAR_M)].tolist(),
        strict=True,
    )
    free, _, _, (x, y, z), near_m = max(ranked)
    if not free:
        return None
    slide_m = 0.0 if near_m >= PARTED_M - _TINY else _slide_m((x, y, z), around)
    return WayOut(direction=(x, y, z), slide_m=slide_m)


def _gaps_m(around: Sequence[Separation], shifts_m: Points) -> Points:
    """Return the smallest gap to all neighbours after each shift (row)."""
    if not around:
        return np.full(len(shifts_m), PARTED_M)
    axes = np.vstack([s.axes for s in around])
    gaps = np.concatenate([s.gaps_m for s in around])[:, None] - axes @ shifts_m.T
    begins = np.cumsum([0, *(len(s.axes) for s in around[:-1])])
    return np.asarray(np.maximum.reduceat(gaps, begins, axis=0).min(axis=0))


def _slide_m(direction: Vector, around: Sequence[Separation]) -> float:
    gaps_m = _gaps_m(around, np.array(_SLIDES_M)[:, None] * np.array(direction))
    parted = (t for t, gap in zip(_SLIDES_M, gaps_m.tolist(), strict=True) if gap >= PARTED_M)
    return next(parted, _SLIDES_M[-1])


def _directions(around: Sequence[Separation]) -> Points:
    """Return the 26 directions of a lattice, and away from each touching face (rows)."""
    if not around:
        return _LATTICE
    away = -np.vstack([s.widest() for s in around])
    total = away.sum(axis=0)
    length = float(np.linalg.norm(total))
    combined = [total / length] if length > _TINY else []
    return np.vstack((_LATTICE, away, *combined))
