"""Commands about project folders: ``new``, ``import`` and ``check``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from sitewright.cli.options import FILE, FOLDER, cell_option, json_option, project_argument
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


@click.command("import")
@click.argument("file", type=FILE)
@click.option("--unit", help="Length unit of the file's numbers, if it states none: mm, m, in ...")
@click.option(
    "--map", "map_file", type=FILE, help="import.toml: what foreign keys and layers mean."
)
@click.option("--repair", type=click.Choice(["hull"]), help="Close open meshes by their hull.")
@click.option("--split", "is_split", is_flag=True, help="Each body of a part is a component.")
@click.option("-o", "--out", "folder", type=FOLDER, required=True, help="Project to make.")
@json_option
def import_(
    file: Path,
    folder: Path,
    is_json: bool,  # noqa: FBT001 -- click
    **options: Any,  # noqa: ANN401 -- click
) -> int:
    """Make a project from a design FILE of another program.

    The kind is told by the content: Rhino .3dm (extra [rhino]), IFC ([ifc]), compas_timber JSON
    ([timber]), BTLx, OBJ, compas_assembly JSON, bar-frame JSON.
    """
    from sitewright.app.importing import ImportOptions, import_file

    out = Output(is_json)
    result = import_file(file, folder, ImportOptions(**options))
    for problem in result.problems:
        out.note(str(problem))
    out.line(
        f"Made {result.folder} with {result.targets_total} components to build ({result.kind})."
    )
    then = "plan" if result.is_inferred else "infer"
    out.line(f"Next: sitewright check {result.folder}, then sitewright {then} {result.folder}")
    out.document(
        "sitewright.import/1",
        {
            "folder": str(result.folder),
            "kind": result.kind,
            "targets_total": result.targets_total,
            "problems": problems_json(result.problems),
        },
    )
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
