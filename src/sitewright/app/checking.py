"""Lists every problem of a project: its files, its model, its shapes, and how all fits the cell."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from sitewright.app.import_notes import notes_for
from sitewright.app.project import BUILDING, CELL, Project, problems_of, require_project
from sitewright.building_model.formats.native import read_as_written
from sitewright.building_model.inference.bare import without_inferred
from sitewright.building_model.inference.completion import is_jointed_frame
from sitewright.building_model.inference.geometry_check import with_geometry
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.spelling import spelled_out
from sitewright.building_model.validation import STRUCTURE_CODES, check_model
from sitewright.construction_graph.siting import sited
from sitewright.errors import CellRejectedError, ModelRejectedError, Problem
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.formats.cell_toml import read_cell

_STOCK = frozenset({"M1", "M2", "M3"})


def check(path: Path | str, *, cell: Path | str | None = None) -> list[Problem]:
    """Return every problem of a project's files, of the model and of how it fits the cell.

    What the import said of a file that cannot be seen in the model any more is said again.

    Raises:
        ProjectError: The folder or one of its files is missing.
    """
    folder = Path(path)
    cell_file = folder / (cell or CELL)
    require_project(folder, cell_file)
    model, found = _model_of(folder / BUILDING)
    if model is None:
        return _sorted([*found, *_cell_of(cell_file)[1]])
    return _checked(folder, cell_file, model, found)


def check_model_file(folder: Path, cell_file: Path, model: BuildingModel) -> list[Problem]:
    """Return every problem of a project as if its building file held this model."""
    return _checked(folder, cell_file, model, check_model(model))


def _checked(
    folder: Path, cell_file: Path, model: BuildingModel, found: list[Problem]
) -> list[Problem]:
    team, wrong = _cell_of(cell_file)
    if any(is_structural(p) for p in found):
        found = marked_fixable(model, found)
    elif team is None:
        found = with_geometry(model, found)
    else:
        placed = sited(team, model)
        found = problems_in(Project(folder=folder, cell_file=cell_file, model=model, cell=placed))
    return _sorted([*found, *wrong, *notes_for(folder, found)])


def problems_in(project: Project) -> list[Problem]:
    """Return all problems of a project whose files can be read, those of its shapes too."""
    found = with_geometry(project.model, problems_of(project))
    return marked_stock(project.model, project.cell, found)


def is_structural(problem: Problem) -> bool:
    """Whether a model with this problem has no graph or no shapes."""
    return problem.severity == "E" and problem.code in STRUCTURE_CODES


def marked_fixable(model: BuildingModel, found: Iterable[Problem]) -> list[Problem]:
    """Mark the problems that only inferred facts cause: they can be inferred anew."""
    bare = check_model(without_inferred(spelled_out(model)))
    stays = {_key(p) for p in bare}
    return [replace(p, is_fixable=_key(p) not in stays) if is_structural(p) else p for p in found]


def marked_stock(model: BuildingModel, cell: Cell, found: Sequence[Problem]) -> list[Problem]:
    """Mark targets without stock for which stock can be laid out."""
    given = without_inferred(model)
    taken = {s.place for s in given.stacks}
    if not is_jointed_frame(given) and not cell.stock_place_by_id.keys() - taken:
        return list(found)
    floating = {p.where for p in found if p.code == "F2"}
    return [
        replace(p, is_fixable=True, fix=f"{p.fix} Or let `sitewright infer --write` lay it out.")
        if p.code in _STOCK and p.where not in floating
        else p
        for p in found
    ]


def _model_of(file: Path) -> tuple[BuildingModel | None, list[Problem]]:
    try:
        return read_as_written(file)
    except ModelRejectedError as rejected:
        return None, list(rejected.problems)


def _cell_of(file: Path) -> tuple[Cell | None, list[Problem]]:
    try:
        return read_cell(file), []
    except CellRejectedError as rejected:
        return None, list(rejected.problems)


def _key(problem: Problem) -> tuple[str, str, str]:
    return problem.code, problem.where, problem.message


def _sorted(found: Iterable[Problem]) -> list[Problem]:
    return sorted(found, key=lambda p: (p.severity, p.where, p.code, p.message))
