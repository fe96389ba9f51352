"""Paths by two trees that start with the straight ways out of both ends."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.search_space import SearchSpace
from sitewright.planning_twin.backends.search_tree import SearchTree

_LONGEST_EDGE = 1.0
CORRIDOR_M = 0.36
"""How far a straight way out of an end is followed."""
_PARALLEL = 0.9998
_ACROSS = 0.5
_ENOUGH_WAYS = 3
_CORNER_STRIDES = (4, 2, 1)
_NEAR_ROOTS = 0.15
_WORKSPACE = 0.15
_MARGINS_RAD = (0.6, 1.6, np.inf)
"""Samples come from around the ends first, and from ever further away."""
_WIDEN_AFTER = 30
_PROBES = 8
_SMALL_RAD = 0.04


@dataclass(slots=True)
class _Side:
    """One of the two trees.

    Attributes:
        roots: Postures that it starts from.
        corridors: Straight ways out of them.
    """

    tree: SearchTree
    roots: list[Array]
    corridors: list[_Corridor] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class _Corridor:
    """A straight way of a tip out of a root.

    Attributes:
        nodes: Its postures in the tree.
        across: Directions in which it may be left.
    """

    root: int
    tip: int
    nodes: range
    across: list[Array]


def found_path(
    space: SearchSpace, start: Array, goals: list[Array], *, max_lines: int, seed: int
) -> list[Array] | None:
    """Return waypoints from the start to one of the goals, None if the budget was used up.

    Straight lines come first. Then the tree of an end in a narrow place gets the straight ways
    of the tip out of it, as far as these are free: such a posture is hardly ever left by chance,
    but nearly always by a line of the tip. From there on the trees grow towards each other,
    towards samples in joint space, or along straight lines of the tip. Ends in wide places get
    their ways out only if that does not help soon.

    Args:
        space: What moves, and what is free.
        start: A free posture.
        goals: Free postures, the most welcome first.
        max_lines: Budget: lines looked at.
        seed: The same seed gives the same path.
    """
    for goal in goals:
        if space.is_free_line(start, goal):
            return [start, goal]
    rng = np.random.default_rng(seed)
    sides = (_side(space, [start]), _side(space, goals))
    return _Search(space, sides, rng, max_lines).path()


def _side(space: SearchSpace, roots: list[Array]) -> _Side:
    tree = SearchTree(space, _LONGEST_EDGE)
    for q in roots:
        tree.add(q)
    return _Side(tree=tree, roots=roots)


@dataclass(frozen=True, slots=True)
class _Grown:
    """A new node of one side's tree."""

    side: int
    node: int


class _Search:
    def __init__(
        self,
        space: SearchSpace,
        sides: tuple[_Side, _Side],
        rng: np.random.Generator,
        max_lines: int,
    ) -> None:
        self._space, self._sides, self._rng, self._max_lines = space, sides, rng, max_lines
        roots = np.array([q for side in sides for q in side.roots])
        self._lowest, self._highest = roots.min(axis=0), roots.max(axis=0)

    def path(self) -> list[Array] | None:
        """Grow both trees in turn until they meet."""
        for grown in self._growth():
            side = self._sides[grown.side]
            if found := self._met(side, self._sides[1 - grown.side], grown.node):
                return found
            if self._space.lines >= self._max_lines:
                return None
        return None

    def _growth(self) -> Iterator[_Grown]:
        """Yield new nodes that are worth an attempt to connect."""
        ends = [
            (k, root, tip)
            for k, side in enumerate(self._sides)
            for root in range(len(side.roots))
            for tip in self._space.tips
        ]
        narrow = [
            (k, root, tip)
            for k, root, tip in ends
            if self._is_narrow(self._sides[k].roots[root], tip)
        ]
        for end in narrow:
            yield from self._corridors(*end)
        for end in narrow:
            yield from self._around_corners(*end)
        yield from self._rounds(0, _WIDEN_AFTER)
        for end in ends:
            if end not in narrow:
                yield from self._corridors(*end)
        yield from self._rounds(_WIDEN_AFTER, self._max_lines)

    def _is_narrow(self, q: Array, tip: int) -> bool:
        """Tell whether most small moves of a robot away from a posture are blocked."""
        mine = self._space.joints_of(tip)
        moves = np.zeros((_PROBES, len(q)))
        moves[:, mine] = _SMALL_RAD * self._rng.normal(size=(_PROBES, mine.stop - mine.start))
        blocked = sum(not self._space.is_free_line(q, q + move) for move in moves)
        return blocked > _PROBES // 2

    def _rounds(self, first: int, last: int) -> Iterator[_Grown]:
        for number in range(first, last):
            k = number % 2
            node = self._grown(self._sides[k], number)
            if node is not None:
                yield _Grown(k, node)
            elif self._space.lines >= self._max_lines:
                return

    def _met(self, side: _Side, other: _Side, node: int) -> list[Array] | None:
        """Return the path if the other tree reaches a node of this one."""
        reached = other.tree.reach(side.tree.point(node).copy())
        if reached is None:
            return None
        mine, theirs = side.tree.branch(node), other.tree.branch(reached)
        whole = [*mine[::-1], *theirs[1:]]
        return whole if side is self._sides[0] else whole[::-1]

    def _corridors(self, k: int, root: int, tip: int) -> Iterator[_Grown]:
        """Add the straight ways of a tip out of a root; yield the last node of each."""
        side = self._sides[k]
        axes = directions(self._space.tip_axes(tip, side.roots[root]))
        for direction in axes:
            first = len(side.tree)
            last = self._along(side.tree, root, tip, direction, CORRIDOR_M)
            if last is not None:
                across = [d for d in axes if abs(float(d @ direction)) < _ACROSS]
                side.corridors.append(_Corridor(root, tip, range(first, last + 1), across))
                yield _Grown(k, last)

    def _around_corners(self, k: int, root: int, tip: int) -> Iterator[_Grown]:
        """Add the straight ways that leave the corridors of a root sideways; yield their ends.

        So a piece gets out from under a ledge. Where a corridor leads into the open there is no
        need for them, and once a few of them do, for more.
        """
        tree = self._sides[k].tree
        corridors = [c for c in self._sides[k].corridors if (c.root, c.tip) == (root, tip)]
        if any(not self._is_narrow(tree.point(c.nodes[-1]), tip) for c in corridors):
            return
        open_ways = 0
        for corridor, node in _corners(corridors):
            for direction in corridor.across:
                last = self._along(tree, node, tip, direction, CORRIDOR_M)
                if last is not None:
                    yield _Grown(k, last)
                    open_ways += not self._is_narrow(tree.point(last), tip)
            if open_ways >= _ENOUGH_WAYS:
                return

    def _along(
        self, tree: SearchTree, node: int, tip: int, direction: Array, length_m: float
    ) -> int | None:
        """Add a straight way of a tip; return its last node, None if it is blocked at once."""
        last = None
        for q in self._space.straight(tip, tree.point(node).copy(), direction, length_m):
            node = last = tree.add(q, node)
        return last

    def _grown(self, side: _Side, rounds: int) -> int | None:
        if self._rng.random() < _WORKSPACE:
            tip = int(self._rng.integers(len(self._space.tips)))
            direction = self._rng.normal(size=3)
            direction /= np.linalg.norm(direction)
            node = int(self._rng.integers(len(side.tree)))
            return self._along(side.tree, node, tip, direction, CORRIDOR_M)
        return side.tree.grow(self._sample(side, rounds))

    def _sample(self, side: _Side, rounds: int) -> Array:
        if self._rng.random() < _NEAR_ROOTS:
            root = side.roots[int(self._rng.integers(len(side.roots)))]
            spread = 10.0 ** self._rng.uniform(-1.5, 0.0)
            q = root + spread * self._rng.normal(size=len(root))
            return np.asarray(np.clip(q, self._space.lower, self._space.upper))
        margin = _MARGINS_RAD[min(rounds // _WIDEN_AFTER, len(_MARGINS_RAD) - 1)]
        lower = np.maximum(self._space.lower, self._lowest - margin)
        upper = np.minimum(self._space.upper, self._highest + margin)
        return np.asarray(self._rng.uniform(lower, upper))


def _corners(corridors: list[_Corridor]) -> Iterator[tuple[_Corridor, int]]:
    """Yield where corridors may be left: their far ends and a few other postures first."""
    seen: set[int] = set()
    for stride in _CORNER_STRIDES:
        for corridor in sorted(corridors, key=lambda c: -len(c.nodes)):
            fresh = [node for node in corridor.nodes[::-stride] if node not in seen]
            seen.update(fresh)
            yield from ((corridor, node) for node in fresh)


def directions(axes: Array) -> list[Array]:
    """Return the axes of the world and of a tip, both ways, without those that repeat."""
    found: list[Array] = []
    for axis in (*np.eye(3)[::-1], *axes[::-1]):
        for direction in (axis, -axis):
            if all(float(direction @ other) < _PARALLEL for other in found):
                found.append(direction)
    return found
