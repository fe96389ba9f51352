"""What goes where: the result to stdout (as one JSON document if asked), the rest to stderr."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import click

from sitewright.errors import Problem
from sitewright.foundation.canonical import Json
from sitewright.foundation.plain_text import json_text, printable


@dataclass(frozen=True, slots=True)
class Output:
    """Where a command's words go.

    Attributes:
        is_json: Print one document instead of lines.
    """

    is_json: bool

    def line(self, words: str = "") -> None:
        """Print a line of the result for people."""
        if not self.is_json:
            click.echo(printable(words))

    def note(self, words: str) -> None:
        """Print progress."""
        click.echo(printable(words), err=True)

    def notes(self, problems: Sequence[Problem]) -> None:
        """Print problems beside the result; what many components share is said once."""
        from sitewright.interaction_twin.problem_lines import problem_lines

        for line in problem_lines(problems):
            self.note(line)

    def document(self, schema: str, content: Mapping[str, Json]) -> None:
        """Print the result as JSON, if JSON was asked for."""
        if self.is_json:
            text = {"schema": schema, **content}
            document = json.dumps(text, indent=2, ensure_ascii=False, allow_nan=False)
            click.echo(json_text(document))


def problem_json(problem: Problem) -> dict[str, Json]:
    """Return a problem of a file as JSON."""
    return {
        "code": problem.code,
        "severity": problem.severity,
        "where": problem.where,
        "message": problem.message,
        "fix": problem.fix,
        "source_id": problem.source_id,
        "fixable": problem.is_fixable,
    }


def problems_json(problems: Sequence[Problem]) -> list[Json]:
    """Return all problems as JSON."""
    return [problem_json(p) for p in problems]
