"""What the refusal of a call depends on, as one hash: the surroundings, and what follows."""

from __future__ import annotations

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import BodyId
from sitewright.foundation.pose import norm
from sitewright.planning_twin.jobsite import scene_of
from sitewright.planning_twin.reach_ball import (
    MARGIN_M,
    radius_m,
    reach_with_tools_m,
    standing_within,
)
from sitewright.planning_twin.scene import arm_text
from sitewright.planning_twin.scope_text import body_text, joints_text, pose_text, tool_text
from sitewright.planning_twin.skill_motions.stage import Stage
from sitewright.robot_team.cell import Robot
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.nogood import scope_hash


def call_scope(stage: Stage, call: SkillCall) -> str:
    """Return the hash of all that decides whether a call has a motion.

    A search may touch anything that arms, tools and carried pieces can get near to; what lies
    farther away from all robots does not count.
    """
    context = stage.context
    holdings = (h for (robot, _), h in sorted(stage.study.holdings.items()) if robot == call.robot)
    return scope_hash(
        {
            "call": repr((call, stage.upcoming)),
            "seed": context.seed,
            "detour": stage.detour,
            "parking": repr(sorted(stage.parking.items())),
            "holdings": [repr(h) for h in holdings],
            "task": repr(context.task),
            "lies_at": repr(sorted(stage.study.lies_at.items())),
            "steadied": repr(sorted(stage.site.steadied.items())),
            "clearance_m": context.cell.clearance_m,
            "tools": [tool_text(t) for _, t in sorted(context.cell.end_effector_by_id.items())],
            "cell": repr(sorted(context.cell.station_by_id.items())),
            "arms": [_arm(stage, r) for r in context.cell.robot_by_id.values()],
            "bodies": _bodies(stage),
        }
    )


def _arm(stage: Stage, robot: Robot) -> Json:
    arm = stage.site.arms[robot.id]
    held: Json = None if arm.held is None else [arm.held, *pose_text(arm.tip_T_held)]
    postures = [robot.home_q_rad, *robot.parking_q_rad, robot.max_acceleration_rad_s2]
    return [
        arm_text(robot.description),
        pose_text(robot.world_T_base),
        joints_text(arm.q_rad),
        arm.mounted,
        round(arm.aperture_m, 4),
        held,
        [list(p) for p in postures],
        robot.waits_along_rails,
    ]


def _bodies(stage: Stage) -> dict[str, Json]:
    scene = scene_of(stage.site)
    found: set[BodyId] = set()
    for robot in stage.context.cell.robot_by_id.values():
        reach_m = reach_with_tools_m(stage.context.cell, robot) + _carried_m(stage, robot)
        centre = robot.world_T_base.position_m
        found |= standing_within(scene, centre, reach_m + MARGIN_M).keys()
    return {i: body_text(scene.bodies[i]) for i in sorted(found)}


def _carried_m(stage: Stage, robot: Robot) -> float:
    """Return how far beyond its tools a robot may reach with a piece of this task."""
    site = stage.site
    pieces = {*stage.context.task.candidates} & site.pieces.keys()
    longest_m = max((radius_m(site.pieces[p].shape) for p in pieces), default=0.0)
    return 2.0 * longest_m + norm(site.arms[robot.id].tip_T_held.position_m)
