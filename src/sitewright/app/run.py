"""Runs of a project: begin, continue or resume one, and answer its open question."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from sitewright.app.design_changes import design_change, told
from sitewright.app.event_log import EventLog
from sitewright.app.installing import installed_times
from sitewright.app.locks import locked
from sitewright.app.run_folder import (
    RunFolder,
    chain_events,
    chain_of,
    next_run_folder,
    refuse_network_folder,
    run_folders,
    run_named,
)
from sitewright.app.runner import Run, RunPorts, run_to_stop
from sitewright.app.runner_commands import perform
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.events import (
    AnyEvent,
    QuestionAnswered,
    RunResumed,
    RunStarted,
)
from sitewright.central_controller.ports import Answer, Question
from sitewright.central_controller.site_state import SiteState
from sitewright.errors import ExecutionError
from sitewright.foundation.clock import Clock
from sitewright.foundation.ids import ComponentId, IdSource, RunId
from sitewright.journal.sqlite import SqliteJournal

_DONE, _NO_MOTION, _EXECUTION = 0, 6, 8


@dataclass(frozen=True, slots=True, kw_only=True)
class RunOptions:
    """What a run is about.

    Attributes:
        project: Name of the project, for the record.
        runs: The project's ``runs`` folder.
        design: The empty site of the design (`site_of`).
        hashes: SHA-256 of model, cell, domain, and the software version, for the record.
        pieces: Stock of the design; None if it is not known.
        cell_lock: Lock file of the cell; two runs must not command the same robots.
        from_design: Start on an empty site instead of continuing the newest run.
        who: Who asked for it at a page.
        decision: What the journal keeps of that.
        first: What is recorded first of all, given the state that the run goes on from.
    """

    project: str
    runs: Path
    design: SiteState
    hashes: Mapping[str, str]
    cell_lock: Path
    pieces: frozenset[ComponentId] | None = None
    from_design: bool = False
    who: str = ""
    decision: DecisionRecord | None = None
    first: Callable[[CycleState], Sequence[AnyEvent]] = field(default=lambda _: ())


@dataclass(frozen=True, slots=True, kw_only=True)
class RunResult:
    """How a run ended, or why it stands.

    Attributes:
        exit_code: As the command line's table says.
        message: One sentence for people.
        question: The open question, if only a person can go on.
        refused: Targets set aside, with the reason.
    """

    run: str
    folder: Path
    exit_code: int
    message: str
    site: SiteState
    is_complete: bool
    question: Question | None = None
    refused: Mapping[ComponentId, str] = field(default_factory=dict)


def run_project(ports: RunPorts, options: RunOptions) -> RunResult:
    """Begin, continue or resume the project's run and go on until it stops.

    An open run is resumed; else the newest is continued by a new one; a finished project has
    nothing to do. If the design is another one than before, the journal says so first, and the
    open proposal is superseded. Raises `LockedError` if another process is at it.
    """
    refuse_network_folder(options.runs.parent)
    with _locked_project(options.runs), locked(options.cell_lock, "The cell"):
        newest = None if options.from_design else newest_run(options.runs)
        chain = chain_of(newest) if newest is not None else ()
        state, head = fold_of(chain, options.design)
        change = design_change(state, options.hashes.get("model", ""), options.pieces)
        news = [*told(state, change, ports.clock.utc_ns()), *options.first(state)]
        if newest is None or state.finished is not None:
            if newest is not None and _folded(state, news).site.is_complete:
                return _result(newest, state, "Every component is installed; nothing to do.")
            folder = next_run_folder(options.runs)
            start = _start(options, folder, newest, head)
            return _go_on(ports, folder, state, [start, *news], chain=chain)
        return _go_on(
            ports,
            newest,
            state,
            [RunResumed(who=options.who, decision=options.decision), *news],
            chain=chain,
        )


def resolve(  # noqa: PLR0913 -- one line of the command line
    runs: Path,
    design: SiteState,
    run: str,
    step: int,
    answer: Answer,
    *,
    who: str,
    clock: Clock,
    ids: IdSource,
) -> Question:
    """Answer the open question of a run about a step; the next `run` goes on from there."""
    with _locked_project(runs):
        folder = run_named(runs, run)
        state, _ = fold_of(chain_of(folder), design)
        question = state.question
        if question is None:
            raise ExecutionError(f"Run {folder.run} has no open question.")
        if question.step != step:
            raise ExecutionError(
                f"The open question of run {folder.run} is about step {question.step}, not {step}."
            )
        answered = QuestionAnswered(question_id=question.question_id, answer=answer, who=who)
        with SqliteJournal(folder.journal) as journal:
            EventLog(folder, journal, clock=clock, ids=ids).append(answered)
        return question


def newest_run(runs: Path) -> RunFolder | None:
    """Return the newest run that began; a journal that lost all its records is an error."""
    for folder in reversed(run_folders(runs)):
        if not folder.is_blank():
            return folder
    return None


def fold_of(chain: tuple[RunFolder, ...], design: SiteState) -> tuple[CycleState, str]:
    """Return the state after all events of a chain of runs, and the last one's head as hex."""
    events, head = chain_events(chain)
    return _folded(CycleState(site=design), events), head


def _folded(state: CycleState, events: Sequence[AnyEvent]) -> CycleState:
    for event in events:
        state = folded(state, event)
    return state


def _start(
    options: RunOptions, folder: RunFolder, previous: RunFolder | None, head: str
) -> RunStarted:
    return RunStarted(
        run=RunId(folder.run),
        project=options.project,
        hashes=options.hashes,
        previous_run=previous.run if previous is not None else "",
        previous_head=head,
        who=options.who,
        decision=options.decision,
    )


def _go_on(
    ports: RunPorts,
    folder: RunFolder,
    state: CycleState,
    first: Sequence[AnyEvent],
    *,
    chain: tuple[RunFolder, ...],
) -> RunResult:
    folder.create()
    times, home = installed_times(chain), (*chain, folder)[0].path
    with SqliteJournal(folder.journal) as journal:
        log = EventLog(folder, journal, clock=ports.clock, ids=ports.ids)
        run = Run(ports, folder, log, state, home=home, installed_at=times)
        if state.site.installed:  # the file may be older than the journal
            run.write_as_built()
        try:
            for event in first:
                run.record(event)
            run_to_stop(run, perform)
            if run.state.finished is not None:
                run.end_cell()
        except BaseException:
            run.hold_if_connected()
            raise
        finally:
            run.disconnect()
    return _result(folder, run.state, _message(run.state))


def _result(folder: RunFolder, state: CycleState, message: str) -> RunResult:
    return RunResult(
        run=folder.run,
        folder=folder.path,
        exit_code=_exit_code(state),
        message=message,
        site=state.site,
        is_complete=state.site.is_complete,
        question=state.question,
        refused={**state.site.refused, **state.site.needs_rework},
    )


def _exit_code(state: CycleState) -> int:
    if state.question is not None:
        return _EXECUTION
    if state.held is not None:
        return state.held.exit_code
    if state.site.is_complete:
        return _DONE
    if state.site.needs_rework:
        return _EXECUTION
    codes = set(state.refusal_codes)
    return codes.pop() if len(codes) == 1 and not state.site.installed else _NO_MOTION


def _message(state: CycleState) -> str:
    if state.question is not None:
        return state.question.text
    if state.held is not None:
        return state.held.reason
    if state.site.is_complete:
        return f"All {len(state.site.targets)} components are installed."
    left = [t for t in state.site.targets if t not in state.site.installed]
    return f"{len(left)} of {len(state.site.targets)} components are not built: {', '.join(left)}."


@contextmanager
def _locked_project(runs: Path) -> Iterator[None]:
    with locked(runs / "lock", "The project"):
        yield
