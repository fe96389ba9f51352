"""The convex parts of a scene with the joints that carry them, for the audit."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose, norm
from sitewright.foundation.shapes import ConvexPart
from sitewright.planning_twin.scene import Attachment, Body, RobotInScene, SceneSnapshot, link_name
from sitewright.robot_team.description import Description, JointKind, Joints
from sitewright.robot_team.kinematics import link_poses

Array = npt.NDArray[np.float64]
NO_JOINT = -1


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A convex piece of a link or body.

    Attributes:
        name: Of its link or body, as pairs have it.
        robot: Whose joint carries it; None if nothing does.
        is_link: Whether it belongs to the arm itself.
        joint: Number of the joint that carries it; `NO_JOINT` if it never moves.
        frame: Link that it is fixed to; empty for the world.
        points_m: Its corners in that frame, k x 3.
        middle_m: Of the ball that encloses them, in that frame.
        radius_m: Of that ball.
        solid: Their hull for the distance engine, in the same frame.
    """

    name: str
    robot: RobotId | None
    is_link: bool
    joint: int
    frame: str
    points_m: Array
    middle_m: Array
    radius_m: float
    solid: Any


def parts_of(scene: SceneSnapshot) -> tuple[Part, ...]:
    """Return all parts of a scene: arms, what they carry, and what stands still."""
    found = [part for r, arm in scene.robots.items() for part in link_parts(r, arm.description)]
    for body in scene.bodies.values():
        found += _body_parts(body, scene.robots)
    return tuple(found)


def frames_of(arm: RobotInScene, q: Joints) -> dict[str, Array]:
    """Return world_T_link, 4 x 4, of every link of an arm in a posture."""
    base = np.array(arm.world_T_base.matrix())
    poses = link_poses(arm.description, q)
    return {link: base @ np.array(pose.matrix()) for link, pose in poses.items()}


def joint_numbers(description: Description) -> dict[str, int]:
    """Return, for every link, the number of the last joint that moves it."""
    numbers = {description.root: NO_JOINT}
    moving = NO_JOINT
    for joint in description.joints:
        if joint.kind is not JointKind.FIXED:
            moving += 1
            numbers[joint.child] = moving
        else:
            numbers[joint.child] = numbers[joint.parent]
    return numbers


def reaches_m(description: Description, part: Part) -> Array:
    """Return how far a point of the part travels at most per radian (or metre) of each joint.

    That is its largest distance from a joint's axis in any posture. It is at most the sum of
    all offsets between the joint and the point, with everything in between stretched out. It is
    looser than need be, and easy to see to be right.
    """
    movable = description.movable_joints
    reaches = np.zeros(len(movable))
    link, length_m = part.frame, float(np.linalg.norm(part.points_m, axis=1).max())
    number = joint_numbers(description)[link]
    parent_joint = {joint.child: joint for joint in description.joints}
    while link != description.root:
        joint = parent_joint[link]
        if joint.kind is JointKind.PRISMATIC:
            reaches[number] = 1.0
            length_m += max(abs(joint.lower_rad), abs(joint.upper_rad))
        elif joint.kind is JointKind.REVOLUTE:
            reaches[number] = length_m
        number -= joint.kind is not JointKind.FIXED
        length_m += norm(joint.parent_T_joint.position_m)
        link = joint.parent
    return reaches


def link_parts(robot: RobotId, arm: Description) -> tuple[Part, ...]:
    """Return the parts of an arm itself."""
    numbers = joint_numbers(arm)
    return tuple(
        _part(
            link_name(robot, link.name),
            piece,
            robot=robot,
            is_link=True,
            joint=numbers[link.name],
            frame=link.name,
        )
        for link in arm.links
        for piece in link.shape
    )


def _body_parts(body: Body, robots: Mapping[RobotId, RobotInScene]) -> Iterator[Part]:
    placement = body.placement
    for piece in body.shape:
        match placement:
            case Attachment(robot=robot, tip_T_body=tip_T_body):
                arm = robots[robot].description
                yield _part(
                    body.id,
                    piece,
                    tip_T_body,
                    robot=robot,
                    joint=joint_numbers(arm)[arm.tip],
                    frame=arm.tip,
                )
            case Pose():
                yield _part(body.id, piece, placement)


def _part(  # noqa: PLR0913 - who, what, where, and who carries it
    name: str,
    piece: ConvexPart,
    frame_T_body: Pose | None = None,
    *,
    robot: RobotId | None = None,
    is_link: bool = False,
    joint: int = NO_JOINT,
    frame: str = "",
) -> Part:
    import coal

    pose = frame_T_body or Pose()
    points = np.array([pose.apply(p) for p in piece.vertices_m()], dtype=np.float64)
    middle = points.mean(axis=0)
    rows = coal.StdVec_Vec3s()
    rows.extend(list(points))
    return Part(
        name=name,
        robot=robot,
        is_link=is_link,
        joint=joint,
        frame=frame,
        points_m=points,
        middle_m=middle,
        radius_m=float(np.linalg.norm(points - middle, axis=1).max()),
        solid=coal.ConvexBase.convexHull(rows, False, "Qt"),  # noqa: FBT003
    )
