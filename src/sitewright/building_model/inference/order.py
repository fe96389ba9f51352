"""The order of construction, found by taking the finished frame apart."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sitewright.building_model.inference.insertion import WayOut, way_out
from sitewright.building_model.inference.statics import Statics
from sitewright.foundation.ids import ComponentId


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
    before those that slide, high ones before low ones; ids break ties.
    """
    present = statics.anchored(frozenset(statics.solid_by_id))
    leaving: list[tuple[ComponentId, WayOut | None]] = []
    ways: dict[ComponentId, WayOut | None] = {}
    while present:
        for component in present - ways.keys():
            ways[component] = _way(statics, component, present)
        gone = next(_candidates(statics, present, ways))
        leaving.append((gone, ways[gone]))
        present -= {gone}
        for neighbour in statics.around[gone]:
            ways.pop(neighbour, None)
    return _arrivals(statics, leaving[::-1])


def _candidates(
    statics: Statics, present: frozenset[ComponentId], ways: dict[ComponentId, WayOut | None]
) -> Iterator[ComponentId]:
    """Yield who may leave next, the best first; at last whoever is there, so that all come out."""
    ranked = sorted(present, key=lambda i: _rank(statics, i, ways[i]))
    carrying = {c for i in present for c in statics.carriers_of(i)}
    for component in ranked:
        rest = present - {component}
        if component not in carrying and statics.anchored(rest) == rest:
            yield component
    yield from ranked


def _rank(
    statics: Statics, component: ComponentId, way: WayOut | None
) -> tuple[int, float, ComponentId]:
    trouble = 2 if way is None else int(way.slide_m > 0.0)
    return (trouble, -round(statics.solid_by_id[component].lowest_m(statics.up), 4), component)


def _way(
    statics: Statics, component: ComponentId, present: frozenset[ComponentId]
) -> WayOut | None:
    around = [s for other, s in statics.around[component].items() if other in present]
    height_m = statics.solid_by_id[component].lowest_m(statics.up) - statics.ground_m
    return way_out(around, statics.up, height_m)


def _arrivals(statics: Statics, coming: list[tuple[ComponentId, WayOut | None]]) -> list[Arrival]:
    there: list[ComponentId] = []
    found = []
    for number, (component, way) in enumerate(coming, start=1):
        is_hanging = not statics.is_carried(component)
        parents = statics.carriers_of(component) & frozenset(there)
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
        there.append(component)
    return found
