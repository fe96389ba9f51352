"""Turns a skill sequence into certified motions, step after step, or says which step cannot be."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.planning_twin.call_scope import call_scope
from sitewright.planning_twin.jobsite import Jobsite
from sitewright.planning_twin.refusal import BlockedBy, NotClear
from sitewright.planning_twin.scene import Pair, owner_of
from sitewright.planning_twin.setting_down import lying_on_fixtures
from sitewright.planning_twin.skill_motions.acts import PLANNERS as ACTS
from sitewright.planning_twin.skill_motions.finish import plan_apply_finish
from sitewright.planning_twin.skill_motions.reach import plan_reach
from sitewright.planning_twin.skill_motions.retract import plan_retract
from sitewright.planning_twin.skill_motions.stage import (
    PlannedSkill,
    SkillRefusal,
    Stage,
)
from sitewright.planning_twin.skill_motions.tool_change import plan_change
from sitewright.planning_twin.study import Study
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.skill import Skill, SkillCall

SkillPlanner = Callable[[Stage, SkillCall], PlannedSkill | SkillRefusal]

SKILL_PLANNERS: Mapping[str, SkillPlanner] = {
    Skill.REACH: plan_reach,
    Skill.RETRACT: plan_retract,
    Skill.APPLY_FINISH: plan_apply_finish,
    Skill.CHANGE_END_EFFECTOR: plan_change,
    **{str(skill): planner for skill, planner in ACTS.items()},
}
"""Motion planner of each skill; a new skill adds a line."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedSequence:
    """Every call of a sequence with its motion, in order."""

    calls: tuple[SkillCall, ...]
    skills: tuple[PlannedSkill, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class SequenceRefusal:
    """The first call that geometry does not allow.

    Attributes:
        number: Its place in the sequence, from 0.
        site: The site as it would stand at that point.
        place_by_robot: Where each robot would be, as far as the sequence tells.
        blocking_robot: The other robot that is in the way, if one is.
        planned: Motions of the calls before it.
    """

    number: int
    call: SkillCall
    cause: SkillRefusal
    site: Jobsite
    place_by_robot: Mapping[RobotId, str | None]
    blocking_robot: RobotId | None = None
    planned: tuple[PlannedSkill, ...] = ()


def plan_sequence(
    context: TwinContext,
    study: Study,
    calls: tuple[SkillCall, ...],
    place_by_robot: Mapping[RobotId, str | None],
    known: tuple[PlannedSkill, ...] = (),
    *,
    only_first: bool = False,
) -> PlannedSequence | SequenceRefusal:
    """Plan all motions of a skill sequence.

    A robot that was sent to park and is in the way of a later step gets its next parking
    posture, and the sequence is planned again from there, before the step is refused.

    Args:
        context: Engines, the site as sensed, the task.
        study: Grasps and facts of the batch check.
        calls: The skill sequence.
        place_by_robot: Place of each robot at the start; None is in transit.
        known: Motions of the first calls that were planned before and still hold.
        only_first: Plan just the first call; the others say what it has to lead to.
    """
    planned = list(known)
    parking: dict[RobotId, int] = {}
    wanted = 1 if only_first else len(calls)
    while len(planned) < wanted:
        number = len(planned)
        site = planned[-1].site_after if planned else context.site
        stage = Stage(
            context=_context_at(context, site, calls[:number]),
            study=study,
            upcoming=calls[number + 1 :],
            detour=context.detours.get(calls[number], 0),
            parking=parking,
        )
        result = _planned(stage, calls[number])
        if isinstance(result, PlannedSkill):
            planned.append(result)
            continue
        places = places_after(place_by_robot, calls[:number])
        blocker = blocking_robot(stage, result)
        again = _park_elsewhere(stage, calls, number, blocker, places, parking)
        if again is None:
            return SequenceRefusal(
                number=number,
                call=calls[number],
                cause=result,
                site=site,
                place_by_robot=places,
                blocking_robot=blocker,
                planned=tuple(planned),
            )
        planned = planned[:again]
    return PlannedSequence(calls=calls[:wanted], skills=tuple(planned))


def _planned(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Plan a call, unless it was refused before where everything was the same."""
    kept, question = stage.context.kept, ("move", call.robot, call.skill, *call.arguments)
    known = kept.recall(question, lambda _: call_scope(stage, call))
    if known is not None:
        return SkillRefusal(call=call, refusal=known)
    result = SKILL_PLANNERS[call.skill](stage, call)
    if isinstance(result, SkillRefusal):
        kept.keep(question, result.refusal, call_scope(stage, call))
    return result


def _context_at(context: TwinContext, site: Jobsite, done: tuple[SkillCall, ...]) -> TwinContext:
    """Return the context with the site of a step, and the piece in place if one is by then."""
    positioned = (ComponentId(c.arguments[0]) for c in reversed(done) if c.skill == Skill.POSITION)
    placed = next(positioned, context.task.placed)
    here = replace(context, site=site, task=replace(context.task, placed=placed))
    for call in done:
        if call.skill == Skill.SET_DOWN:
            piece = ComponentId(call.arguments[0])
            here = replace(here, task=lying_on_fixtures(here, piece))
    return here


def places_after(
    start: Mapping[RobotId, str | None], calls: tuple[SkillCall, ...]
) -> dict[RobotId, str | None]:
    """Return where each robot is after some calls; None is in transit."""
    places = dict(start)
    for call in calls:
        if call.skill == Skill.REACH:
            places[call.robot] = call.arguments[0]
        elif call.skill == Skill.RETRACT:
            places[call.robot] = None
    return places


def blocking_robot(stage: Stage, refused: SkillRefusal) -> RobotId | None:
    """Return the other robot whose links, tool or piece are in the way."""
    scene = stage.reaching(refused.call.robot).scene
    for pair in _pairs_of(refused):
        for name in pair:
            owner = owner_of(scene, name)
            if owner is not None and owner != refused.call.robot:
                return owner
    return None


def _pairs_of(refused: SkillRefusal) -> tuple[Pair, ...]:
    match refused.refusal:
        case BlockedBy(pairs=pairs):
            return pairs
        case NotClear(pair=pair):
            return (pair,)
        case _:
            return ()


def _park_elsewhere(
    stage: Stage,
    calls: tuple[SkillCall, ...],
    number: int,
    blocker: RobotId | None,
    places: Mapping[RobotId, str | None],
    parking: dict[RobotId, int],
) -> int | None:
    """Choose another parking posture for an idle robot; return the step to plan again from."""
    if blocker is None or places.get(blocker) is not None:
        return None
    options = len(stage.parking_postures(blocker))
    tried = parking.get(blocker, 0) + 1
    if tried >= options:
        return None
    for k in range(number - 1, -1, -1):
        if calls[k].robot == blocker and calls[k].skill == Skill.RETRACT:
            parking[blocker] = tried
            return k
    return None
