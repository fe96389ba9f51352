"""Copies of model, cell and site with one thing changed, to be planned on."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import replace

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import shape_of
from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.site_graph import SiteGraphs
from sitewright.central_controller.surveying import Surveyor
from sitewright.construction_graph.graph import MaterialNode
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector, distance, scale, subtract
from sitewright.planning_twin.layout.floor import floor_of
from sitewright.planning_twin.layout.movables import MovableKind, Shift, Yard, yard_of


def with_model(surveyor: Surveyor, model: BuildingModel) -> Surveyor:
    """Return what would be looked at under another design of the same pieces."""
    return _with_design(surveyor, Design(model=model, cell=surveyor.design.cell))


def with_component(surveyor: Surveyor, component: Component) -> Surveyor:
    """Return what would be looked at if one component were designed otherwise."""
    model = surveyor.design.model
    components = {**model.component_by_id, component.id: component}
    return with_model(surveyor, replace(model, component_by_id=components))


def without_pieces(context: SiteContext, pieces: Iterable[ComponentId]) -> SiteContext:
    """Return the context as if some pieces were not there."""
    gone = frozenset(pieces)
    seen = context.observation
    left = {p: pose for p, pose in seen.world_T_piece.items() if p not in gone}
    return replace(context, observation=replace(seen, world_T_piece=left))


def moved_on_a_copy(
    surveyor: Surveyor, context: SiteContext, thing: str, goal: Vector, by_m: float
) -> tuple[Surveyor, SiteContext] | None:
    """Return surveyor and site as if a robot or a stack stood nearer to a goal.

    What stands under it alone, and what lies on it, moves along. None if it is nearer than
    that already, if it may not be moved, or if it would stand in the way of something.
    """
    cell = surveyor.design.cell
    yard = yard_of(cell)
    movable = next((m for m in yard.movables if m.id == thing), None)
    if movable is None or _holds_something(context, thing):
        return None
    shift = _towards(movable.world_T_start.position_m, goal, by_m)
    lying = _lying_at(surveyor, context)
    if shift is None or not _is_free(surveyor, context, yard, lying, {thing: shift}):
        return None
    changed = _with_design(
        surveyor, Design(model=surveyor.design.model, cell=yard.arranged({thing: shift}))
    )
    if movable.kind is not MovableKind.STOCK:
        return changed, context
    motion, seen = shift.moves(movable), context.observation
    poses = {p: motion @ seen.world_T_piece[p] for p in lying.get(thing, ())}
    there = replace(seen, world_T_piece={**seen.world_T_piece, **poses})
    return changed, replace(context, observation=there)


def _with_design(surveyor: Surveyor, design: Design) -> Surveyor:
    return replace(surveyor, design=design, graph_of=SiteGraphs(design.model, design.cell))


def _holds_something(context: SiteContext, thing: str) -> bool:
    robots = context.observation.robots.items()
    return any(robot == thing and state.gripped is not None for robot, state in robots)


def _towards(start: Vector, goal: Vector, by_m: float) -> Shift | None:
    level: Vector = (goal[0], goal[1], start[2])
    away_m = distance(start, level)
    if away_m <= by_m:
        return None
    x_m, y_m, _ = scale(subtract(level, start), by_m / away_m)
    return Shift(x_m=x_m, y_m=y_m)


def _lying_at(surveyor: Surveyor, context: SiteContext) -> dict[str, list[ComponentId]]:
    """Return what lies at each stock place."""
    found: dict[str, list[ComponentId]] = defaultdict(list)
    for node in surveyor.graph_of(context).node_by_id.values():
        if isinstance(node, MaterialNode) and node.id in context.observation.world_T_piece:
            found[node.place].append(node.id)
    return found


def _is_free(
    surveyor: Surveyor,
    context: SiteContext,
    yard: Yard,
    lying: dict[str, list[ComponentId]],
    arrangement: dict[str, Shift],
) -> bool:
    design, seen = surveyor.design, context.observation.world_T_piece
    bodies = {
        place: [(surveyor.shapes[p].shape, seen[p]) for p in pieces]
        for place, pieces in lying.items()
    }
    building = [
        (shape_of(c), design.world_T_target(c.id))
        for c in design.model.component_by_id.values()
        if c.layer in (Layer.TARGET, Layer.AS_BUILT)
    ]
    return floor_of(yard, bodies, building).is_free(arrangement)
