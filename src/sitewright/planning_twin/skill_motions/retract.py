"""Retract: straight out of contact, and on to a parking posture if nothing follows at once."""

from __future__ import annotations

from sitewright.foundation.ids import StationId
from sitewright.planning_twin.jobsite import scene_of
from sitewright.planning_twin.motion import PathSegment, PlannedMotion
from sitewright.planning_twin.refusal import NoIk, Refusal
from sitewright.planning_twin.skill_motions.moving import finished_motion, move_to_first
from sitewright.planning_twin.skill_motions.stage import (
    PlannedSkill,
    SkillRefusal,
    Stage,
    with_joints,
)
from sitewright.planning_twin.skill_motions.way_out import way_out
from sitewright.robot_team.cell import StationKind
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.site_index import preparation_place


def plan_retract(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Plan the way out of a place; a robot that has nothing to do next goes and parks.

    With a piece in hand it waits where it is lifted: parking postures are chosen for empty hands.
    """
    out = _way_out(stage, call)
    if not isinstance(out, tuple):
        return SkillRefusal(call=call, refusal=out)
    waits_here = _is_followed_by_reach(stage, call) or stage.site.arms[call.robot].held is not None
    motion = _out_only(stage, call, out) if waits_here else _out_and_park(stage, call, out)
    if motion is None:
        return PlannedSkill(motions=(), params={}, site_after=stage.site)
    if not isinstance(motion, PlannedMotion):
        return SkillRefusal(call=call, refusal=motion)
    site = with_joints(stage.site, call.robot, motion.timed.path.end_rad)
    return PlannedSkill(motions=(motion,), params={}, site_after=site)


def _is_followed_by_reach(stage: Stage, call: SkillCall) -> bool:
    following = stage.upcoming[0] if stage.upcoming else None
    return (
        following is not None and following.robot == call.robot and following.skill == Skill.REACH
    )


def _way_out(stage: Stage, call: SkillCall) -> tuple[PathSegment, ...] | NoIk:
    """Return the straight lines out of contact; none from a place that touches nothing."""
    (place,) = call.arguments
    station = stage.context.cell.station_by_id.get(StationId(place))
    is_tool_station = station is not None and station.kind is StationKind.TOOL
    if is_tool_station or place == preparation_place(stage.context.cell, call.robot):
        return ()
    return way_out(stage, call.robot)


def _out_only(
    stage: Stage, call: SkillCall, out: tuple[PathSegment, ...]
) -> PlannedMotion | Refusal | None:
    if not out:
        return None
    return finished_motion(stage, call.robot, scene_of(stage.site), out)


def _out_and_park(
    stage: Stage, call: SkillCall, out: tuple[PathSegment, ...]
) -> PlannedMotion | Refusal | None:
    """Plan the way out and on to a parking posture, as one trajectory."""
    options = stage.parking_postures(call.robot)
    first = stage.parking.get(call.robot, 0) % len(options)
    return move_to_first(stage, call.robot, options[first:] + options[:first], out=out)
