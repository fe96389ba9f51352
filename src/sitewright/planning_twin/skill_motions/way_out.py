"""The straight way out of whatever contact a robot is in now."""

from __future__ import annotations

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose, scale
from sitewright.planning_twin.approach import (
    NEIGHBOUR_M,
    Approach,
    Touch,
    straight_approach,
)
from sitewright.planning_twin.jobsite import scene_of
from sitewright.planning_twin.motion import PathSegment
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.scene import Pair
from sitewright.planning_twin.skill_motions.dock import tool_in_dock, way_up
from sitewright.planning_twin.skill_motions.resting import may_touch, resting_contacts
from sitewright.planning_twin.skill_motions.stage import (
    Stage,
)
from sitewright.planning_twin.task import UP
from sitewright.planning_twin.touches import lift_thresholds
from sitewright.robot_team.gripper import mount_T_tcp


def way_out(stage: Stage, robot: RobotId) -> tuple[PathSegment, ...] | NoIk:
    """Return straight lines out of contact: out of a dock, up with a piece, or along the tool."""
    docked = tool_in_dock(stage, robot)
    if docked is not None:
        return way_up(stage, robot, docked)
    touch = _touch_now(stage, robot)
    way = straight_approach(stage.reaching(robot), touch, stage.q_rad(robot))
    return way.outwards() if isinstance(way, Approach) else way


def stands_in_contact(stage: Stage, robot: RobotId) -> bool:
    """Tell whether a robot is too near to something that it may touch to start a free motion."""
    resting = resting_contacts(stage, robot)
    return not stage.reaching(robot).is_clear(stage.q_rad(robot), resting, is_padded=True)


def _touch_now(stage: Stage, robot: RobotId) -> Touch:
    task, arm = stage.context.task, stage.site.arms[robot]
    world_T_tip, tool = stage.tip(robot), stage.context.tool_of(robot)
    resting, near = resting_contacts(stage, robot), _contacts_now(stage, robot)
    if arm.held is not None:
        tool = stage.tool(robot)
        near, direction = {**near, **lift_thresholds(task, tool, arm.held)}, UP
    else:
        tip_T_tcp = Pose() if tool is None else mount_T_tcp(tool.description)
        direction = scale((world_T_tip @ tip_T_tcp).z_axis, -1.0)
    return Touch(
        world_T_tip=world_T_tip,
        back_off=direction,
        near_m={**resting, **near},
        free_m=resting,
    )


def _contacts_now(stage: Stage, robot: RobotId) -> dict[Pair, float]:
    """Return what a robot may touch where it stands, or be near to with a piece in hand.

    It is looked for in the scene, because a robot can stand anywhere after an interruption.
    """
    held = stage.site.arms[robot].held
    pairs = stage.context.backends.collision.violations(
        scene_of(stage.site), robot, stage.q_rad(robot), {}
    )
    near_m = may_touch(stage, robot).thresholds_m(pairs)
    if held is None:
        return near_m
    return {pair: tau_m if held in pair else NEIGHBOUR_M for pair, tau_m in near_m.items()}
