"""Reach: free motion and straight approach into the contact pose of a place."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import BodyId, ComponentId, EndEffectorId, RobotId, StationId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.approach import Approach, Reaching, Touch
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.jobsite import world_T_dock
from sitewright.planning_twin.motion import PlannedMotion
from sitewright.planning_twin.refusal import NoGrasp, NoIk, Refusal
from sitewright.planning_twin.setting_down import pose_on
from sitewright.planning_twin.skill_motions.dock import above_dock
from sitewright.planning_twin.skill_motions.finish import covers_patch, first_touches
from sitewright.planning_twin.skill_motions.moving import (
    Reached,
    move_to_any,
    move_to_first,
    reach_any,
)
from sitewright.planning_twin.skill_motions.stage import (
    Chosen,
    PlannedSkill,
    SkillRefusal,
    Stage,
    with_joints,
    with_opening,
)
from sitewright.planning_twin.touches import pick_touch, place_touch, set_down_touch, spot_touch
from sitewright.robot_team.cell import StationKind
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.kinematics import without_turns
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.site_index import preparation_place

_SAME_OPENING_M = 0.001
_SAME_BRANCH = 0.01
"""Radians, or metres of a rail."""


def plan_reach(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Plan the motion to a place; which contact pose it means follows from what comes next.

    An empty gripper opens for the piece that it is going to take before it moves.
    """
    (place,) = call.arguments
    opening_m = _opening_for(stage, call.robot, place)
    params: dict[str, Json] = {}
    if opening_m is not None:
        params["aperture_m"] = opening_m
        stage = stage.at(with_opening(stage.site, call.robot, opening_m))
    found = _motion(stage, call.robot, place)
    if not isinstance(found, PlannedMotion | Reached):
        return SkillRefusal(call=call, refusal=found)
    motion = found.motion if isinstance(found, Reached) else found
    return PlannedSkill(
        motions=(motion,),
        params=params,
        site_after=with_joints(stage.site, call.robot, motion.timed.path.end_rad),
        chosen=_chosen(found) if isinstance(found, Reached) else None,
    )


def _chosen(found: Reached) -> Chosen | None:
    if found.first_refusal is None or not found.touch.label:
        return None
    return Chosen(label=found.touch.label, refusal=found.first_refusal)


def _opening_for(stage: Stage, robot: RobotId, place: str) -> float | None:
    """Return how far an empty gripper must open for its next piece; None if it need not move."""
    arm = stage.site.arms[robot]
    piece = None if arm.held is not None else _piece_to_grasp(stage, robot, place)
    holding = None if piece is None else stage.holding(robot, piece)
    if holding is None or abs(arm.aperture_m - holding.grasp.open_m) < _SAME_OPENING_M:
        return None
    return holding.grasp.open_m


def _motion(stage: Stage, robot: RobotId, place: str) -> PlannedMotion | Reached | Refusal:
    station = stage.context.cell.station_by_id.get(StationId(place))
    if place == preparation_place(stage.context.cell, robot):
        home = stage.robot(robot).home_q_rad
        return move_to_first(stage, robot, stage.out_of_the_way(robot, (home,)))
    if station is not None and station.kind is StationKind.TOOL:
        return _above_dock(stage, robot)
    touches = _touches(stage, robot, place)
    if not isinstance(touches, list | Iterator):
        return touches
    wanted_rad = _wanted_rad(stage, robot, place)
    serves = partial(_serves, stage, place, wanted_rad)
    return reach_any(stage, robot, touches, serves=serves, wanted_rad=wanted_rad)


def _serves(
    stage: Stage, place: str, wanted_rad: Joints | None, reaching: Reaching, approach: Approach
) -> bool:
    """Tell whether what follows can be done from a contact posture.

    A pick and a placement use the branch that the batch check proved for lifting and letting
    go; a finish must allow all its strokes.
    """
    spot = stage.context.task.spot(place)
    if spot is not None:
        return spot.patch is None or covers_patch(reaching, spot, approach)
    is_any = wanted_rad is None
    return is_any or _is_same_branch(reaching.description, approach.contact_rad, wanted_rad or ())


def _wanted_rad(stage: Stage, robot: RobotId, place: str) -> Joints | None:
    """Return the posture in contact that was proven for picking or placing; None if any serves."""
    if stage.context.task.spot(place) is not None:
        return None
    held = stage.site.arms[robot].held
    piece = held or _piece_to_grasp(stage, robot, place)
    holding = None if piece is None else stage.holding(robot, piece)
    is_elsewhere = held is None and place != stage.study.lies_at.get(piece or ComponentId(""))
    if holding is None or is_elsewhere:
        return None
    if held is None:
        return holding.pick_rad
    return holding.hold_rad if place == stage.context.task.target else None


def _is_same_branch(description: Description, a: Joints, b: Joints) -> bool:
    """Tell whether two postures are equal but for full turns."""
    apart = without_turns(description, tuple(x - y for x, y in zip(a, b, strict=True)))
    return max(map(abs, apart)) < _SAME_BRANCH


def _touches(stage: Stage, robot: RobotId, place: str) -> Iterator[Touch] | list[Touch] | Refusal:
    task, arm = stage.context.task, stage.site.arms[robot]
    spot = task.spot(place)
    if spot is not None:
        return _spot_touches(stage, robot, spot)
    piece = arm.held or _piece_to_grasp(stage, robot, place)
    holding = None if piece is None else stage.holding(robot, piece)
    if piece is None or holding is None:
        return NoGrasp(
            is_proven=False, candidates=0, reason=Sentence("nothing to do at {place}", place=place)
        )
    tool = stage.tool(robot)
    if arm.held is None:
        at = stage.site.world_T_piece[piece]
        return [pick_touch(task, tool, piece, at, holding.grasp)]
    if place == task.target:
        insertion = task.insertions[holding.insertion]
        return [place_touch(task, tool, piece, holding.grasp, insertion)]
    return _set_down_touches(stage, robot, piece, place)


def _piece_to_grasp(stage: Stage, robot: RobotId, place: str) -> ComponentId | None:
    for call in stage.upcoming:
        if call.robot == robot and call.skill == Skill.GRASP and call.arguments[1] == place:
            return ComponentId(call.arguments[0])
    return None


def _set_down_touches(
    stage: Stage, robot: RobotId, piece: ComponentId, place: str
) -> list[Touch] | Refusal:
    task = stage.context.task
    world_T_surface = task.buffers.get(place)
    holding = stage.holding(robot, piece)
    if world_T_surface is None or holding is None:
        return NoIk(
            is_proven=False, reason=Sentence("nothing can be set down at {place}", place=place)
        )
    pose = pose_on(world_T_surface, stage.site.pieces[piece], stage.site.world_T_piece[piece])
    tool = stage.tool(robot)
    fixtures = tuple(BodyId(f) for f in stage.context.cell.fixture_by_id)
    return [set_down_touch(pose, tool, piece, holding.grasp, touches=fixtures)]


def _spot_touches(stage: Stage, robot: RobotId, spot: Spot) -> Iterator[Touch]:
    tool = stage.tool(robot)
    piece = placed_piece(stage)
    if spot.patch is not None:
        yield from first_touches(spot, tool, piece)
        return
    for pose in tool_poses(spot, tool, has_yaw=False):
        yield spot_touch(tool, spot.body(piece), pose)


def placed_piece(stage: Stage) -> ComponentId:
    """Return the piece that stands, or is held, at the target."""
    task = stage.context.task
    if task.placed is None:
        raise ValueError(f"no piece is in place at {task.target}")
    return task.placed


def _above_dock(stage: Stage, robot: RobotId) -> PlannedMotion | Refusal:
    """Move over the dock that the coming change begins at."""
    change = _coming_change(stage, robot)
    if change is None:
        return NoIk(is_proven=False, reason=Sentence("no tool change follows at this station"))
    known = stage.context.cell.end_effector_by_id
    first = next(known[EndEffectorId(i)] for i in change.arguments[:2] if i in known)
    return move_to_any(stage, robot, above_dock(world_T_dock(stage.context.cell, first)))


def _coming_change(stage: Stage, robot: RobotId) -> SkillCall | None:
    changes = (
        c for c in stage.upcoming if c.robot == robot and c.skill == Skill.CHANGE_END_EFFECTOR
    )
    return next(changes, None)
