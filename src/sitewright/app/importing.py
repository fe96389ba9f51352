"""Makes a project of a file of another program: read, infer what it lacks, write."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

from sitewright.app.project import BUILDING, CELL, ProjectError, example_folder
from sitewright.building_model.component import Layer
from sitewright.building_model.formats.compas_timber import import_compas_timber
from sitewright.building_model.formats.native import write_building
from sitewright.building_model.inference.assembly import infer_assembly
from sitewright.errors import Problem

_CELL_EXAMPLE = "frame_house"


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportResult:
    """A project that was made of a file.

    Attributes:
        problems: Warnings, and what could not be inferred.
        has_new_cell: The folder had no cell; it got one laid out for timber frames.
    """

    folder: Path
    targets_total: int
    problems: tuple[Problem, ...]
    has_new_cell: bool


def import_file(file: Path, unit: str | None, out: Path) -> ImportResult:
    """Read a timber model, infer what its format cannot say, and write a project.

    Args:
        file: A compas_timber JSON file.
        unit: Length unit of its numbers (``mm``, ``m`` ...).
        out: Project folder; a building that is there already is not overwritten.

    Raises:
        ModelRejectedError: The file cannot be read, or parts of it are wrong.
        ProjectError: The folder holds a building already.
    """
    if (out / BUILDING).exists():
        raise ProjectError(f"{out} has a {BUILDING} already; name a new folder.")
    model, warnings = import_compas_timber(file, unit)
    model, open_points = infer_assembly(model)
    out.mkdir(parents=True, exist_ok=True)
    has_new_cell = not (out / CELL).exists()
    if has_new_cell:
        shutil.copy(example_folder(_CELL_EXAMPLE) / CELL, out / CELL)
    write_building(model, out / BUILDING)
    return ImportResult(
        folder=out,
        targets_total=sum(c.layer is Layer.TARGET for c in model.component_by_id.values()),
        problems=(*warnings, *open_points),
        has_new_cell=has_new_cell,
    )
