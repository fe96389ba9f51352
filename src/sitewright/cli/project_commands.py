"""The command that makes a project folder to start from: ``new``."""

from __future__ import annotations

from pathlib import Path

import click

from sitewright.cli.options import FOLDER, json_option
from sitewright.cli.output import Output


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
