"""The loop plan - refuse - replan for one target: symbolic plan, motions, facts, again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from sitewright.central_controller.blame import reason_for, removals_of, to_blame
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.clock import Clock
from sitewright.foundation.ids import ComponentId
from sitewright.planning_twin.feedback import Lessons, refused_call
from sitewright.planning_twin.motion import PlanningBackends
from sitewright.planning_twin.refusal import NoPath
from sitewright.planning_twin.sequence import (
    PlannedSequence,
    SequenceRefusal,
    plan_sequence,
)
from sitewright.planning_twin.skill_motions.stage import PlannedSkill
from sitewright.planning_twin.study import Study, StudyRefusal, with_another_grasp
from sitewright.planning_twin.tacking import Holding
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.wording import is_proof
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.domain import Domain
from sitewright.symbolic_planning.nogood import MinimalReason, Nogood, with_nogoods
from sitewright.symbolic_planning.planner import NoPlan, SkillSequence, SymbolicPlanner
from sitewright.symbolic_planning.problem import Problem, problem_for
from sitewright.symbolic_planning.site_view import SiteView

MOST_ROUNDS = 30
"""So many plans are refused by geometry before a person is asked."""
_MOST_SEARCHES = 4
"""So many searches for a path may use up their budgets before the planner gives up."""
_MOST_GRASPS = 8
"""So many grasps of a piece have their motions planned before another way is looked for."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanningPorts:
    """The engines of both planners, and the clock that measures them.

    Attributes:
        certifying_s: Time that proofs have taken so far.
    """

    domain: Domain
    symbolic: SymbolicPlanner
    backends: PlanningBackends
    clock: Clock
    certifying_s: Callable[[], float] = field(default=lambda: 0.0)


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


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetRefusal:
    """No plan with certified motions was found for the target.

    Attributes:
        is_limit: A budget ended; more rounds might help.
        removals: Smallest sets of bodies and robots without which there might be a plan.
    """

    problem: Problem
    reason: str
    is_proven: bool
    is_limit: bool
    notes: tuple[RefusalNote, ...]
    removals: tuple[tuple[str, ...], ...] = ()


def plan_target(
    ports: PlanningPorts, context: TwinContext, study: Study, view: SiteView, watch: Stopwatch
) -> TargetPlan | TargetRefusal:
    """Plan a target until symbols and geometry agree, or say why they cannot.

    Args:
        ports: Both planners.
        context: The twin's picture of site and task.
        study: The batch check's facts and grasps.
        view: The symbolic picture; its geometric facts are replaced by the study's.
        watch: Where the time goes.
    """
    target = view.target
    notes = [_study_note(target, r) for r in study.refusals]
    lessons = Lessons(base=study.base, nogoods=list(study.nogoods))
    tried: list[Holding] = []
    start = {robot: status.place for robot, status in view.robot_status.items()}
    known: tuple[tuple[SkillCall, PlannedSkill], ...] = ()
    for _ in range(MOST_ROUNDS):
        watch.start()
        problem = problem_for(ports.domain, replace(view, geometry=lessons.facts))
        sequence = ports.symbolic.plan(problem)
        watch.stop("symbolic")
        if isinstance(sequence, NoPlan):
            blame = _blame(ports, view, lessons, watch)
            return _refused(problem, sequence, blame, lessons, notes)
        watch.start()
        result = plan_sequence(
            replace(context, seed=context.seed + lessons.new_seeds),
            study,
            sequence.calls,
            start,
            known=tuple(_still_valid(known, sequence.calls)),
        )
        watch.stop("motion")
        if isinstance(result, PlannedSequence):
            part = PlanPart(problem=problem, sequence=sequence, motions=result)
            return TargetPlan(parts=(part,), notes=tuple(notes))
        notes.append(_note(target, result, sequence.calls))
        if sum(n.kind == NoPath.__name__ for n in notes) >= _MOST_SEARCHES:
            reason = f"{_MOST_SEARCHES} searches ended without a path; the last: {notes[-1].reason}"
            return replace(_given_up(problem, reason, notes), is_limit=True)
        watch.start()
        regrasped = _another_grasp(context, study, result, tried)
        watch.stop("motion")
        if regrasped is not None:
            study, known, lessons.base = regrasped, (), regrasped.base
        elif lessons.learn(result, sequence.calls):
            known = tuple(zip(sequence.calls[: result.number], result.planned, strict=True))
        else:
            return _given_up(
                problem, f"{notes[-1].reason}; no other order or robot avoids it", notes
            )
    reason = f"{MOST_ROUNDS} plans were refused by geometry; the last one: {notes[-1].reason}"
    return replace(_given_up(problem, reason, notes), is_limit=True)


def _another_grasp(
    context: TwinContext, study: Study, refused: SequenceRefusal, tried: list[Holding]
) -> Study | None:
    """Return the study with the next grasp, if the refused motion depends on one.

    A robot in the way is a matter of order, and a fastener's pose of the tool's tilt.
    """
    call = refused.call
    is_elsewhere = any(context.task.spot(a) is not None for a in call.arguments)
    holding = next((h for (r, _), h in study.holdings.items() if r == call.robot), None)
    if holding is None or is_elsewhere or refused.blocking_robot is not None:
        return None
    if len(tried) >= _MOST_GRASPS or context.task.placed is not None:
        return None
    tried.append(holding)
    mine = tuple(h for h in tried if (h.robot, h.piece) == (holding.robot, holding.piece))
    return with_another_grasp(context, study, holding, mine)


def _still_valid(
    known: tuple[tuple[SkillCall, PlannedSkill], ...], calls: tuple[SkillCall, ...]
) -> Iterator[PlannedSkill]:
    """Yield the motions of the common beginning; a motion may depend on the call after it."""
    for k, (call, planned) in enumerate(known):
        is_same = k + 1 < len(calls) and calls[k] == call
        follows = k + 1 >= len(known) or (is_same and calls[k + 1] == known[k + 1][0])
        if not (is_same and follows) or k + 1 == len(known):
            return
        yield planned


def _blame(
    ports: PlanningPorts, view: SiteView, lessons: Lessons, watch: Stopwatch
) -> MinimalReason:
    """Return the fewest refusals that keep the target from being built."""

    def is_solvable(nogoods: Sequence[Nogood]) -> bool:
        geometry = with_nogoods(lessons.base, nogoods)
        problem = problem_for(ports.domain, replace(view, geometry=geometry))
        return not isinstance(ports.symbolic.plan(problem), NoPlan)

    watch.start()
    blame = to_blame(lessons.nogoods, is_solvable)
    watch.stop("symbolic")
    return blame


def _refused(
    problem: Problem,
    no: NoPlan,
    blame: MinimalReason,
    lessons: Lessons,
    notes: list[RefusalNote],
) -> TargetRefusal:
    """A proof over facts is one over the site only if every fact taken away was proven."""
    return TargetRefusal(
        problem=problem,
        reason=reason_for(problem.target, no.reason, blame),
        is_proven=no.is_proven and all(n.is_proven for n in lessons.nogoods),
        is_limit=not no.is_proven,
        notes=tuple(notes),
        removals=removals_of(blame),
    )


def _given_up(problem: Problem, reason: str, notes: list[RefusalNote]) -> TargetRefusal:
    return TargetRefusal(
        problem=problem, reason=reason, is_proven=False, is_limit=False, notes=tuple(notes)
    )


def _note(
    target: ComponentId, refused: SequenceRefusal, calls: tuple[SkillCall, ...]
) -> RefusalNote:
    refusal = refused.cause.refusal
    return RefusalNote(
        target=target,
        kind=type(refusal).__name__,
        reason=refused_call(refused, calls, scope="", attempt=1).evidence,
        is_proven=is_proof(refusal),
        is_replanned=True,
    )


def _study_note(target: ComponentId, refused: StudyRefusal) -> RefusalNote:
    return RefusalNote(
        target=target,
        kind=type(refused.refusal).__name__,
        reason=refused.nogood.evidence,
        is_proven=refused.nogood.is_proven,
    )
