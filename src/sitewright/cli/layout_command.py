"""The command ``layout``: better places for robots and stock, shown, and written if asked."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sitewright.cli.options import FILE, cell_option, json_option, project_argument
from sitewright.cli.output import Output
from sitewright.cli.terminal import Dialogue

if TYPE_CHECKING:
    from sitewright.app.layout import LayoutProposal
    from sitewright.foundation.canonical import Json
    from sitewright.planning_twin.layout.judging import Judgement

PICTURE = "layout.svg"
_DONE, _NO_MOTION = 0, 6


@click.command()
@project_argument
@cell_option
@click.option("--seed", default=0, show_default=True, help="The same seed finds the same places.")
@click.option(
    "--budget", default=60, show_default=True, help="So many reach checks may be made at most."
)
@click.option("--area", help="Floor that may be used: x0,y0,x1,y1 in metres. [the widest fixture]")
@click.option("--keep", multiple=True, help="Id of a robot or stock place that stays; repeatable.")
@click.option("--svg", type=FILE, help="Write the picture to this file.")
@click.option("--write", is_flag=True, help="Change cell.toml; keeps cell.toml.bak.")
@json_option
def layout(  # noqa: PLR0913 -- click
    project: Path,
    cell: Path | None,
    *,
    seed: int,
    budget: int,
    area: str | None,
    keep: tuple[str, ...],
    svg: Path | None,
    write: bool,
    is_json: bool,
) -> int:
    """Propose better places for robots and stock, so that more of the model can be built.

    Fixtures that carry only one of them go with it; other fixtures, tool stations and the model
    stay. Nothing is written without --write.
    """
    from sitewright.app.cell_writing import write_cell
    from sitewright.app.clock import SystemClock
    from sitewright.app.layout import LayoutOptions, propose_layout
    from sitewright.app.project import read_project
    from sitewright.interaction_twin.labels import labels_of
    from sitewright.interaction_twin.reach.moves import layout_lines, layout_picture

    opened, out = read_project(project, cell=cell), Output(is_json)
    _require_known(keep, {*opened.cell.robot_by_id, *opened.cell.stock_place_by_id})
    options = LayoutOptions(seed=seed, budget=budget, area_m=_area(area), kept=keep)
    with Dialogue() as dialogue:
        found = propose_layout(opened, options, SystemClock(), lambda j: dialogue.say(_progress(j)))
    labels = labels_of(opened.model, opened.cell)
    for line in layout_lines(found.yard, found.arrangement, found.before, found.after):
        out.line(line)
    file = svg or project / PICTURE
    title = opened.model.name or project.resolve().name
    reports = (found.before, found.after)
    drawn = layout_picture(found.yard, found.arrangement, reports, labels, title)
    file.write_text(drawn + "\n", encoding="utf-8")
    out.line(f"Picture: {file}")
    is_written = write and found.is_better
    if is_written:
        backup = write_cell(opened, found.project.cell)
        out.line(f"{opened.cell_file} is changed; the old one is {backup}.")
    elif found.is_better:
        out.line("Nothing is written without --write.")
    out.document(
        "sitewright.layout/1", {**_document(found), "svg": str(file), "is_written": is_written}
    )
    return _DONE if found.after.share == 1.0 else _NO_MOTION


def _progress(judgement: Judgement) -> str:
    blocked = f", {', '.join(judgement.blocked)} not clear" if judgement.blocked else ""
    return f"{100.0 * judgement.report.share:.0f} % buildable{blocked}"


def _area(words: str | None) -> tuple[tuple[float, float], tuple[float, float]] | None:
    if words is None:
        return None
    try:
        x0, y0, x1, y1 = (float(w) for w in words.split(","))
    except ValueError:
        raise click.UsageError("--area wants four numbers: x0,y0,x1,y1.") from None
    if x0 >= x1 or y0 >= y1:
        raise click.UsageError("--area wants the lower left corner first: x0 < x1, y0 < y1.")
    return (x0, y0), (x1, y1)


def _require_known(names: tuple[str, ...], known: set[str]) -> None:
    from sitewright.errors import did_you_mean

    for name in names:
        if name not in known:
            hint = did_you_mean(name, known)
            raise click.UsageError(f"--keep {name}: no such robot or stock place.{hint}")


def _document(found: LayoutProposal) -> dict[str, Json]:
    from sitewright.interaction_twin.reach.moves import move_lines

    moves: list[Json] = [
        {"id": m.id, "kind": m.kind.value, "x_m": s.x_m, "y_m": s.y_m, "yaw_rad": s.yaw_rad}
        for m in found.yard.movables
        for s in (found.arrangement.get(m.id),)
        if s is not None
    ]
    return {
        "share_before": found.before.share,
        "share_after": found.after.share,
        "moves": moves,
        "words": list(move_lines(found.yard, found.arrangement, found.before)),
        "notes": list(found.after.notes),
    }
