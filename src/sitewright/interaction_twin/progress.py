"""What happens, as one line for people per event that matters to them."""

from __future__ import annotations

from collections.abc import Mapping

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
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import counted, in_seconds
from sitewright.interaction_twin.narration import narrate


def progress_line(event: AnyEvent, labels: Labels) -> str:
    """Return the line of an event; empty if it is of no interest while watching."""
    return (
        _run_line(event)
        or _work_line(event, labels)
        or _trouble_line(event, labels)
        or _steering_line(event, labels)
    )


def _run_line(event: AnyEvent) -> str:
    match event:
        case RunStarted(run=run, previous_run=previous):
            return f"Run {run} continues {previous}." if previous else f"Run {run} begins."
        case RunResumed():
            return "The run goes on where it stopped."
        case DesignChanged():
            return _design_line(event)
        case RunHeld(reason=reason):
            return f"! {reason}"
        case RunFinished(is_complete=is_complete):
            return "Everything is installed." if is_complete else "Nothing more can be built."
        case _:
            return ""


def _design_line(event: DesignChanged) -> str:
    old, new = event.old_sha256[:8], event.model_sha256[:8]
    again = f" New work on what stands: {', '.join(event.reopened)}." if event.reopened else ""
    return f"The design changed ({old} -> {new}); plans are made anew.{again}"


def _work_line(event: AnyEvent, labels: Labels) -> str:
    match event:
        case ProposalMade():
            return _proposal_line(event, labels)
        case SkillIntent(call=call):
            return f"  {narrate(call, labels)}"
        case SkillOutcome(report=report) if not report.is_done:
            return f"  ! not done: {report.reason}"
        case ComponentInstalled():
            error_mm = event.world_T_wanted.distance_to_m(event.world_T_measured) * 1000.0
            return f"{labels.name(event.target)} is installed, {error_mm:.1f} mm off."
        case _:
            return ""


def _steering_line(event: AnyEvent, labels: Labels) -> str:
    """Return what a person changed beside the plan."""
    match event:
        case ZoneDrawn(zone=zone, who=who):
            return f"{who} drew the keep-out zone {zone.id}."
        case ZoneRemoved(zone=name, who=who):
            return f"{who} took the keep-out zone {name} away."
        case DoneByHand(target=target, who=who):
            return f"{who} did work on {labels.name(target)} by hand."
        case _:
            return ""


def _proposal_line(event: ProposalMade, labels: Labels) -> str:
    duration = in_seconds(sum(s.duration_s for s in event.steps))
    planned = in_seconds(event.timing_s.get("total", 0.0))
    return (
        f"{labels.name(event.target)}: {counted(len(event.steps), 'step')}, {duration} "
        f"(planned in {planned}, code {check_code(event.fingerprint)})"
    )


def _trouble_line(  # noqa: PLR0911 -- one line per kind of event
    event: AnyEvent, labels: Labels
) -> str:
    """Return what went otherwise than planned."""
    match event:
        case RefusalMet(refusal=note):
            where = labels.name(note.target)
            told = labels.told(f"{note.reason} ({note.kind}); {note.then or 'no way round it'}")
            return f"  {where}: {told}"
        case TargetRefused(target=target, reason=reason):
            return f"! {labels.name(target)} cannot be built now: {labels.told(reason)}"
        case TargetWaits(target=target, until=until):
            return f"  {labels.name(target)} waits until {labels.name(until)} is built"
        case DeviationSeen(subject=subject, what=what):
            return f"  ! {labels.name(subject)}: {labels.told(what)}"
        case SkillReconciled(verdict=verdict, evidence=evidence):
            return f"  the cell's ledger says {verdict}: {evidence}"
        case AlternativeRefused() | ProposalSuperseded() | ApprovalRefused() | LinkLost():
            return f"! {_TROUBLE[event.kind]}: {labels.told(event.reason)}"
        case _:
            return ""


_TROUBLE: Mapping[str, str] = {
    AlternativeRefused.kind: "The other action is not possible",
    ProposalSuperseded.kind: "A new plan is needed",
    ApprovalRefused.kind: "The approval does not hold any more",
    LinkLost.kind: "The cell was lost",
}
