"""No order of events, with repeats and stale approvals, starts a step twice or unapproved."""

from __future__ import annotations

import json
from dataclasses import replace

import hypothesis.strategies as st
from hypothesis import settings
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from builders_run import KEY, A, B, SmallPlanner, design
from sitewright.central_controller.approval import Approval, sealed
from sitewright.central_controller.cycle import advance, folded
from sitewright.central_controller.cycle_state import CycleState, Phase
from sitewright.central_controller.events import (
    AnyEvent,
    ApprovalGiven,
    ApprovalRefused,
    DeviationSeen,
    EpochOpened,
    LinkLost,
    ProposalMade,
    ProposalSuperseded,
    QuestionAnswered,
    RunResumed,
    RunStarted,
    SiteObserved,
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
    event_from_json,
    event_to_json,
)
from sitewright.central_controller.fingerprint import fingerprint
from sitewright.central_controller.guard import Granted, Refused, may_start
from sitewright.central_controller.ports import (
    START_WITHIN_S,
    Answer,
    Planned,
    Scope,
    ScopeKind,
    SiteContext,
)
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.foundation.canonical import canonical_json
from sitewright.foundation.ids import CommandId, ComponentId, RobotId, RunId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.driver import Observation, RobotObservation, SkillReport

RUN = RunId("run-1")


def seen(q_rad: dict[RobotId, float]) -> Observation:
    robots = {
        r: RobotObservation(q_rad=(q,), velocity_rad_s=(0.0,), mounted=None)
        for r, q in q_rad.items()
    }
    piece = ComponentId("piece-1")
    return Observation(time_s=0.0, robots=robots, world_T_piece={piece: Pose((-1.0, 0.0, 0.3))})


def at_start(step: ProposedStep) -> Observation:
    q_rad = {A: 0.0, B: 0.0}
    for motion in step.motions:
        q_rad[motion.timed.trajectory.robot] = motion.timed.trajectory.start_rad[0]
    return seen(q_rad)


def elsewhere(step: ProposedStep) -> Observation:
    now = at_start(step)
    away = {r: replace(s, q_rad=(s.q_rad[0] + 0.02,)) for r, s in now.robots.items()}
    return replace(now, robots=away)


class Cycle(RuleBasedStateMachine):
    def __init__(self) -> None:
        super().__init__()
        self.state = CycleState(site=design(targets=1))
        self.stored: list[tuple[str, int, str]] = []
        self.now_ns, self.count = 1_000, 0
        self.proposals: list[Proposal] = []
        self.given: dict[str, tuple[str, Scope, int]] = {}
        self.begun: set[str] = set()
        self.started: list[tuple[str, int]] = []
        self.record(RunStarted(run=RUN, project="p", hashes={}))
        self.record(EpochOpened(epoch=1))

    def record(self, event: AnyEvent) -> None:
        self.state, _ = advance(self.state, event)
        self.stored.append((event.kind, event.version, canonical_json(event_to_json(event))))

    def fresh(self) -> str:
        self.count += 1
        return f"id-{self.count}"

    @rule()
    def a_proposal_is_made(self) -> None:
        context = SiteContext(run=RUN, site=self.state.site, observation=seen({A: 0.0, B: 0.0}))
        outcome = SmallPlanner().propose(context)
        if self.state.flight is not None or not isinstance(outcome, Planned):
            return
        which = {"which": str(len(self.proposals))}
        proposal = replace(outcome.proposal, context=which)
        self.proposals.append(proposal)
        self.record(
            ProposalMade(
                fingerprint=fingerprint(proposal),
                target=proposal.target,
                site_serial=proposal.site_serial,
                steps=(),
            )
        )

    @precondition(lambda self: self.proposals)
    @rule(
        which=st.integers(0, 3),
        kind=st.sampled_from(ScopeKind),
        step=st.integers(1, 9),
        forged=st.sampled_from(["", "", "", "mac", "scope", "key"]),
        age_s=st.sampled_from([0, 0, 0, 500]),
    )
    def an_approval_arrives(
        self, which: int, kind: ScopeKind, step: int, forged: str, age_s: int
    ) -> None:
        """For this or an older proposal, genuine or forged."""
        proposal = self.proposals[-1 - which % len(self.proposals)]
        given_ns = self.now_ns - age_s * 1_000_000_000
        approval = self.approval(proposal, Scope(kind, step), given_ns)
        if forged == "key":
            approval = sealed(approval, b"another key")
        if forged == "mac":
            approval = replace(approval, mac="0" * 64)
        if forged == "scope":
            approval = replace(approval, scope=Scope(ScopeKind.PLAN, 77))
        if not forged:
            self.given[approval.approval_id] = (
                approval.fingerprint,
                approval.scope,
                approval.start_before_utc_ns,
            )
        self.record(ApprovalGiven(approval=approval))

    @precondition(lambda self: self.proposals)
    @rule()
    def the_next_step_starts_if_it_may(self) -> None:
        proposal, number = self.proposals[-1], self.state.done + 1
        if number > len(proposal.steps):
            return
        step = proposal.steps[number - 1]
        verdict = self.verdict(step, proposal, at_start(step))
        if isinstance(verdict, Refused):
            return
        approval_id = verdict.approval.approval_id
        self.check_granted(verdict, proposal, step)
        self.started.append((fingerprint(proposal), number))
        self.begun.add(approval_id)
        self.record(
            SkillIntent(
                command_id=CommandId(self.fresh()),
                approval_id=approval_id,
                step=number,
                fingerprint=fingerprint(proposal),
                target=proposal.target,
                call=step.call,
                params=step.params,
                effects=step.effects,
                epoch=1,
            )
        )

    @precondition(lambda self: self.state.flight is None)
    @rule(steps=st.integers(1, 4))
    def all_goes_well_for_some_steps(self, steps: int) -> None:
        if self.state.proposal is None or self.state.site.serial != self.proposals[-1].site_serial:
            self.a_proposal_is_made()
        self.an_approval_arrives(0, ScopeKind.PLAN, 1, "", 0)
        for _ in range(steps):
            self.the_next_step_starts_if_it_may()
            self.an_outcome_arrives("done")
            if self.state.flight is not None:
                self.effects_are_looked_at()

    @invariant()
    def whatever_may_start_is_in_order(self) -> None:
        """Try the steps around the next one, of the open and of an older proposal."""
        for proposal in self.proposals[-1:] + self.proposals[-2:-1]:
            for step in proposal.steps[max(0, self.state.done - 1) : self.state.done + 2]:
                verdict = self.verdict(step, proposal, at_start(step))
                if isinstance(verdict, Granted):
                    self.check_granted(verdict, proposal, step)
                    self.nearly_the_same_is_refused(step, proposal)

    @invariant()
    def nothing_starts_beside_a_running_step(self) -> None:
        """Not even under an approval that is given at this moment."""
        if self.state.flight is None or self.state.proposal is None:
            return
        proposal = self.proposals[-1]
        fresh = replace(self.state, approval=self.approval(proposal, Scope(), self.now_ns))
        for step in proposal.steps[: self.state.done + 2]:
            assert isinstance(self.verdict(step, proposal, at_start(step), fresh), Refused)

    def nearly_the_same_is_refused(self, step: ProposedStep, proposal: Proposal) -> None:
        now = at_start(step)
        assert not step.motions or isinstance(
            self.verdict(step, proposal, elsewhere(step)), Refused
        )
        changed = replace(step, duration_s=step.duration_s + 1.0)
        steps = tuple(changed if s is step else s for s in proposal.steps)
        assert isinstance(self.verdict(changed, replace(proposal, steps=steps), now), Refused)
        assert isinstance(self.verdict(changed, proposal, now), Refused)
        for other in (
            self.approval(replace(proposal, run="run-2"), Scope(), self.now_ns),
            self.approval(proposal, Scope(ScopeKind.STEP, step.number + 1), self.now_ns),
            self.approval(proposal, Scope(ScopeKind.UNTIL, step.number - 1), self.now_ns),
        ):
            state = replace(self.state, approval=other)
            assert isinstance(self.verdict(step, proposal, now, state), Refused)
        approval = self.state.approval
        assert approval is not None
        if approval.approval_id not in self.begun:
            late_ns = approval.start_before_utc_ns + 1
            verdict = may_start(step, proposal, self.state, now, key=KEY, now_utc_ns=late_ns)
            assert isinstance(verdict, Refused)

    def verdict(
        self,
        step: ProposedStep,
        proposal: Proposal,
        now: Observation,
        state: CycleState | None = None,
    ) -> Granted | Refused:
        state = state or self.state
        return may_start(step, proposal, state, now, key=KEY, now_utc_ns=self.now_ns)

    def approval(self, proposal: Proposal, scope: Scope, given_ns: int) -> Approval:
        return sealed(
            Approval(
                approval_id=self.fresh(),
                fingerprint=fingerprint(proposal),
                scope=scope,
                who="tester",
                given_utc_ns=given_ns,
                start_before_utc_ns=given_ns + round(START_WITHIN_S * 1e9),
                nonce=self.fresh(),
            ),
            KEY,
        )

    def check_granted(self, verdict: Granted, proposal: Proposal, step: ProposedStep) -> None:
        """Compare the guard's yes with the test's own books."""
        approval_id, digest = verdict.approval.approval_id, fingerprint(proposal)
        assert approval_id in self.given, "a forged approval was taken"
        approved, scope, deadline_ns = self.given[approval_id]
        assert approved == digest, "an approval of another plan was taken"
        assert scope.covers(step.number)
        assert approval_id in self.begun or self.now_ns <= deadline_ns
        assert (digest, step.number) not in self.started, "a step was started twice"
        assert proposal.site_serial == self.state.site.serial
        earlier = {n for which, n in self.started if which == digest}
        assert earlier == set(range(1, step.number)), "a step was skipped"
        assert self.state.flight is None, "a step was started while another one ran"

    @rule(how=st.sampled_from(["done", "failed", "late"]))
    def an_outcome_arrives(self, how: str) -> None:
        flight = self.state.flight
        if how == "late" or flight is None:
            self.record(
                SkillOutcome(command_id=CommandId("id-1"), report=SkillReport(is_done=True))
            )
        elif flight.phase is not Phase.ENDED:
            self.record(
                SkillOutcome(
                    command_id=flight.intent.command_id, report=SkillReport(is_done=how == "done")
                )
            )

    @precondition(lambda self: self.state.flight is not None)
    @rule()
    def effects_are_looked_at(self) -> None:
        flight = self.state.flight
        assert flight is not None
        if flight.phase is not Phase.ENDED:
            return
        if flight.report is None or not flight.report.is_done:
            self.lose_proposal()
        self.record(SiteObserved(time_s=1.0, after=flight.intent.command_id))

    def lose_proposal(self) -> None:
        if self.state.proposal is not None:
            digest = self.state.proposal.fingerprint
            self.record(ProposalSuperseded(fingerprint=digest, reason="r", at_utc_ns=self.now_ns))

    @rule()
    def the_site_deviates(self) -> None:
        self.record(DeviationSeen(level=2, subject="piece-1", what="moved"))

    @rule()
    def the_controller_restarts(self) -> None:
        self.record(RunResumed())
        self.record(EpochOpened(epoch=self.state.epoch + 1))

    @rule(verdict=st.sampled_from(["never", "not-done", "unknown"]))
    def a_command_is_reconciled(self, verdict: str) -> None:
        self.record(LinkLost(reason="gone"))
        flight = self.state.flight
        if flight is not None and flight.phase is Phase.UNCERTAIN:
            command_id = flight.intent.command_id
            self.record(SkillReconciled(command_id=command_id, verdict=verdict, evidence="e"))

    @rule(answer=st.sampled_from(Answer))
    def a_person_answers(self, answer: Answer) -> None:
        flight = self.state.flight
        if flight is not None and flight.phase is Phase.UNKNOWN:
            self.record(QuestionAnswered(question_id="q", answer=answer, who="tester"))

    @rule(minutes=st.sampled_from([1, 6, 11]))
    def time_passes(self, minutes: int) -> None:
        self.now_ns += minutes * 60_000_000_000

    @rule()
    def an_approval_is_refused(self) -> None:
        self.record(ApprovalRefused(approval_id="x", fingerprint="y", step=1, reason="r"))

    @invariant()
    def replay_gives_the_live_state(self) -> None:
        state = CycleState(site=design(targets=1))
        for kind, version, text in self.stored:
            state = folded(state, event_from_json(kind, version, json.loads(text)))
        assert canonical_json(repr(state)) == canonical_json(repr(_as_stored(self.state)))


def _as_stored(state: CycleState) -> CycleState:
    """Tuples in free parameters come back as lists; that is the only difference."""
    if state.flight is None:
        return state
    intent = state.flight.intent
    params = json.loads(canonical_json(intent.params))
    return replace(state, flight=replace(state.flight, intent=replace(intent, params=params)))


Cycle.TestCase.settings = settings(max_examples=40, stateful_step_count=20, deadline=None)
TestCycle = Cycle.TestCase
