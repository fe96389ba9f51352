"""Work that reads much and takes long, in a process beside the server's event loop."""

from __future__ import annotations

import asyncio
import signal
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from typing import ParamSpec, TypeVar

from sitewright.app.project import read_project
from sitewright.app.serving.past_runs import replay_of, run_document, runs_document
from sitewright.errors import BackendError, JournalError
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.phrases import Phrasebook
from sitewright.interaction_twin.web.twin import Document
from sitewright.journal.sqlite import read_records

_P = ParamSpec("_P")
_R = TypeVar("_R")


class SideWork:
    """One process that is started when it is first needed, and anew if it dies."""

    def __init__(self) -> None:
        self._pool: ProcessPoolExecutor | None = None

    async def do(self, work: Callable[_P, _R], *args: _P.args, **kwargs: _P.kwargs) -> _R:
        """Call a function of a module there.

        Raises:
            BackendError: The process died.
        """
        if self._pool is None:
            self._pool = ProcessPoolExecutor(
                max_workers=1, mp_context=get_context("spawn"), initializer=_leave_it_to_the_server
            )
        try:
            loop = asyncio.get_running_loop()
            return await loop.run_in_executor(self._pool, partial(work, *args, **kwargs))
        except BrokenProcessPool as error:
            self._pool = None
            raise BackendError("The process that looks things up ended; ask again.") from error

    def close(self) -> None:
        """End the process."""
        if self._pool is not None:
            self._pool.shutdown(wait=True, cancel_futures=True)
            self._pool = None


def _leave_it_to_the_server() -> None:
    """A Ctrl-C goes to every process of the terminal; the server ends this one in order."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def all_runs(folder: Path, cell: Path | None) -> Document:
    """Return all runs of a project."""
    return runs_document(read_project(folder, cell=cell))


def one_run(folder: Path, cell: Path | None, run: str, book: Phrasebook) -> Document | None:
    """Return a run with its events and bars."""
    project = read_project(folder, cell=cell)
    return run_document(project, run, labels_of(project.model, project.cell), book)


def replay(folder: Path, cell: Path | None, run: str) -> Document | None:
    """Return everything that was sensed in a run."""
    return replay_of(read_project(folder, cell=cell), run)


@dataclass(frozen=True, slots=True)
class StepAsked:
    """A step of a proposal, and the language to tell of it."""

    fingerprint: str
    number: int
    book: Phrasebook


def why(folder: Path, cell: Path | None, step: StepAsked) -> Document | None:
    """Return why a step of a proposal is as it is; None if there is no such step."""
    from sitewright.app.explaining_steps import explain_step
    from sitewright.errors import ApprovalError
    from sitewright.interaction_twin.step_document import step_document
    from sitewright.interaction_twin.step_words import explanation

    project = read_project(folder, cell=cell)
    try:
        reasons = explain_step(project, step.number, code=step.fingerprint)
    except ApprovalError:
        return None
    labels = labels_of(project.model, project.cell)
    lines: list[Json] = list(explanation(reasons, labels, step.book))
    return {"lines": lines, "document": step_document(reasons)}


def is_whole(runs: Path, run: str) -> bool:
    """Return whether a run's journal can be read and its chain of hashes is unbroken."""
    if not run:
        return True
    try:
        read_records(runs / run / "journal.db")
    except JournalError:
        return False
    return True
