"""What a robot cannot reach for certain: outside the sphere of its stretched arm and tool."""

from __future__ import annotations

from sitewright.building_model.shapes import extent_of
from sitewright.foundation.pose import Pose, Vector, distance, norm
from sitewright.foundation.shapes import Shape
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.description import Description, JointKind


def is_point_in_reach(robot: Robot, tool: EndEffector, point_m: Vector) -> bool:
    """Return whether a world point is within the sphere; False is a proof, True is none."""
    return distance(_shoulder(robot), point_m) <= _radius_m(robot, tool)


def is_box_in_reach(robot: Robot, tool: EndEffector, shape: Shape, world_T_shape: Pose) -> bool:
    """Return whether any point of a shape's box is within the sphere."""
    shape_T_shoulder = world_T_shape.inverse().apply(_shoulder(robot))
    box = extent_of(shape)
    nearest = tuple(
        min(max(x, low), high)
        for x, low, high in zip(shape_T_shoulder, box.low_m, box.high_m, strict=True)
    )
    gap = tuple(a - b for a, b in zip(shape_T_shoulder, nearest, strict=True))
    return norm((gap[0], gap[1], gap[2])) <= _radius_m(robot, tool)


def _shoulder(robot: Robot) -> Vector:
    """Return the origin of the first movable joint in the world."""
    base_T_joint = Pose()
    for joint in robot.description.joints:
        base_T_joint = base_T_joint @ joint.parent_T_joint
        if joint.kind is not JointKind.FIXED:
            break
    return (robot.world_T_base @ base_T_joint).position_m


def _radius_m(robot: Robot, tool: EndEffector) -> float:
    """Return an upper bound of the distance from the shoulder to the tool's tip."""
    return _chain_m(robot.description) + _chain_m(tool.description, from_root=True)


def _chain_m(description: Description, *, from_root: bool = False) -> float:
    """Return the sum of the offsets on the way to the tip, after the first movable joint."""
    total_m, is_counting = 0.0, from_root
    on_the_way = _links_to_tip(description)
    for joint in description.joints:
        if joint.child not in on_the_way:
            continue
        if is_counting:
            total_m += norm(joint.parent_T_joint.position_m)
        if joint.kind is JointKind.PRISMATIC:
            total_m += max(abs(joint.lower_rad), abs(joint.upper_rad))
        is_counting = is_counting or joint.kind is not JointKind.FIXED
    return total_m


def _links_to_tip(description: Description) -> set[str]:
    parent_of = {j.child: j.parent for j in description.joints}
    found, link = set(), description.tip
    while link in parent_of:
        found.add(link)
        link = parent_of[link]
    return found
