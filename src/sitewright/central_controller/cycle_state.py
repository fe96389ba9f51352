"""Everything that the next decision of a run needs, as one value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sitewright.central_controller.approval import Approval
from sitewright.central_controller.events import ProposalMade, RunFinished, RunHeld, SkillIntent
from sitewright.central_controller.ports import Question, RefusalNote
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.ids import ComponentId, RunId
from sitewright.robot_team.description import Joints
from sitewright.robot_team.driver import SkillReport
from sitewright.robot_team.skill import SkillCall

_NO_RUN = RunId("")


class Phase(StrEnum):
    """How far a started skill is."""

    STARTED = "started"
    """The intent is on the disk; the driver may be told."""
    UNCERTAIN = "uncertain"
    """The controller or the cell died since; the ledger must be asked."""
    NEVER = "never"
    """The ledger knows nothing of it; it may be issued again."""
    UNKNOWN = "unknown"
    """Neither ledger nor sensors can tell; a person must."""
    ENDED = "ended"
    """Its outcome is recorded; its effects are to be sensed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Flight:
    """The one skill that is under way.

    Attributes:
        source: Where the outcome comes from: driver, ledger, sensors or person.
        has_deviated: A deviation after it is recorded already.
        start_q_rad: Sensed posture of the robot when it started; empty if none was sensed.
        start_place: Place of the robot then; an empty tuple if it was not known.
    """

    intent: SkillIntent
    phase: Phase = Phase.STARTED
    report: SkillReport | None = None
    source: str = ""
    has_deviated: bool = False
    start_q_rad: Joints = ()
    start_place: tuple[str | None, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class CycleState:
    """Everything that the next decision needs; a fold of the journal.

    Attributes:
        model_sha256: Of the file of the design that the plans are made of.
        epoch: 0 while the cell is not connected.
        proposal: The open proposal; None when one must be made.
        done: Steps of the open proposal that are done.
        approval: The last approval of the open proposal.
        started: (approval, step) pairs that were used.
        wish: Call that a person chose instead of the next step.
        why: Why an approval is asked anew.
        replans: Replans per target since the command was last given.
        link_losses: How often the cell was lost since a skill ended; `link_reason` is the last why.
        rejected: Fingerprints that people refused.
        refusals: Refusals met while planning the open proposal.
        refusal_codes: Exit codes of the targets set aside in this run.
        held: Why the run stands, with the exit code.
    """

    site: SiteState
    run: RunId = _NO_RUN
    model_sha256: str = ""
    epoch: int = 0
    proposal: ProposalMade | None = None
    done: int = 0
    approval: Approval | None = None
    started: frozenset[tuple[str, int]] = frozenset()
    flight: Flight | None = None
    question: Question | None = None
    wish: SkillCall | None = None
    why: str = ""
    replans: Mapping[ComponentId, int] = field(default_factory=dict)
    replan_times_utc_ns: tuple[int, ...] = ()
    link_losses: int = 0
    link_reason: str = ""
    rejected: frozenset[str] = frozenset()
    refusals: tuple[RefusalNote, ...] = ()
    refusal_codes: tuple[int, ...] = ()
    held: RunHeld | None = None
    finished: RunFinished | None = None
