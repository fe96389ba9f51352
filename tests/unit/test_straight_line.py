"""Straight tip lines: few waypoints, close to the line, no change of branch."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from motion_scenes import HOME, kr120
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.scene import RobotInScene
from sitewright.planning_twin.straight import straight_line
from sitewright.robot_team.description import Joints
from sitewright.robot_team.kinematics import tip_pose

KINEMATICS = OpwKinematics()
BASE = translation(-1.6, 0.2, 0.1) @ rotation((0.0, 0.0, 1.0), 0.4)
ARM = RobotInScene(description=kr120(), world_T_base=BASE, q_rad=HOME)


def tip(q: Joints) -> Pose:
    return BASE @ tip_pose(kr120(), q)


def line(
    start: Pose, end: Pose, near: Joints = HOME, max_chord_m: float = 0.0005
) -> tuple[Joints, ...]:
    found = straight_line(KINEMATICS, ARM, start, end, near, max_chord_m=max_chord_m)
    assert not isinstance(found, NoIk), found
    return found


def off_line_m(waypoints: tuple[Joints, ...], start: Pose, end: Pose) -> float:
    """Largest distance of the densely sampled tip from the line through both ends."""
    length = start.distance_to_m(end)
    worst = 0.0
    for a, b in pairwise(waypoints):
        for k in range(21):
            q = tuple(x + k / 20 * (y - x) for x, y in zip(a, b, strict=True))
            p = tip(q).position_m
            along = sum(
                (p[i] - start.position_m[i]) * (end.position_m[i] - start.position_m[i])
                for i in range(3)
            )
            share = along / length**2
            foot = [
                start.position_m[i] + share * (end.position_m[i] - start.position_m[i])
                for i in range(3)
            ]
            worst = max(worst, math.dist(p, foot))
    return worst


@pytest.mark.parametrize("distance_m", [0.03, 0.12, 0.30])
def test_the_tip_stays_within_the_chord_of_the_line(distance_m: float) -> None:
    start = tip(HOME)
    end = translation(0.0, 0.0, -distance_m) @ start
    waypoints = line(start, end)
    assert off_line_m(waypoints, start, end) <= 0.0005 * 1.05
    assert tip(waypoints[-1]).distance_to_m(end) < 1e-9


def test_a_finer_chord_takes_more_waypoints() -> None:
    start = tip(HOME)
    end = translation(0.0, 0.0, -0.14) @ start
    coarse, fine = line(start, end), line(start, end, max_chord_m=0.00002)
    assert len(coarse) < len(fine)


def test_the_line_starts_at_the_given_posture_to_the_bit() -> None:
    start = tip(HOME)
    waypoints = line(start, translation(0.02, 0.0, -0.05) @ start)
    assert waypoints[0] == HOME


def test_the_way_back_is_the_same_line() -> None:
    start = tip(HOME)
    end = translation(0.0, 0.1, -0.1) @ start
    there = line(start, end)
    back = line(end, start, near=there[-1])
    assert back[0] == there[-1]
    assert max(abs(a - b) for a, b in zip(back[-1], there[0], strict=True)) < 1e-6


def test_a_line_out_of_reach_is_a_proven_refusal() -> None:
    start = tip(HOME)
    found = straight_line(KINEMATICS, ARM, start, translation(5.0, 0.0, 0.0) @ start, HOME)
    assert isinstance(found, NoIk)
    assert found.is_proven


def test_a_line_through_the_wrist_singularity_is_refused_not_jumped() -> None:
    over = (0.0, -1.5, 1.2, 0.0, 0.03, 0.0)
    start = tip(over)
    end = translation(*(0.25 * c for c in start.y_axis)) @ start
    found = straight_line(KINEMATICS, ARM, start, end, over)
    if isinstance(found, NoIk):
        assert not found.is_proven
    else:
        assert off_line_m(found, start, end) <= 0.0005 * 1.05


def test_a_turn_on_the_spot_is_a_line_too() -> None:
    start = tip(HOME)
    waypoints = line(start, start @ rotation((0.0, 0.0, 1.0), 0.4))
    assert tip(waypoints[-1]).angle_to_rad(start) == pytest.approx(0.4, abs=1e-6)
    assert all(tip(q).distance_to_m(start) < 0.0006 for q in waypoints)
