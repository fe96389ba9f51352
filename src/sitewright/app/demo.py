"""The demonstration project: the wooden frame, copied once and run as often as one likes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sitewright.app.project import BUILDING, CELL, Project, new_project, open_project
from sitewright.app.run import fold_of, newest_run
from sitewright.app.run_folder import chain_of
from sitewright.central_controller.site_state import site_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Demo:
    """A demonstration that is ready to run.

    Attributes:
        is_new: The folder was made just now.
        starts_anew: The frame stands already, so the next run begins on an empty site.
    """

    project: Project
    is_new: bool
    starts_anew: bool


def open_demo(folder: Path, *, example: str = "wooden_frame") -> Demo:
    """Return the demonstration project in a folder; make it if the folder is new or empty.

    Raises:
        ProjectError: The folder holds something else.
    """
    is_there = (folder / BUILDING).exists() and (folder / CELL).exists()
    if not is_there:
        new_project(folder, example=example)
    project = open_project(folder)
    return Demo(project=project, is_new=not is_there, starts_anew=is_built(project))


def is_built(project: Project) -> bool:
    """Tell whether the newest run of a project has finished with everything installed."""
    newest = newest_run(project.folder / "runs")
    if newest is None:
        return False
    state, _ = fold_of(chain_of(newest), site_of(project.model))
    return state.finished is not None and state.site.is_complete
