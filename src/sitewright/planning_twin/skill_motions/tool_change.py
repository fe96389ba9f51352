"""Change-end-effector: dock the old one, move over, take the new one, and up."""

from __future__ import annotations

from dataclasses import dataclass, replace

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import EndEffectorId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.approach import (
    PRE_M,
    Approach,
    Touch,
    straight_approach,
)
from sitewright.planning_twin.jobsite import (
    Jobsite,
    end_effector_bodies,
    scene_of,
    world_T_dock,
)
from sitewright.planning_twin.motion import PlannedMotion
from sitewright.planning_twin.refusal import NoIk, Refusal
from sitewright.planning_twin.scene import Attachment
from sitewright.planning_twin.skill_motions.dock import (
    above_dock,
    dock_touch,
    tool_in_dock,
    way_up,
)
from sitewright.planning_twin.skill_motions.moving import finished_motion, move_to, move_to_any
from sitewright.planning_twin.skill_motions.stage import (
    PlannedSkill,
    SkillRefusal,
    Stage,
    with_joints,
)
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.skill import SkillCall

_ABOVE_M = 2 * PRE_M
_SAME_PLACE_M = 0.001


@dataclass(frozen=True, slots=True, kw_only=True)
class _Progress:
    """The change half way: motions so far and the site after them."""

    stage: Stage
    motions: tuple[PlannedMotion, ...] = ()


def plan_change(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Plan the three motions of a change; either end may be a bare flange."""
    known = stage.context.cell.end_effector_by_id
    old, new = (known.get(EndEffectorId(i)) for i in call.arguments[:2])
    start = _Progress(stage=stage)
    progress = start if old is None else _dock(start, call.robot, old)
    if new is not None and isinstance(progress, _Progress):
        progress = _take(progress, call.robot, new)
    if isinstance(progress, _Progress):
        progress = _leave(progress, call.robot, new or old)
    if not isinstance(progress, _Progress):
        return SkillRefusal(call=call, refusal=progress)
    params: dict[str, Json] = {
        "old": None if old is None else old.id,
        "new": None if new is None else new.id,
        "station": call.arguments[2],
    }
    return PlannedSkill(motions=progress.motions, params=params, site_after=progress.stage.site)


def _dock(progress: _Progress, robot: RobotId, old: EndEffector) -> _Progress | Refusal:
    """Move straight down into the old tool's dock and let it go."""
    stage = progress.stage
    down = _lines(stage, robot, old)
    if isinstance(down, NoIk):
        return down
    motion = _to_start_and(stage, robot, down)
    if not isinstance(motion, PlannedMotion):
        return motion
    dock = world_T_dock(stage.context.cell, old)
    edits = {b.id: b.placement for b in end_effector_bodies(old, dock, 0.0)}
    site = with_joints(stage.site, robot, down.contact_rad)
    arm = replace(site.arms[robot], mounted=None, aperture_m=0.0)
    docked = {**site.docked, old.id: old.station}
    site = replace(site, arms={**site.arms, robot: arm}, docked=docked)  # type: ignore[arg-type]
    return _Progress(
        stage=stage.at(site), motions=(*progress.motions, replace(motion, scene_edits=edits))
    )


def _take(progress: _Progress, robot: RobotId, new: EndEffector) -> _Progress | Refusal:
    """Go up from a dock, over to the new tool and straight down onto it."""
    stage = progress.stage
    up = way_up(stage, robot, tool_in_dock(stage, robot))
    if isinstance(up, NoIk):
        return up
    outside = stage.at(with_joints(stage.site, robot, up[-1].waypoints_rad[-1])) if up else stage
    over = move_to_any(outside, robot, above_dock(world_T_dock(stage.context.cell, new)))
    if not isinstance(over, PlannedMotion):
        return over
    there = stage.at(with_joints(stage.site, robot, over.timed.path.end_rad))
    down = _lines(there, robot, new)
    if isinstance(down, NoIk):
        return down
    segments = (*up, *over.timed.path.segments, *down.segments)
    motion = finished_motion(stage, robot, scene_of(stage.site), segments)
    if not isinstance(motion, PlannedMotion):
        return motion
    taken = end_effector_bodies(new, Attachment(robot, Pose()), 0.0)
    edits = {b.id: b.placement for b in taken}
    site = _mounted(with_joints(stage.site, robot, down.contact_rad), robot, new)
    return _Progress(
        stage=stage.at(site), motions=(*progress.motions, replace(motion, scene_edits=edits))
    )


def _leave(progress: _Progress, robot: RobotId, tool: EndEffector | None) -> _Progress | Refusal:
    """Go straight up out of the dock."""
    stage = progress.stage
    up = way_up(stage, robot, tool)
    if isinstance(up, NoIk):
        return up
    motion = finished_motion(stage, robot, scene_of(stage.site), up)
    if not isinstance(motion, PlannedMotion):
        return motion
    site = with_joints(stage.site, robot, motion.timed.path.end_rad)
    return _Progress(stage=stage.at(site), motions=(*progress.motions, motion))


def _mounted(site: Jobsite, robot: RobotId, new: EndEffector) -> Jobsite:
    arm = replace(site.arms[robot], mounted=new.id, aperture_m=0.0)
    docked = {i: s for i, s in site.docked.items() if i != new.id}
    return replace(site, arms={**site.arms, robot: arm}, docked=docked)


def _lines(stage: Stage, robot: RobotId, tool: EndEffector) -> Approach | NoIk:
    """Return the straight way down to a dock from above it, on the robot's present branch."""
    dock = world_T_dock(stage.context.cell, tool)
    touch = dock_touch(stage, robot, tool, dock)
    start = stage.tip(robot)
    reaching = stage.reaching(robot)
    down = reaching.line(above_dock(dock), dock, stage.q_rad(robot))
    if above_dock(dock).distance_to_m(start) > _SAME_PLACE_M or isinstance(down, NoIk):
        postures = reaching.solve(dock, stage.q_rad(robot))
        return (
            postures if isinstance(postures, NoIk) else _first_line(stage, robot, touch, postures)
        )
    return straight_approach(reaching, touch, down[-1])


def _first_line(stage: Stage, robot: RobotId, touch: Touch, postures: tuple) -> Approach | NoIk:  # type: ignore[type-arg]
    reaching = stage.reaching(robot)
    lines = (straight_approach(reaching, touch, q) for q in postures)
    found = next((a for a in lines if isinstance(a, Approach)), None)
    return found or NoIk(is_proven=False, reason=Sentence("no straight way into the dock"))


def _to_start_and(stage: Stage, robot: RobotId, down: Approach) -> PlannedMotion | Refusal:
    return move_to(stage, robot, down.pre_rad, down.segments)
