"""The construction relationship graph of the site as folded and as sensed."""

from __future__ import annotations

from sitewright.building_model.component import Layer
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.ports import SiteContext
from sitewright.construction_graph.build import (
    NOWHERE,
    InstalledPiece,
    MovedPiece,
    SiteChanges,
    graph_of,
)
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.foundation.ids import ComponentId, StockPlaceId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Cell, StationKind

_SAME_LEVEL_M = 0.030
_STILL_STACKED_M = 0.300
_ON_BUFFER_M = 0.300


class SiteGraphs:
    """The graphs of a design's sites; the last one is kept, since it is asked for repeatedly."""

    def __init__(self, model: BuildingModel, cell: Cell) -> None:
        self._model, self._cell = model, cell
        self._designed: ConstructionGraph | None = None
        self._last: tuple[SiteContext, ConstructionGraph] | None = None

    def __call__(self, context: SiteContext) -> ConstructionGraph:
        """Return the graph of a site as folded and as sensed."""
        if self._last is not None and self._last[0] is context:
            return self._last[1]
        if self._designed is None:
            self._designed = graph_of(self._model, self._cell)
        found = graph_now(self._model, self._cell, context, self._designed)
        self._last = (context, found)
        return found


def graph_now(
    model: BuildingModel,
    cell: Cell,
    context: SiteContext,
    designed: ConstructionGraph | None = None,
) -> ConstructionGraph:
    """Return the graph: what is installed, which stock is left, and where it was seen.

    A piece that was seen away from its stack lies on a buffer, or at no place at all: then it
    is in a gripper, or has fallen, and is not offered. Nor is one that is not seen any more.

    Args:
        model: A checked building model.
        cell: Gives the model's place in the world and the stock places.
        context: The site.
        designed: The graph of the untouched site, if it is known.
    """
    site = context.site
    designed = designed or graph_of(model, cell)
    installed = {
        target: InstalledPiece(
            material=site.placed[target].piece,
            world_T_component=site.placed[target].world_T_measured,
        )
        for target in site.installed
        if target in site.placed
    }
    stock = [
        c.id
        for c in model.component_by_id.values()
        if c.layer is Layer.MATERIAL and c.id not in site.consumed
    ]
    held = {r.gripped for r in context.observation.robots.values()}
    sensed: dict[ComponentId, Pose] = {}
    moved: dict[ComponentId, MovedPiece] = {}
    for piece in stock:
        if piece not in designed.node_by_id:
            continue
        stacked = designed.node_by_id[piece].world_T_component
        seen = context.observation.world_T_piece.get(piece)
        if seen is None:
            moved[piece] = MovedPiece(place=NOWHERE, world_T_component=stacked)
        elif piece not in held and _is_stacked(stacked, seen):
            sensed[piece] = seen
        else:
            place = NOWHERE if piece in held else _buffer_under(cell, seen)
            moved[piece] = MovedPiece(place=place, world_T_component=seen)
    changes = SiteChanges(installed=installed, consumed=site.consumed, moved=moved, sensed=sensed)
    return graph_of(model, cell, changes)


def _is_stacked(designed: Pose, seen: Pose) -> bool:
    dx, dy, dz = (a - b for a, b in zip(designed.position_m, seen.position_m, strict=True))
    return abs(dz) < _SAME_LEVEL_M and (dx * dx + dy * dy) ** 0.5 < _STILL_STACKED_M


def _buffer_under(cell: Cell, seen: Pose) -> StockPlaceId:
    for station in cell.station_by_id.values():
        if station.kind is StationKind.BUFFER:
            x, y, z = (station.world_T_station.inverse() @ seen).position_m
            if 0.0 < z < _ON_BUFFER_M and (x * x + y * y) ** 0.5 < _ON_BUFFER_M:
                return StockPlaceId(station.id)
    return NOWHERE
