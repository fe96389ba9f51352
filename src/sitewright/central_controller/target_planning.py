"""The loop plan - refuse - replan for one target: symbolic plan, motions, facts, again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from sitewright.central_controller.blame import to_blame
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.ports import RefusalNote
from sitewright.central_controller.target_outcome import (
    PlanPart,
    TargetPlan,
    TargetRefusal,
    given_up,
    no_plan_left,
    note_of_motion,
    notes_of_choices,
    notes_of_study,
)
from sitewright.foundation.clock import Clock
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.feedback import Lessons
from sitewright.planning_twin.kept_refusals import KeptRefusals
from sitewright.planning_twin.motion import PlanningBackends
from sitewright.planning_twin.refusal import NoPath
from sitewright.planning_twin.sequence import (
    PlannedSequence,
    SequenceRefusal,
    plan_sequence,
)
from sitewright.planning_twin.skill_motions.stage import PlannedSkill
from sitewright.planning_twin.study import Study, with_another_grasp
from sitewright.planning_twin.tacking import Holding
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.domain import Domain
from sitewright.symbolic_planning.nogood import Nogood, with_nogoods
from sitewright.symbolic_planning.planner import NoPlan, SymbolicPlanner
from sitewright.symbolic_planning.problem import Problem, problem_for
from sitewright.symbolic_planning.site_view import GeometricFacts, SiteView

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
        kept: Refusals of earlier calls, for as long as their geometry stays.
    """

    domain: Domain
    symbolic: SymbolicPlanner
    backends: PlanningBackends
    clock: Clock
    certifying_s: Callable[[], float] = field(default=lambda: 0.0)
    kept: KeptRefusals = field(default_factory=KeptRefusals)


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
    loop = _Loop(ports=ports, context=context, view=view, watch=watch, study=study)
    for _ in range(MOST_ROUNDS):
        outcome = loop.next_round()
        if outcome is not None:
            return outcome
    reason = Sentence(
        "{count} plans were refused by geometry; the last one: {last}",
        count=MOST_ROUNDS,
        last=loop.notes[-1].reason,
    )
    return loop.give_up(reason, is_limit=True)


@dataclass(slots=True, kw_only=True)
class _Loop:
    """The plan of one target while symbols and geometry do not agree yet.

    Attributes:
        tried: Grasps whose motions were refused.
        known: Motions of the last plan up to where it was refused.
    """

    ports: PlanningPorts
    context: TwinContext
    view: SiteView
    watch: Stopwatch
    study: Study
    lessons: Lessons = field(init=False)
    notes: list[RefusalNote] = field(default_factory=list)
    tried: list[Holding] = field(default_factory=list)
    known: tuple[tuple[SkillCall, PlannedSkill], ...] = ()
    _problem: Problem | None = None

    def __post_init__(self) -> None:
        studied = self.study
        self.lessons = Lessons(base=studied.base, nogoods=list(studied.nogoods))

    @property
    def problem(self) -> Problem:
        """The problem of the round."""
        if self._problem is None:
            self._problem = self._problem_with(self.lessons.facts)
        return self._problem

    def next_round(self) -> TargetPlan | TargetRefusal | None:
        """Plan once; None if there is something else to try."""
        self._problem = None
        with self.watch.timed("symbolic"):
            sequence = self.ports.symbolic.plan(self.problem)
        if isinstance(sequence, NoPlan):
            return self._refused(sequence)
        with self.watch.timed("motion"):
            result = self._motions(sequence.calls)
        if isinstance(result, PlannedSequence):
            part = PlanPart(problem=self.problem, sequence=sequence, motions=result)
            return TargetPlan(parts=(part,), notes=self._notes_of_plan(result))
        return self._go_on(result, sequence.calls)

    def give_up(self, reason: str, *, is_limit: bool = False) -> TargetRefusal:
        """Return the refusal after too many tries."""
        notes, candidates = self._all_notes(), self.view.candidates
        return given_up(self.problem, reason, notes, self.study, candidates, is_limit=is_limit)

    def _all_notes(self) -> tuple[RefusalNote, ...]:
        return (*notes_of_study(self.view.target, self.study), *self.notes)

    def _notes_of_plan(self, motions: PlannedSequence) -> tuple[RefusalNote, ...]:
        target, study = self.view.target, self.study
        chosen = notes_of_choices(target, study, self.context.site, motions)
        return (*notes_of_study(target, study, motions.calls), *self.notes, *chosen)

    def _problem_with(self, geometry: GeometricFacts) -> Problem:
        return problem_for(self.ports.domain, replace(self.view, geometry=geometry))

    def _motions(self, calls: tuple[SkillCall, ...]) -> PlannedSequence | SequenceRefusal:
        return plan_sequence(
            replace(self.context, seed=self.context.seed + self.lessons.new_seeds),
            self.study,
            calls,
            {robot: status.place for robot, status in self.view.robot_status.items()},
            known=tuple(_still_valid(self.known, calls)),
        )

    def _refused(self, no: NoPlan) -> TargetRefusal:
        def is_solvable(nogoods: Sequence[Nogood]) -> bool:
            problem = self._problem_with(with_nogoods(self.lessons.base, nogoods))
            return not isinstance(self.ports.symbolic.plan(problem), NoPlan)

        with self.watch.timed("symbolic"):
            blame = to_blame(self.lessons.nogoods, is_solvable)
            is_proven = self._is_proven(no)
        notes = self._all_notes()
        return no_plan_left(self.problem, no, blame, self.study, notes, is_proven=is_proven)

    def _is_proven(self, no: NoPlan) -> bool:
        """Tell whether the proven refusals alone leave no plan, proven by the planner of symbols.

        A proof over facts is one over the site only if every fact taken away was proven. Who is
        in whose way was found by collisions, and proves nothing.
        """
        base, nogoods = self.lessons.base, self.lessons.nogoods
        proven = [n for n in nogoods if n.is_proven]
        if len(proven) == len(nogoods) and not base.excludes:
            return no.is_proven
        problem = self._problem_with(with_nogoods(replace(base, excludes=frozenset()), proven))
        found = self.ports.symbolic.plan(problem)
        return isinstance(found, NoPlan) and found.is_proven

    def _go_on(
        self, refused: SequenceRefusal, calls: tuple[SkillCall, ...]
    ) -> TargetRefusal | None:
        """Take in a refused motion; return a refusal if nothing else is left to try."""
        searches = sum(n.kind == NoPath.__name__ for n in self.notes)
        is_search = isinstance(refused.cause.refusal, NoPath)
        if is_search and searches + 1 >= _MOST_SEARCHES:
            self._note(refused, calls, "")
            last = self.notes[-1].reason
            reason = Sentence(
                "{count} searches ended without a path; the last: {last}",
                count=_MOST_SEARCHES,
                last=last,
            )
            return self.give_up(reason, is_limit=True)
        with self.watch.timed("motion"):
            regrasped = _another_grasp(self.context, self.study, refused, self.tried)
        if regrasped is not None:
            self._note(refused, calls, Sentence("it is held differently"))
            self.study, self.known, self.lessons.base = regrasped, (), regrasped.base
            return None
        if self.lessons.learn(refused, calls):
            self._note(refused, calls, Sentence("the steps are ordered or shared out differently"))
            self.known = tuple(zip(calls[: refused.number], refused.planned, strict=True))
            return None
        self._note(refused, calls, "")
        last = self.notes[-1].reason
        return self.give_up(Sentence("{last}; no other order or robot avoids it", last=last))

    def _note(self, refused: SequenceRefusal, calls: tuple[SkillCall, ...], then: str) -> None:
        self.notes.append(note_of_motion(self.view.target, refused, calls, then))


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
