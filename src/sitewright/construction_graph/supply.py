"""Which piece becomes which target if everything is built in order, and in which order that is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from sitewright.building_model.matching import MaterialType, fits
from sitewright.construction_graph.graph import JOBSITE, ConstructionGraph, MaterialNode
from sitewright.construction_graph.queries import distance_m, material_type, materials, targets
from sitewright.construction_graph.queue import target_queue
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class Supplied:
    """One target and the pieces that may become it.

    Attributes:
        waits_for: Targets that must be installed before it.
        accessible: Pieces that fit and can be lifted when its turn comes, the nearest first.
        others: Pieces that fit and are still covered then.
    """

    target: ComponentId
    waits_for: tuple[ComponentId, ...]
    accessible: tuple[ComponentId, ...]
    others: tuple[ComponentId, ...] = ()


def supplied_in_order(graph: ConstructionGraph, bases_m: Iterable[Vector]) -> tuple[Supplied, ...]:
    """Return all targets in the order in which they can be supplied.

    Of the targets that are ready the first of the queue comes next, or the first one with a piece
    that nothing lies on; it takes the piece that is nearest to a robot.

    Args:
        graph: The untouched site.
        bases_m: Where the robots stand that take pieces.
    """
    yard = _Yard(graph, tuple(bases_m))
    waits_for = _waits_for(graph)
    wanted = {n.id: n.material_type for n in targets(graph)}
    queue, built = list(target_queue(graph)), set[ComponentId]()
    found: list[Supplied] = []
    while queue:
        ready = [t for t in queue if waits_for[t] <= built]
        target = next((t for t in ready if any(yard.accessible(wanted[t]))), ready[0])
        supplied = Supplied(
            target=target,
            waits_for=tuple(sorted(waits_for[target])),
            accessible=tuple(yard.accessible(wanted[target])),
            others=tuple(yard.covered(wanted[target])),
        )
        found.append(supplied)
        yard.take(supplied.accessible[:1])
        queue.remove(target)
        built.add(target)
    return tuple(found)


def _waits_for(graph: ConstructionGraph) -> dict[ComponentId, set[ComponentId]]:
    nodes = {n.id: n for n in targets(graph)}
    found = {i: {p for p in n.construction_parents if p in nodes} for i, n in nodes.items()}
    for earlier, later in graph.comes_before:
        if earlier in nodes and later in nodes:
            found[later].add(earlier)
    return found


class _Yard:
    """The stock as it is used up."""

    def __init__(self, graph: ConstructionGraph, bases_m: tuple[Vector, ...]) -> None:
        self._nodes: dict[ComponentId, MaterialNode] = {n.id: n for n in materials(graph)}
        self._kind: dict[ComponentId, MaterialType] = {
            i: material_type(n) for i, n in self._nodes.items()
        }
        near = sorted(self._nodes.values(), key=lambda n: (distance_m(n, bases_m), n.id))
        self._left = [n.id for n in near]
        self._below = {i: n.construction_parents[0] for i, n in self._nodes.items()}
        self._fits: dict[tuple[MaterialType, MaterialType], bool] = {}

    def accessible(self, wanted: MaterialType) -> Iterator[ComponentId]:
        """Yield the pieces that fit and that nothing lies on, the nearest first."""
        on = self._carrying()
        return (i for i in self._left if i not in on and self._does(i, wanted))

    def covered(self, wanted: MaterialType) -> Iterator[ComponentId]:
        """Yield the pieces that fit and that something lies on."""
        on = self._carrying()
        return (i for i in self._left if i in on and self._does(i, wanted))

    def take(self, pieces: Iterable[ComponentId]) -> None:
        """Use pieces up."""
        for piece in pieces:
            self._left.remove(piece)

    def _does(self, piece: ComponentId, wanted: MaterialType) -> bool:
        key = (self._kind[piece], wanted)
        if key not in self._fits:
            self._fits[key] = fits(*key)
        return self._fits[key]

    def _carrying(self) -> set[ComponentId]:
        return {self._below[i] for i in self._left} - {JOBSITE}
