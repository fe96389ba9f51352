"""The terminal as the approval dialogue sees it, and a status line while nothing is asked."""

from __future__ import annotations

import sys
from types import TracebackType
from typing import TYPE_CHECKING, Self

import click

from sitewright.foundation.plain_text import printable

if TYPE_CHECKING:
    from rich.status import Status


class Dialogue:
    """Shows lines on stderr and reads answers from stdin; a spinner runs while planning.

    The spinner is there only on a terminal; in a pipe or a log there are plain lines.
    """

    def __init__(self) -> None:
        self._status: Status | None = None

    def __enter__(self) -> Self:
        """Start the spinner, if there is a terminal."""
        if sys.stderr.isatty():
            from rich.console import Console

            self._status = Console(stderr=True).status("Planning ...")
            self._status.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Stop the spinner."""
        if self._status is not None:
            self._status.stop()
            self._status = None

    def say(self, line: str) -> None:
        """Show a line above the spinner."""
        line = printable(line)
        if self._status is None:
            click.echo(line, err=True)
            return
        self._status.console.print(line, markup=False, highlight=False, soft_wrap=True)
        words = line.strip()
        if words:
            self._status.update(words[:80].replace("[", "("))

    def ask(self, prompt: str) -> str | None:
        """Return what was typed; None at the end of the input."""
        if self._status is not None:
            self._status.stop()
        click.echo(printable(prompt), err=True, nl=False)
        typed = sys.stdin.readline()
        if self._status is not None:
            self._status.start()
        if not typed:
            click.echo("", err=True)
            return None
        if not sys.stdin.isatty():  # nobody saw it being typed
            click.echo(typed.rstrip(), err=True)
        return typed.strip()
