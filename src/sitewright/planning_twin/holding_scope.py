"""What the refusal of a grasp depends on, as one hash: when it changes, the refusal is void."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from sitewright.foundation.canonical import Json, sha256_hex
from sitewright.foundation.ids import BodyId, ComponentId
from sitewright.foundation.pose import Pose, Vector
from sitewright.planning_twin.approach import PRE_M
from sitewright.planning_twin.jobsite import scene_of
from sitewright.planning_twin.reach_ball import (
    MARGIN_M,
    radius_m,
    reach_with_tools_m,
    standing_within,
)
from sitewright.planning_twin.refusal import BlockedBy, NoGrasp, Refusal
from sitewright.planning_twin.scene import arm_text, shape_hash
from sitewright.planning_twin.scope_text import body_text, joints_text, pose_text, tool_text
from sitewright.planning_twin.tacking import tacks_needed
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.wording import is_proof
from sitewright.robot_team.cell import Robot
from sitewright.symbolic_planning.nogood import scope_hash


def holding_scope(context: TwinContext, robot: Robot, piece: ComponentId, refusal: Refusal) -> str:
    """Return the hash of all that decides whether a robot can take a piece and place it.

    A proof depends on arm, end effector, piece and poses alone, unless it is one by collisions;
    what is blocked depends on the things in the way besides. A search that found nothing depends
    on everything that the arm can reach, and if fasteners must be driven meanwhile, on what the
    other robots can reach and on how they stand.
    """
    parts: dict[str, Json] = {"kind": type(refusal).__name__, **_kinematic(context, robot, piece)}
    by_collisions = isinstance(refusal, NoGrasp) and refusal.freedoms is not None
    if by_collisions or not is_proof(refusal):
        parts["task"] = _task_text(context, piece)
        parts["bodies"] = _bodies(context, robot, piece, refusal)
        if tacks_needed(context.task):
            parts["others"] = [_arm(context, r) for r in context.cell.robot_by_id.values()]
    return scope_hash(parts)


def _kinematic(context: TwinContext, robot: Robot, piece: ComponentId) -> dict[str, Json]:
    shape = context.site.pieces[piece]
    return {
        "arm": _arm(context, robot),
        "piece": [shape_hash(shape.shape), list(shape.size_m), shape.mass_kg],
        "lies": [pose_text(pose) for pose in _lying(context, robot, piece)],
        "world_T_target": pose_text(context.task.world_T_target),
    }


def _lying(context: TwinContext, robot: Robot, piece: ComponentId) -> list[Pose]:
    """Return where a piece is to be taken; nothing if it is in hand already."""
    site = context.site
    return [] if site.arms[robot.id].held == piece else [site.world_T_piece[piece]]


def _arm(context: TwinContext, robot: Robot) -> Json:
    """Return an arm with what it carries; how it stands counts only where others drive."""
    arm = context.site.arms[robot.id]
    tool = context.tool_of(robot.id)
    is_driver = bool(tacks_needed(context.task))
    return [
        robot.id,
        sha256_hex(arm_text(robot.description)),
        robot.description.payload_kg,
        pose_text(robot.world_T_base),
        [*robot.home_q_rad, robot.waits_along_rails],
        joints_text(arm.q_rad) if is_driver else [],
        None if tool is None else tool.id,
        [tool_text(context.cell.end_effector_by_id[i]) for i in robot.end_effectors],
        None if arm.held is None else [arm.held, *pose_text(arm.tip_T_held)],
        sorted(context.site.docked.items()) if is_driver else [],
    ]


def _task_text(context: TwinContext, piece: ComponentId) -> str:
    task = context.task
    told = (task.touches, task.insertions, task.lies_on.get(piece, ()), task.placed)
    driven = (task.spots, task.hold_until) if tacks_needed(task) else ()
    return repr((told, driven, context.cell.clearance_m))


def _bodies(
    context: TwinContext, robot: Robot, piece: ComponentId, refusal: Refusal
) -> Mapping[str, Json]:
    scene = scene_of(context.site)
    if isinstance(refusal, BlockedBy):
        named = {name for pair in refusal.pairs for name in pair}
        found = {i for i in scene.bodies if i in named}
    else:
        balls = _balls(context, robot, piece)
        found = {i for ball in balls for i in standing_within(scene, *ball)}
    return {i: body_text(scene.bodies[i]) for i in sorted(found - {BodyId(piece)})}


def _balls(
    context: TwinContext, robot: Robot, piece: ComponentId
) -> Iterator[tuple[Vector, float]]:
    """Yield where arm, tool and carried piece may be while a grasp is tried."""
    task, site = context.task, context.site
    others = context.cell.robot_by_id.values() if tacks_needed(task) else ()
    for arm in (robot, *(o for o in others if o.id != robot.id)):
        yield arm.world_T_base.position_m, reach_with_tools_m(context.cell, arm) + MARGIN_M
    slide_m = max(i.slide_m for i in task.insertions)
    around_m = radius_m(site.pieces[piece].shape) + PRE_M + slide_m + MARGIN_M
    for pose in (*_lying(context, robot, piece), task.world_T_target):
        yield pose.position_m, around_m
