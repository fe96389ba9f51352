"""Plans a whole building in advance, without moving anything."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from sitewright.app.engines import proposals_of
from sitewright.app.project import Project
from sitewright.central_controller.ports import (
    Escalation,
    NothingToDo,
    Planned,
    RefusalNote,
    SiteContext,
)
from sitewright.central_controller.rehearsal import initial_observation, rehearsed
from sitewright.central_controller.site_state import site_of
from sitewright.construction_graph.build import graph_of
from sitewright.foundation.ids import ComponentId, RunId

Progress = Callable[[str, str], None]
_REHEARSAL = RunId("rehearsal")


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanReport:
    """What a rehearsal of the building found.

    Attributes:
        planned: Proposals of the targets that can be built, in order.
        escalated: Targets that need a person, with the reason.
        waiting: Targets whose construction parents could not be planned.
        refusals: Every refusal met on the way.
        timing_s: ``symbolic``, ``motion``, ``total``.
    """

    targets_total: int
    planned: tuple[Planned, ...] = ()
    escalated: tuple[Escalation, ...] = ()
    waiting: tuple[ComponentId, ...] = ()
    refusals: tuple[RefusalNote, ...] = ()
    timing_s: dict[str, float] = field(default_factory=dict)

    @property
    def targets_planned(self) -> int:
        """How many targets have a plan whose motions are all certified."""
        return len(self.planned)


def start_of(project: Project) -> SiteContext:
    """Return the untouched site of a project."""
    graph = graph_of(project.model, project.cell)
    seen = initial_observation(project.model, project.cell, graph)
    return SiteContext(run=_REHEARSAL, site=site_of(project.model), observation=seen)


def plan_project(
    project: Project, target: str | None = None, on_progress: Progress | None = None
) -> PlanReport:
    """Plan all targets in order, each against the site as it would stand by then.

    Args:
        project: An opened project.
        target: Stop after this one; None plans the whole building.
        on_progress: Called after each target with its id and what became of it, in words.
    """
    proposals = proposals_of(project)
    say = on_progress or (lambda _target, _words: None)
    context = start_of(project)
    planned: list[Planned] = []
    escalated: list[Escalation] = []
    total = len(context.site.targets)
    while True:
        set_aside = frozenset(e.target for e in escalated)
        outcome = proposals.propose(context, exclude=set_aside)
        match outcome:
            case NothingToDo():
                break
            case Escalation(target=component, reason=reason):
                escalated.append(outcome)
                say(component, f"refused: {reason}")
            case Planned(proposal=proposal):
                planned.append(outcome)
                say(proposal.target, f"{len(proposal.steps)} steps ({len(planned)}/{total})")
                context = rehearsed(context, proposal)
                if proposal.target == target:
                    break
    return _report(context, planned, escalated, total)


def _report(
    context: SiteContext, planned: list[Planned], escalated: list[Escalation], total: int
) -> PlanReport:
    done = {p.proposal.target for p in planned} | {e.target for e in escalated}
    timing: dict[str, float] = {}
    outcomes: list[Planned | Escalation] = [*planned, *escalated]
    for outcome in outcomes:
        for kind, spent in outcome.timing_s.items():
            timing[kind] = timing.get(kind, 0.0) + spent
    return PlanReport(
        targets_total=total,
        planned=tuple(planned),
        escalated=tuple(escalated),
        waiting=tuple(t for t in context.site.targets if t not in done),
        refusals=tuple(r for o in outcomes for r in o.refusals),
        timing_s=timing,
    )
