"""Another arm in the way: a nail gun beside a held piece, a long piece around an arm."""

from __future__ import annotations

import math

import numpy as np
from benchmarks.motion.carrying import Carry, carried, in_base, pointing_down, tilted
from benchmarks.motion.surroundings import beam_from_above, clutter, tip_at
from benchmarks.motion.trial import (
    HOME,
    TABLE_TOP_M,
    A,
    B,
    NotNarrowError,
    Trial,
    give_gripper,
    give_nailer,
    two_arms,
)

from sitewright.foundation.pose import Pose, translation
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.description import Joints

_STRETCHED: Joints = tuple(math.radians(v) for v in (0.0, -15.0, 35.0, 0.0, 60.0, 0.0))


def nail_gun_beside_a_held_piece(rng: np.random.Generator) -> Trial:
    """Return a nail gun that goes down between two studs while A holds a piece beside it."""
    trial = two_arms(rng)
    give_gripper(trial, A, (float(rng.uniform(0.8, 1.4)), 0.09, 0.04))
    give_nailer(trial, B)
    trial.robots = (B,)
    spot = pointing_down(
        float(rng.uniform(-0.15, 0.45)),
        float(rng.uniform(-0.6, 0.6)),
        TABLE_TOP_M + 0.38 + float(rng.uniform(0.04, 0.2)),
        float(rng.uniform(-math.pi, math.pi)),
    )
    goal = tilted(spot, *rng.uniform(-0.2, 0.2, 2).tolist())
    _from_the_side(trial, goal, float(rng.uniform(0.3, 0.5)))
    for side in (-1.0, 1.0):
        size = (float(rng.uniform(0.6, 1.4)), 0.045, float(rng.uniform(0.24, 0.34)))
        far, near = (
            goal @ translation(0.0, side * offset, 0.375 - size[2] / 2.0) for offset in (0.5, 0.0)
        )
        trial.pinch_body(f"stud{side:+.0f}", size, far, near)
    _hold_beside(trial, goal)
    _holster(trial)
    clutter(trial, int(rng.integers(1, 3)))
    return trial


def long_piece_around_the_other_arm(rng: np.random.Generator) -> Trial:
    """Return a long piece that A carries past B, which reaches into the way."""
    trial = two_arms(rng)
    length = float(rng.uniform(2.0, 3.2))
    give_gripper(trial, A, (length, 0.09, 0.06))
    give_nailer(trial, B)
    side = float(rng.choice((-1.0, 1.0)))
    ends = []
    for sign in (1.0, -1.0):
        azimuth = side * sign * float(rng.uniform(0.7, 1.3))
        radius = float(rng.uniform(1.4, 1.9))
        x, y = radius * math.cos(azimuth), radius * math.sin(azimuth)
        yaw = azimuth + math.pi / 2.0 + float(rng.uniform(-0.4, 0.4))
        ends.append(pointing_down(x, y, float(rng.uniform(0.8, 1.3)), yaw))
    lifts = tuple(rng.uniform(0.1, 0.7, 2).tolist())
    radius = float(rng.uniform(1.0, 1.4))
    carry = Carry(start=ends[0], goal=ends[1], lift_m=(lifts[0], lifts[1]), arc_radius_m=radius)
    azimuth = math.atan2(ends[0].position_m[1], ends[0].position_m[0])
    trial.move_by(carried(trial, A, carry, (azimuth, *HOME[1:])))
    _reach_into(trial)
    beam_from_above(trial, "beam", translation(-0.5, 0.0, 0.0), 1.6, low_m=1.0)
    clutter(trial, int(rng.integers(1, 3)))
    return trial


def _from_the_side(trial: Trial, world_T_goal: Pose, down_m: float) -> None:
    """Let B come from its side and go down to a place."""
    rng = trial.rng
    azimuth = float(rng.choice((-1.0, 1.0))) * float(rng.uniform(0.9, 1.6))
    radius = float(rng.uniform(1.2, 1.6))
    x, y = radius * math.cos(azimuth), radius * math.sin(azimuth)
    start = pointing_down(x, y, float(rng.uniform(0.8, 1.2)), azimuth)
    carry = Carry(start=start, goal=in_base(trial, B, world_T_goal), lift_m=(0.1, down_m))
    trial.move_by(carried(trial, B, carry, (azimuth, *HOME[1:])))


def _holster(trial: Trial) -> None:
    """Bring posts from three sides as near to the gun, where it starts, as they may come."""
    tip = tip_at(trial, B, 0)
    for number, (x, y) in enumerate(((0.4, 0.0), (-0.2, 0.35), (-0.2, -0.35))):
        far, near = (tip @ translation(s * x, s * y, 0.25) for s in (1.0, 0.0))
        trial.pinch_body(f"holster-{number}", (0.05, 0.05, 0.4), far, near)


def _hold_beside(trial: Trial, goal: Pose) -> None:
    """Bring the piece that A holds from afar as near to the gun as it may come."""
    rng = trial.rng
    level = float(rng.uniform(0.0, 0.12))
    x, y, z = goal.position_m
    yaw = float(rng.uniform(-1.2, 1.2))
    near = pointing_down(x - 0.05, y, z - 0.3 + 0.26 + level, yaw)
    away = float(rng.uniform(0.6, 0.9))

    def scene_at(share: float) -> SceneSnapshot:
        pose = translation(-away * (1.0 - share), 0.0, 0.0) @ near
        found = trial.backends.kinematics.solve(
            trial.scene.robots[A].description, in_base(trial, A, pose), HOME
        )
        if isinstance(found, NoIk):
            raise NotNarrowError(found.reason)
        return trial.scene.with_joints(A, found[0])

    trial.pinch(scene_at)


def _reach_into(trial: Trial) -> None:
    """Let B reach towards A as far as the witness allows."""
    rng = trial.rng
    turn = float(rng.uniform(-0.35, 0.35))
    pulled_in = (turn, *HOME[1:])
    stretched = (turn, *(_STRETCHED[k] + float(rng.uniform(-0.25, 0.25)) for k in range(1, 6)))

    def scene_at(share: float) -> SceneSnapshot:
        q = tuple(a + share * (b - a) for a, b in zip(pulled_in, stretched, strict=True))
        return trial.scene.with_joints(B, q)

    trial.pinch(scene_at)
