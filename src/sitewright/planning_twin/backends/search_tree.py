"""A tree of free postures that grows from one or more roots."""

from __future__ import annotations

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.search_space import SearchSpace

_FIRST_ROOM = 64
_ROOT = -1
_HALVINGS = 4
_SAME = 1e-9


class SearchTree:
    """Postures with their parents, found again by nearness."""

    def __init__(self, space: SearchSpace, longest: float) -> None:
        self._space, self._longest = space, longest
        self._points = np.empty((_FIRST_ROOM, len(space.lower)))
        self._parents: list[int] = []

    def __len__(self) -> int:
        return len(self._parents)

    def point(self, node: int) -> Array:
        """Return a node's posture."""
        return np.asarray(self._points[node])

    def add(self, q: Array, parent: int = _ROOT) -> int:
        """Add a posture; without a parent it is a root. Returns its number."""
        if len(self._parents) == len(self._points):
            self._points = np.concatenate((self._points, np.empty_like(self._points)))
        self._points[len(self._parents)] = q
        self._parents.append(parent)
        return len(self._parents) - 1

    def nearest(self, q: Array) -> int:
        """Return the node nearest to a posture."""
        return int(self._space.distances(self._points[: len(self)], q).argmin())

    def branch(self, node: int) -> list[Array]:
        """Return the postures from a node back to its root."""
        found = []
        while node != _ROOT:
            found.append(self._points[node].copy())
            node = self._parents[node]
        return found

    def grow(self, q: Array) -> int | None:
        """Go from the nearest node as far as can be gone towards a posture, one edge at most.

        Where the whole edge is blocked, shorter ones are tried, so that the tree gets into
        narrow places. Returns the new node, None if there is none.
        """
        node = self.nearest(q)
        here = self._points[node]
        way = q - here
        length = self._space.distance(q, here)
        if length < _SAME:
            return None
        share = min(1.0, self._longest / length)
        for _ in range(_HALVINGS):
            there = here + share * way
            if self._space.is_free_line(here, there):
                return self.add(there, node)
            share /= 2.0
        return None

    def reach(self, q: Array) -> int | None:
        """Go towards a posture edge by edge; return its node, None if it is not reached."""
        node = self.nearest(q)
        while True:
            here = self._points[node]
            length = self._space.distance(q, here)
            if length < _SAME:
                return node
            share = min(1.0, self._longest / length)
            there = q if share == 1.0 else here + share * (q - here)
            if not self._space.is_free_line(here, there):
                return None
            node = self.add(there, node)
