"""Which target comes next, and which pieces may become it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sitewright.building_model.matching import fits, material_type_of
from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.situation import target_node
from sitewright.central_controller.wishes import put_off, wanted_pieces
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.construction_graph.queries import (
    accessible_materials,
    children,
    is_ready,
    material_type,
    materials,
)
from sitewright.construction_graph.queue import target_queue
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector, distance
from sitewright.robot_team.cell import Capability
from sitewright.robot_team.waiting import foot_m


def front_target(
    design: Design,
    graph: ConstructionGraph,
    context: SiteContext,
    exclude: Iterable[ComponentId] = (),
) -> ComponentId | None:
    """Return the target to do next: one in progress, else the first ready one with a piece.

    A ready target whose piece is still buried waits for those that uncover it.
    """
    out = {*exclude, *context.site.excluded, *context.site.installed}
    waiting = [t for t in target_queue(graph) if t not in out]
    started = [t for t in waiting if t in context.site.placed]
    ready = [t for t in waiting if is_ready(graph, target_node(graph, t))]
    waiting_for = context.site.waiting.items()
    unbuilt = {t for t, first in waiting_for if first not in context.site.installed}
    later = put_off(context.site.rejections) | unbuilt
    ready.sort(key=lambda t: (t in later, not _held(design, graph, context, t)))
    supplied = (t for t in ready if choices_of_pieces(design, graph, context, t) != [()])
    return next(iter(started), None) or next(supplied, None) or next(iter(ready), None)


def other_ready_targets(
    graph: ConstructionGraph, context: SiteContext, target: ComponentId
) -> list[ComponentId]:
    """Return the targets that could be built before one, in construction order."""
    site = context.site
    out = {target, *site.excluded, *site.installed}
    waiting = (t for t in target_queue(graph) if t not in out)
    return [t for t in waiting if is_ready(graph, target_node(graph, t))]


@dataclass(frozen=True, slots=True, kw_only=True)
class PieceOnSite:
    """A piece of stock that is right for a target.

    Attributes:
        distance_m: From the nearest base of a robot that may grasp to the middle of its box; for
            a robot that waits along its rails, from where it stands and on to the target.
        under: What lies on it; empty if it can be taken now.
    """

    piece: ComponentId
    distance_m: float
    under: tuple[ComponentId, ...]


def pieces_for(
    design: Design, graph: ConstructionGraph, context: SiteContext, target: ComponentId
) -> tuple[PieceOnSite, ...]:
    """Return all pieces that are right for a target, buried ones too, the nearest first."""
    wanted = target_node(graph, target).material_type
    ways = _ways_from(design, context, target)
    found = [
        PieceOnSite(
            piece=node.id,
            distance_m=_distance(ways, context, node.id),
            under=children(graph, node.id),
        )
        for node in materials(graph)
        if fits(material_type(node), wanted)
    ]
    return tuple(sorted(found, key=lambda p: (p.distance_m, p.piece)))


def choices_of_pieces(
    design: Design, graph: ConstructionGraph, context: SiteContext, target: ComponentId
) -> list[tuple[ComponentId, ...]]:
    """Return choices of pieces: the one in place or in hand, else nearest, then all."""
    placed = context.site.placed.get(target)
    if placed is not None:
        return [(placed.piece,)]
    found = [m.id for m in accessible_materials(graph, target_node(graph, target))]
    accessible = wanted_pieces(found, context.site.rejections)
    if held := _held(design, graph, context, target):
        return [held]
    ways = _ways_from(design, context, target)
    ordered = sorted(accessible, key=lambda m: (_distance(ways, context, m), m))
    return [tuple(ordered[:k]) for k in range(1, len(ordered) + 1)] or [()]


def _held(
    design: Design, graph: ConstructionGraph, context: SiteContext, target: ComponentId
) -> tuple[ComponentId, ...]:
    """Return the pieces in grippers that could become a target."""
    wanted = target_node(graph, target).material_type
    held = {r.gripped for r in context.observation.robots.values()}
    pieces = (c for c in design.model.component_by_id.values() if c.id in held)
    return tuple(c.id for c in pieces if fits(material_type_of(c), wanted))


def _ways_from(
    design: Design, context: SiteContext, target: ComponentId
) -> list[tuple[Vector, Vector | None]]:
    """Return where each robot stands that may grasp, and where it has to go with the piece.

    That it goes anywhere counts only for one that waits along its rails; it stands where it is
    sensed, all others at their base.
    """
    robots = [r for r in design.cell.robot_by_id.values() if Capability.GRASPING in r.can]
    seen = context.observation.robots
    belongs_m = design.world_T_target(target).position_m
    return [
        (
            foot_m(r, seen[r.id].q_rad if r.id in seen else r.home_q_rad),
            belongs_m if r.waits_along_rails else None,
        )
        for r in robots
    ]


def _distance(
    ways: Sequence[tuple[Vector, Vector | None]], context: SiteContext, piece: ComponentId
) -> float:
    """Return the shortest way of a robot to the middle of a piece's box, and on to the target."""
    pose = context.observation.world_T_piece.get(piece)
    if pose is None or not ways:
        return float("inf")
    at_m = pose.position_m
    return min(
        distance(at_m, foot) + (0.0 if belongs is None else distance(at_m, belongs))
        for foot, belongs in ways
    )
