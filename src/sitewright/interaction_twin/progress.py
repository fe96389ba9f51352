"""What happens, as one line for people per event that matters to them."""

from __future__ import annotations

from sitewright.central_controller.events import (
    AlternativeRefused,
    AnyEvent,
    ApprovalRefused,
    ComponentInstalled,
    DesignChanged,
    DeviationSeen,
    DoneByHand,
    LinkLost,
    ProposalMade,
    ProposalSuperseded,
    RefusalMet,
    RunFinished,
    RunHeld,
    RunResumed,
    RunStarted,
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
    TargetRefused,
    TargetWaits,
    ZoneDrawn,
    ZoneRemoved,
)
from sitewright.central_controller.fingerprint import check_code
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import in_seconds
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.retelling import Telling


def progress_line(event: AnyEvent, labels: Labels, book: Phrasebook = ENGLISH) -> str:
    """Return the line of an event; empty if it is of no interest while watching."""
    tell = Telling(labels, book)
    said = (
        _run_line(event) or _work_line(event, tell) or _trouble_line(event) or _steering_line(event)
    )
    return tell(said) if said else ""


def _run_line(event: AnyEvent) -> str:  # noqa: PLR0911 -- one line per kind of event
    match event:
        case RunStarted(run=run, previous_run=previous) if previous:
            return Sentence("Run {run} continues {previous}.", run=run, previous=previous)
        case RunStarted(run=run):
            return Sentence("Run {run} begins.", run=run)
        case RunResumed():
            return Sentence("The run goes on where it stopped.")
        case DesignChanged():
            return _design_line(event)
        case RunHeld(reason=reason):
            return Sentence("! {reason}", reason=reason)
        case RunFinished(is_complete=True):
            return Sentence("Everything is installed.")
        case RunFinished():
            return Sentence("Nothing more can be built.")
        case _:
            return ""


def _design_line(event: DesignChanged) -> Sentence:
    old, new = event.old_sha256[:8], event.model_sha256[:8]
    changed = Sentence(
        "The design changed ({old} -> {new}); plans are made anew.", old=old, new=new
    )
    if not event.reopened:
        return changed
    return Sentence(
        "{changed} New work on what stands: {components:comma}.",
        changed=changed,
        components=event.reopened,
    )


def _work_line(event: AnyEvent, tell: Telling) -> str:
    match event:
        case ProposalMade():
            return _proposal_line(event)
        case SkillIntent(call=call):
            return Sentence("  {text}", text=narrate(call, tell.labels, tell.book))
        case SkillOutcome(report=report) if not report.is_done:
            return Sentence("  ! not done: {why}", why=report.reason)
        case ComponentInstalled():
            error_mm = event.world_T_wanted.distance_to_m(event.world_T_measured) * 1000.0
            return Sentence(
                "{component} is installed, {off_mm:.1f} mm off.",
                component=event.target,
                off_mm=error_mm,
            )
        case _:
            return ""


def _steering_line(event: AnyEvent) -> str:
    """Return what a person changed beside the plan."""
    match event:
        case ZoneDrawn(zone=zone, who=who):
            return Sentence("{who} drew {zone}.", who=who, zone=zone.id)
        case ZoneRemoved(zone=name, who=who):
            return Sentence("{who} took {zone} away.", who=who, zone=name)
        case DoneByHand(target=target, who=who):
            return Sentence("{who} did work on {target} by hand.", who=who, target=target)
        case _:
            return ""


def _proposal_line(event: ProposalMade) -> Sentence:
    figures = {
        "target": event.target,
        "duration": in_seconds(sum(s.duration_s for s in event.steps)),
        "planned": in_seconds(event.timing_s.get("total", 0.0)),
        "code": check_code(event.fingerprint),
    }
    if len(event.steps) == 1:
        return Sentence(
            "{target}: 1 step, {duration} (planned in {planned}, code {code})", **figures
        )
    return Sentence(
        "{target}: {count} steps, {duration} (planned in {planned}, code {code})",
        count=len(event.steps),
        **figures,
    )


def _trouble_line(event: AnyEvent) -> str:  # noqa: C901, PLR0911 -- one line per kind
    """Return what went otherwise than planned."""
    match event:
        case RefusalMet(refusal=note):
            return Sentence(
                "  {target}: {reason} ({kind}); {then}",
                target=note.target,
                reason=note.reason,
                kind=note.kind,
                then=note.then or Sentence("no way round it"),
            )
        case TargetRefused(target=target, reason=reason):
            return Sentence("! {target} cannot be built now: {why}", target=target, why=reason)
        case TargetWaits(target=target, until=until):
            return Sentence("  {target} waits until {other} is built", target=target, other=until)
        case DeviationSeen(subject=subject, what=what):
            return Sentence("  ! {subject}: {what}", subject=subject, what=what)
        case SkillReconciled(verdict=verdict, evidence=evidence):
            return Sentence(
                "  the cell's ledger says {verdict}: {evidence}", verdict=verdict, evidence=evidence
            )
        case AlternativeRefused(reason=reason):
            return Sentence("! The other action is not possible: {why}", why=reason)
        case ProposalSuperseded(reason=reason):
            return Sentence("! A new plan is needed: {why}", why=reason)
        case ApprovalRefused(reason=reason):
            return Sentence("! The approval does not hold any more: {why}", why=reason)
        case LinkLost(reason=reason):
            return Sentence("! The cell was lost: {why}", why=reason)
        case _:
            return ""
