"""From the journal's events to the summary of a run: pure folds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sitewright.building_model.component import Process
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.approval import Approval
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import (
    AlternativeChosen,
    AnyEvent,
    ApprovalGiven,
    ApprovalRefused,
    ApprovalRejected,
    DeviationSeen,
    ProposalMade,
    ProposalSuperseded,
    QuestionAnswered,
    QuestionAsked,
    RefusalMet,
    RunFinished,
    RunHeld,
    RunResumed,
    RunStarted,
    SkillIntent,
    SkillOutcome,
    TargetRefused,
)
from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.ports import PUT_OFF, RefusalNote, ScopeKind
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.report.as_built import built_components
from sitewright.interaction_twin.report.content import (
    Decision,
    Figures,
    PlanRow,
    RunSummary,
    Stamped,
)
from sitewright.interaction_twin.report.timeline import timeline
from sitewright.interaction_twin.report.waiting import robot_times, time_by_cause

_FASTENING = frozenset({Process.NAIL, Process.SCREW})
_FINISHING = frozenset({Process.PAINT})
_APPROVAL = 7
PLANNING_TIMES = ("symbolic", "motion", "certificate", "total")

Contact = tuple[str, str, str]
"""Two bodies in order of name, and the skill during which they touched."""


def summarise(
    model: BuildingModel,
    before: SiteState,
    history: Sequence[Stamped],
    *,
    cell_figures: Mapping[str, Json] | None = None,
) -> RunSummary:
    """Return the summary of one run.

    Args:
        model: The design.
        before: The site when the run began: empty, or what the runs before have left.
        history: All events of the run, in order.
        cell_figures: What the cell tells now; needed only while the run has not finished.
    """
    events = [s.event for s in history]
    state = CycleState(site=before)
    for event in events:
        state = folded(state, event)
    site = state.site
    started = next((e for e in events if isinstance(e, RunStarted)), None)
    times = timeline(events)
    ended, note = _ending(events)
    contacts = _contacts(events, cell_figures)
    return RunSummary(
        run=started.run if started else "",
        project=started.project if started else model.name,
        started_utc_ns=history[0].at_utc_ns if history else 0,
        ended_utc_ns=history[-1].at_utc_ns if history else 0,
        ended=ended,
        ending_note=note,
        figures=_figures(model, site, events, contacts),
        continues=started.previous_run if started else "",
        resumed=sum(isinstance(e, RunResumed) for e in events),
        spent_s={cause.value: spent_s for cause, spent_s in time_by_cause(history).items()},
        robot_times=robot_times(times.actual),
        planned=times.planned,
        actual=times.actual,
        plans=tuple(_plan_row(e) for e in events if isinstance(e, ProposalMade)),
        decisions=_decisions(history),
        refusals=_refusals(events),
        deviations=tuple(f"{e.subject}: {e.what}" for e in events if isinstance(e, DeviationSeen)),
        built=built_components(model, site),
        contacts=contacts or (),
        hashes=dict(started.hashes) if started else {},
    )


def _ending(events: Sequence[AnyEvent]) -> tuple[str, str]:
    for event in reversed(events):
        match event:
            case RunFinished(is_complete=True):
                return "complete", "Every component is installed."
            case RunFinished():
                return "finished", "Some components were set aside."
            case RunHeld(reason=reason):
                return "held", reason
            case _:
                continue
    return "open", "The run has not ended."


def _contacts(
    events: Sequence[AnyEvent], cell_figures: Mapping[str, Json] | None
) -> tuple[Contact, ...] | None:
    """Return the distinct unallowed contacts; None if the cell has not told."""
    told = [e.extra for e in events if isinstance(e, RunFinished)]
    figures = cell_figures if cell_figures is not None else (told[-1] if told else {})
    logged = figures.get("contacts")
    if not isinstance(logged, Sequence) or isinstance(logged, str):
        return None
    found: set[Contact] = set()
    for entry in logged:
        if isinstance(entry, Mapping):
            pair = entry.get("pair")
            names = [str(n) for n in pair] if isinstance(pair, Sequence) else [str(pair), ""]
            first, second = sorted(names)[:2]
            found.add((first, second, str(entry.get("skill", ""))))
    return tuple(sorted(found))


@dataclass(frozen=True, slots=True)
class _Executed:
    """Skills that were started, and how they ended."""

    intents: tuple[SkillIntent, ...]
    done: int
    failed: int


def _executed(events: Sequence[AnyEvent]) -> _Executed:
    reports = {e.command_id: e.report for e in events if isinstance(e, SkillOutcome)}
    done = sum(r.is_done for r in reports.values())
    intents = tuple(e for e in events if isinstance(e, SkillIntent))
    return _Executed(intents, done, len(reports) - done)


def _figures(
    model: BuildingModel,
    site: SiteState,
    events: Sequence[AnyEvent],
    contacts: tuple[Contact, ...] | None,
) -> Figures:
    ran = _executed(events)
    operations = [o for t in site.targets for o in model.component_by_id[t].operations]
    fasteners = [o.id for o in operations if o.process in _FASTENING]
    finishes = [o.id for o in operations if o.process in _FINISHING]
    distances = [i.closest_distance_m for i in ran.intents if i.closest_distance_m is not None]
    built = [b for b in built_components(model, site) if b.status == "installed"]
    errors_m = [b.position_error_m for b in built if b.position_error_m is not None]
    errors_rad = [b.angle_error_rad for b in built if b.angle_error_rad is not None]
    return Figures(
        targets_total=len(site.targets),
        targets_installed=len(site.installed),
        fasteners_total=len(fasteners),
        fasteners_driven=sum(o in site.done_operations for o in fasteners),
        finishes_total=len(finishes),
        finishes_applied=sum(o in site.done_operations for o in finishes),
        skills_executed=ran.done,
        skills_failed=ran.failed,
        trajectories_total=sum(len(i.trajectories) for i in ran.intents),
        trajectories_certified=sum(i.certificates for i in ran.intents),
        trajectories_confirmed=sum(i.confirmed for i in ran.intents),
        unallowed_contacts=None if contacts is None else len(contacts),
        closest_distance_m=min(distances, default=None),
        worst_pose_error_m=max(errors_m, default=None),
        worst_pose_error_rad=max(errors_rad, default=None),
        replans=sum(_is_replan(e) for e in events),
        questions_asked=sum(isinstance(e, QuestionAsked) for e in events),
        makespan_s=timeline(events).makespan_s,
        planning_s=_planning_times(events),
    )


def _is_replan(event: AnyEvent) -> bool:
    """Tell whether a plan was made anew: geometry refused it, or the site differed from it."""
    match event:
        case RefusalMet(refusal=refusal):
            return refusal.is_replanned
        case ProposalSuperseded(is_replan=is_replan):
            return is_replan
        case _:
            return False


def _planning_times(events: Sequence[AnyEvent]) -> dict[str, float]:
    times = dict.fromkeys(PLANNING_TIMES, 0.0)
    for event in events:
        if isinstance(event, ProposalMade | TargetRefused):
            for name, spent_s in event.timing_s.items():
                times[name] = times.get(name, 0.0) + spent_s
    return times


def _plan_row(made: ProposalMade) -> PlanRow:
    distances = [s.closest_distance_m for s in made.steps if s.closest_distance_m is not None]
    return PlanRow(
        target=made.target,
        code=check_code(made.fingerprint),
        steps=len(made.steps),
        duration_s=sum(s.duration_s for s in made.steps),
        closest_distance_m=min(distances, default=None),
        planning_s=made.timing_s.get("total", 0.0),
    )


def _refusals(events: Sequence[AnyEvent]) -> tuple[RefusalNote, ...]:
    """Return the refusals met, each once, and last the targets set aside."""
    notes = [e.refusal for e in events if isinstance(e, RefusalMet)]
    aside = [
        RefusalNote(
            target=e.target,
            kind=PUT_OFF if e.exit_code == _APPROVAL else TargetRefused.__name__,
            reason=e.reason,
            is_proven=e.is_proven,
            blockers=e.blockers,
            then="; or ".join(f"would work: {c.words}" for c in e.counter_proposals),
        )
        for e in events
        if isinstance(e, TargetRefused)
    ]
    return tuple(dict.fromkeys((*notes, *aside)))


def _decisions(history: Sequence[Stamped]) -> tuple[Decision, ...]:
    found = (_decision(s.at_utc_ns, s.event) for s in history)
    return tuple(d for d in found if d is not None)


def _decision(at: int, event: AnyEvent) -> Decision | None:
    match event:
        case ApprovalGiven(approval=approval):
            code, scope = check_code(approval.fingerprint), _scope_words(approval)
            return Decision(
                at_utc_ns=at, what="approved", who=approval.who, code=code, detail=scope
            )
        case ApprovalRejected(who=who, rejection=rejection):
            code = check_code(rejection.fingerprint)
            detail = f"{rejection.reason}: {rejection.detail}".rstrip(": ")
            return Decision(at_utc_ns=at, what="rejected", who=who, code=code, detail=detail)
        case ApprovalRefused(fingerprint=digest, reason=reason):
            code = check_code(digest)
            return Decision(at_utc_ns=at, what="void", who="guard", code=code, detail=reason)
        case AlternativeChosen(who=who, call=call, fingerprint=digest):
            words = " ".join((call.skill, call.robot, *call.arguments))
            code = check_code(digest)
            return Decision(at_utc_ns=at, what="other action", who=who, code=code, detail=words)
        case QuestionAnswered(who=who, answer=answer):
            return Decision(at_utc_ns=at, what="answered", who=who, detail=answer.value)
        case _:
            return None


def _scope_words(approval: Approval) -> str:
    match approval.scope.kind:
        case ScopeKind.PLAN:
            return "all steps"
        case ScopeKind.UNTIL:
            return f"up to step {approval.scope.step}"
        case ScopeKind.STEP:
            return f"step {approval.scope.step}"
