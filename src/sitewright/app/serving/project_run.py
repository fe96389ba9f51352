"""The run of a project as the worker runs it: opened anew each time, watched at some speed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TypedDict

from sitewright.app.execution import Watch, require_targets, run_command
from sitewright.app.project import Project, open_project
from sitewright.app.reporting import write_report
from sitewright.app.run import RunResult
from sitewright.app.serving.channel import Channel
from sitewright.app.serving.history import Numbered, history_of
from sitewright.app.serving.memory import Memory
from sitewright.app.serving.policy_file import policy_of
from sitewright.app.serving.rules import site_wish
from sitewright.app.serving.worker import Hooks, Worker
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.events import AnyEvent, ProposalSuperseded, QuestionAnswered
from sitewright.central_controller.site_state import SiteState, site_of
from sitewright.central_controller.steering import Steering, steered
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.decisions import Signed
from sitewright.interaction_twin.roles import Verb


def worker_of(
    channel: Channel,
    folder: Path,
    *,
    cell: Path | None = None,
    speed: float = 1.0,
    from_design: bool = False,
    waits: bool = False,
) -> Worker:
    """Return the worker of a project.

    Args:
        channel: The pipe to the server.
        folder: The project.
        cell: Another cell file.
        speed: Of the simulated cell; 1 is real time, 0 as fast as it can.
        from_design: Begin the first run on an empty site.
        waits: Go on only when somebody says so.

    Raises:
        SitewrightError: The project cannot be opened, or has nothing to build.
    """
    project = open_project(folder, cell=cell)
    require_targets(project)
    history = history_of(project.folder / "runs")
    memory = Memory()
    for record in history:
        memory.note(record.run, record.stamped)
    anew = [from_design]

    def run_once(hooks: Hooks) -> RunResult:
        opened = _at_speed(open_project(folder, cell=cell), speed)
        begun_by = hooks.begun_by
        result = run_command(
            opened,
            hooks.desk,
            from_design=anew[0],
            watch=Watch(
                on_record=hooks.on_record,
                on_connect=hooks.on_connect,
                hold_asked=hooks.desk.hold_asked,
                **begun(begun_by),
            ),
        )
        anew[0] = False
        write_report(opened, result.run)
        return result

    design = site_of(project.model)

    def at_rest() -> CycleState:
        return state_after(history_of(project.folder / "runs"), design)

    return Worker(
        channel=channel,
        memory=memory,
        run_once=run_once,
        begins_itself=not waits and (from_design or begins_itself(history, design)),
        policy=policy_of(project.settings),
        at_rest=at_rest,
        types=types_of(project.model),
    )


def types_of(model: BuildingModel) -> dict[ComponentId, str]:
    """Return the type of each component."""
    return {c.id: c.type for c in model.component_by_id.values()}


class Begun(TypedDict):
    """Who began or resumed a run, and what comes first in it."""

    who: str
    decision: DecisionRecord | None
    first: Callable[[CycleState], Sequence[AnyEvent]]


def begun(signed: Signed | None) -> Begun:
    """Return what a decision to go on means: what was decided while the run stood comes first."""
    if signed is None:
        return Begun(who="", decision=None, first=_nothing)
    who = signed.person.who
    match signed.decision.verb:
        case Verb.ZONE | Verb.MANUAL:
            return Begun(who=who, decision=None, first=partial(_steered_first, site_wish(signed)))
        case Verb.ANSWER:
            return Begun(who=who, decision=None, first=partial(_answered_first, signed))
        case _:
            return Begun(who=who, decision=signed.record(), first=_nothing)


def _steered_first(wish: Steering, state: CycleState) -> Sequence[AnyEvent]:
    why, events = steered(state.site, wish)
    made = state.proposal
    if made is None:
        return events
    gone = ProposalSuperseded(fingerprint=made.fingerprint, reason=why, is_replan=False)
    return [*events, gone]


def _answered_first(signed: Signed, state: CycleState) -> Sequence[AnyEvent]:
    question, answer = state.question, signed.decision.answer
    if question is None or answer is None or question.question_id != signed.decision.question_id:
        return ()
    return [
        QuestionAnswered(
            question_id=question.question_id,
            answer=answer,
            who=signed.person.who,
            decision=signed.record(),
        )
    ]


def _nothing(state: CycleState) -> Sequence[AnyEvent]:
    del state
    return ()


def begins_itself(history: Sequence[Numbered], design: SiteState) -> bool:
    """Tell whether a run may go on without being told: nothing would move by itself.

    What was approved, or is under way, waits for a person at the page; so does what was held.
    """
    state = state_after(history, design)
    is_pending = state.approval is not None or state.flight is not None
    is_over = state.finished is not None or state.held is not None
    return not (is_pending or is_over or state.question is not None)


def state_after(history: Sequence[Numbered], design: SiteState) -> CycleState:
    """Return the fold of a history."""
    state = CycleState(site=design)
    for record in history:
        state = folded(state, record.stamped.event)
    return state


def _at_speed(project: Project, speed: float) -> Project:
    """Return the project with a simulated cell that runs at some speed."""
    settings = {**project.cell.simulation, "real_time_factor": speed}
    return replace(project, cell=replace(project.cell, simulation=settings))
