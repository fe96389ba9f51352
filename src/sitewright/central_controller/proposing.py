"""Proposals for the front target: graph, batch check, symbolic plan and motions put together."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from sitewright.building_model.matching import fits, material_type_of
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.other_ways import can_come_next, continuation, other_ways
from sitewright.central_controller.ports import (
    Alternative,
    Escalation,
    FactsChanged,
    NothingToDo,
    Planned,
    ProposalOutcome,
    RefusalNote,
    SiteContext,
    StillClear,
)
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.situation import (
    Design,
    jobsite_of,
    lies_at,
    robot_statuses,
    target_node,
    task_of,
)
from sitewright.central_controller.target_planning import (
    PlanningPorts,
    TargetPlan,
    TargetRefusal,
    plan_target,
)
from sitewright.central_controller.wishes import (
    another_seed,
    put_off,
    wanted_pieces,
    without_refused_robots,
)
from sitewright.construction_graph.graph import NOWHERE, ConstructionGraph, MaterialNode
from sitewright.construction_graph.queries import accessible_materials, is_ready
from sitewright.construction_graph.queue import target_queue
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.planning_twin.jobsite import Jobsite, PieceShape
from sitewright.planning_twin.recheck import recertify
from sitewright.planning_twin.refusal import StaleCertificate
from sitewright.planning_twin.sequence import PlannedSequence, SequenceRefusal, plan_sequence
from sitewright.planning_twin.skill_motions.stage import with_opening
from sitewright.planning_twin.study import Study, study
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.wording import in_words
from sitewright.robot_team.cell import Capability
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.grounding import GroundAction
from sitewright.symbolic_planning.problem import Problem, problem_for
from sitewright.symbolic_planning.reasons import effects, facts_that_fail, relies_on
from sitewright.symbolic_planning.site_view import SiteView

GraphOf = Callable[[SiteContext], ConstructionGraph]

_NO_PLAN_PROVEN, _LIMIT, _NO_MOTION = 4, 5, 6


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
        target = self._front(graph, context, exclude)
        if target is None:
            return NothingToDo()
        if target in self.unsupported:
            return _standing_on_nothing(target, self.unsupported[target])
        watch, before_s = Stopwatch(clock=self.ports.clock), self.ports.certifying_s()
        notes: list[RefusalNote] = []
        pieces = self._pieces(graph, context, target)
        outcome: TargetPlan | TargetRefusal | None = None
        situation: Situation | None = None
        for candidates in pieces:
            situation = self._situation(graph, context, target, candidates, watch)
            outcome = plan_target(
                self.ports, situation.twin, situation.study, situation.view, watch
            )
            notes += outcome.notes
            if isinstance(outcome, TargetPlan):
                timing_s = self._timing(watch, before_s)
                return self._planned(context, situation, outcome, notes, timing_s)
        return self._escalation(target, graph, outcome, notes, self._timing(watch, before_s))

    def alternatives(self, context: SiteContext) -> tuple[Alternative, ...]:
        """Return what could be done next instead, the cheapest first."""
        graph = self.graph_of(context)
        target = self._front(graph, context, frozenset())
        if target is None:
            return ()
        situation = self._first_situation(graph, context, target)
        problem = problem_for(self.ports.domain, situation.view)
        start = {r: s.place for r, s in situation.view.robot_status.items()}

        def why_not(call: SkillCall, following: tuple[SkillCall, ...]) -> str:
            planned = plan_first(situation, call, following, start)
            if isinstance(planned, SequenceRefusal):
                return in_words(planned.cause.refusal)
            return ""

        return other_ways(problem, self.ports.symbolic, why_not)

    def propose_single(self, context: SiteContext, call: SkillCall) -> ProposalOutcome:
        """Plan one chosen call, with the best continuation in mind.

        A call that is not applicable now is nothing to do.
        """
        graph = self.graph_of(context)
        target = self._front(graph, context, frozenset())
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
        planned = plan_first(situation, call, following, start)
        watch.stop("motion")
        if isinstance(planned, SequenceRefusal):
            note = RefusalNote(
                target=target,
                kind=type(planned.cause.refusal).__name__,
                reason=in_words(planned.cause.refusal),
                is_proven=False,
            )
            return Escalation(target=target, reason=note.reason, is_proven=False, refusals=(note,))
        proposal = self._proposal(context, target, problem, planned)
        return Planned(proposal=proposal, timing_s=self._timing(watch, before_s))

    def check(
        self, step: ProposedStep, context: SiteContext
    ) -> StillClear | StaleCertificate | FactsChanged:
        """Evaluate what a step relies on, then prove its motions on the scene as sensed."""
        graph = self.graph_of(context)
        site = jobsite_of(self.design, self.shapes, context, self.ports.backends.kinematics)
        target = self._front(graph, context, frozenset()) or context.site.installed[-1]
        named = tuple(ComponentId(a) for a in step.call.arguments if a in self.shapes)
        view = self._view(graph, context, site, target, named)
        missing = facts_that_fail(step.relies_on, view)
        if missing:
            return FactsChanged(facts=missing)
        opening = step.params.get("aperture_m") if step.call.skill == Skill.REACH else None
        if isinstance(opening, float):
            site = with_opening(site, step.call.robot, opening)
        proof = recertify(self.ports.backends.certifier, site, step.motions)
        return proof if isinstance(proof, StaleCertificate) else StillClear(proof)

    def strays(self, context: SiteContext) -> frozenset[ComponentId]:
        """Return the pieces of stock that lie at no stock place and are in no gripper."""
        held = {robot.gripped for robot in context.observation.robots.values()}
        return frozenset(
            node.id
            for node in self.graph_of(context).node_by_id.values()
            if isinstance(node, MaterialNode) and node.place == NOWHERE and node.id not in held
        )

    def _front(
        self, graph: ConstructionGraph, context: SiteContext, exclude: frozenset[ComponentId]
    ) -> ComponentId | None:
        """Return the target to do next: one in progress, else the first ready one with a piece.

        A ready target whose piece is still buried waits for those that uncover it.
        """
        out = exclude | context.site.excluded | set(context.site.installed)
        waiting = [t for t in target_queue(graph) if t not in out]
        started = [t for t in waiting if t in context.site.placed]
        ready = [t for t in waiting if is_ready(graph, target_node(graph, t))]
        later = put_off(context.site.rejections)
        ready.sort(key=lambda t: (t in later, not self._is_in_hand(graph, context, t)))
        supplied = (t for t in ready if self._pieces(graph, context, t) != [()])
        return next(iter(started), None) or next(supplied, None) or next(iter(ready), None)

    def _is_in_hand(
        self, graph: ConstructionGraph, context: SiteContext, target: ComponentId
    ) -> bool:
        return bool(self._held(graph, context, target))

    def _held(
        self, graph: ConstructionGraph, context: SiteContext, target: ComponentId
    ) -> tuple[ComponentId, ...]:
        """Return the pieces in grippers that could become a target."""
        wanted = target_node(graph, target).material_type
        held = {r.gripped for r in context.observation.robots.values()}
        components = (self.design.component(p) for p in self.shapes if p in held)
        return tuple(c.id for c in components if fits(material_type_of(c), wanted))

    def _pieces(
        self, graph: ConstructionGraph, context: SiteContext, target: ComponentId
    ) -> list[tuple[ComponentId, ...]]:
        """Return choices of pieces: the one in place or in hand, else nearest, then all."""
        placed = context.site.placed.get(target)
        if placed is not None:
            return [(placed.piece,)]
        node = target_node(graph, target)
        found = [m.id for m in accessible_materials(graph, node)]
        accessible = wanted_pieces(found, context.site.rejections)
        if held := self._held(graph, context, target):
            return [held]
        ordered = sorted(accessible, key=lambda m: (self._distance(context, m), m))
        return [tuple(ordered[:k]) for k in range(1, len(ordered) + 1)] or [()]

    def _distance(self, context: SiteContext, piece: ComponentId) -> float:
        """Return the distance to the nearest robot that may grasp (base to middle of the box)."""
        pose = context.observation.world_T_piece.get(piece)
        robots = self.design.cell.robot_by_id.values()
        bases = [r.world_T_base for r in robots if Capability.GRASPING in r.can]
        if pose is None or not bases:
            return float("inf")
        return min(pose.distance_to_m(b) for b in bases)

    def _first_situation(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        target: ComponentId,
        watch: Stopwatch | None = None,
    ) -> Situation:
        candidates = self._pieces(graph, context, target)[0]
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

    def _planned(
        self,
        context: SiteContext,
        situation: Situation,
        plan: TargetPlan,
        notes: Sequence[RefusalNote],
        timing_s: Mapping[str, float],
    ) -> Planned:
        return Planned(
            proposal=self._proposal(context, situation.target, plan.problem, plan.motions),
            attachments={
                "domain": self.ports.domain.text,
                "problem": plan.problem.text,
                "plan": plan.sequence.text,
            },
            refusals=tuple(dict.fromkeys(notes)),
            timing_s=timing_s,
        )

    def _proposal(
        self,
        context: SiteContext,
        target: ComponentId,
        problem: Problem,
        motions: PlannedSequence,
    ) -> Proposal:
        pairs = zip(motions.calls, motions.skills, strict=True)
        steps = tuple(
            ProposedStep(
                number=number,
                call=call,
                params={**skill.params, "contacts": [list(c) for c in skill.declared_contacts()]},
                motions=skill.motions,
                duration_s=skill.act_s + sum(m.timed.trajectory.duration_s for m in skill.motions),
                relies_on=_relied_on(problem, problem.action(call)),
                effects=_effects(problem, problem.action(call)),
                contacts=skill.declared_contacts(),
            )
            for number, (call, skill) in enumerate(pairs, start=1)
        )
        return Proposal(
            run=context.run,
            target=target,
            steps=steps,
            site_serial=context.site.serial,
            context=dict(self.identity),
        )

    def _escalation(
        self,
        target: ComponentId,
        graph: ConstructionGraph,
        outcome: TargetPlan | TargetRefusal | None,
        notes: Sequence[RefusalNote],
        timing_s: Mapping[str, float],
    ) -> Escalation:
        if not isinstance(outcome, TargetRefusal):
            node = target_node(graph, target)
            raise TypeError(f"{target} ({node.type}) was neither planned nor refused")
        code = _NO_PLAN_PROVEN if outcome.is_proven else _NO_MOTION
        return Escalation(
            target=target,
            reason=outcome.reason,
            is_proven=outcome.is_proven,
            exit_code=_LIMIT if outcome.is_limit else code,
            attachments={"domain": self.ports.domain.text, "problem": outcome.problem.text},
            refusals=tuple(dict.fromkeys(notes)),
            timing_s=timing_s,
        )


def _standing_on_nothing(target: ComponentId, reason: str) -> Escalation:
    note = RefusalNote(target=target, kind="Unsupported", reason=reason, is_proven=True)
    return Escalation(target=target, reason=reason, is_proven=True, refusals=(note,))


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


def _relied_on(problem: Problem, action: GroundAction | None) -> tuple[str, ...]:
    return () if action is None else relies_on(problem, action)


def _effects(problem: Problem, action: GroundAction | None) -> tuple[str, ...]:
    return () if action is None else effects(problem, action)
