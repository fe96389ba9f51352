"""Where a building stands while it is built: the cell's site, and how the model lies in it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.findings import refused
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import (
    Extent,
    UnsupportedGeometryError,
    extent_of,
    shape_of,
)
from sitewright.errors import Problem
from sitewright.foundation.pose import dot, unit
from sitewright.robot_team.cell import Cell

_LEVEL = math.cos(math.radians(1.0))
_HANGS_M = 0.005
"""A component that hangs higher falls when it is let go."""


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


def hanging_problems(model: BuildingModel, cell: Cell) -> Iterator[Problem]:
    """Yield L5 for each target that stands on the ground, but on nothing of the cell.

    Boxes around the fixtures are looked at, so a slanted one may carry less than it seems.

    Args:
        model: Its targets; `ground` says which stand on the ground.
        cell: With the model placed in it.
    """
    tops = [extent_of(f.shape, f.world_T_fixture) for f in cell.fixture_by_id.values()]
    for component in model.component_by_id.values():
        if component.layer is not Layer.TARGET or not component.ground:
            continue
        try:
            low = extent_of(shape_of(component), cell.world_T_model @ component.world_T_component)
        except UnsupportedGeometryError:
            continue
        gap_m = min((_gap_m(low, top) for top in tops), default=math.inf)
        if gap_m > _HANGS_M:
            yield _hanging(component, gap_m)


def _gap_m(above: Extent, below: Extent) -> float:
    """Return how far a box is above another one; infinite if it is not above it."""
    is_beside = any(
        above.high_m[k] < below.low_m[k] or above.low_m[k] > below.high_m[k] for k in (0, 1)
    )
    is_under = below.low_m[2] > above.low_m[2]
    return math.inf if is_beside or is_under else above.low_m[2] - below.high_m[2]


def _hanging(component: Component, gap_m: float) -> Problem:
    hangs = (
        f"hangs {gap_m * 1000:.0f} mm above what is below it"
        if math.isfinite(gap_m)
        else "has nothing of the cell below it"
    )
    return refused(
        "L5",
        component,
        f"It stands on the ground, but {hangs}: it would fall.",
        "Correct the cell's [site] world_T_model, or add the table or floor as a [[fixture]].",
    )
