"""The update of the construction graph when a piece becomes part of the building."""

from __future__ import annotations

from dataclasses import replace

from sitewright.construction_graph.build import built_node
from sitewright.construction_graph.graph import JOBSITE, ConstructionGraph, MaterialNode, TargetNode
from sitewright.construction_graph.queries import children
from sitewright.errors import SitewrightError
from sitewright.foundation.ids import ComponentId, StockPlaceId
from sitewright.foundation.pose import Pose


class WrongInstallationError(SitewrightError):
    """The graph has no such piece or target to install; a bug of the caller."""


def install(
    graph: ConstructionGraph, material: ComponentId, target: ComponentId, world_T_measured: Pose
) -> ConstructionGraph:
    """Return the graph after a piece was installed at a target.

    The piece is renamed to the target, moved to the layer As-Built and put under the target's
    construction parents; what was below it in its stack is exposed.

    Args:
        graph: The graph before.
        material: The piece; nothing may rest on it.
        target: The target that it became.
        world_T_measured: Where it was sensed.
    """
    piece, place = graph.node_by_id.get(material), graph.node_by_id.get(target)
    if not isinstance(piece, MaterialNode) or not isinstance(place, TargetNode):
        raise WrongInstallationError(
            f"{material!r} cannot be installed as {target!r}: no such piece or target."
        )
    if above := children(graph, material):
        raise WrongInstallationError(f"{material!r} is buried under {', '.join(above)}.")
    rest = {i: n for i, n in graph.node_by_id.items() if i != material}
    rest[target] = built_node(place, material, world_T_measured)
    return replace(graph, node_by_id=rest)


def move_piece(
    graph: ConstructionGraph, material: ComponentId, place: StockPlaceId, world_T_piece: Pose
) -> ConstructionGraph:
    """Return the graph after a piece was set down elsewhere, or picked up (`NOWHERE`)."""
    piece = graph.node_by_id.get(material)
    if not isinstance(piece, MaterialNode):
        raise WrongInstallationError(f"{material!r} is no piece of stock.")
    if above := children(graph, material):
        raise WrongInstallationError(f"{material!r} is buried under {', '.join(above)}.")
    moved = replace(
        piece, place=place, world_T_component=world_T_piece, construction_parents=(JOBSITE,)
    )
    return replace(graph, node_by_id={**graph.node_by_id, material: moved})
