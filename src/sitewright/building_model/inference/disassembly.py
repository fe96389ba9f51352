"""The order of building: the reverse of taking the finished structure apart, piece by piece."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from sitewright.building_model.inference.bodies import Points
from sitewright.building_model.inference.carrying import Bearing, lowest_m
from sitewright.building_model.inference.ways import (
    Ways,
    contact_slides,
    slide_m,
    slides_along,
    sliding,
)
from sitewright.foundation.ids import ComponentId

_CLEAR, _SHORT, _LOCKED = 0, 1, 2
_RISES = 1e-3
_MANY = 1_000_000
_SEVERAL = 2

_Rank = tuple[int, bool, float, int]
"""How hard it is to take a component out; see `_Disassembly._ranks`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Given:
    """What the author states about the order.

    Attributes:
        before: Components that must be there first, by component.
        order: Stated numbers.
        existing: Components that stand before the work begins.
    """

    before: Mapping[ComponentId, frozenset[ComponentId]] = field(default_factory=dict)
    order: Mapping[ComponentId, int] = field(default_factory=dict)
    existing: frozenset[ComponentId] = frozenset()


@dataclass(frozen=True, slots=True, kw_only=True)
class Step:
    """One component on its way out.

    Attributes:
        direction: Straight way out in the model frame; None if its neighbours lock it.
        is_short: Only the first 150 mm of the way are free.
        slide_m: How far it slides along a neighbour.
        blockers: Components that would be in this way: they come later.
        ignores: Components that it carries and that should have left before it, but could not.
    """

    id: ComponentId
    direction: tuple[float, float, float] | None
    is_short: bool
    slide_m: float
    blockers: frozenset[ComponentId]
    ignores: frozenset[ComponentId]


def build_order(bearing: Bearing, ways: Ways, given: Given) -> list[Step]:
    """Return the components in an order in which they can be built, first to last."""
    state = _Disassembly(bearing, ways, given)
    steps = []
    while state.present:
        steps.append(state.take())
    return steps[::-1]


class _Disassembly:
    """The structure while it is taken apart."""

    def __init__(self, bearing: Bearing, ways: Ways, given: Given) -> None:
        self.bearing, self.ways, self.given = bearing, ways, given
        self.index = {name: k for k, name in enumerate(ways.names)}
        self.present = {i for i in ways.names if i not in given.existing}
        self.far = ways.far.sum(axis=2, dtype=np.int64)
        self.near = ways.near.sum(axis=2, dtype=np.int64)
        self.contacts = contact_slides(bearing, ways)
        self.slides = self.contacts.sum(axis=2, dtype=np.int64)
        self.height = {i: -round(lowest_m(b, bearing.up), 4) for i, b in bearing.bodies.items()}
        self.above: dict[ComponentId, set[ComponentId]] = {i: set() for i in ways.names}
        self.after: dict[ComponentId, set[ComponentId]] = {i: set() for i in ways.names}
        for above, carriers in bearing.carriers.items():
            for below in carriers:
                self.above[below].add(above)
        for later, earlier in given.before.items():
            for first in earlier:
                if first in self.after and later in self.after:
                    self.after[first].add(later)
        self.gone: set[ComponentId] = set()

    def take(self) -> Step:
        """Take the best component out and say how it went."""
        ranks = self._ranks()
        chosen = self._choose(
            sorted(self.present, key=lambda i: (*ranks[i], -self.index[i])), ranks
        )
        trouble = ranks[chosen][0]
        step = self._step(chosen, trouble)
        k = self.index[chosen]
        self.present.discard(chosen)
        self.gone.add(chosen)
        self.far -= self.ways.far[:, :, k]
        self.near -= self.ways.near[:, :, k]
        self.slides -= self.contacts[:, :, k]
        return step

    def _ranks(self) -> dict[ComponentId, _Rank]:
        """Clear ways first, then those that rise, then high ones, then those that slide least."""
        free, short = self._free()
        rises = (self.ways.directions @ self.bearing.up) > _RISES
        clear, some = np.asarray(free.any(axis=0)), np.asarray(short.any(axis=0))
        open_ways = np.where(clear[None], free, short)
        up = np.asarray(open_ways[rises].any(axis=0))
        slides = np.where(open_ways, self.slides, _MANY).min(axis=0)
        ranks = {}
        for i in self.present:
            k = self.index[i]
            trouble = _CLEAR if clear[k] else _SHORT if some[k] else _LOCKED
            ranks[i] = (trouble, not up[k], self.height[i], int(slides[k]))
        return ranks

    def _free(self) -> tuple[npt.NDArray[np.bool_], npt.NDArray[np.bool_]]:
        open_ = ~self.ways.barred
        return (self.far == 0) & open_, (self.near == 0) & open_

    def _choose(self, ranked: list[ComponentId], ranks: Mapping[ComponentId, _Rank]) -> ComponentId:
        """Return the first that may leave; step by step less is asked for.

        What the author states is asked for longest, then what carries what, then that nothing
        is left hanging. Of equals the first goes that leaves the others joined as they are.
        """
        allowed = [i for i in ranked if self._is_allowed(i)] or ranked
        bare = [i for i in allowed if not self._carries(i)]
        for component in bare:
            if not self._leaves_hanging(component):
                equals = [i for i in bare if ranks[i] == ranks[component]]
                return next((i for i in equals if self._leaves_joined(i)), component)
        return (bare or allowed)[0]

    def _leaves_joined(self, component: ComponentId) -> bool:
        return not self._parts(component) and not self._leaves_hanging(component)

    def _parts(self, component: ComponentId) -> bool:
        """Whether what it is joined to falls into separate groups without it."""
        joined = self.bearing.joined
        there = (self.present | self.given.existing) - {component}
        neighbours = set(joined[component] & there)
        if len(neighbours) < _SEVERAL:
            return False
        waiting, reached = [neighbours.pop()], set[ComponentId]()
        while waiting and neighbours:
            one = waiting.pop()
            reached.add(one)
            neighbours.discard(one)
            waiting += (joined[one] & there) - reached
        return bool(neighbours)

    def _is_allowed(self, component: ComponentId) -> bool:
        if self.after[component] & self.present:
            return False
        number = self.given.order.get(component)
        if number is None:
            return True
        return all(self.given.order.get(i, number) <= number for i in self.present)

    def _carries(self, component: ComponentId) -> frozenset[ComponentId]:
        """Return what rests on it and is still there."""
        return frozenset(self.above[component] & self.present)

    def _leaves_hanging(self, component: ComponentId) -> bool:
        """Whether something that leads down to the ground now would not without it."""
        hanging = [
            j
            for j in self.bearing.joined[component] & self.present
            if not self.bearing.is_carried(j)
        ]
        if not hanging:
            return False
        there = frozenset(self.present | self.given.existing)
        before = self.bearing.anchored(there) - {component}
        return bool(before - self.bearing.anchored(there - {component}))

    def _step(self, component: ComponentId, trouble: int) -> Step:
        k = self.index[component]
        there = (self.present | self.given.existing) - {component}
        free, short = self._free()
        possible = np.flatnonzero((free if trouble == _CLEAR else short)[:, k])
        direction, blockers, slide = None, frozenset[ComponentId](), 0.0
        if len(possible):
            best = self._best(component, possible, there)
            way = self.ways.directions[best]
            matrix = self.ways.far if trouble == _CLEAR else self.ways.near
            hit = {self.ways.names[j] for j in np.flatnonzero(matrix[best, k])}
            blockers = frozenset(hit & self.gone)
            direction = (float(way[0]), float(way[1]), float(way[2]))
            slide = slide_m(self.bearing, component, there, way)
        return Step(
            id=component,
            direction=direction,
            is_short=trouble == _SHORT,
            slide_m=slide,
            blockers=blockers,
            ignores=self._carries(component),
        )

    def _best(
        self, component: ComponentId, possible: npt.NDArray[np.int64], there: Iterable[ComponentId]
    ) -> int:
        """Return the direction that slides along least and rises most."""
        normals = sliding(self.bearing, component, there)
        directions: Points = self.ways.directions
        return int(
            min(
                possible,
                key=lambda d: (
                    slides_along(normals, directions[d]),
                    -round(float(directions[d] @ self.bearing.up), 6),
                    d,
                ),
            )
        )
