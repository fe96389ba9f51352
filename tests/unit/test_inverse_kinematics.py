"""Inverse kinematics: all branches, whole turns, the straight wrist, proof of unreachable."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from motion_scenes import HOME, kr120
from sitewright.errors import TeamError
from sitewright.foundation.pose import Pose, from_axis_angle, rotation, translation
from sitewright.planning_twin.backends.kinematic_chain import chain_of, matrix_of, pose_of
from sitewright.planning_twin.backends.numeric_kinematics import NumericSolver
from sitewright.planning_twin.backends.opw_geometry import OpwGeometry, opw_geometry
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics, solver_of
from sitewright.planning_twin.backends.opw_solver import OpwSolver
from sitewright.planning_twin.backends.whole_turns import distinct, wrapped
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Description, Joint, Joints, Link
from sitewright.robot_team.kinematics import tip_pose

KINEMATICS = OpwKinematics()


def random_postures(count: int, seed: int = 1) -> list[Joints]:
    chain = chain_of(kr120())
    rows = np.random.default_rng(seed).uniform(chain.lower, chain.upper, (count, 6))
    return [tuple(row) for row in rows.tolist()]


def solutions(pose: Pose, near: Joints = HOME) -> tuple[Joints, ...]:
    found = KINEMATICS.solve(kr120(), pose, near)
    assert not isinstance(found, NoIk), found
    return found


def largest(a: Joints, b: Joints) -> float:
    return max(abs(x - y) for x, y in zip(a, b, strict=True))


def test_frames_in_arrays_equal_the_plain_forward_kinematics() -> None:
    for q in random_postures(20):
        ours, plain = KINEMATICS.tip(kr120(), q), tip_pose(kr120(), q)
        assert ours.distance_to_m(plain) < 1e-12
        assert ours.angle_to_rad(plain) < 1e-7


def test_the_lengths_of_the_kr_120_are_read_off_its_description() -> None:
    geometry = opw_geometry(chain_of(kr120()))
    assert isinstance(geometry, OpwGeometry)
    assert geometry.lengths_m == pytest.approx((0.35, 0.041, 0.0, 0.675, 1.15, 1.0, 0.215))
    assert geometry.offsets_rad == pytest.approx((0.0, -math.pi / 2.0, 0.0, 0.0, 0.0, 0.0))
    assert geometry.is_flipped == (True, False, False, True, False, True)


def test_the_closed_form_equals_the_frames_on_500_postures() -> None:
    solver = solver_of(kr120())
    assert isinstance(solver, OpwSolver)
    assert solver.error(np.array(random_postures(500, seed=3))) < 1e-9


def test_every_posture_is_found_again_and_comes_first() -> None:
    for q in random_postures(100):
        assert largest(solutions(tip_pose(kr120(), q), near=q)[0], q) < 1e-6


def test_all_solutions_reach_the_pose_inside_the_limits() -> None:
    chain = chain_of(kr120())
    counts = []
    for q in random_postures(30):
        pose = tip_pose(kr120(), q)
        found = solutions(pose)
        counts.append(len(found))
        for solution in found:
            here = tip_pose(kr120(), solution)
            assert here.distance_to_m(pose) < 1e-7
            assert here.angle_to_rad(pose) < 1e-6
            assert (np.array(solution) >= chain.lower).all()
            assert (np.array(solution) <= chain.upper).all()
    assert 14.0 < np.mean(counts) < 21.0


def test_solutions_come_nearest_first() -> None:
    for q in random_postures(10):
        found = solutions(tip_pose(kr120(), q), near=HOME)
        distances = [math.dist(s, HOME) for s in found]
        assert distances == sorted(distances)


def test_no_branch_is_lost_at_a_straight_wrist() -> None:
    for q in random_postures(40):
        straight = (*q[:4], 0.0, q[5])
        found = solutions(tip_pose(kr120(), straight), near=straight)
        arm = [s for s in found if largest(s[:3], straight[:3]) < 1e-6]
        assert arm, "the branch of the arm itself is missing"
        assert any(abs(s[4]) < 1e-6 for s in arm)


def test_a_quaternion_that_is_slightly_off_loses_no_solution() -> None:
    q = random_postures(1)[0]
    pose = tip_pose(kr120(), q)
    w, x, y, z = (c * (1.0 + 9e-7) for c in pose.quaternion_wxyz)
    scaled = Pose(pose.position_m, (w, x, y, z))
    assert len(solutions(scaled)) == len(solutions(pose))


def test_out_of_reach_is_proven_with_its_distance() -> None:
    found = KINEMATICS.solve(kr120(), translation(4.0, 0.0, 0.675), HOME)
    assert isinstance(found, NoIk)
    assert found.is_proven
    assert found.extension_m > 1.0


def test_outside_the_limits_is_proven_too() -> None:
    description = replace(
        kr120(),
        joints=tuple(
            replace(j, lower_rad=-0.01, upper_rad=0.01) if j.name == "joint_a1" else j
            for j in kr120().joints
        ),
    )
    behind = rotation((0.0, 0.0, 1.0), math.pi / 2.0) @ tip_pose(kr120(), HOME)
    found = OpwKinematics().solve(description, behind, HOME)
    assert isinstance(found, NoIk)
    assert found.is_proven
    assert "limits" in found.reason


def test_whole_turns_are_added_inside_the_limits_only() -> None:
    lower, upper = np.array([-7.0, -1.0]), np.array([7.0, 1.0])
    rows = wrapped(np.array([[0.5, 0.5]]), lower, upper)
    assert sorted(rows[:, 0]) == pytest.approx([0.5 - 2 * math.pi, 0.5, 0.5 + 2 * math.pi])
    assert not len(wrapped(np.array([[0.0, 2.0]]), lower, upper))


def test_equal_postures_count_once_whole_turns_aside() -> None:
    rows = np.array([[0.1, 0.2], [0.1 + 2 * math.pi, 0.2], [0.3, 0.2]])
    assert len(distinct(rows)) == 2


def skewed_arm() -> Description:
    """The KR 120 with a bent wrist axis: no closed form."""
    tilt = Pose(quaternion_wxyz=from_axis_angle((0.0, 0.0, 1.0), 0.3))
    joints = tuple(
        replace(j, parent_T_joint=j.parent_T_joint @ translation(0.05, 0.02, 0.0) @ tilt)
        if j.name == "joint_a5"
        else j
        for j in kr120().joints
    )
    return replace(kr120(), name="skewed", joints=joints)


def test_an_arm_without_closed_form_is_solved_by_iterations() -> None:
    arm = skewed_arm()
    kinematics = OpwKinematics()
    assert isinstance(solver_of(arm), NumericSolver)
    q = (0.3, -1.4, 1.2, 0.4, 0.7, -0.5)
    found = kinematics.solve(arm, tip_pose(arm, q), near_rad=(0.0, -1.5, 1.5, 0.0, 0.5, 0.0))
    assert not isinstance(found, NoIk)
    for solution in found:
        assert tip_pose(arm, solution).distance_to_m(tip_pose(arm, q)) < 1e-8
    refused = kinematics.solve(arm, translation(4.0, 0.0, 0.0), q)
    assert isinstance(refused, NoIk)
    assert not refused.is_proven


def test_iterations_repeat_to_the_bit() -> None:
    solver = NumericSolver(chain_of(skewed_arm()))
    target = matrix_of(tip_pose(skewed_arm(), HOME))
    first, second = (solver.postures(target, np.zeros(6)) for _ in range(2))
    assert not isinstance(first, NoIk)
    assert not isinstance(second, NoIk)
    assert (first == second).all()


def test_a_branching_arm_is_refused() -> None:
    fork = replace(
        kr120(),
        links=(*kr120().links, Link(name="twig")),
        joints=(
            *kr120().joints,
            replace(kr120().joints[5], name="extra", parent="link_2", child="twig"),
        ),
    )
    with pytest.raises(TeamError, match="extra"):
        chain_of(fork)


def test_a_matrix_gives_its_pose_back() -> None:
    pose = tip_pose(kr120(), HOME)
    assert pose_of(matrix_of(pose)).distance_to_m(pose) < 1e-12
    assert isinstance(kr120().joints[0], Joint)
