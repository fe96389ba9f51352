"""No order of events, with repeats and stale approvals, starts a step twice or unapproved."""

from __future__ import annotations

import json
from dataclasses import replace

import hypothesis.strategies as st
from hypothesis import settings
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from builders_run import KEY, A, B, SmallPlanner, design
from sitewright.central_controller.approval import START_DEADLINE_NS, Approval, sealed
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
        self.proposals.append(outcome.proposal)
        self.record(
            ProposalMade(
                fingerprint=fingerprint(outcome.proposal),
                target=outcome.proposal.target,
                site_serial=outcome.proposal.site_serial,
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
        approval = sealed(
            Approval(
                approval_id=self.fresh(),
                fingerprint=fingerprint(proposal),
                scope=Scope(kind, step),
                who="tester",
                given_utc_ns=given_ns,
                start_before_utc_ns=given_ns + START_DEADLINE_NS,
                nonce=self.fresh(),
            ),
            b"another key" if forged == "key" else KEY,
        )
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
    @rule(number=st.integers(1, 9), next_one=st.booleans(), away=st.sampled_from([0.0, 0.0, 0.02]))
    def a_step_wants_to_start(self, number: int, next_one: bool, away: float) -> None:
        proposal = self.proposals[-1]
        number = self.state.done + 1 if next_one else number
        if number > len(proposal.steps):
            return
        step, flight = proposal.steps[number - 1], self.state.flight
        now = at_start(step)
        if away:
            moved = {r: replace(s, q_rad=(s.q_rad[0] + away,)) for r, s in now.robots.items()}
            now = replace(now, robots=moved)
        verdict = may_start(step, proposal, self.state, now, key=KEY, now_utc_ns=self.now_ns)
        if isinstance(verdict, Refused):
            return
        self.check_granted(verdict, proposal, step)
        assert flight is None
        assert not (away and step.motions)
        self.record(
            SkillIntent(
                command_id=CommandId(self.fresh()),
                approval_id=verdict.approval.approval_id,
                step=number,
                fingerprint=fingerprint(proposal),
                target=proposal.target,
                call=step.call,
                params=step.params,
                effects=step.effects,
                epoch=1,
            )
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
        earlier = {n for d, n in self.started if d == digest}
        assert earlier == set(range(1, step.number)), "a step was skipped"
        self.started.append((digest, step.number))
        self.begun.add(approval_id)

    @rule(is_done=st.booleans(), is_late=st.booleans())
    def an_outcome_arrives(self, is_done: bool, is_late: bool) -> None:
        flight = self.state.flight
        if is_late or flight is None:
            self.record(
                SkillOutcome(command_id=CommandId("id-1"), report=SkillReport(is_done=True))
            )
        elif flight.phase is not Phase.ENDED:
            self.record(
                SkillOutcome(
                    command_id=flight.intent.command_id, report=SkillReport(is_done=is_done)
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


Cycle.TestCase.settings = settings(max_examples=60, stateful_step_count=25, deadline=None)
TestCycle = Cycle.TestCase
