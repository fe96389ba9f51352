"""The command ``check``: all problems of a project, and the safe repairs of some."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sitewright.cli.infer_commands import change_lines, changes_json
from sitewright.cli.options import FILE, cell_option, json_option, project_argument
from sitewright.cli.output import Output, problems_json
from sitewright.cli.reach_report import show_reach

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sitewright.errors import Problem
    from sitewright.foundation.canonical import Json

_INVALID = 3


@click.command()
@project_argument
@cell_option
@click.option("--all", "is_all", is_flag=True, help="One line per problem; nothing is folded.")
@click.option("--fix", is_flag=True, help="Show what the safe repairs would change.")
@click.option("--write", is_flag=True, help="With --fix: change building.json, keep the old one.")
@click.option("--reach", is_flag=True, help="Say who reaches what, in which way, instead.")
@click.option("--svg", type=FILE, help="With --reach: write the picture to this file.")
@json_option
def check(  # noqa: PLR0913 -- click
    project: Path,
    cell: Path | None,
    *,
    is_all: bool,
    fix: bool,
    write: bool,
    reach: bool,
    svg: Path | None,
    is_json: bool,
) -> int:
    """List every problem of a project's files, with what to do about each.

    With --reach: which robot can take, place, fasten and finish what, in which way, and what is
    proven impossible. No paths are searched.
    """
    from sitewright.app.checking import check as problems_of

    if write and not fix:
        raise click.UsageError("--write goes with --fix.")
    if (svg is not None or fix) and reach == fix:
        raise click.UsageError("--svg goes with --reach, and --reach without --fix.")
    out = Output(is_json)
    if reach:
        return show_reach(out, project, cell, svg=svg, is_all=is_all)
    if fix:
        return _fix(out, project, cell, is_all=is_all, write=write)
    problems = problems_of(project, cell=cell)
    _say(out, problems, is_all=is_all)
    out.document("sitewright.check/1", _document(problems))
    return _code(problems)


def _fix(out: Output, project: Path, cell: Path | None, *, is_all: bool, write: bool) -> int:
    from sitewright.app.model_writing import BACKUP
    from sitewright.app.repairing import repair_project

    found = repair_project(project, write=write, cell=cell)
    for line in change_lines(found.changes):
        out.line(line)
    count = len(found.changes)
    if found.is_written:
        out.line(f"{count} changes written; the old model is {project / BACKUP}.")
    elif count:
        out.line(f"{count} changes; nothing is written without --write.")
    else:
        out.line("Nothing that can be repaired safely.")
    out.line(f"{len(found.mended)} problems mended. What stays:")
    _say(out, found.problems, is_all=is_all)
    out.document(
        "sitewright.check/1",
        {
            **_document(found.problems),
            "is_written": found.is_written,
            "mended": problems_json(found.mended),
            "changes": changes_json(found.changes),
        },
    )
    return _code(found.problems)


def _say(out: Output, problems: Sequence[Problem], *, is_all: bool) -> None:
    from sitewright.interaction_twin.problem_lines import problem_lines

    lines = list(problem_lines(problems, is_all=is_all))
    for line in lines:
        out.line(line)
    errors = sum(p.severity == "E" for p in problems)
    fixable = sum(p.is_fixable for p in problems)
    mends = f" `sitewright check --fix` mends {fixable}." if fixable else ""
    folded = " --all lists each." if len(lines) < len(problems) else ""
    counts = f"{_counted(errors, 'error')}, {_counted(len(problems) - errors, 'warning')}"
    out.line(f"{counts}.{mends}{folded}")


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _document(problems: Sequence[Problem]) -> dict[str, Json]:
    errors = sum(p.severity == "E" for p in problems)
    return {
        "errors": errors,
        "warnings": len(problems) - errors,
        "fixable": sum(p.is_fixable for p in problems),
        "problems": problems_json(problems),
    }


def _code(problems: Sequence[Problem]) -> int:
    return _INVALID if any(p.severity == "E" for p in problems) else 0
