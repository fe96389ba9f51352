"""Slots between pieces that stand: a stud between studs, and the last stud of a panel."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from benchmarks.motion.carrying import Carry, carried, in_base, pointing_down, tilted
from benchmarks.motion.surroundings import clutter, rack
from benchmarks.motion.trial import HOME, TABLE_TOP_M, A, Trial, give_gripper, two_arms

from sitewright.foundation.pose import Pose, translation

_HOOKED = 0.5
"""So many of the pieces slide under a ledge at the end, and cannot be lifted from there."""
_FAR_M = 0.45
_GRIPPED_M = 0.26
"""From the flange to the lower side of a held piece."""


def stud_between_studs(rng: np.random.Generator) -> Trial:
    """Return a stud that goes down between two others, in whatever direction these lie."""
    trial = two_arms(rng)
    width, height = ((0.09, 0.04), (0.045, 0.12), (0.06, 0.10))[int(rng.integers(3))]
    length = float(rng.uniform(1.2, 1.8))
    goal = _brought(trial, (length, width, height), depth_m=float(rng.uniform(0.08, 0.2)))
    for side in (-1.0, 1.0):
        beside = (float(rng.uniform(0.8, 1.8)), 0.045, float(rng.uniform(0.14, 0.24)))
        _beside(trial, f"stud{side:+.0f}", beside, goal.pose, side)
    _ledge(trial, goal, length)
    rack(trial, A, length)
    clutter(trial, int(rng.integers(1, 3)))
    return trial


def last_stud(rng: np.random.Generator) -> Trial:
    """Return a stud that goes down into the last gap of a panel: plates at its ends, studs beside.

    The studs beside are cut where the gripper is, so that they are as near as the piece allows.
    """
    trial = two_arms(rng)
    length = float(rng.uniform(0.9, 1.6))
    piece = (length, 0.06, 0.12)
    goal = _brought(trial, piece, depth_m=float(rng.uniform(0.06, 0.12)))
    for side in (-1.0, 1.0):
        for end in (-1.0, 1.0):
            along = end * (length / 4.0 + 0.06)
            cut = (length / 2.0 - 0.12, 0.045, 0.12)
            _beside(trial, f"stud{side:+.0f}{end:+.0f}", cut, goal.pose, side, along)
    for end in (-1.0, 1.0):
        plate = (0.045, 0.8, 0.14)
        far, near = (
            goal.pose @ translation(end * (length / 2.0 + 0.03 + far_m), 0.0, _GRIPPED_M - 0.07)
            for far_m in (_FAR_M, -0.03)
        )
        if end != np.sign(goal.slide_m):
            trial.pinch_body(f"plate{end:+.0f}", plate, far, near)
    _ledge(trial, goal, length)
    rack(trial, A, length)
    return trial


@dataclass(frozen=True, slots=True)
class _Goal:
    """Where the tip ends in the world, and how far along its x axis it slid from (0: not)."""

    pose: Pose
    slide_m: float


def _brought(trial: Trial, piece: tuple[float, float, float], depth_m: float) -> _Goal:
    """Let arm A bring a piece from its side to the table; return world_T_tip at the end."""
    rng = trial.rng
    give_gripper(trial, A, piece)
    turn = float(rng.uniform(-math.pi / 2.0, math.pi / 2.0))
    goal = pointing_down(
        float(rng.uniform(-0.4, 0.15)),
        float(rng.uniform(-0.6, 0.6)),
        TABLE_TOP_M + _GRIPPED_M + float(rng.uniform(0.05, 0.25)),
        turn,
    )
    goal = tilted(goal, *rng.uniform(-0.12, 0.12, 2).tolist())
    side = float(rng.choice((-1.0, 1.0)))
    azimuth = side * float(rng.uniform(1.1, 1.9))
    radius = float(rng.uniform(1.3, 1.7))
    start = pointing_down(
        radius * math.cos(azimuth),
        radius * math.sin(azimuth),
        float(rng.uniform(0.7, 1.1)),
        azimuth + float(rng.uniform(-0.8, 0.8)),
    )
    slide_m = 0.0
    if rng.random() < _HOOKED:
        slide_m = float(rng.choice((-1.0, 1.0))) * float(rng.uniform(0.08, 0.25))
    lifts = (float(rng.uniform(0.1, 0.3)), depth_m + float(rng.uniform(0.15, 0.35)))
    carry = Carry(start=start, goal=in_base(trial, A, goal), lift_m=lifts, slide_m=(0.0, slide_m))
    trial.move_by(carried(trial, A, carry, (azimuth, *HOME[1:])))
    return _Goal(goal, slide_m)


def _ledge(trial: Trial, goal: _Goal, length_m: float) -> None:
    """Lower a board onto the end of a piece that slid in, as far as the witness allows."""
    if goal.slide_m == 0.0:
        return
    end = -math.copysign(length_m / 2.0 - abs(goal.slide_m) / 2.0 + 0.12, goal.slide_m)
    far, near = (goal.pose @ translation(end, 0.0, z_m) for z_m in (-0.9, _GRIPPED_M))
    trial.pinch_body("ledge", (0.24, 0.3, 0.02), far, near)


def _beside(
    trial: Trial,
    name: str,
    size: tuple[float, float, float],
    goal: Pose,
    side: float,
    along_m: float = 0.0,
) -> None:
    """Bring a stud from the side towards a piece at its place; both have the same lower side."""
    far, near = (
        goal @ translation(along_m, side * offset, _GRIPPED_M - size[2] / 2.0)
        for offset in (_FAR_M, 0.0)
    )
    trial.pinch_body(name, size, far, near)
