"""Proposals for the front target: graph, batch check, symbolic plan and motions put together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.central_controller.choosing import choices_of_pieces, front_target
from sitewright.central_controller.counter_proposals import Adviser
from sitewright.central_controller.design import Design
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.other_ways import can_come_next, continuation, other_ways
from sitewright.central_controller.outcomes import (
    escalation,
    planned,
    proposal_of,
    proposed_steps,
    single_refused,
    standing_on_nothing,
    steps_of,
)
from sitewright.central_controller.ports import (
    Alternative,
    FactsChanged,
    NothingToDo,
    Planned,
    ProposalOutcome,
    SiteContext,
    StillClear,
)
from sitewright.central_controller.proposal import ProposedStep
from sitewright.central_controller.recovering import Recovery
from sitewright.central_controller.start_site import site_at_start
from sitewright.central_controller.statuses import strays
from sitewright.central_controller.surveying import GraphOf, Situation, Surveyor
from sitewright.central_controller.target_outcome import TargetRefusal
from sitewright.central_controller.target_planning import PlanningPorts
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.recheck import recertify
from sitewright.planning_twin.refusal import StaleCertificate
from sitewright.planning_twin.sequence import PlannedSequence, SequenceRefusal, plan_sequence
from sitewright.planning_twin.wording import in_words
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.problem import problem_for
from sitewright.symbolic_planning.reasons import facts_that_fail


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
        outcome = Recovery(surveyor=self.surveyor, target=target, watch=watch).plan(context)
        if isinstance(outcome, TargetRefusal):
            adviser = Adviser(surveyor=self.surveyor, target=target, watch=watch)
            helps = adviser.counter_proposals(context, outcome)
            return escalation(target, outcome, self._timing(watch, before_s), helps)
        timing_s = self._timing(watch, before_s)
        proposal = proposal_of(context, outcome.target, steps_of(outcome), self.identity)
        return planned(proposal, outcome, timing_s, target)

    @property
    def surveyor(self) -> Surveyor:
        """What looks at the site for the planners."""
        return Surveyor(
            design=self.design,
            shapes=self.shapes,
            ports=self.ports,
            graph_of=self.graph_of,
            seed=self.seed,
        )

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
        steps = proposed_steps(problem, first)
        proposal = proposal_of(context, target, steps, self.identity)
        return Planned(proposal=proposal, timing_s=timing_s)

    def check(
        self, step: ProposedStep, context: SiteContext
    ) -> StillClear | StaleCertificate | FactsChanged:
        """Evaluate what a step relies on, then prove its motions on the scene as sensed."""
        graph = self.graph_of(context)
        site = self.surveyor.jobsite(context)
        target = front_target(self.design, graph, context) or context.site.installed[-1]
        named = tuple(ComponentId(a) for a in step.call.arguments if a in self.shapes)
        view = self.surveyor.view(graph, context, site, target, named)
        missing = facts_that_fail(step.relies_on, view)
        if missing:
            return FactsChanged(facts=missing)
        proof = recertify(self.ports.backends.certifier, site_at_start(site, step), step.motions)
        if isinstance(proof, StaleCertificate):
            return proof
        return StillClear(tuple(p.certificate for p in proof), tuple(p.scene for p in proof))

    def strays(self, context: SiteContext) -> frozenset[ComponentId]:
        """Return the pieces of stock that lie at no stock place and are in no gripper."""
        return strays(self.graph_of(context), context)

    def _first_situation(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        target: ComponentId,
        watch: Stopwatch | None = None,
    ) -> Situation:
        candidates = choices_of_pieces(self.design, graph, context, target)[0]
        used = watch or Stopwatch(clock=self.ports.clock)
        return self.surveyor.situation(graph, context, target, candidates, used)

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
