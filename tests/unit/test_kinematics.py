"""Forward kinematics against pinocchio and against the arm's public description."""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np
import pinocchio
import pytest

from sitewright.foundation.pose import Pose
from sitewright.robot_team.description import Description, Joint, JointKind, Link
from sitewright.robot_team.formats.urdf import read_urdf
from sitewright.robot_team.kinematics import link_poses, tip_pose
from sitewright.robot_team.models.catalogue import builtin_end_effector, builtin_robot

KR120 = read_urdf(builtin_robot("kuka-kr120-r2500-pro"))
GRIPPER = read_urdf(builtin_end_effector("builtin:parallel-gripper"))


def random_postures(description: Description, count: int) -> list[tuple[float, ...]]:
    draw = np.random.default_rng(7)
    lower = [j.lower_rad for j in description.movable_joints]
    upper = [j.upper_rad for j in description.movable_joints]
    return [tuple(row) for row in draw.uniform(lower, upper, (count, len(lower))).tolist()]


def largest_difference(
    description: Description, urdf: Path, links: list[str], *, count: int = 100
) -> float:
    """Compare with pinocchio, which orders joints on its own."""
    model = pinocchio.buildModelFromUrdf(str(urdf))
    data = model.createData()
    worst = 0.0
    for q in random_postures(description, count):
        full = pinocchio.neutral(model)
        for joint, position in zip(description.movable_joints, q, strict=True):
            full[model.joints[model.getJointId(joint.name)].idx_q] = position
        pinocchio.framesForwardKinematics(model, data, full)
        ours = link_poses(description, q)
        for link in links:
            theirs = data.oMf[model.getFrameId(link)].homogeneous
            worst = max(worst, float(np.abs(np.array(ours[link].matrix()) - theirs).max()))
    return worst


def test_every_link_of_the_kr120_is_where_pinocchio_puts_it() -> None:
    links = [link.name for link in KR120.links]
    assert len(links) == 8
    assert largest_difference(KR120, Path(KR120.urdf), links) <= 1e-9


def test_the_fingers_of_the_gripper_are_where_pinocchio_puts_them() -> None:
    links = [link.name for link in GRIPPER.links]
    assert "finger_right_link" in links
    assert largest_difference(GRIPPER, Path(GRIPPER.urdf), links, count=20) <= 1e-9


@pytest.mark.skipif(
    "SITEWRIGHT_DATA" not in os.environ, reason="SITEWRIGHT_DATA names no folder of shared data"
)
def test_the_joint_frames_are_those_of_the_public_description() -> None:
    public = Path(os.environ["SITEWRIGHT_DATA"]) / "kuka_kr120" / "kr120r2500pro.urdf"
    links = [link.name for link in KR120.links]
    assert largest_difference(KR120, public, links) <= 1e-6


def test_stretched_out_at_zero_the_tool_looks_along_x() -> None:
    pose = tip_pose(KR120, (0.0,) * 6)
    assert pose.position_m == pytest.approx((0.35 + 1.15 + 1.0 + 0.215, 0.0, 0.675 - 0.041))
    assert pose.z_axis == pytest.approx((1.0, 0.0, 0.0))


def test_the_tip_is_the_same_with_and_without_the_other_links() -> None:
    for q in random_postures(KR120, 20):
        alone, among_all = tip_pose(KR120, q), link_poses(KR120, q)["tool0"]
        assert alone.distance_to_m(among_all) < 1e-12
        assert alone.angle_to_rad(among_all) < 1e-7


def test_a_posture_with_too_few_joints_is_refused() -> None:
    with pytest.raises(ValueError, match="has 6 movable joints, not 5"):
        tip_pose(KR120, (0.0,) * 5)


def test_a_slider_on_a_turned_joint_moves_along_its_own_axis() -> None:
    arm = Description(
        name="crane",
        links=(Link(name="base"), Link(name="boom"), Link(name="hook")),
        joints=(
            Joint(
                name="turn", kind=JointKind.REVOLUTE, parent="base", child="boom", axis=(0, 0, 1)
            ),
            Joint(
                name="slide",
                kind=JointKind.PRISMATIC,
                parent="boom",
                child="hook",
                parent_T_joint=Pose((1.0, 0.0, 0.0)),
            ),
        ),
        root="base",
        tip="hook",
    )
    assert tip_pose(arm, (math.pi / 2, 0.5)).position_m == pytest.approx((0.0, 1.5, 0.0))
