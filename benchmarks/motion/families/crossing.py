"""Over a fence zone, and two arms that cross each other's way."""

from __future__ import annotations

import math

import numpy as np
from benchmarks.motion.carrying import Carry, carried, in_base, pointing_down
from benchmarks.motion.surroundings import beam_from_above, clutter, tip_at, turned, wall_from_below
from benchmarks.motion.trial import (
    HOME,
    A,
    B,
    Trial,
    give_gripper,
    give_nailer,
    two_arms,
)

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import translation
from sitewright.robot_team.description import Joints


def over_the_fence_zone(rng: np.random.Generator) -> Trial:
    """Return a piece that goes over a zone and under a beam, with little room between them."""
    trial = two_arms(rng)
    give_gripper(trial, A, (float(rng.uniform(0.8, 1.6)), 0.09, 0.06))
    give_nailer(trial, B)
    trial.scene = trial.scene.with_joints(B, (2.0, *HOME[1:]))
    middle = float(rng.choice((-1.0, 1.0))) * float(rng.uniform(0.5, 1.2))
    apart = float(rng.uniform(0.5, 0.8))
    ends = []
    for azimuth in (middle + apart, middle - apart):
        radius = float(rng.uniform(1.4, 1.9))
        x, y = radius * math.cos(azimuth), radius * math.sin(azimuth)
        yaw = azimuth + float(rng.uniform(-0.5, 0.5))
        ends.append(pointing_down(x, y, float(rng.uniform(0.75, 1.0)), yaw))
    height = float(rng.uniform(1.3, 1.7))
    lifts = (height - ends[0].position_m[2], height - ends[1].position_m[2])
    carry = Carry(start=ends[0], goal=ends[1], lift_m=lifts)
    azimuth = math.atan2(ends[0].position_m[1], ends[0].position_m[0])
    trial.move_by(carried(trial, A, carry, (azimuth, *HOME[1:])))
    base = trial.scene.robots[A].world_T_base
    across = turned(base, middle + math.pi / 2.0)
    fence = across @ translation(float(rng.uniform(-0.15, 0.15)), -1.9, 0.0)
    wall_from_below(trial, "fence", fence, 2.2)
    beam = across @ translation(float(rng.uniform(-0.2, 0.2)), -1.9, 0.0)
    beam_from_above(trial, "beam", beam, 1.0, low_m=height - 0.1)
    clutter(trial, int(rng.integers(1, 3)))
    return trial


def both_arms_moving(rng: np.random.Generator) -> Trial:
    """Return two arms that change places over the table; the witness lets one wait aside."""
    trial = two_arms(rng)
    give_gripper(trial, A, (float(rng.uniform(0.8, 1.4)), 0.09, 0.04))
    give_nailer(trial, B)
    side = float(rng.choice((-1.0, 1.0)))
    ways: dict[RobotId, tuple[Joints, ...]] = {}
    for robot, sign in ((A, 1.0), (B, -1.0)):
        trial.robots = (robot,)
        ways[robot] = _across(trial, robot, sign * side)
    trial.robots = (A, B)
    trial.move_by(_one_waits(ways[A], ways[B]))
    for robot in (A, B):
        _post_beside(trial, robot)
    clutter(trial, int(rng.integers(1, 3)))
    return trial


def _across(trial: Trial, robot: RobotId, side: float) -> tuple[Joints, ...]:
    """Return a way from one side of the table to the other, drawn in halfway."""
    rng = trial.rng
    ends = []
    for sign in (1.0, -1.0):
        x = float(rng.uniform(-0.25, 0.25))
        y = side * sign * float(rng.uniform(0.3, 0.7))
        z = float(rng.uniform(0.9, 1.2))
        ends.append(in_base(trial, robot, pointing_down(x, y, z, float(rng.uniform(-1.5, 1.5)))))
    carry = Carry(start=ends[0], goal=ends[1], lift_m=(0.15, 0.15), arc_radius_m=1.0)
    azimuth = math.atan2(ends[0].position_m[1], ends[0].position_m[0])
    return carried(trial, robot, carry, (azimuth, *HOME[1:]))


def _one_waits(first: tuple[Joints, ...], second: tuple[Joints, ...]) -> tuple[Joints, ...]:
    """Return the way of both: one goes halfway and waits until the other has gone its way."""
    half = len(first) // 2
    together = [(*q, *second[0]) for q in first[: half + 1]]
    together += [(*first[half], *q) for q in second[1:]]
    together += [(*q, *second[-1]) for q in first[half + 1 :]]
    return tuple(together)


def _post_beside(trial: Trial, robot: RobotId) -> None:
    """Bring a post from the side as near to a robot's goal as the witness allows."""
    rng = trial.rng
    near = translation(*tip_at(trial, robot, -1).position_m)
    direction = float(rng.uniform(-math.pi, math.pi))
    far = translation(0.9 * math.cos(direction), 0.9 * math.sin(direction), 0.0) @ near
    down = translation(0.0, 0.0, -0.3)
    trial.pinch_body(f"post-{robot}", (0.07, 0.07, 0.9), down @ far, down @ near)
