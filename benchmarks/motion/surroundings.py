"""Things around a motion that leave little room beside it."""

from __future__ import annotations

import math

import numpy as np
from benchmarks.motion.trial import NotNarrowError, Trial

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose, from_axis_angle, rotation, translation

_TRIES = 12
_FAR_M = 1.3
_TIP_M = 0.25


def clutter(trial: Trial, count: int) -> None:
    """Bring posts, beams and boards from random sides as near to the witness as they may come."""
    rng = trial.rng
    placed = 0
    for number in range(_TRIES):
        if placed == count:
            return
        name = f"clutter-{number}"
        size = ((0.09, 0.09, 1.6), (1.8, 0.14, 0.045), (0.8, 0.8, 0.03))[int(rng.integers(3))]
        robot = trial.robots[int(rng.integers(len(trial.robots)))]
        waypoint = int(rng.integers(len(trial.witness)))
        near = tip_at(trial, robot, waypoint) @ translation(0.0, 0.0, _TIP_M)
        direction = rng.normal(size=3)
        direction[2] = abs(direction[2])
        x, y, z = np.array(near.position_m) + _FAR_M * direction / np.linalg.norm(direction)
        yaw = float(rng.uniform(-math.pi, math.pi))
        turn = from_axis_angle((0.0, 0.0, 1.0), yaw)
        before = trial.scene, dict(trial.kinds)
        try:
            trial.pinch_body(
                name, size, Pose((float(x), float(y), float(z)), turn), Pose(near.position_m, turn)
            )
            placed += 1
        except NotNarrowError:
            trial.scene, trial.kinds = before


def wall_from_below(trial: Trial, name: str, place: Pose, length_m: float) -> None:
    """Raise a zone from the floor as far as the witness allows.

    Args:
        trial: Gets the body.
        name: Its name.
        place: Its middle on the floor; it runs along y.
        length_m: How long it is.
    """
    size = (0.12, length_m, 2.4)
    low, high = (translation(0.0, 0.0, z_m) @ place for z_m in (-1.15, 1.2))
    trial.pinch_body(name, size, low, high)


def beam_from_above(trial: Trial, name: str, place: Pose, length_m: float, low_m: float) -> None:
    """Lower a beam as far as the witness allows; `place` is on the floor, it runs along y."""
    size = (0.2, length_m, 0.2)
    high, low = (translation(0.0, 0.0, z_m) @ place for z_m in (3.6, low_m))
    trial.pinch_body(name, size, high, low)


def turned(place: Pose, yaw_rad: float) -> Pose:
    """Return a place turned about the vertical."""
    return place @ rotation((0.0, 0.0, 1.0), yaw_rad)


def rack(trial: Trial, robot: RobotId, length_m: float) -> None:
    """Bring posts from both sides as near to a held piece, where it starts, as they may come."""
    for side in (-1.0, 1.0):
        for end in (-0.35, 0.35):
            post = (0.05, 0.05, float(trial.rng.uniform(0.3, 0.5)))
            far, near = (
                tip_at(trial, robot, 0) @ translation(end * length_m, side * y_m, _TIP_M)
                for y_m in (0.4, 0.0)
            )
            trial.pinch_body(f"post{side:+.0f}{end:+.1f}", post, far, near)


def tip_at(trial: Trial, robot: RobotId, waypoint: int) -> Pose:
    """Return world_T_tip of a robot at a waypoint of the witness."""
    first = 6 * trial.robots.index(robot)
    arm = trial.scene.robots[robot]
    q = trial.witness[waypoint][first : first + 6]
    return arm.world_T_base @ trial.backends.kinematics.tip(arm.description, q)
