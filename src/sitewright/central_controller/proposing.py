"""Proposals for the front target: graph, batch check, symbolic plan and motions put together."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from sitewright.central_controller.choosing import choices_of_pieces, front_target
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.other_ways import can_come_next, continuation, other_ways
from sitewright.central_controller.outcomes import (
    escalation,
    planned,
    proposal_of,
    single_refused,
    standing_on_nothing,
)
from sitewright.central_controller.ports import (
    Alternative,
    FactsChanged,
    NothingToDo,
    Planned,
    ProposalOutcome,
    RefusalNote,
    SiteContext,
    StillClear,
)
from sitewright.central_controller.proposal import ProposedStep
from sitewright.central_controller.situation import (
    Design,
    jobsite_of,
    task_of,
)
from sitewright.central_controller.statuses import lies_at, robot_statuses
from sitewright.central_controller.target_planning import (
    PlanningPorts,
    TargetPlan,
    TargetRefusal,
    plan_target,
)
from sitewright.central_controller.wishes import (
    another_seed,
    without_refused_robots,
)
from sitewright.construction_graph.graph import NOWHERE, ConstructionGraph, MaterialNode
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.planning_twin.jobsite import Jobsite, PieceShape
from sitewright.planning_twin.recheck import recertify
from sitewright.planning_twin.refusal import StaleCertificate
from sitewright.planning_twin.sequence import PlannedSequence, SequenceRefusal, plan_sequence
from sitewright.planning_twin.skill_motions.stage import with_opening
from sitewright.planning_twin.study import Study, study
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.wording import in_words
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.problem import problem_for
from sitewright.symbolic_planning.reasons import facts_that_fail
from sitewright.symbolic_planning.site_view import SiteView

GraphOf = Callable[[SiteContext], ConstructionGraph]


@dataclass(frozen=True, slots=True, kw_only=True)
class Situation:
    """Everything that is known about one target at one moment."""

    target: ComponentId
    twin: TwinContext
    study: Study
    view: SiteView


@dataclass(frozen=True, slots=True, kw_only=True)
class Proposals:
    """The proposal source and start check of a project (ports `ProposalSource`, `StartCheck`).

    Attributes:
        graph_of: The construction relationship graph of a folded site.
        identity: Hashes of team, cell, model and domain, for the fingerprint.
        seed: First seed of all motion searches.
        unsupported: Targets that would stand on nothing, with the reason; they are not placed.
    """

    design: Design
    shapes: Mapping[ComponentId, PieceShape]
    ports: PlanningPorts
    graph_of: GraphOf
    identity: Mapping[str, str]
    seed: int = 0
    unsupported: Mapping[ComponentId, str] = field(default_factory=dict)

    def propose(
        self, context: SiteContext, *, exclude: frozenset[ComponentId] = frozenset()
    ) -> ProposalOutcome:
        """Plan the front target of the queue, widening the choice of pieces if geometry refuses."""
        graph = self.graph_of(context)
        target = front_target(self.design, graph, context, exclude)
        if target is None:
            return NothingToDo()
        if target in self.unsupported:
            return standing_on_nothing(target, self.unsupported[target])
        watch, before_s = Stopwatch(clock=self.ports.clock), self.ports.certifying_s()
        notes: list[RefusalNote] = []
        first, *wider = choices_of_pieces(self.design, graph, context, target)
        outcome = self._outcome(graph, context, target, first, watch)
        for candidates in wider:
            if isinstance(outcome, TargetPlan):
                break
            notes += outcome.notes
            outcome = self._outcome(graph, context, target, candidates, watch)
        notes += outcome.notes
        timing_s = self._timing(watch, before_s)
        if isinstance(outcome, TargetRefusal):
            return escalation(target, outcome, notes, timing_s)
        proposal = proposal_of(context, target, outcome.problem, outcome.motions, self.identity)
        return planned(proposal, outcome, notes, timing_s)

    def _outcome(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        target: ComponentId,
        candidates: tuple[ComponentId, ...],
        watch: Stopwatch,
    ) -> TargetPlan | TargetRefusal:
        situation = self._situation(graph, context, target, candidates, watch)
        return plan_target(self.ports, situation.twin, situation.study, situation.view, watch)

    def alternatives(self, context: SiteContext) -> tuple[Alternative, ...]:
        """Return what could be done next instead, the cheapest first."""
        graph = self.graph_of(context)
        target = front_target(self.design, graph, context)
        if target is None:
            return ()
        situation = self._first_situation(graph, context, target)
        problem = problem_for(self.ports.domain, situation.view)
        start = {r: s.place for r, s in situation.view.robot_status.items()}

        def why_not(call: SkillCall, following: tuple[SkillCall, ...]) -> str:
            first = plan_first(situation, call, following, start)
            return in_words(first.cause.refusal) if isinstance(first, SequenceRefusal) else ""

        return other_ways(problem, self.ports.symbolic, why_not)

    def propose_single(self, context: SiteContext, call: SkillCall) -> ProposalOutcome:
        """Plan one chosen call, with the best continuation in mind.

        A call that is not applicable now is nothing to do.
        """
        graph = self.graph_of(context)
        target = front_target(self.design, graph, context)
        if target is None:
            return NothingToDo()
        watch, before_s = Stopwatch(clock=self.ports.clock), self.ports.certifying_s()
        situation = self._first_situation(graph, context, target, watch)
        problem = problem_for(self.ports.domain, situation.view)
        if not can_come_next(problem, call):
            return NothingToDo()
        following = continuation(problem, self.ports.symbolic, call)
        start = {r: s.place for r, s in situation.view.robot_status.items()}
        watch.start()
        first = plan_first(situation, call, following, start)
        watch.stop("motion")
        timing_s = self._timing(watch, before_s)
        if isinstance(first, SequenceRefusal):
            return single_refused(target, first, timing_s)
        proposal = proposal_of(context, target, problem, first, self.identity)
        return Planned(proposal=proposal, timing_s=timing_s)

    def check(
        self, step: ProposedStep, context: SiteContext
    ) -> StillClear | StaleCertificate | FactsChanged:
        """Evaluate what a step relies on, then prove its motions on the scene as sensed."""
        graph = self.graph_of(context)
        site = jobsite_of(self.design, self.shapes, context, self.ports.backends.kinematics)
        target = front_target(self.design, graph, context) or context.site.installed[-1]
        named = tuple(ComponentId(a) for a in step.call.arguments if a in self.shapes)
        view = self._view(graph, context, site, target, named)
        missing = facts_that_fail(step.relies_on, view)
        if missing:
            return FactsChanged(facts=missing)
        opening = step.params.get("aperture_m") if step.call.skill == Skill.REACH else None
        if isinstance(opening, float):
            site = with_opening(site, step.call.robot, opening)
        proof = recertify(self.ports.backends.certifier, site, step.motions)
        if isinstance(proof, StaleCertificate):
            return proof
        return StillClear(tuple(p.certificate for p in proof), tuple(p.scene for p in proof))

    def strays(self, context: SiteContext) -> frozenset[ComponentId]:
        """Return the pieces of stock that lie at no stock place and are in no gripper."""
        held = {robot.gripped for robot in context.observation.robots.values()}
        return frozenset(
            node.id
            for node in self.graph_of(context).node_by_id.values()
            if isinstance(node, MaterialNode) and node.place == NOWHERE and node.id not in held
        )

    def _first_situation(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        target: ComponentId,
        watch: Stopwatch | None = None,
    ) -> Situation:
        candidates = choices_of_pieces(self.design, graph, context, target)[0]
        used = watch or Stopwatch(clock=self.ports.clock)
        return self._situation(graph, context, target, candidates, used)

    def _situation(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        target: ComponentId,
        candidates: tuple[ComponentId, ...],
        watch: Stopwatch,
    ) -> Situation:
        site = jobsite_of(self.design, self.shapes, context, self.ports.backends.kinematics)
        task = task_of(self.design, graph, context, target, candidates)
        rejections = context.site.rejections
        seed = another_seed(self.seed, target, rejections)
        twin = TwinContext(backends=self.ports.backends, site=site, task=task, seed=seed)
        places = lies_at(graph, candidates)
        watch.start()
        studied = study(twin, places)
        watch.stop("motion")
        base = without_refused_robots(studied.base, target, rejections)
        studied = replace(studied, base=base)
        view = self._view(graph, context, site, target, candidates)
        return Situation(
            target=target, twin=twin, study=studied, view=replace(view, geometry=studied.facts)
        )

    def _view(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        site: Jobsite,
        target: ComponentId,
        candidates: tuple[ComponentId, ...],
    ) -> SiteView:
        in_hand = {arm.held for arm in site.arms.values()}
        loose = tuple(c for c in candidates if c not in in_hand)
        placed = context.site.placed
        return SiteView(
            graph=graph,
            cell=self.design.cell,
            target=target,
            candidates=candidates,
            robot_status=robot_statuses(self.design, context, site),
            lies_at=lies_at(graph, loose),
            in_place={t: p.piece for t, p in placed.items() if t not in context.site.installed},
            standing=context.site.standing,
            done_operations=context.site.done_operations,
            docked=dict(context.observation.docked),
        )

    def _timing(self, watch: Stopwatch, certifying_before_s: float) -> dict[str, float]:
        return watch.report(self.ports.certifying_s() - certifying_before_s)


def plan_first(
    situation: Situation,
    call: SkillCall,
    following: tuple[SkillCall, ...],
    start: Mapping[RobotId, str | None],
) -> PlannedSequence | SequenceRefusal:
    """Plan the motion of the first call only; what follows decides its freedoms."""
    return plan_sequence(
        situation.twin, situation.study, (call, *following), start, only_first=True
    )
