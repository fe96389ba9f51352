"""A failed command: what went wrong in words, as JSON if asked for, and the exit code."""

from __future__ import annotations

import errno
import json
import sys
import traceback
from collections.abc import Sequence

import click

from sitewright.cli.output import problems_json
from sitewright.errors import CellRejectedError, ModelRejectedError, SitewrightError
from sitewright.foundation.canonical import Json
from sitewright.foundation.plain_text import json_text, one_line, printable

INTERNAL, USAGE, INTERRUPTED = 1, 2, 130
SCHEMA = "sitewright.error/1"


def failed(error: BaseException, arguments: Sequence[str]) -> int:
    """Print an error as the command line was asked to, and return the exit code.

    Args:
        error: What ended the command.
        arguments: The command line, which may not even have been parsed.
    """
    code, message = _what(error)
    if "--debug" in arguments:
        traceback.print_exception(error, file=sys.stderr)
    if "--json" in arguments:
        document = _document(error, code, message)
        click.echo(json_text(json.dumps(document, indent=2, ensure_ascii=False)))
    if isinstance(error, click.UsageError):
        error.show()
    elif message:
        click.secho(f"error: {printable(message)}", err=True, fg="red")
    if code == INTERNAL and "--debug" not in arguments:
        click.echo("This is a bug in Sitewright; --debug shows where.", err=True)
    return code


def _what(error: BaseException) -> tuple[int, str]:
    match error:
        case ModelRejectedError() | CellRejectedError():
            return error.exit_code, _rejected(error)
        case SitewrightError():
            return error.exit_code, str(error)
        case click.Abort() | KeyboardInterrupt():
            return INTERRUPTED, "interrupted"
        case click.ClickException():
            return USAGE, error.format_message()
        case OSError(filename=name, strerror=why, errno=number) if name:
            return USAGE if number == errno.ENAMETOOLONG else INTERNAL, f"{name}: {why}"
        case _:
            return INTERNAL, f"{type(error).__name__}: {error}"


def _rejected(error: ModelRejectedError | CellRejectedError) -> str:
    """Say what is wrong with a file; what many of its components share is said once."""
    from sitewright.interaction_twin.problem_lines import problem_lines

    count = len(error.problems)
    lines = (f"\n  {line}" for line in problem_lines(error.problems))
    return f"{one_line(error.file)}: {count} problem{'s' if count != 1 else ''}{''.join(lines)}"


def _document(error: BaseException, code: int, message: str) -> dict[str, Json]:
    document: dict[str, Json] = {
        "schema": SCHEMA,
        "exit_code": code,
        "error": type(error).__name__,
        "message": message,
    }
    if isinstance(error, ModelRejectedError | CellRejectedError):
        document["problems"] = problems_json(error.problems)
    return document
