"""Opens a project folder: building model, cell, domain and settings, checked together."""

from __future__ import annotations

import shutil
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from importlib.resources import files
from pathlib import Path

from sitewright.building_model.component import Layer
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import shape_of
from sitewright.construction_graph.project_check import check_project
from sitewright.construction_graph.siting import sited
from sitewright.errors import (
    BuildingModelError,
    ModelRejectedError,
    Problem,
    SitewrightError,
    did_you_mean,
)
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.formats.cell_toml import read_cell

BUILDING, CELL, DOMAIN, SETTINGS = "building.json", "cell.toml", "domain.pddl", "sitewright.toml"
_UNSUPPORTED = "F2"
EXAMPLES = ("wooden_frame", "painted_frame", "irb6700_frame", "track_frame", "four_arms")


class ProjectError(BuildingModelError):
    """The folder is no project; the message says what is missing and how to get it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Project:
    """A user's project.

    Attributes:
        folder: Where its files and `runs/` are.
        cell_file: The cell that is used, e.g. a mirrored one.
        cell: As in its file, with the model placed in it.
        settings: Content of ``sitewright.toml``; empty without one.
        unsupported: Targets that would stand on nothing (F2), with the reason: each is refused
            when its turn comes, the others are built.
    """

    folder: Path
    cell_file: Path
    model: BuildingModel
    cell: Cell
    settings: Mapping[str, Json] = field(default_factory=dict)
    unsupported: Mapping[ComponentId, str] = field(default_factory=dict)

    @property
    def domain_file(self) -> Path | None:
        """The user's own domain, if there is one."""
        own = self.folder / DOMAIN
        return own if own.exists() else None

    def with_model(self, model: BuildingModel) -> Project:
        """Return the project with another building, placed in the same cell."""
        bare = self.cell.world_T_model @ self.model.site_T_model.inverse()
        return replace(self, model=model, cell=sited(replace(self.cell, world_T_model=bare), model))


def open_project(path: Path | str, *, cell: Path | str | None = None) -> Project:
    """Read a project; every problem of a file is reported at once.

    Args:
        path: The project folder.
        cell: Another cell file than ``cell.toml``; relative to the folder, or absolute.

    Raises:
        ProjectError: The folder or one of its files is missing.
        ModelRejectedError: ``building.json`` has problems, or does not fit the cell.
        CellRejectedError: ``cell.toml`` has problems.
    """
    project = read_project(path, cell=cell)
    folder = project.folder
    found = [p for p in problems_of(project) if p.severity == "E"]
    errors = [p for p in found if p.code != _UNSUPPORTED]
    if errors:
        raise ModelRejectedError(str(folder / BUILDING), errors)
    floating = {ComponentId(p.where): f"{p.message} {p.fix}" for p in found}
    return replace(project, unsupported=floating)


def read_project(path: Path | str, *, cell: Path | str | None = None) -> Project:
    """Read a project whose model and cell need not fit each other.

    Args:
        path: The project folder.
        cell: As for `open_project`.

    Raises:
        ProjectError: The folder or one of its files is missing.
        ModelRejectedError: ``building.json`` cannot be read.
        CellRejectedError: ``cell.toml`` has problems.
    """
    folder = Path(path)
    cell_file = folder / (cell or CELL)
    require_project(folder, cell_file)
    model = read_building(folder / BUILDING)
    return Project(
        folder=folder,
        cell_file=cell_file,
        model=model,
        cell=sited(read_cell(cell_file), model),
        settings=_settings(folder),
    )


def problems_of(project: Project) -> list[Problem]:
    """Return all problems of a project whose files could be read, warnings too."""
    from sitewright.app.arms import arm_problems
    from sitewright.app.postures import posture_problems
    from sitewright.planning_twin.backends.twin import make_backends

    model, cell = project.model, project.cell
    obstacles = obstacles_of(model, cell)
    backends = make_backends()
    return [
        *check_project(model, cell),
        *posture_problems(cell, obstacles, backends.collision),
        *arm_problems(cell, backends.kinematics),
    ]


def obstacles_of(model: BuildingModel, cell: Cell) -> dict[ComponentId, tuple[Shape, Pose]]:
    """Return the shapes and world poses of what is drawn only to be kept out of."""
    return {
        c.id: (shape_of(c), cell.world_T_model @ c.world_T_component)
        for c in model.component_by_id.values()
        if c.layer is Layer.VIRTUAL_COLLISION
    }


def new_project(folder: Path | str, *, example: str = "wooden_frame") -> Path:
    """Copy an example's building, cell and notes into a new folder.

    Raises:
        ProjectError: The folder is not empty, or there is no such example.
    """
    if example not in EXAMPLES:
        hint = did_you_mean(example, EXAMPLES)
        raise ProjectError(
            f"There is no example {example!r}; there are {', '.join(EXAMPLES)}.{hint}"
        )
    goal = Path(folder)
    if goal.exists() and any(goal.iterdir()):
        raise ProjectError(f"{goal} is not empty; name a new folder.")
    goal.mkdir(parents=True, exist_ok=True)
    for file in sorted(example_folder(example).iterdir()):
        if file.is_file():
            shutil.copy(file, goal / file.name)
    return goal


def example_folder(example: str) -> Path:
    """Return where an example lies: in the installed package, else in the source tree."""
    packaged = Path(str(files("sitewright"))) / "examples" / example
    return packaged if packaged.exists() else Path(__file__).parents[3] / "examples" / example


def require_project(folder: Path, cell_file: Path) -> None:
    """Raise `ProjectError` if a folder or one of the files that it needs is missing."""
    require_building(folder)
    if not cell_file.exists():
        raise ProjectError(f"{folder} has no {cell_file.name}. `sitewright new` makes one.")


def require_building(folder: Path) -> None:
    """Raise `ProjectError` if a folder or its building is missing."""
    if not folder.is_dir():
        raise ProjectError(f"{folder} is no folder. `sitewright new {folder}` makes a project.")
    if not (folder / BUILDING).exists():
        raise ProjectError(f"{folder} has no {BUILDING}. `sitewright import` makes one.")


def _settings(folder: Path) -> Mapping[str, Json]:
    file = folder / SETTINGS
    if not file.exists():
        return {}
    try:
        return tomllib.loads(file.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ProjectError(f"{file}: {error}. Mend the file or remove it.") from error


def is_usable(path: Path | str) -> bool:
    """Tell whether a folder opens as a project."""
    try:
        open_project(path)
    except SitewrightError:
        return False
    return True
