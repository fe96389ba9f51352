"""Finds things of an IFC file that refer to themselves, before the libraries recurse into them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

_Graph = dict[int, list[int]]


def circles(file: Any) -> list[str]:  # noqa: ANN401 - untyped entity
    """Return one sentence per circle of placements, shapes, wholes and parts, units, properties."""
    graphs = (_placements(file), _shapes(file), _wholes(file), _units(file), _properties(file))
    found = [_circle(graph) for graph in graphs]
    return [
        f"{' -> '.join(f'#{n}' for n in path)} ({file.by_id(path[0]).is_a()}) goes in a circle"
        for path in found
        if path
    ]


def _placements(file: Any) -> _Graph:  # noqa: ANN401
    return {
        p.id(): [p.PlacementRelTo.id()] if p.PlacementRelTo is not None else []
        for p in file.by_type("IfcLocalPlacement")
    }


def _shapes(file: Any) -> _Graph:  # noqa: ANN401
    graph = {
        b.id(): [b.FirstOperand.id(), b.SecondOperand.id()]
        for b in file.by_type("IfcBooleanResult")
    }
    for mapped in file.by_type("IfcMappedItem"):
        graph[mapped.id()] = [i.id() for i in mapped.MappingSource.MappedRepresentation.Items]
    return graph


def _units(file: Any) -> _Graph:  # noqa: ANN401
    return {
        u.id(): [u.ConversionFactor.UnitComponent.id()]
        for u in file.by_type("IfcConversionBasedUnit")
    }


def _properties(file: Any) -> _Graph:  # noqa: ANN401
    return {p.id(): [h.id() for h in p.HasProperties] for p in file.by_type("IfcComplexProperty")}


def _wholes(file: Any) -> _Graph:  # noqa: ANN401
    graph: _Graph = {}
    for relation in file.by_type("IfcRelDecomposes"):
        whole = getattr(relation, "RelatingObject", None) or getattr(
            relation, "RelatingBuildingElement", None
        )
        parts = getattr(relation, "RelatedObjects", None) or [
            getattr(relation, "RelatedOpeningElement", None)
        ]
        if whole is not None:
            graph.setdefault(whole.id(), []).extend(p.id() for p in parts if p is not None)
    return graph


def _circle(graph: Mapping[int, Sequence[int]]) -> list[int]:
    """Return the nodes of one circle, its first node repeated at the end; or nothing."""
    done: set[int] = set()
    for root in sorted(graph):
        path, place = [root], {root: 0}
        branches = [iter(graph[root])]
        while branches:
            node = next(branches[-1], None)
            if node is None:
                branches.pop()
                done.add(path[-1])
                del place[path.pop()]
            elif node in place:
                return [*path[place[node] :], node]
            elif node not in done:
                place[node] = len(path)
                path.append(node)
                branches.append(iter(graph.get(node, ())))
    return []
