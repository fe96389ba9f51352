"""Questions to the construction graph."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.building_model.component import Layer
from sitewright.building_model.matching import MaterialType, fits
from sitewright.construction_graph.graph import (
    JOBSITE,
    NOWHERE,
    ConstructionGraph,
    MaterialNode,
    Node,
    TargetNode,
)
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector, distance


def children(graph: ConstructionGraph, parent: ComponentId) -> tuple[ComponentId, ...]:
    """Return what rests on a component, or on the jobsite, in order of id."""
    return tuple(sorted(i for i, n in graph.node_by_id.items() if parent in n.construction_parents))


def leaves(graph: ConstructionGraph) -> tuple[ComponentId, ...]:
    """Return the components that nothing rests on, in order of id."""
    covered = _covered(graph)
    return tuple(sorted(i for i in graph.node_by_id if i not in covered))


def targets(graph: ConstructionGraph) -> tuple[TargetNode, ...]:
    """Return what is still to be built, in order of id."""
    nodes = (n for n in graph.node_by_id.values() if isinstance(n, TargetNode))
    return tuple(sorted(nodes, key=lambda n: n.id))


def materials(graph: ConstructionGraph) -> tuple[MaterialNode, ...]:
    """Return all pieces of stock, in order of id."""
    nodes = (n for n in graph.node_by_id.values() if isinstance(n, MaterialNode))
    return tuple(sorted(nodes, key=lambda n: n.id))


def accessible_materials(graph: ConstructionGraph, target: TargetNode) -> list[MaterialNode]:
    """Return the pieces that may become a target and can be lifted now, in order of id.

    A piece that another rests on is never among them, nor one that lies at no place.
    """
    covered = _covered(graph)
    return [
        piece
        for piece in materials(graph)
        if piece.id not in covered
        and piece.place != NOWHERE
        and fits(material_type(piece), target.material_type)
    ]


def nearest_material(
    graph: ConstructionGraph, target: TargetNode, base_positions_m: Iterable[Vector]
) -> MaterialNode | None:
    """Return the accessible piece nearest to any of some robot bases; ties go by id.

    Args:
        graph: The graph as it stands.
        target: What the piece should become.
        base_positions_m: Origins of the base links of the robots that could grasp it; the
            distance runs to the middle of the piece's box.
    """
    bases = tuple(base_positions_m)
    pieces = accessible_materials(graph, target)
    return min(pieces, key=lambda p: (distance_m(p, bases), p.id), default=None)


def distance_m(node: Node, base_positions_m: Iterable[Vector]) -> float:
    """Return the distance from the middle of a component to the nearest base."""
    middle = node.world_T_component.position_m
    return min((distance(base, middle) for base in base_positions_m), default=float("inf"))


def material_type(piece: MaterialNode) -> MaterialType:
    """Return what a piece is: type, section, length and material."""
    length, width, height = (round(s, 7) for s in piece.size_m)
    return (piece.type, (min(width, height), max(width, height)), length, piece.material)


def is_ready(graph: ConstructionGraph, target: TargetNode) -> bool:
    """Return whether all that a target rests on, or must follow, is installed."""
    return not missing_before(graph, target)


def missing_before(graph: ConstructionGraph, target: TargetNode) -> tuple[ComponentId, ...]:
    """Return what must be installed before a target and is not, in order of id."""
    needed = {p for p in target.construction_parents if p != JOBSITE}
    needed |= {earlier for earlier, later in graph.comes_before if later == target.id}
    return tuple(sorted(n for n in needed if not _is_built(graph, n)))


def _is_built(graph: ConstructionGraph, component: ComponentId) -> bool:
    node = graph.node_by_id.get(component)
    return node is not None and node.layer is Layer.AS_BUILT


def _covered(graph: ConstructionGraph) -> set[ComponentId]:
    return {p for n in graph.node_by_id.values() for p in n.construction_parents}
