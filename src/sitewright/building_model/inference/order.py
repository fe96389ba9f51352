"""The order of construction, found by taking the finished frame apart."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from heapq import heappop, heappush

from sitewright.building_model.inference.insertion import WayOut, way_out
from sitewright.building_model.inference.standing import Standing
from sitewright.building_model.inference.statics import Statics
from sitewright.foundation.ids import ComponentId

_Rank = tuple[int, float, ComponentId]


@dataclass(frozen=True, slots=True, kw_only=True)
class Arrival:
    """How one component comes into the frame.

    Attributes:
        number: 1 for the first.
        parents: What it rests on; for a hanging one, what it is joined to by then.
        is_hanging: Nothing carries it from below: it needs hold until it is fastened.
        way: Way out, reversed the way in; None if its neighbours lock it.
    """

    id: ComponentId
    number: int
    parents: tuple[ComponentId, ...]
    is_hanging: bool
    way: WayOut | None


def floating(statics: Statics) -> tuple[ComponentId, ...]:
    """Return the components that stand on nothing, even when all is built."""
    everything = frozenset(statics.solid_by_id)
    return tuple(sorted(everything - statics.anchored(everything)))


def arrivals(statics: Statics) -> list[Arrival]:
    """Return how the components come, first to last; those that stand on nothing are left out.

    The frame is taken apart from the end: a component may leave if it carries nothing and all
    that stays still leads down to the ground. Those that part from all neighbours at once go
    before those that slide, high ones before low ones; ids break ties. If none may leave, the
    best of all goes, so that all come out.
    """
    apart = _TakingApart(statics)
    return _arrivals(statics, list(apart.leaving())[::-1])


class _TakingApart:
    """Who leaves next, the best first; whoever is kept by another waits until that has gone."""

    def __init__(self, statics: Statics) -> None:
        self._statics = statics
        self._standing = Standing(statics, statics.anchored(frozenset(statics.solid_by_id)))
        self._way: dict[ComponentId, WayOut | None] = {}
        self._rank: dict[ComponentId, _Rank] = {}
        self._queue: list[_Rank] = []
        self._waiting: dict[ComponentId, list[ComponentId]] = {}

    def leaving(self) -> Iterator[tuple[ComponentId, WayOut | None]]:
        """Yield the components as they leave, each with its way out."""
        self._look_at(self._standing.present)
        while self._standing.present:
            gone = self._next()
            yield gone, self._way[gone]
            self._standing.take(gone)
            del self._rank[gone]
            self._look_at(self._statics.around[gone].keys() & self._standing.present)
            for kept in self._waiting.pop(gone, ()):
                self._push(kept)

    def _next(self) -> ComponentId:
        while self._queue and not self._standing.lost:
            rank = heappop(self._queue)
            component = rank[-1]
            if self._rank.get(component) != rank:
                continue
            keeper = self._standing.kept_by(component)
            if keeper is None:
                return component
            self._waiting.setdefault(keeper, []).append(component)
        if len(self._standing.lost) == 1:
            (component,) = self._standing.lost
            if self._standing.kept_by(component) is None:
                return component
        return min(self._rank.values())[-1]

    def _look_at(self, components: Iterable[ComponentId]) -> None:
        """Find the ways out of some components as things stand now."""
        for component in components:
            way = _way(self._statics, component, self._standing.present)
            height_m = self._statics.solid_by_id[component].lowest_m(self._statics.up)
            trouble = 2 if way is None else int(way.slide_m > 0.0)
            self._way[component] = way
            self._rank[component] = (trouble, -round(height_m, 4), component)
            self._push(component)

    def _push(self, component: ComponentId) -> None:
        if component in self._rank:
            heappush(self._queue, self._rank[component])


def _way(
    statics: Statics, component: ComponentId, present: AbstractSet[ComponentId]
) -> WayOut | None:
    around = [s for other, s in statics.around[component].items() if other in present]
    height_m = statics.solid_by_id[component].lowest_m(statics.up) - statics.ground_m
    return way_out(around, statics.up, height_m)


def _arrivals(statics: Statics, coming: list[tuple[ComponentId, WayOut | None]]) -> list[Arrival]:
    there: set[ComponentId] = set()
    found = []
    for number, (component, way) in enumerate(coming, start=1):
        is_hanging = not statics.is_carried(component)
        parents = statics.carriers_of(component) & there
        if is_hanging:
            parents = statics.holders(component, there)
        found.append(
            Arrival(
                id=component,
                number=number,
                parents=tuple(sorted(parents)) if component not in statics.ground else (),
                is_hanging=is_hanging,
                way=way,
            )
        )
        there.add(component)
    return found
