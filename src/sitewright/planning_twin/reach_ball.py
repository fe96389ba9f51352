"""How far from its base an arm can have anything: what lies farther away never matters to it."""

from __future__ import annotations

from functools import lru_cache

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose, Vector, distance, norm
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.jobsite import end_effector_bodies
from sitewright.planning_twin.scene import Attachment, Body, SceneSnapshot
from sitewright.robot_team.cell import Cell, EndEffector, Robot
from sitewright.robot_team.description import Description, JointKind

MARGIN_M = 0.05
"""More than clearance, padding and every reserve of the engines together."""
_MOUNT = Attachment(RobotId("any"), Pose())


@lru_cache(maxsize=64)
def tip_reach_m(description: Description) -> float:
    """Return a bound on the distance from the root frame to the tip frame."""
    return _frames_m(description)[description.tip]


@lru_cache(maxsize=64)
def arm_reach_m(description: Description) -> float:
    """Return a bound on the distance from the root frame to any point of the arm."""
    frames_m = _frames_m(description)
    return max(frames_m[link.name] + radius_m(link.shape) for link in description.links)


def reach_with_tools_m(cell: Cell, robot: Robot) -> float:
    """Return a bound on the distance from a robot's base to any point of it and of its tools."""
    tools = [cell.end_effector_by_id[i] for i in robot.end_effectors]
    longest_m = max((tool_reach_m(t) for t in tools), default=0.0)
    description = robot.description
    return max(arm_reach_m(description), tip_reach_m(description) + longest_m)


def tool_reach_m(tool: EndEffector) -> float:
    """Return a bound on the distance from an end effector's mount to any point of it."""
    bodies = end_effector_bodies(tool, _MOUNT, tool.opens_to_m)
    return max(
        norm(b.placement.tip_T_body.position_m) + radius_m(b.shape)
        for b in bodies
        if isinstance(b.placement, Attachment)
    )


@lru_cache(maxsize=4096)
def radius_m(shape: Shape) -> float:
    """Return the radius of the ball about a body's origin that holds it."""
    return max((norm(v) for part in shape for v in part.vertices_m()), default=0.0)


def standing_within(scene: SceneSnapshot, centre: Vector, reach_m: float) -> dict[BodyId, Body]:
    """Return the bodies that no robot carries and that may come into a ball."""
    return {
        i: body
        for i, body in scene.bodies.items()
        if not isinstance(body.placement, Attachment)
        and distance(body.placement.position_m, centre) - radius_m(body.shape) <= reach_m
    }


def _frames_m(description: Description) -> dict[str, float]:
    """Return for each link a bound on the distance from the root frame to the link's frame."""
    found = {description.root: 0.0}
    for joint in description.joints:
        step_m = norm(joint.parent_T_joint.position_m)
        if joint.kind is JointKind.PRISMATIC:
            step_m += max(abs(joint.lower_rad), abs(joint.upper_rad))
        found[joint.child] = found[joint.parent] + step_m
    return found
