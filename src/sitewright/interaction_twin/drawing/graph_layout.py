"""Where the nodes of the relationship graph stand: each a row above the highest it rests on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sitewright.building_model.component import Layer
from sitewright.construction_graph.graph import JOBSITE, ConstructionGraph
from sitewright.foundation.ids import ComponentId

_LAST = 1e6


@dataclass(frozen=True, slots=True)
class GraphLayout:
    """Column and row (0 is the jobsite) of every node."""

    column: Mapping[ComponentId, float]
    row: Mapping[ComponentId, int]


def graph_layout(graph: ConstructionGraph) -> GraphLayout:
    """Return a layout in which no two nodes of a row are closer than one column."""
    row = _rows(graph)
    members: dict[int, list[ComponentId]] = {}
    for component in sorted(row):
        members.setdefault(row[component], []).append(component)
    widest = max((len(m) for m in members.values()), default=1)
    column: dict[ComponentId, float] = {}
    for number in sorted(members):
        ordered = sorted(members[number], key=lambda c: (_wished(graph, c, column), c))
        column |= _spread(graph, ordered, column, widest)
    return GraphLayout(column, row)


def _rows(graph: ConstructionGraph) -> dict[ComponentId, int]:
    """Return the longest way to the jobsite; the graph is acyclic."""
    row: dict[ComponentId, int] = {JOBSITE: 0}

    def height(component: ComponentId) -> int:
        if component not in row:
            node = graph.node_by_id.get(component)
            parents = node.construction_parents if node is not None else ()
            row[component] = 1 + max((height(p) for p in parents), default=0)
        return row[component]

    for component in sorted(graph.node_by_id):
        height(component)
    return {c: r for c, r in row.items() if c == JOBSITE or c in graph.node_by_id}


def _wished(
    graph: ConstructionGraph, component: ComponentId, column: Mapping[ComponentId, float]
) -> float:
    """Return the mean column of what a node rests on; targets stand left of the stock."""
    node = graph.node_by_id.get(component)
    if node is None:
        return 0.0
    below = [column[p] for p in node.construction_parents if p in column and p != JOBSITE]
    if below:
        return sum(below) / len(below)
    return _LAST if node.layer is Layer.MATERIAL else -1.0


def _spread(
    graph: ConstructionGraph,
    ordered: Sequence[ComponentId],
    column: Mapping[ComponentId, float],
    widest: int,
) -> dict[ComponentId, float]:
    """Give each node of a row a column near its wish, none closer than one to the next."""
    if list(ordered) == [JOBSITE]:
        return {JOBSITE: (widest - 1) / 2.0}
    found: dict[ComponentId, float] = {}
    last = -1.0
    for component in ordered:
        wish = _wished(graph, component, column)
        free = last + 1.0
        last = max(free, wish) if 0.0 <= wish < _LAST else free
        found[component] = last
    overhang = last - (widest - 1)
    return {c: max(x - max(overhang, 0.0), float(i)) for i, (c, x) in enumerate(found.items())}
