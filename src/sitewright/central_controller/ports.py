"""Ports of the run: who proposes, who approves, who checks again before a step starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Protocol

from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.ids import ComponentId, RunId, ZoneId
from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.moment import Moment
from sitewright.planning_twin.motion import Certificate
from sitewright.planning_twin.refusal import StaleCertificate
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.driver import Observation
from sitewright.robot_team.skill import SkillCall

PUT_OFF = "PutOff"
"""Kind of a refusal that is no planner's: a person wants the target later."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SiteContext:
    """What a planner starts from.

    Attributes:
        site: Fold of design and journal; `site.serial` goes into the proposal, and
            `site.rejections` are wishes to be respected.
        observation: The cell as sensed just now.
        again: How often the planner came back with a plan that was rejected.
    """

    run: RunId
    site: SiteState
    observation: Observation
    again: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class RefusalNote:
    """A refusal that was met while planning, in words.

    Attributes:
        kind: Class of the refusal, e.g. ``NoIk``, ``BlockedBy``, ``NoPlan``.
        is_replanned: A plan was refused by it and made anew; False for what the batch check found
            before there was a plan.
        blockers: The fewest things that are in the way, if things are.
        then: What was done instead; empty if nothing was left to do.
        pair: Two bodies that come too near to each other, if that is the reason.
        moment: Where the pair was seen, if it is known.
    """

    target: ComponentId
    kind: str
    reason: str
    is_proven: bool
    is_replanned: bool = False
    blockers: tuple[str, ...] = ()
    then: str = ""
    pair: tuple[str, ...] = ()
    moment: Moment | None = field(default=None, compare=False)

    @property
    def verdict(self) -> str:
        """How sure the "no" is, as `verdict_of` words it."""
        if self.kind == PUT_OFF:
            return Sentence("a person's wish")
        return verdict_of(self.blockers, is_proven=self.is_proven)


def verdict_of(blockers: Sequence[str], *, is_proven: bool) -> str:
    """Return which of three things a "no" is: proven, blocked by something, or not found."""
    if is_proven:
        return Sentence("proven impossible")
    if blockers:
        return Sentence("blocked by {things:and}", things=tuple(blockers))
    return Sentence("not found within budget")


@dataclass(frozen=True, slots=True, kw_only=True)
class Planned:
    """A proposal is ready.

    Attributes:
        attachments: Texts for the run folder's ``pddl/``: ``domain``, ``problem``, ``plan``.
        refusals: Those met on the way to it.
        waits: Targets that come before in the queue, and have no plan until this one is built.
        timing_s: ``symbolic``, ``motion``, ``certificate`` and ``total``.
    """

    proposal: Proposal
    attachments: Mapping[str, str] = field(default_factory=dict)
    refusals: tuple[RefusalNote, ...] = ()
    waits: tuple[ComponentId, ...] = ()
    timing_s: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class CounterProposal:
    """A change that was made on a copy of model, cell or site, and with which a plan was found.

    Attributes:
        words: What to change: ``move the stack at pallet-2 by 0.3 m towards kr120-a``.
        steps: Of the target's plan after the change, all motions certified.
        duration_s: Of that plan.
    """

    words: str
    steps: int
    duration_s: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Escalation:
    """The planner cannot go on with a target; a person is needed.

    Attributes:
        reason: The minimal reason and what would help, in sentences.
        exit_code: 4 proven that no plan exists, 5 a limit was reached, 6 no motion.
        blockers: The fewest things that are in the way, if things are.
        counter_proposals: What would help, tried on a copy.
    """

    target: ComponentId
    reason: str
    is_proven: bool
    exit_code: int = 6
    attachments: Mapping[str, str] = field(default_factory=dict)
    refusals: tuple[RefusalNote, ...] = ()
    timing_s: Mapping[str, float] = field(default_factory=dict)
    blockers: tuple[str, ...] = ()
    counter_proposals: tuple[CounterProposal, ...] = ()

    @property
    def verdict(self) -> str:
        """How sure the "no" is, as `verdict_of` words it."""
        return verdict_of(self.blockers, is_proven=self.is_proven)


@dataclass(frozen=True, slots=True)
class NothingToDo:
    """No target is left that is neither installed nor set aside."""


ProposalOutcome = Planned | Escalation | NothingToDo


@dataclass(frozen=True, slots=True, kw_only=True)
class Alternative:
    """Another skill call that could come next.

    Attributes:
        duration_s: Estimated time of the call.
        price_s: How much longer the whole target takes than by the proposal; None if the
            target cannot be reached any more after it, or if nobody has computed it.
        note: Why it is dear or leads nowhere; empty if there is nothing to say.
    """

    call: SkillCall
    duration_s: float = 0.0
    price_s: float | None = None
    leads_nowhere: bool = False
    note: str = ""


class ProposalSource(Protocol):
    """Makes proposals for the front target of the site."""

    def propose(
        self, context: SiteContext, *, exclude: frozenset[ComponentId] = frozenset()
    ) -> ProposalOutcome:
        """Plan the next target that is not in `exclude`, from the site as sensed.

        A target that has its piece in place and lacks operations, a piece in a gripper, and
        robots away from their stations are normal starts: plans go on from there.
        """
        ...

    def alternatives(self, context: SiteContext) -> tuple[Alternative, ...]:
        """Return the skill calls that are applicable now, the cheapest first."""
        ...

    def propose_single(self, context: SiteContext, call: SkillCall) -> ProposalOutcome:
        """Plan the motion of one chosen call as a proposal of one step."""
        ...


@dataclass(frozen=True, slots=True)
class StillClear:
    """The step's motions were certified again on the scene as sensed.

    Attributes:
        certificates: One for each motion.
        scenes: What each was made against, in the same order.
    """

    certificates: tuple[Certificate, ...]
    scenes: tuple[SceneSnapshot, ...] = ()


@dataclass(frozen=True, slots=True)
class FactsChanged:
    """Facts that the step relies on do not hold any more."""

    facts: tuple[str, ...]


class StartCheck(Protocol):
    """Checks a step once more on what is sensed, right before it starts."""

    def check(
        self, step: ProposedStep, context: SiteContext
    ) -> StillClear | StaleCertificate | FactsChanged:
        """Evaluate `relies_on` and certify the same motions on the scene built from `context`."""
        ...

    def strays(self, context: SiteContext) -> frozenset[ComponentId]:
        """Return the pieces that no plan counts on where they lie: fallen, or put aside.

        They are bodies in the scene and may be in the way, but their motion changes no fact.
        """
        ...


class ScopeKind(StrEnum):
    """How much of a proposal an approval covers."""

    PLAN = "plan"
    UNTIL = "until"
    STEP = "step"


@dataclass(frozen=True, slots=True)
class Scope:
    """All steps, the steps up to `step`, or just `step`."""

    kind: ScopeKind = ScopeKind.PLAN
    step: int = 0

    def covers(self, number: int) -> bool:
        """Return whether a step may run under this scope."""
        match self.kind:
            case ScopeKind.PLAN:
                return True
            case ScopeKind.UNTIL:
                return number <= self.step
            case ScopeKind.STEP:
                return number == self.step


@dataclass(frozen=True, slots=True, kw_only=True)
class ApprovalRequest:
    """What a person (or a policy) is asked.

    Attributes:
        proposal: All steps; those before `next_step` are done.
        fingerprint: SHA-256 of exactly what will run.
        code: Its check code for the eye, ``7KQ2-M9TD``.
        is_single: It is one chosen step; it is confirmed once and needs no other way.
        alternatives: Computes the other feasible actions when called (may take a second).
        refusals: Those met while planning.
        why: Why this is asked anew (deviation, expiry ...); empty the first time.
        site: As folded when it was asked.
    """

    proposal: Proposal
    fingerprint: str
    code: str
    next_step: int
    is_single: bool
    alternatives: Callable[[], tuple[Alternative, ...]]
    refusals: tuple[RefusalNote, ...] = ()
    why: str = ""
    site: SiteState = field(default_factory=SiteState)


START_WITHIN_S = 600.0
"""An approval whose first step has not started after 10 min is void, unless a policy says else."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Approve:
    """Yes, to the fingerprint that was shown.

    Attributes:
        fingerprint: The one that was shown; another one in memory makes the answer stale.
        who: Name of the person or policy.
        start_within_s: If its first step has not started by then, it is void.
    """

    fingerprint: str
    who: str
    scope: Scope = Scope()
    comment: str = ""
    decision: DecisionRecord | None = None
    start_within_s: float = START_WITHIN_S


@dataclass(frozen=True, slots=True, kw_only=True)
class Reject:
    """No; `reason` is one of the words of `Rejection`, `step` 0 is the whole plan."""

    who: str
    reason: str
    detail: str = ""
    step: int = 0
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class DoInstead:
    """One of the alternatives first; it comes back as a proposal of one step."""

    who: str
    call: SkillCall
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Hold:
    """Stop here; the next run goes on."""

    who: str
    reason: str = ""
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Mismatch:
    """A component of the model is not on the site as the model says; look before going on."""

    who: str
    component: str
    detail: str = ""
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawZone:
    """Keep out of a box from now on."""

    who: str
    size_m: Vector
    world_T_zone: Pose
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class RemoveZone:
    """A drawn box need not be kept out of any more."""

    who: str
    zone: ZoneId
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ByHand:
    """Work on a target was done by hand; `effects` are facts of `hand_facts`."""

    who: str
    target: ComponentId
    effects: tuple[str, ...]
    decision: DecisionRecord | None = None


ApprovalAnswer = Approve | Reject | DoInstead | Hold | Mismatch | DrawZone | RemoveZone | ByHand


class Answer(StrEnum):
    """What a person says about a skill whose outcome nobody knows."""

    DONE = "done"
    NOT_DONE = "not-done"
    PARTIAL = "partial"


@dataclass(frozen=True, slots=True, kw_only=True)
class Question:
    """An unknown outcome that only a person can settle.

    Attributes:
        step: Number of the step in its proposal, as ``sitewright resolve`` takes it.
        text: The question in one sentence.
    """

    question_id: str
    run: RunId
    step: int
    command_id: str
    call: SkillCall
    target: ComponentId
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Settled:
    """A person's answer to a question."""

    answer: Answer
    who: str = "operator"
    decision: DecisionRecord | None = None


class Approver(Protocol):
    """Who says yes or no."""

    def ask(self, request: ApprovalRequest) -> ApprovalAnswer:
        """Show a proposal and return the answer; blocks until there is one."""
        ...

    def answer(self, question: Question) -> Settled | None:
        """Ask about an unknown outcome; None if nobody is there to say (``auto`` never knows)."""
        ...
