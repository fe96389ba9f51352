"""What is built next: targets in construction order, each with its operations in order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from typing import TypeVar

from sitewright.construction_graph.graph import ConstructionGraph, TargetNode
from sitewright.construction_graph.queries import targets
from sitewright.foundation.ids import ComponentId, OperationId

Item = TypeVar("Item", bound=str)


@dataclass(frozen=True, slots=True)
class QueuedTarget:
    """One target and its queue of operations."""

    target: ComponentId
    operations: tuple[OperationId, ...]


def construction_queue(graph: ConstructionGraph) -> tuple[QueuedTarget, ...]:
    """Return all targets still to be built, in construction order."""
    nodes = {n.id: n for n in targets(graph)}
    return tuple(QueuedTarget(i, operation_queue(nodes[i])) for i in target_queue(graph))


def target_queue(graph: ConstructionGraph) -> tuple[ComponentId, ...]:
    """Return the targets still to be built: what carries first, then by order, then by id.

    The order is partial; `TargetNode.order` only breaks ties, and a target without one comes
    after those with one.
    """
    nodes = {n.id: n for n in targets(graph)}
    before: dict[ComponentId, set[ComponentId]] = {
        i: {p for p in n.construction_parents if p in nodes} for i, n in nodes.items()
    }
    for earlier, later in graph.comes_before:
        if earlier in nodes and later in nodes:
            before[later].add(earlier)
    return _sorted_by(before, {i: _rank(n) for i, n in nodes.items()})


def operation_queue(target: TargetNode) -> tuple[OperationId, ...]:
    """Return a target's operations: what must be done first, then as the designer lists them."""
    ids = [o.id for o in target.operations]
    before = {o.id: {a for a in o.after if a in ids} for o in target.operations}
    return _sorted_by(before, {i: (0, n, i) for n, i in enumerate(ids)})


def _rank(node: TargetNode) -> tuple[int, int, str]:
    return (1, 0, node.id) if node.order is None else (0, node.order, node.id)


def _sorted_by(
    before: Mapping[Item, set[Item]], rank: Mapping[Item, tuple[int, int, str]]
) -> tuple[Item, ...]:
    """Return a topological order that always takes the free item of lowest rank (Kahn)."""
    waits_for = {item: len(earlier) for item, earlier in before.items()}
    followers: dict[Item, list[Item]] = {item: [] for item in before}
    for item, earlier in before.items():
        for first in earlier:
            followers[first].append(item)
    free = [(rank[item], item) for item, count in waits_for.items() if count == 0]
    heapify(free)
    order: list[Item] = []
    while free:
        _, item = heappop(free)
        order.append(item)
        for follower in followers[item]:
            waits_for[follower] -= 1
            if waits_for[follower] == 0:
                heappush(free, (rank[follower], follower))
    return tuple(_complete(order, before))


def _complete(order: Sequence[Item], before: Mapping[Item, set[Item]]) -> Sequence[Item]:
    if len(order) != len(before):
        left = sorted(set(before) - set(order))
        raise ValueError(f"these wait for each other: {', '.join(left)}")
    return order
