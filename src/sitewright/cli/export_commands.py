"""The command that writes the as-built state for other programs: ``export``."""

from __future__ import annotations

from pathlib import Path

import click

from sitewright.cli.options import FILE, cell_option, json_option, project_argument
from sitewright.cli.output import Output


@click.command()
@project_argument
@cell_option
@click.option("--json-model", "kind", flag_value="json", help="As-built model, native schema.")
@click.option("--csv", "kind", flag_value="csv", default="csv", help="Table (the default).")
@click.option("--ifc", "kind", flag_value="ifc", help="Lines added to a copy of the IFC file.")
@click.option("--3dm", "kind", flag_value="rhino", help="Onto a copy of the Rhino file.")
@click.option("--original", type=FILE, help="The imported file, if it has moved.")
@click.option("-o", "--out", type=click.Path(path_type=Path), help="File to write.")
@json_option
def export(
    project: Path,
    cell: Path | None,
    kind: str,
    original: Path | None,
    out: Path | None,
    *,
    is_json: bool,
) -> int:
    """Write what was built: a table, the as-built model, or a patch on a copy of the original."""
    from sitewright.app import exporting
    from sitewright.app.project import open_project

    screen = Output(is_json)
    opened = open_project(project, cell=cell)
    goal = out or opened.folder / f"as_built.{kind}"
    if kind == "json":
        written = exporting.export_json(opened, goal)
    elif kind == "ifc":
        source = original or exporting.original_of(opened, "ifc")
        goal = out or source.with_name(f"{source.stem}_asbuilt.ifc")
        written = exporting.export_ifc(opened, source, goal)
    elif kind == "rhino":
        source = original or exporting.original_of(opened, "rhino")
        goal = out or source.with_name(f"{source.stem}_asbuilt.3dm")
        written = exporting.export_rhino(opened, source, goal)
    else:
        written = exporting.export_csv(opened, goal)
    for note in written.notes:
        screen.note(note)
    listed = ", ".join(str(f) for f in written.files)
    screen.line(f"Wrote {listed}: {written.installed} installed components.")
    screen.document(
        "sitewright.export/1",
        {
            "files": [str(f) for f in written.files],
            "installed": written.installed,
            "notes": list(written.notes),
        },
    )
    return 0
