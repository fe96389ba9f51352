"""What planning one target comes to: a plan in parts, or a refusal with its reason."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from sitewright.central_controller.blame import pieces_to_blame, reason_for, removals_of
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.feedback import refused_call, removals_of_refused
from sitewright.planning_twin.holding import dropped_at
from sitewright.planning_twin.jobsite import Jobsite
from sitewright.planning_twin.refusal import BlockedBy, Refusal, pair_of, seen_at
from sitewright.planning_twin.sequence import PlannedSequence, SequenceRefusal
from sitewright.planning_twin.study import Study
from sitewright.planning_twin.tacking import Holding
from sitewright.planning_twin.wording import how_held, in_words, is_proof
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.nogood import MinimalReason
from sitewright.symbolic_planning.planner import NoPlan, SkillSequence
from sitewright.symbolic_planning.problem import Problem

_NEWS = 0.01
"""A grasp that costs less is the straight one at the middle, perhaps turned over."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanPart:
    """One symbolic plan whose every motion is certified."""

    problem: Problem
    sequence: SkillSequence
    motions: PlannedSequence


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetPlan:
    """A plan for a target: the errands that come first, if any, then the target itself."""

    parts: tuple[PlanPart, ...]
    notes: tuple[RefusalNote, ...]

    @property
    def target(self) -> ComponentId:
        """What is built by it."""
        return self.parts[-1].problem.target

    def after(self, errand: TargetPlan) -> TargetPlan:
        """Return the plan with an errand before it."""
        parts, notes = (*errand.parts, *self.parts), (*errand.notes, *self.notes)
        return replace(self, parts=parts, notes=notes)


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetRefusal:
    """No plan with certified motions was found for the target.

    Attributes:
        is_limit: A budget ended; more rounds might help.
        removals: Smallest sets of bodies and robots without which there might be a plan.
        start_matters: Pieces that might serve if they lay, or were held, differently.
        passable: Those of them that robots might pass on by way of buffers, by reach alone.
        blamed: Facts without whose refusal there might be a plan.
    """

    problem: Problem
    reason: str
    is_proven: bool
    is_limit: bool
    notes: tuple[RefusalNote, ...]
    removals: tuple[tuple[str, ...], ...] = ()
    start_matters: tuple[ComponentId, ...] = ()
    passable: tuple[ComponentId, ...] = ()
    blamed: tuple[Fact, ...] = ()

    @property
    def blockers(self) -> tuple[str, ...]:
        """The fewest things that are in the way, if things are."""
        return self.removals[0] if self.removals else ()


def no_plan_left(
    problem: Problem,
    no: NoPlan,
    blame: MinimalReason,
    study: Study,
    notes: Iterable[RefusalNote],
    *,
    is_proven: bool,
) -> TargetRefusal:
    """Return the refusal of a target that the symbols allow no plan for any more.

    It is no proof if a piece might be passed on by way of buffers.
    """
    start_matters = tuple(p for p in pieces_to_blame(blame) if study.depends_on_start(p))
    passable = tuple(p for p in start_matters if p in study.passable)
    return TargetRefusal(
        problem=problem,
        reason=reason_for(problem.target, no.reason, blame),
        is_proven=is_proven and not passable,
        is_limit=not no.is_proven,
        notes=tuple(notes),
        removals=removals_of(blame),
        start_matters=start_matters,
        passable=passable,
        blamed=tuple(dict.fromkeys(n.fact for n in (*blame.alone, *blame.together))),
    )


def given_up(
    problem: Problem,
    reason: str,
    notes: Iterable[RefusalNote],
    study: Study,
    candidates: Iterable[ComponentId],
    *,
    is_limit: bool = False,
) -> TargetRefusal:
    """Return the refusal of a target whose motions failed too often; never a proof."""
    told = tuple(notes)
    blockers = told[-1].blockers if told else ()
    start_matters = tuple(p for p in candidates if study.depends_on_start(p))
    return TargetRefusal(
        problem=problem,
        reason=reason,
        is_proven=False,
        is_limit=is_limit,
        notes=told,
        removals=(blockers,) if blockers else (),
        start_matters=start_matters,
        passable=tuple(p for p in start_matters if p in study.passable),
    )


def note_of_motion(
    target: ComponentId, refused: SequenceRefusal, calls: tuple[SkillCall, ...], then: str
) -> RefusalNote:
    """Return the note of a plan that geometry refused, and what was tried next."""
    refusal = refused.cause.refusal
    return RefusalNote(
        target=target,
        kind=type(refusal).__name__,
        reason=refused_call(refused, calls, scope="", attempt=1).evidence,
        is_proven=is_proof(refusal),
        is_replanned=True,
        blockers=_blockers_of_call(refused),
        then=then,
        pair=pair_of(refusal),
        moment=seen_at(refusal),
    )


def _blockers_of_call(refused: SequenceRefusal) -> tuple[str, ...]:
    """Return the fewest things in the way of a call; the robot itself if nothing else is."""
    itself = (refused.call.robot,) if isinstance(refused.cause.refusal, BlockedBy) else ()
    return next(iter(removals_of_refused(refused)), itself)


def notes_of_study(
    target: ComponentId, study: Study, calls: tuple[SkillCall, ...] = ()
) -> tuple[RefusalNote, ...]:
    """Return what the batch check found impossible, and which calls of a plan do it otherwise."""
    return tuple(
        RefusalNote(
            target=target,
            kind=type(r.refusal).__name__,
            reason=r.nogood.evidence,
            is_proven=r.nogood.is_proven,
            blockers=next(iter(r.nogood.removals), ()),
            then=_done_instead(r.nogood.fact, calls),
            pair=pair_of(r.refusal),
            moment=seen_at(r.refusal),
        )
        for r in study.refusals
    )


def _done_instead(fact: Fact, calls: tuple[SkillCall, ...]) -> str:
    """Return who does in a plan what a robot cannot, or which other piece is taken."""
    _, robot, *about = fact
    acts = [c for c in calls if c.skill in (Skill.GRASP, Skill.FASTEN, Skill.APPLY_FINISH)]
    same = next((c for c in acts if c.arguments[0] in about), None)
    if same is not None:
        return Sentence("{robot} does it", robot=same.robot) if same.robot != robot else ""
    other = next((c for c in acts if c.skill == Skill.GRASP), None)
    if other is None:
        return ""
    return Sentence("{robot} takes {piece}", robot=other.robot, piece=other.arguments[0])


def notes_of_choices(
    target: ComponentId, study: Study, site: Jobsite, motions: PlannedSequence
) -> tuple[RefusalNote, ...]:
    """Return where a plan holds a piece, or leans a tool, because the first choice would not do."""
    held = (
        _note_of_grasp(target, holding, site.world_T_piece[holding.piece])
        for (robot, piece), holding in study.holdings.items()
        if holding.passed_over
        and holding.grasp.cost >= _NEWS
        and any(
            (c.skill, c.robot, c.arguments[0]) == (Skill.GRASP, robot, piece) for c in motions.calls
        )
    )
    leaning = (
        RefusalNote(
            target=target,
            kind=type(skill.chosen.refusal).__name__,
            reason=Sentence(
                "{robot} cannot stand upright on {spot}: {why}",
                robot=call.robot,
                spot=call.arguments[0],
                why=in_words(skill.chosen.refusal),
            ),
            is_proven=is_proof(skill.chosen.refusal),
            blockers=_blockers(skill.chosen.refusal),
            then=Sentence("it leans ({how})", how=skill.chosen.label),
            pair=pair_of(skill.chosen.refusal),
            moment=seen_at(skill.chosen.refusal),
        )
        for call, skill in zip(motions.calls, motions.skills, strict=True)
        if skill.chosen is not None
    )
    return (*held, *leaning)


def _blockers(refusal: Refusal) -> tuple[str, ...]:
    return next(iter(refusal.removals), ()) if isinstance(refusal, BlockedBy) else ()


def _note_of_grasp(target: ComponentId, holding: Holding, world_T_piece: Pose) -> RefusalNote:
    return RefusalNote(
        target=target,
        kind="NoGrasp",
        reason=Sentence(
            "{robot} cannot hold {piece} straight at its middle: "
            "cheaper grasps fail at {ends:comma}",
            robot=holding.robot,
            piece=holding.piece,
            ends=dropped_at(holding.passed_over),
        ),
        is_proven=False,
        then=Sentence("it is held {how}", how=how_held(holding.grasp, world_T_piece)),
    )
