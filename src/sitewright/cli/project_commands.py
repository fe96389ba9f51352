"""Commands about project folders: ``new`` and ``check``."""

from __future__ import annotations

from pathlib import Path

import click

from sitewright.cli.options import FOLDER, cell_option, json_option, project_argument
from sitewright.cli.output import Output, problems_json

_INVALID = 3


@click.command()
@click.argument("folder", type=FOLDER)
@click.option("--example", default="wooden_frame", show_default=True, help="What to copy.")
@json_option
def new(folder: Path, example: str, is_json: bool) -> int:  # noqa: FBT001 -- click
    """Make a project folder to start from: a copy of an example."""
    from sitewright.app.project import new_project

    out = Output(is_json)
    made = new_project(folder, example=example)
    files = sorted(f.name for f in made.iterdir())
    out.line(f"Made {made} with {', '.join(files)}.")
    out.line(f"Next: sitewright check {made}, then sitewright run {made}")
    out.document("sitewright.new/1", {"folder": str(made), "files": files})
    return 0


@click.command()
@project_argument
@cell_option
@json_option
def check(project: Path, cell: Path | None, is_json: bool) -> int:  # noqa: FBT001 -- click
    """List every problem of a project's files, with what to do about each."""
    from sitewright.app.project import check as problems_in

    out = Output(is_json)
    problems = problems_in(project, cell=cell)
    errors = sum(p.severity == "E" for p in problems)
    warnings = len(problems) - errors
    for problem in problems:
        out.line(str(problem))
    out.line(f"{errors} errors, {warnings} warnings.")
    out.document(
        "sitewright.check/1",
        {"errors": errors, "warnings": warnings, "problems": problems_json(problems)},
    )
    return _INVALID if errors else 0
