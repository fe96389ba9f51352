"""Where a building stands while it is built: the cell's site, and how the model lies in it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from sitewright.building_model.model import BuildingModel
from sitewright.errors import Problem
from sitewright.foundation.pose import dot, unit
from sitewright.robot_team.cell import Cell

_LEVEL = math.cos(math.radians(1.0))


def sited(cell: Cell, model: BuildingModel) -> Cell:
    """Return a cell as read from its file with a model placed in it as the model says."""
    return replace(cell, world_T_model=cell.world_T_model @ model.site_T_model)


def gravity_problems(model: BuildingModel, cell: Cell) -> Iterator[Problem]:
    """Yield L4 if the gravity that a model counts on does not point down in its cell.

    Args:
        model: Its gravity decides what carries what.
        cell: With the model placed in it.
    """
    if not any(model.gravity):
        return
    down = unit(cell.world_T_model.turn(model.gravity))
    if dot(down, (0.0, 0.0, -1.0)) >= _LEVEL:
        return
    off_deg = math.degrees(math.acos(max(-1.0, min(1.0, -down[2]))))
    yield Problem(
        code="L4",
        severity="E",
        where="build",
        message=f"The model's gravity points {off_deg:.0f} degrees away from down in the cell.",
        fix="Correct 'build.gravity', 'build.site_T_model' or the cell's [site] world_T_model; "
        "a drawn panel is laid flat by `sitewright import --lay-flat`.",
    )
