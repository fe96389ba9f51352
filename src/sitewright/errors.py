"""Every exception that Sitewright raises on purpose.

SitewrightError
    BuildingModelError      the designer can fix it
        ModelRejectedError      a file with its whole list of problems
    TeamError               the cell or the team cannot do it
        CellRejectedError       a cell file with its whole list of problems
    ApprovalError           approval missing, stale or refused
    ExecutionError          the site did not do what was commanded
        CommandRefusedError     a driver did not accept a command; nothing moved
    JournalError            the record cannot be written or trusted
    BackendError            an outside program is missing, broke or was slow
        BackendMissingError     it is not installed
        OutcomeUnknownError     the connection was lost while a command ran
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from difflib import get_close_matches

from typing_extensions import override


class SitewrightError(Exception):
    """Base of all errors on purpose; `exit_code` is the command line's answer."""

    exit_code = 1


class BuildingModelError(SitewrightError):
    """The building model or project is wrong; its author can fix it."""

    exit_code = 3


class TeamError(SitewrightError):
    """No robot of this cell can do what is asked."""

    exit_code = 3


class ApprovalError(SitewrightError):
    """What should run is not what was approved, or nothing was approved."""

    exit_code = 7


class ExecutionError(SitewrightError):
    """A skill failed or its outcome is unknown."""

    exit_code = 8


class CommandRefusedError(ExecutionError):
    """A driver did not accept a command (old epoch, unknown skill ...); nothing moved."""


class JournalError(SitewrightError):
    """The journal cannot be written, or what it holds cannot be trusted."""

    exit_code = 8


class BackendError(SitewrightError):
    """A program or library that we call is missing, broke or was slow."""

    exit_code = 10


class BackendMissingError(BackendError):
    """A backend is not installed; the message says how to get it."""

    def __init__(
        self, role: str, name: str, *, available: Iterable[str], install: str = ""
    ) -> None:
        self.name = name
        there = ", ".join(sorted(available)) or "none"
        hint = f" Install it with: {install}" if install else ""
        super().__init__(f"The {role} {name!r} is not installed; available: {there}.{hint}")


class OutcomeUnknownError(BackendError):
    """The connection to a driver was lost while a command ran; nobody knows how it ended."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """One thing that is wrong in a file, with its place and its fix.

    Attributes:
        code: Validation code of the documentation, e.g. ``P1``.
        severity: ``E`` refuses the file, ``W`` does not.
        where: Component, robot or key that it is about; never empty.
        message: What is wrong, in one sentence.
        fix: What to do about it, in one sentence.
        source_id: Id of the same thing in the file it was imported from, if any.
        is_fixable: ``sitewright check --fix`` mends it without altering what the author stated.
    """

    code: str
    severity: str
    where: str
    message: str
    fix: str
    source_id: str = ""
    is_fixable: bool = False

    @override
    def __str__(self) -> str:
        """Return the line that a person reads."""
        source = f" [{self.source_id}]" if self.source_id not in {"", self.where} else ""
        said = f"{self.message} {self.fix}".rstrip()
        return f"{self.severity} {self.code} {self.where}{source}: {said}"


class ModelRejectedError(BuildingModelError):
    """A file with problems; all of them are listed, not only the first."""

    def __init__(self, file: str, problems: Sequence[Problem]) -> None:
        self.file, self.problems = file, tuple(problems)
        count = len(self.problems)
        lines = "\n  ".join(str(p) for p in self.problems)
        super().__init__(f"{file}: {count} problem{'s' if count != 1 else ''}\n  {lines}")


class CellRejectedError(TeamError):
    """A cell file with problems; all of them are listed."""

    def __init__(self, file: str, problems: Sequence[Problem]) -> None:
        self.file, self.problems = file, tuple(problems)
        count = len(self.problems)
        lines = "\n  ".join(str(p) for p in self.problems)
        super().__init__(f"{file}: {count} problem{'s' if count != 1 else ''}\n  {lines}")


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return `` Did you mean a, b?`` with the nearest known names, or nothing."""
    similar = get_close_matches(name, sorted(known), n=3)
    return f" Did you mean {', '.join(similar)}?" if similar else ""
