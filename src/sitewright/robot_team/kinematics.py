"""Forward kinematics of a description in plain Python."""

from __future__ import annotations

import math

from sitewright.foundation.pose import Pose, rotation, scale
from sitewright.robot_team.description import Description, Joint, JointKind, Joints

_DIGITS = 6
_HALF_A_TURN = round(math.pi, _DIGITS)


def link_poses(description: Description, q: Joints) -> dict[str, Pose]:
    """Return ``root_T_link`` of every link, fixed frames included.

    Args:
        description: A robot or an end effector.
        q: One position per movable joint, radians or metres, in the description's order.
    """
    root_T_link = {description.root: Pose()}
    for joint, position in _positions(description, q):
        root_T_link[joint.child] = root_T_link[joint.parent] @ _child_pose(joint, position)
    return root_T_link


def tip_pose(description: Description, q: Joints) -> Pose:
    """Return ``root_T_tip``; only the joints between root and tip are computed."""
    by_child = {joint.child: (joint, at) for joint, at in _positions(description, q)}
    root_T_tip, link = Pose(), description.tip
    while link != description.root:
        joint, position = by_child[link]
        root_T_tip, link = _child_pose(joint, position) @ root_T_tip, joint.parent
    return root_T_tip


def without_turns(description: Description, q: Joints) -> Joints:
    """Return a posture as the arm looks in it: whole turns of a joint make no difference.

    Positions of sliding joints stay; all are rounded to a millionth of a radian or metre. Half a
    turn is positive.
    """
    return tuple(
        round(at, _DIGITS) if joint.kind is JointKind.PRISMATIC else _within_a_turn(at)
        for joint, at in zip(description.movable_joints, q, strict=True)
    )


def _within_a_turn(at_rad: float) -> float:
    found = round(math.remainder(at_rad, math.tau), _DIGITS)
    return -found if found == -_HALF_A_TURN else found


def _child_pose(joint: Joint, position: float) -> Pose:
    """Return the pose of a joint's child link in its parent link at a joint position."""
    match joint.kind:
        case JointKind.FIXED:
            return joint.parent_T_joint
        case JointKind.REVOLUTE:
            return joint.parent_T_joint @ rotation(joint.axis, position)
        case JointKind.PRISMATIC:
            return joint.parent_T_joint @ Pose(scale(joint.axis, position))


def _positions(description: Description, q: Joints) -> list[tuple[Joint, float]]:
    """Pair every joint with its position; a fixed one stays at zero."""
    movable = description.movable_joints
    if len(q) != len(movable):
        raise ValueError(f"{description.name} has {len(movable)} movable joints, not {len(q)}")
    position_by_name = {joint.name: at for joint, at in zip(movable, q, strict=True)}
    return [(joint, position_by_name.get(joint.name, 0.0)) for joint in description.joints]
