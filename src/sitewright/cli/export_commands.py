"""The command that writes a state of the building for other programs: ``export``."""

from __future__ import annotations

from pathlib import Path

import click

from sitewright.cli.options import FILE, cell_option, json_option, project_argument
from sitewright.cli.output import Output

_BY_ENDING = {".json": "json", ".csv": "csv", ".glb": "glb", ".ifc": "ifc", ".3dm": "rhino"}


@click.command()
@project_argument
@cell_option
@click.option("--json-model", "kind", flag_value="json", help="Model, native schema.")
@click.option("--csv", "kind", flag_value="csv", help="Table (the default).")
@click.option("--gltf", "kind", flag_value="glb", help="3D scene, one .glb file.")
@click.option("--ifc", "kind", flag_value="ifc", help="Lines added to a copy of the IFC file.")
@click.option("--3dm", "kind", flag_value="rhino", help="Onto a copy of the Rhino file.")
@click.option("--design", "is_design", is_flag=True, help="As designed, nothing built yet.")
@click.option("--run", default="", help="As the run with this id left it; now by default.")
@click.option("--original", type=FILE, help="The imported file, if it has moved.")
@click.option("-o", "--out", type=click.Path(path_type=Path), help="File to write.")
@json_option
def export(  # noqa: PLR0913 -- one argument for each option
    project: Path,
    cell: Path | None,
    kind: str | None,
    run: str,
    original: Path | None,
    out: Path | None,
    *,
    is_design: bool,
    is_json: bool,
) -> int:
    """Write what was built: a table, a model, a 3D scene, or a patch on a copy of the original.

    Without an option for the kind, the ending of --out says it: .csv, .json, .glb, .ifc, .3dm.
    """
    from sitewright.app.built_state import Moment, state_at
    from sitewright.app.exporting import export_as

    if is_design and run:
        raise click.UsageError("--design and --run name two states; give one.")
    screen = Output(is_json)
    state = state_at(project, Moment(is_design=is_design, run=run), cell=cell)
    ending = out.suffix.lower() if out is not None else ""
    written = export_as(kind or _BY_ENDING.get(ending, "csv"), state, original=original, out=out)
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
