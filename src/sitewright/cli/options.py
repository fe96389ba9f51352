"""Options that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import click

Command = TypeVar("Command", bound=Callable[..., object])

FOLDER = click.Path(path_type=Path, file_okay=False)
FILE = click.Path(path_type=Path, dir_okay=False)


def json_option(command: Command) -> Command:
    """Add ``--json`` (and ``--debug``, which `main` looks for)."""
    command = click.option("--json", "is_json", is_flag=True, help="One JSON document on stdout.")(
        command
    )
    return click.option(
        "--debug", is_flag=True, expose_value=False, help="Show where an error comes from."
    )(command)


def cell_option(command: Command) -> Command:
    """Add ``--cell``."""
    return click.option(
        "--cell", type=FILE, help="Another cell file than cell.toml, relative to the project."
    )(command)


def project_argument(command: Command) -> Command:
    """Add the project folder, the working folder by default."""
    return click.argument("project", type=FOLDER, default=Path())(command)


def approve_option(default: str) -> Callable[[Command], Command]:
    """Add ``--approve`` with its default."""
    return click.option(
        "--approve",
        type=click.Choice(["plan", "step", "auto"]),
        default=default,
        show_default=True,
        help="Ask once per plan, before each step, or never (auto: simulation only).",
    )
