"""What carries a piece and what it may touch: where it lies now, and where it belongs."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.model import RelationKind
from sitewright.building_model.shapes import Extent, extent_of, shape_of
from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import SiteContext
from sitewright.construction_graph.graph import JOBSITE, NOWHERE, ConstructionGraph, MaterialNode
from sitewright.foundation.ids import BodyId, ComponentId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.robot_team.cell import Cell

_TOUCHING_M = 0.002


def body_of(context: SiteContext, component: ComponentId) -> ComponentId:
    """Return the physical piece of a component: what it was made of, or itself."""
    placed = context.site.placed.get(component)
    return component if placed is None else placed.piece


def touches(design: Design, context: SiteContext, component: Component) -> tuple[BodyId, ...]:
    """Return what a placed component may touch: what carries it, and joined neighbours."""
    related = {
        other
        for r in design.model.relations
        if r.kind in (RelationKind.CONNECTION, RelationKind.CONTACT, RelationKind.SUPPORTS)
        for this, other in ((r.a, r.b), (r.b, r.a))
        if this == component.id
    }
    joined = _standing(design, context, sorted(related))
    return tuple(dict.fromkeys((*rests_on(design, context, component), *joined)))


def rests_on(design: Design, context: SiteContext, component: Component) -> tuple[BodyId, ...]:
    """Return what carries a placed component: construction parents, or the fixture under it."""
    parents = _standing(design, context, component.construction_parents)
    if component.construction_parents and not component.ground:
        return parents
    pose = design.world_T_target(component.id)
    return (*parents, *_fixtures_at(design.cell, shape_of(component), pose))


def _standing(
    design: Design, context: SiteContext, components: Iterable[ComponentId]
) -> tuple[BodyId, ...]:
    return tuple(
        BodyId(body_of(context, c))
        for c in components
        if c in context.site.placed or design.component(c).layer is Layer.AS_BUILT
    )


def _fixtures_at(cell: Cell, shape: Shape, world_T_shape: Pose) -> tuple[BodyId, ...]:
    """Return the fixtures whose bounding boxes a body at a pose touches."""
    body = extent_of(shape, world_T_shape)
    fixtures = cell.fixture_by_id.values()
    return tuple(
        BodyId(f.id) for f in fixtures if _is_touched(body, extent_of(f.shape, f.world_T_fixture))
    )


def _is_touched(body: Extent, other: Extent) -> bool:
    sides = zip(body.low_m, body.high_m, other.low_m, other.high_m, strict=True)
    return max(max(low - top, bottom - high) for low, high, bottom, top in sides) < _TOUCHING_M


def lies_on(
    design: Design, graph: ConstructionGraph, context: SiteContext, piece: ComponentId
) -> tuple[BodyId, ...]:
    """Return what a piece lies on where it was seen: the piece below, else the fixture.

    One that fell may lean on anything whose bounding box it touches.
    """
    node = graph.node_by_id.get(piece)
    below = [BodyId(p) for p in (() if node is None else node.construction_parents) if p != JOBSITE]
    seen = context.observation.world_T_piece.get(piece)
    if below or seen is None:
        return tuple(below)
    shape = shape_of(design.component(piece))
    fixtures = _fixtures_at(design.cell, shape, seen)
    has_fallen = isinstance(node, MaterialNode) and node.place == NOWHERE
    return (*fixtures, *_pieces_at(design, context, piece, seen)) if has_fallen else fixtures


def _pieces_at(
    design: Design, context: SiteContext, piece: ComponentId, seen: Pose
) -> tuple[BodyId, ...]:
    """Return the other pieces whose bounding boxes a piece touches."""
    body = extent_of(shape_of(design.component(piece)), seen)
    others = sorted(context.observation.world_T_piece.items())
    return tuple(
        BodyId(other)
        for other, pose in others
        if other != piece and _is_touched(body, extent_of(shape_of(design.component(other)), pose))
    )
