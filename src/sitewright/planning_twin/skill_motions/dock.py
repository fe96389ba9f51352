"""Docks of end effectors: what may touch in one, and the straight way out of it."""

from __future__ import annotations

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose, scale
from sitewright.planning_twin.approach import (
    CONTACT_M,
    NEIGHBOUR_M,
    PRE_M,
    Approach,
    Touch,
    straight_approach,
)
from sitewright.planning_twin.jobsite import bodies_of_tool, lifted, world_T_dock
from sitewright.planning_twin.motion import PathSegment
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.scene import Pair, link_name
from sitewright.planning_twin.skill_motions.stage import Stage
from sitewright.planning_twin.task import declared
from sitewright.robot_team.cell import EndEffector

_ABOVE_M = 2 * PRE_M
_MATING_M = -0.003
"""Changer plates mate; an arm's envelope may stand a little over its flange face."""


def above_dock(dock: Pose) -> Pose:
    """Return the tip pose from which a dock is entered, straight along the mount's z."""
    return lifted(dock, scale(dock.z_axis, -1.0), _ABOVE_M)


def tool_in_dock(stage: Stage, robot: RobotId) -> EndEffector | None:
    """Return the end effector in whose dock a robot stands: its own, or one under a bare flange."""
    tip, mounted = stage.tip(robot), stage.site.arms[robot].mounted
    cell = stage.context.cell
    tools = [
        cell.end_effector_by_id[i] for i in (stage.site.docked if mounted is None else (mounted,))
    ]
    near = (t for t in tools if t.station is not None)
    return next((t for t in near if world_T_dock(cell, t).distance_to_m(tip) < PRE_M / 2), None)


def dock_touch(stage: Stage, robot: RobotId, tool: EndEffector, dock: Pose) -> Touch:
    """Return the contact of a flange with a tool that stands in its dock, or is put there."""
    return Touch(
        world_T_tip=dock,
        back_off=scale(dock.z_axis, -1.0),
        near_m=dock_contacts(stage, robot, tool),
        free_m=declared(NEIGHBOUR_M, bodies_of_tool(tool), _fixtures(stage)),
        distance_m=_ABOVE_M,
    )


def dock_contacts(stage: Stage, robot: RobotId, tool: EndEffector) -> dict[Pair, float]:
    """Return what may touch in a dock: flange and tool, tool and rack."""
    links = stage.robot(robot).description.links
    flange = next(link.name for link in reversed(links) if link.shape)
    bodies = bodies_of_tool(tool)
    return {
        **declared(CONTACT_M, bodies, _fixtures(stage)),
        **declared(_MATING_M, bodies, (BodyId(link_name(robot, flange)),)),
    }


def _fixtures(stage: Stage) -> tuple[BodyId, ...]:
    return tuple(BodyId(f) for f in stage.context.cell.fixture_by_id)


def way_up(
    stage: Stage, robot: RobotId, tool: EndEffector | None
) -> tuple[PathSegment, ...] | NoIk:
    """Return the straight lines up out of a dock; none without one."""
    if tool is None:
        return ()
    tip = stage.tip(robot)
    touch = dock_touch(stage, robot, tool, tip)
    way = straight_approach(stage.reaching(robot), touch, stage.q_rad(robot))
    return way.outwards() if isinstance(way, Approach) else way
