"""Planned and actual skills on one time axis, from the events of a run."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from sitewright.central_controller.events import (
    AnyEvent,
    ProposalMade,
    SiteObserved,
    SkillIntent,
    SkillOutcome,
)
from sitewright.foundation.ids import CommandId
from sitewright.interaction_twin.drawing.bars import Bar
from sitewright.robot_team.driver import SkillReport


@dataclass(frozen=True, slots=True, kw_only=True)
class Timeline:
    """Bars on one axis.

    Attributes:
        zero_s: The cell's clock where the axis begins: at the first skill.
    """

    planned: tuple[Bar, ...] = ()
    actual: tuple[Bar, ...] = ()
    zero_s: float = 0.0

    @property
    def makespan_s(self) -> float:
        """From the first start to the last end of what really ran."""
        ends = [b.starts_s + b.duration_s for b in self.actual]
        return max(ends) - min(b.starts_s for b in self.actual) if ends else 0.0


@dataclass(slots=True)
class _Fold:
    """The fold's state: the clock, the open proposal, and what is under way."""

    now_s: float = 0.0
    proposal: ProposalMade | None = None
    is_shown: bool = False
    flight: SkillIntent | None = None
    started_s: float = 0.0
    report: SkillReport | None = None
    planned: list[Bar] = field(default_factory=list)
    actual: list[Bar] = field(default_factory=list)


def timeline(events: Iterable[AnyEvent]) -> Timeline:
    """Return the skills of a run in time; the first one starts at zero.

    The end of a skill is the cell's clock when its effects were sensed, its length what the
    driver measured. A plan's bars start where its first step really started.
    """
    fold = _Fold()
    for event in events:
        match event:
            case ProposalMade():
                fold.proposal, fold.is_shown = event, False
            case SkillIntent():
                _start(fold, event)
            case SkillOutcome(command_id=command, report=report):
                if fold.flight is not None and fold.flight.command_id == command:
                    fold.report = report
            case SiteObserved(time_s=time_s, after=after):
                _observe(fold, time_s, CommandId(after))
            case _:
                pass
    _close(fold, fold.now_s)
    return _from_zero(Timeline(planned=tuple(fold.planned), actual=tuple(fold.actual)))


def _start(fold: _Fold, intent: SkillIntent) -> None:
    _close(fold, fold.now_s)
    fold.flight, fold.started_s, fold.report = intent, fold.now_s, None
    proposal = fold.proposal
    if proposal is None or fold.is_shown or proposal.fingerprint != intent.fingerprint:
        return
    fold.is_shown, start_s = True, fold.now_s
    for step in proposal.steps:
        bar = Bar(
            robot=step.call.robot,
            call=step.call,
            target=proposal.target,
            starts_s=start_s,
            duration_s=step.duration_s,
            step=step.number,
            fingerprint=proposal.fingerprint,
        )
        fold.planned.append(bar)
        start_s += step.duration_s


def _observe(fold: _Fold, time_s: float, after: CommandId) -> None:
    if fold.flight is not None and fold.flight.command_id == after:
        _close(fold, time_s)
    fold.now_s = time_s


def _close(fold: _Fold, end_s: float) -> None:
    """End what is under way; without a report it was interrupted and lasted till now."""
    intent, report = fold.flight, fold.report
    if intent is None:
        return
    is_done = report is not None and report.is_done
    duration_s = max(0.0, end_s - fold.started_s)
    if report is not None and 0.0 < report.duration_s <= duration_s:
        duration_s = report.duration_s
    fold.actual.append(
        Bar(
            robot=intent.call.robot,
            call=intent.call,
            target=intent.target,
            starts_s=max(fold.started_s, end_s - duration_s),
            duration_s=duration_s,
            is_done=is_done,
            step=intent.step,
            fingerprint=intent.fingerprint,
        )
    )
    fold.flight, fold.report = None, None


def _from_zero(found: Timeline) -> Timeline:
    zero_s = min((b.starts_s for b in found.actual), default=0.0)
    return Timeline(
        planned=tuple(replace(b, starts_s=b.starts_s - zero_s) for b in found.planned),
        actual=tuple(replace(b, starts_s=b.starts_s - zero_s) for b in found.actual),
        zero_s=zero_s,
    )
