"""Everything that can happen in a run: a closed union of frozen events with kind and version."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar, get_args

from sitewright.central_controller.approval import Approval
from sitewright.central_controller.codec import DecodeError, from_json, to_json
from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.ports import Answer, CounterProposal, Question, RefusalNote
from sitewright.central_controller.site_state import DrawnZone, Rejection
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import (
    CommandId,
    ComponentId,
    EndEffectorId,
    OperationId,
    RobotId,
    RunId,
    StationId,
    ZoneId,
)
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.motion import Certificate
from sitewright.robot_team.driver import FastenerObservation, RobotObservation, SkillReport
from sitewright.robot_team.skill import SkillCall


@dataclass(frozen=True, slots=True, kw_only=True)
class RunStarted:
    """A run began; with a previous run its site is where that one left it.

    Attributes:
        previous_head: Hash of the previous run's last event, as hex.
        hashes: SHA-256 of model, cell, domain ..., and the software version.
        who: Who asked for it at a page; empty if it was the command line.
    """

    kind: ClassVar[str] = "run_started"
    version: ClassVar[int] = 2
    run: RunId
    project: str
    hashes: Mapping[str, str]
    previous_run: str = ""
    previous_head: str = ""
    who: str = ""
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class RunResumed:
    """The command was given again for an open run; a started skill is uncertain from here."""

    kind: ClassVar[str] = "run_resumed"
    version: ClassVar[int] = 2
    who: str = ""
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class DesignChanged:
    """The building is another one from here on; a plan made of the old one is dead.

    Attributes:
        old_sha256: Of the design's file until now.
        model_sha256: Of the design's file from now on.
        reopened: Installed components that got new operations: they stand, but are not done.
        gone: Pieces of stock that the design has no more; nobody misses them.
    """

    kind: ClassVar[str] = "design_changed"
    version: ClassVar[int] = 1
    old_sha256: str
    model_sha256: str
    reopened: tuple[ComponentId, ...] = ()
    gone: tuple[ComponentId, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class EpochOpened:
    """The cell was (re)connected; commands of older epochs are refused by it."""

    kind: ClassVar[str] = "epoch_opened"
    version: ClassVar[int] = 1
    epoch: int


@dataclass(frozen=True, slots=True, kw_only=True)
class LinkLost:
    """The cell did not answer; a skill that was under way is uncertain."""

    kind: ClassVar[str] = "link_lost"
    version: ClassVar[int] = 1
    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class SiteObserved:
    """What was sensed, as difference to the observation recorded before.

    Attributes:
        after: Command whose effects were looked at; its step is closed by this event.
        gone: Pieces that are seen no more.
        lost_fasteners: Fasteners that are sensed no more.
    """

    kind: ClassVar[str] = "site_observed"
    version: ClassVar[int] = 1
    time_s: float
    after: str = ""
    robots: Mapping[RobotId, RobotObservation] = field(default_factory=dict)
    world_T_piece: Mapping[ComponentId, Pose] = field(default_factory=dict)
    gone: tuple[ComponentId, ...] = ()
    fasteners: tuple[FastenerObservation, ...] = ()
    lost_fasteners: tuple[OperationId, ...] = ()
    coverage: Mapping[OperationId, float] = field(default_factory=dict)
    docked: Mapping[EndEffectorId, StationId] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class DeviationSeen:
    """Sensed differs from expected by more than the tolerance.

    Attributes:
        level: 1 small, 2 a new symbolic plan is needed, 3 a person is needed.
        subject: Component, robot or operation that it is about.
        after: Command after which it was seen; empty if nothing was moving.
    """

    kind: ClassVar[str] = "deviation_seen"
    version: ClassVar[int] = 1
    level: int
    subject: str
    what: str
    after: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetSelected:
    """The planner took up a target."""

    kind: ClassVar[str] = "target_selected"
    version: ClassVar[int] = 1
    target: ComponentId


@dataclass(frozen=True, slots=True, kw_only=True)
class RefusalMet:
    """A planner's "no" that planning went on from."""

    kind: ClassVar[str] = "refusal_met"
    version: ClassVar[int] = 1
    refusal: RefusalNote


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetRefused:
    """All that the planner knows was tried; the target is set aside for this run."""

    kind: ClassVar[str] = "target_refused"
    version: ClassVar[int] = 1
    target: ComponentId
    reason: str
    is_proven: bool
    exit_code: int
    timing_s: Mapping[str, float] = field(default_factory=dict)
    blockers: tuple[str, ...] = ()
    counter_proposals: tuple[CounterProposal, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetWaits:
    """A target has no plan before another one is built, and has one afterwards."""

    kind: ClassVar[str] = "target_waits"
    version: ClassVar[int] = 1
    target: ComponentId
    until: ComponentId


@dataclass(frozen=True, slots=True, kw_only=True)
class StepSummary:
    """One line of a proposal, for whoever reads the journal."""

    number: int
    call: SkillCall
    duration_s: float
    trajectories: int
    closest_distance_m: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class ProposalMade:
    """A proposal is in the run folder under its fingerprint.

    Attributes:
        is_single: One chosen step, not a whole plan.
        timing_s: Planning times: symbolic, motion, certificate, total.
    """

    kind: ClassVar[str] = "proposal_made"
    version: ClassVar[int] = 1
    fingerprint: str
    target: ComponentId
    site_serial: int
    steps: tuple[StepSummary, ...]
    is_single: bool = False
    timing_s: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class ProposalSuperseded:
    """The open proposal cannot go on; a new plan is made.

    Attributes:
        is_replan: Counts against the limit of replans per target.
        at_utc_ns: When, for the limit of replans in a time.
    """

    kind: ClassVar[str] = "proposal_superseded"
    version: ClassVar[int] = 1
    fingerprint: str
    reason: str
    is_replan: bool = True
    at_utc_ns: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class ApprovalGiven:
    """A person or policy approved a scope of the open proposal."""

    kind: ClassVar[str] = "approval_given"
    version: ClassVar[int] = 2
    approval: Approval
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ApprovalRefused:
    """The guard did not let an approved step start; the approval is void."""

    kind: ClassVar[str] = "approval_refused"
    version: ClassVar[int] = 1
    approval_id: str
    fingerprint: str
    step: int
    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ApprovalRejected:
    """A person said no to the open proposal."""

    kind: ClassVar[str] = "approval_rejected"
    version: ClassVar[int] = 2
    who: str
    rejection: Rejection
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class AlternativeChosen:
    """A person chose another feasible action instead of the next step."""

    kind: ClassVar[str] = "alternative_chosen"
    version: ClassVar[int] = 2
    who: str
    fingerprint: str
    call: SkillCall
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class AlternativeRefused:
    """The chosen action has no motion; the plan goes on without it."""

    kind: ClassVar[str] = "alternative_refused"
    version: ClassVar[int] = 1
    call: SkillCall
    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoneDrawn:
    """A person drew a box that robots and pieces keep out of from now on."""

    kind: ClassVar[str] = "zone_drawn"
    version: ClassVar[int] = 1
    zone: DrawnZone
    who: str
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoneRemoved:
    """A person took a drawn zone away."""

    kind: ClassVar[str] = "zone_removed"
    version: ClassVar[int] = 1
    zone: ZoneId
    who: str
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class DoneByHand:
    """A person says that work on a target was done by hand, effect by effect.

    Attributes:
        effects: Facts that the person vouches for; events of their own carry them out.
    """

    kind: ClassVar[str] = "done_by_hand"
    version: ClassVar[int] = 1
    target: ComponentId
    effects: tuple[str, ...]
    who: str
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillIntent:
    """A step is about to start; written and synced before the driver hears of it.

    Attributes:
        trajectories: SHA-256 of each trajectory.
        closest_distance_m: Of the certificates made at start on the sensed scene.
        certificates: How many motions were certified again at start.
        confirmed: How many motions the independent engine had confirmed.
        scene_revision: Sensed scene of the last certificate.
        proofs: The certificates made at start; their scenes are in the run's blobs, named by
            their revisions.
    """

    kind: ClassVar[str] = "skill_intent"
    version: ClassVar[int] = 1
    command_id: CommandId
    approval_id: str
    step: int
    fingerprint: str
    target: ComponentId
    call: SkillCall
    params: Mapping[str, Json]
    effects: tuple[str, ...]
    epoch: int
    trajectories: tuple[str, ...] = ()
    certificates: int = 0
    confirmed: int = 0
    closest_distance_m: float | None = None
    scene_revision: str = ""
    proofs: tuple[Certificate, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillOutcome:
    """A skill ended as reported by the driver (or later by its ledger, or by the sensors)."""

    kind: ClassVar[str] = "skill_outcome"
    version: ClassVar[int] = 1
    command_id: CommandId
    report: SkillReport
    source: str = "driver"


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillReconciled:
    """What became of a skill without outcome.

    Attributes:
        verdict: ``never`` (may be issued again), ``not-done`` (plan from what is sensed) or
            ``unknown`` (a person must say).
    """

    kind: ClassVar[str] = "skill_reconciled"
    version: ClassVar[int] = 1
    command_id: CommandId
    verdict: str
    evidence: str


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillReissued:
    """The same command goes out again; the ledger said that it never started.

    Attributes:
        proofs: As in `SkillIntent`; made anew.
    """

    kind: ClassVar[str] = "skill_reissued"
    version: ClassVar[int] = 1
    command_id: CommandId
    epoch: int
    proofs: tuple[Certificate, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class ComponentPositioned:
    """A piece was sensed at a target's pose."""

    kind: ClassVar[str] = "component_positioned"
    version: ClassVar[int] = 1
    target: ComponentId
    piece: ComponentId
    robot: RobotId
    world_T_wanted: Pose
    world_T_measured: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class ComponentStanding:
    """A target was released and stands without a robot."""

    kind: ClassVar[str] = "component_standing"
    version: ClassVar[int] = 1
    target: ComponentId


@dataclass(frozen=True, slots=True, kw_only=True)
class OperationDone:
    """A fastener is in, or a finish is on.

    Attributes:
        by: ``sensed``, or ``person`` if a person answered for it.
    """

    kind: ClassVar[str] = "operation_done"
    version: ClassVar[int] = 1
    operation: OperationId
    target: ComponentId
    robot: RobotId
    by: str = "sensed"


@dataclass(frozen=True, slots=True, kw_only=True)
class ComponentInstalled:
    """A target stands, has all its operations and was measured."""

    kind: ClassVar[str] = "component_installed"
    version: ClassVar[int] = 1
    target: ComponentId
    piece: ComponentId
    robot: RobotId
    world_T_wanted: Pose
    world_T_measured: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class ComponentDisplaced:
    """A positioned piece that was not standing yet is not at its target any more."""

    kind: ClassVar[str] = "component_displaced"
    version: ClassVar[int] = 1
    target: ComponentId
    piece: ComponentId


@dataclass(frozen=True, slots=True, kw_only=True)
class QuestionAsked:
    """Only a person can say what happened; nothing moves until then."""

    kind: ClassVar[str] = "question_asked"
    version: ClassVar[int] = 1
    question: Question


@dataclass(frozen=True, slots=True, kw_only=True)
class QuestionAnswered:
    """A person settled an unknown outcome."""

    kind: ClassVar[str] = "question_answered"
    version: ClassVar[int] = 2
    question_id: str
    answer: Answer
    who: str
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class RunHeld:
    """The run stops here but stays open; the next `run` goes on."""

    kind: ClassVar[str] = "run_held"
    version: ClassVar[int] = 2
    reason: str
    exit_code: int
    who: str = ""
    decision: DecisionRecord | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class RunFinished:
    """Nothing is left to do in this run: all targets are installed or set aside."""

    kind: ClassVar[str] = "run_finished"
    version: ClassVar[int] = 1
    is_complete: bool
    extra: Mapping[str, Json] = field(default_factory=dict)


AnyEvent = (
    RunStarted
    | RunResumed
    | DesignChanged
    | EpochOpened
    | LinkLost
    | SiteObserved
    | DeviationSeen
    | TargetSelected
    | RefusalMet
    | TargetRefused
    | TargetWaits
    | ProposalMade
    | ProposalSuperseded
    | ApprovalGiven
    | ApprovalRefused
    | ApprovalRejected
    | AlternativeChosen
    | AlternativeRefused
    | ZoneDrawn
    | ZoneRemoved
    | DoneByHand
    | SkillIntent
    | SkillOutcome
    | SkillReconciled
    | SkillReissued
    | ComponentPositioned
    | ComponentStanding
    | OperationDone
    | ComponentInstalled
    | ComponentDisplaced
    | QuestionAsked
    | QuestionAnswered
    | RunHeld
    | RunFinished
)

_TYPE_BY_KIND: Mapping[str, type[AnyEvent]] = {t.kind: t for t in get_args(AnyEvent)}


def event_to_json(event: AnyEvent) -> Mapping[str, Json]:
    """Return the event's body; kind and version stand beside it in the journal."""
    body = to_json(event)
    assert isinstance(body, Mapping)  # noqa: S101 -- a dataclass becomes an object
    return {name: value for name, value in body.items() if name != "is"}


def event_from_json(kind: str, version: int, body: Json) -> AnyEvent:
    """Return the event of a stored body; unknown kinds and newer versions are a `DecodeError`."""
    event_type = _TYPE_BY_KIND.get(kind)
    if event_type is None:
        raise DecodeError(f"event kind {kind!r} is unknown to this version")
    if version > event_type.version:
        raise DecodeError(f"event {kind!r} has version {version}; known: {event_type.version}")
    return from_json(event_type, body)
