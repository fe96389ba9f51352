"""A project's building at one moment: as designed, as a run left it, or as it stands now.

Nothing is asked of the cell but where it puts the model, so that a building which no cell can
build yet has its states too.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sitewright.app.design_changes import kept_design
from sitewright.app.installing import as_built_model, installed_times
from sitewright.app.project import BUILDING, CELL, require_building
from sitewright.app.run import fold_of, newest_run
from sitewright.app.run_folder import RunFolder, chain_of, run_named
from sitewright.building_model.as_built import is_installed
from sitewright.building_model.formats.native import read_as_written
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.object_states import ObjectState, object_states
from sitewright.central_controller.site_state import SiteState, site_of
from sitewright.construction_graph.siting import sited
from sitewright.errors import CellRejectedError
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.formats.cell_toml import read_cell


@dataclass(frozen=True, slots=True, kw_only=True)
class Moment:
    """When: now, unless told otherwise.

    Attributes:
        is_design: Before anything was built.
        run: As the run with this id left it.
    """

    is_design: bool = False
    run: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class BuiltState:
    """A project's building at one moment.

    Attributes:
        name: ``design`` or ``as_built``, the usual name of files about it.
        folder: The project.
        design: The design that the moment is about.
        as_built: The same with everything folded in that was built by then.
        site: What the controller knew then.
        cell: The cell with the model placed in it; None if it cannot be read.
        notes: What a reader should know of it, one sentence each.
    """

    name: str
    folder: Path
    design: BuildingModel
    as_built: BuildingModel
    site: SiteState
    cell: Cell | None
    notes: tuple[str, ...] = ()

    @property
    def world_T_model(self) -> Pose:
        """Where the cell puts the model; where it is without one."""
        return Pose() if self.cell is None else self.cell.world_T_model

    @property
    def installed(self) -> int:
        """How many components the team has built."""
        return sum(is_installed(c) for c in self.as_built.component_by_id.values())

    @property
    def objects(self) -> dict[str, ObjectState]:
        """What became of each object of the imported file, by its id."""
        return object_states(self.design, self.as_built, self.world_T_model)


def state_at(
    folder: Path, moment: Moment | None = None, *, cell: Path | str | None = None
) -> BuiltState:
    """Return a project's building at a moment, whether or not its cell could build it.

    Args:
        folder: The project.
        moment: When; now by default.
        cell: Another cell file than ``cell.toml``; relative to the folder, or absolute.

    Raises:
        ProjectError: The folder or its building is missing.
        ModelRejectedError: ``building.json`` cannot be read.
        CellRejectedError: Something was built, and the cell that it was built in cannot be read.
        ExecutionError: There is no such run.
    """
    moment = moment or Moment()
    require_building(folder)
    model, problems = read_as_written(folder / BUILDING)
    errors = sum(p.severity == "E" for p in problems)
    noun = "error" if errors == 1 else "errors"
    notes = [f"{BUILDING} has {errors} {noun}; `sitewright check` lists them."] if errors else []
    chain = _chain(folder / "runs", moment)
    if moment.run:
        then = kept_design(folder, fold_of(chain, site_of(model))[0].model_sha256)
        notes += [] if then else ["The design of that run was not kept; this is today's."]
        model = then or model
    site = fold_of(chain, site_of(model))[0].site
    team, said = _cell(folder / (cell or CELL), model, is_needed=bool(site.placed))
    return BuiltState(
        name="design" if moment.is_design else "as_built",
        folder=folder,
        design=model,
        as_built=as_built_model(model, site, installed_times(chain)),
        site=site,
        cell=team,
        notes=(*notes, *said),
    )


def _chain(runs: Path, moment: Moment) -> tuple[RunFolder, ...]:
    if moment.is_design:
        return ()
    last = run_named(runs, moment.run) if moment.run else newest_run(runs)
    return () if last is None else chain_of(last)


def _cell(file: Path, model: BuildingModel, *, is_needed: bool) -> tuple[Cell | None, list[str]]:
    """Return the cell; one that nothing was built in may be missing or wrong."""
    try:
        return sited(read_cell(file), model), []
    except CellRejectedError as rejected:
        if is_needed:
            raise
        why = rejected.problems[0].message if file.exists() else "it is not there."
        note = f"{file.name} cannot be read ({why}) Poses are in the model's own frame."
        return None, [note]
