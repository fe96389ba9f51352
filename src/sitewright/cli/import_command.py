"""The command ``import``: a design file becomes a project, or a changed one is merged into it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sitewright.cli.change_words import change_lines, conflict_lines
from sitewright.cli.options import FILE, FOLDER, json_option
from sitewright.cli.output import Output, problems_json

if TYPE_CHECKING:
    from sitewright.app.importing import ImportOptions
    from sitewright.app.reimporting import Reimport, Wishes

_INVALID = 3
_GB, _S = click.FloatRange(0.25, 1024.0), click.FloatRange(1.0, 86_400.0)


@click.command("import")
@click.argument("file", type=FILE)
@click.option("--unit", help="Length unit of the file's numbers, if it states none: mm, m, in ...")
@click.option(
    "--map", "map_file", type=FILE, help="import.toml: what foreign keys and layers mean."
)
@click.option("--repair", type=click.Choice(["hull"]), help="Close open meshes by their hull.")
@click.option("--split", "is_split", is_flag=True, help="Each body of a part is a component.")
@click.option("--group", help="Build only this group, e.g. one wall panel; draw the rest.")
@click.option("--lay-flat", "lays_flat", is_flag=True, help="Drawn standing, built lying flat.")
@click.option("--turn-over", "is_turned_over", is_flag=True, help="Laid flat: the other face down.")
@click.option("--reader-gb", type=_GB, help="Memory that reading may use.  [default: 4]")
@click.option("--reader-s", type=_S, help="Seconds that reading may take.  [default: 60]")
@click.option(
    "-o", "--out", "folder", type=FOLDER, required=True, help="Project to make or to change."
)
@click.option("--write", is_flag=True, help="Changed file: change the project; else only a diff.")
@click.option(
    "--keep-installed",
    "keeps_installed",
    is_flag=True,
    help="Changed file: leave what stands as it is.",
)
@click.option(
    "--prefer",
    type=click.Choice(["mine", "file"]),
    default="mine",
    show_default=True,
    help="Changed file: who wins where you and the file changed a fact.",
)
@click.option("--base", type=FILE, help="Changed file: the one before, if no record of it is kept.")
@json_option
def import_(
    file: Path,
    folder: Path,
    is_json: bool,  # noqa: FBT001 -- click
    **options: Any,  # noqa: ANN401 -- click
) -> int:
    """Make a project from a design FILE of another program, or take a changed one into it.

    The kind is told by the content: Rhino .3dm (extra [rhino]), IFC ([ifc]), compas_timber JSON
    ([timber]), BTLx, OBJ, compas_assembly JSON, bar-frame JSON. Into a project that was imported
    before, the changes of the file are merged: a diff is shown, --write takes them.
    """
    from sitewright.app.importing import ImportOptions
    from sitewright.app.project import BUILDING
    from sitewright.app.reimporting import Wishes
    from sitewright.building_model.merging import Preference

    out = Output(is_json)
    wishes = Wishes(
        write=options.pop("write"),
        keeps_installed=options.pop("keeps_installed"),
        prefer=Preference(options.pop("prefer")),
        base=options.pop("base"),
    )
    taken = ImportOptions(**options)
    if not (folder / BUILDING).exists():
        return _new(file, folder, taken, out)
    return _changed(file, folder, taken, wishes, out)


def _new(file: Path, folder: Path, options: ImportOptions, out: Output) -> int:
    from sitewright.app.importing import import_file
    from sitewright.app.inferring import PANEL_RULES

    result = import_file(file, folder, options)
    out.notes(result.problems)
    out.line(
        f"Made {result.folder} with {result.targets_total} components to build ({result.kind})."
    )
    then = "plan" if result.is_inferred else "infer"
    rules = f" --rules {PANEL_RULES} --write" if result.is_laid_flat and then == "infer" else ""
    out.line(
        f"Next: sitewright check {result.folder}, then sitewright {then} {result.folder}{rules}"
    )
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


def _changed(file: Path, folder: Path, options: ImportOptions, wishes: Wishes, out: Output) -> int:
    from sitewright.app.reimporting import reimport_file

    found = reimport_file(file, folder, options, wishes)
    for line in change_lines(found.changes, found.before, found.after):
        out.line(line)
    for line in conflict_lines(found.conflicts):
        out.line(line)
    out.notes(found.problems)
    out.line(_summary(found))
    out.document("sitewright.reimport/1", _document(found))
    return _INVALID if found.is_refused else 0


def _summary(found: Reimport) -> str:
    from sitewright.app.model_writing import BACKUP
    from sitewright.central_controller.fingerprint import check_code

    count = len(found.changes)
    if found.is_refused:
        return f"{count} changes; nothing is written: the file changes what stands already (I1)."
    if not found.is_written:
        return f"{count} changes; nothing is written without --write."
    words = f"{count} changes written; the old model is {found.folder / BACKUP}."
    if found.superseded:
        words += (
            f" Plan {check_code(found.superseded)} is superseded; "
            f"`sitewright run {found.folder}` proposes a new one."
        )
    return words


def _document(found: Reimport) -> dict[str, Any]:
    from sitewright.app.model_changes import plain_value

    return {
        "folder": str(found.folder),
        "kind": found.kind,
        "is_written": found.is_written,
        "superseded": found.superseded,
        "changes": [
            {"where": c.where, "key": c.key, "old": c.old, "new": c.new, "why": c.why}
            for c in found.changes
        ],
        "conflicts": [
            {
                "where": c.where,
                "key": c.key,
                "mine": plain_value(c.mine),
                "file": plain_value(c.file),
                "taken": c.taken.value,
            }
            for c in found.conflicts
        ],
        "problems": problems_json(found.problems),
    }
