"""What became of a proposal: a fold of the journal's events about it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sitewright.central_controller.events import (
    AlternativeChosen,
    AnyEvent,
    ApprovalGiven,
    ApprovalRejected,
    ProposalMade,
    ProposalSuperseded,
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
)
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.report.content import Stamped

_MS = 1_000_000


@dataclass(slots=True, kw_only=True)
class ProposalStory:
    """What became of a proposal.

    Attributes:
        status: ``waiting``, ``approved``, ``running``, ``done``, ``rejected`` or ``superseded``.
        step_status: By number: ``open``, ``running``, ``done``, ``not done`` or ``superseded``.
        decided: The last decision about it; None before.
    """

    made: ProposalMade
    asked_at_ms: int
    status: str = "waiting"
    step_status: dict[int, str] = field(default_factory=dict)
    decided: Mapping[str, Json] | None = None
    _step_by_command: dict[str, int] = field(default_factory=dict)

    @property
    def done_steps(self) -> frozenset[int]:
        """Numbers of the steps that were done."""
        return frozenset(n for n, status in self.step_status.items() if status == "done")

    def hear(self, stamped: Stamped) -> None:
        """Learn from an event that came after the proposal was made."""
        event = stamped.event
        match event:
            case SkillIntent() | SkillOutcome() | SkillReconciled():
                self._hear_of_step(event)
            case ProposalSuperseded(fingerprint=f) if f == self.made.fingerprint:
                self.status = "superseded"
            case _:
                self._hear_of_decision(event, stamped.at_utc_ns // _MS)

    def end(self) -> None:
        """Settle what is said of steps that never ran, after the last event."""
        if self.status in {"rejected", "superseded"}:
            for number, status in self.step_status.items():
                if status == "open":
                    self.step_status[number] = "superseded"
        elif all(s == "done" for s in self.step_status.values()):
            self.status = "done"

    def _hear_of_step(self, event: SkillIntent | SkillOutcome | SkillReconciled) -> None:
        if isinstance(event, SkillIntent):
            if event.fingerprint == self.made.fingerprint:
                self._step_by_command[event.command_id] = event.step
                self.status, self.step_status[event.step] = "running", "running"
            return
        step = self._step_by_command.get(event.command_id)
        if step is None:
            return
        if isinstance(event, SkillOutcome):
            self.step_status[step] = "done" if event.report.is_done else "not done"
        elif event.verdict == "not-done":
            self.step_status[step] = "not done"

    def _hear_of_decision(self, event: AnyEvent, at_ms: int) -> None:
        match event:
            case ApprovalGiven(approval=a) if a.fingerprint == self.made.fingerprint:
                self.status = "approved"
                scope: Json = {"kind": a.scope.kind.value, "step": a.scope.step}
                self.decided = {"who": a.who, "verb": "approve", "at_ms": at_ms, "scope": scope}
            case ApprovalRejected(who=who, rejection=r) if r.fingerprint == self.made.fingerprint:
                self.status = "rejected"
                self.decided = {"who": who, "verb": "reject", "at_ms": at_ms, "reason": r.reason}
            case AlternativeChosen(who=who, fingerprint=f) if f == self.made.fingerprint:
                self.status = "rejected"
                self.decided = {"who": who, "verb": "instead", "at_ms": at_ms}
            case _:
                pass


def story_of(fingerprint: str, history: Sequence[Stamped]) -> ProposalStory | None:
    """Return what became of a proposal; None if it was never made in this history."""
    story: ProposalStory | None = None
    for stamped in history:
        event = stamped.event
        if isinstance(event, ProposalMade) and event.fingerprint == fingerprint:
            story = ProposalStory(
                made=event,
                asked_at_ms=stamped.at_utc_ns // _MS,
                step_status={s.number: "open" for s in event.steps},
            )
        elif story is not None:
            story.hear(stamped)
    if story is not None:
        story.end()
    return story
