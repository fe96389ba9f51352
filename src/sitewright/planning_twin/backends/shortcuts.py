"""Quicker paths: straight lines past the corners of a path, and corners drawn in."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.search_space import SearchSpace

_TRIES = 60
_PATIENCE = 12
"""So many tries in a row may be in vain."""
_STOP_S = 0.5
"""A corner costs about so long, because the robot rests there."""
_LEAST_GAIN_S = 0.01
_PULLS = (0.8, 0.4, 0.2)


def quicker(space: SearchSpace, path: list[Array], seed: int) -> list[Array]:
    """Return a free path between the same ends that takes less time, or the same one.

    First every corner is joined to the furthest later one that a free line reaches. Then lines
    between random places of the path are tried, and corners are moved towards the line between
    their neighbours.

    Args:
        space: What moves, and what is free.
        path: Waypoints joined by free lines.
        seed: The same seed gives the same path.
    """
    path = _without_detours(space, path)
    rng = np.random.default_rng(seed)
    in_vain = 0
    for _ in range(_TRIES):
        if len(path) <= 2 or in_vain >= _PATIENCE:  # noqa: PLR2004 - a line has two ends
            break
        tried = _cut(space, path, np.sort(rng.random(2)))
        tried = _pulled(space, tried, int(rng.integers(1, max(2, len(tried) - 1))))
        in_vain = in_vain + 1 if tried is path else 0
        path = tried
    return path


def _without_detours(space: SearchSpace, path: list[Array]) -> list[Array]:
    kept, here = [path[0]], 0
    while here < len(path) - 1:
        here = next(
            k
            for k in range(len(path) - 1, here, -1)
            if k == here + 1 or space.is_free_line(path[here], path[k])
        )
        kept.append(path[here])
    return kept


def _cut(space: SearchSpace, path: list[Array], shares: Array) -> list[Array]:
    """Return the path with a line between two places of it, if that is quicker and free."""
    ends = np.cumsum([space.duration_s(a, b) for a, b in pairwise(path)])
    first, last = (int(k) for k in np.searchsorted(ends, shares * ends[-1]))
    a, b = (_at(path, ends, share * ends[-1]) for share in shares)
    return _better(space, path, [*path[: first + 1], a, b, *path[last + 1 :]], (a, b))


def _at(path: list[Array], ends: Array, at_s: float) -> Array:
    """Return the place of a path that is reached after some time without stops."""
    k = int(np.searchsorted(ends, at_s))
    start_s = ends[k - 1] if k else 0.0
    return np.asarray(path[k] + (at_s - start_s) / (ends[k] - start_s) * (path[k + 1] - path[k]))


def _pulled(space: SearchSpace, path: list[Array], k: int) -> list[Array]:
    """Return the path with a corner moved towards the line between its neighbours."""
    if not 0 < k < len(path) - 1:
        return path
    before, corner, after = path[k - 1 : k + 2]
    way = after - before
    share = np.clip((corner - before) @ way / (way @ way), 0.0, 1.0) if way.any() else 0.0
    for pull in _PULLS:
        moved = corner + pull * (before + share * way - corner)
        tried = [*path[:k], moved, *path[k + 1 :]]
        found = _better(space, path, tried, (before, moved), (moved, after))
        if found is tried:
            return tried
    return path


def _better(
    space: SearchSpace, path: list[Array], tried: list[Array], *lines: tuple[Array, Array]
) -> list[Array]:
    """Return the second path if it is quicker and its new lines are free, else the first."""
    is_quicker = _duration_s(space, tried) < _duration_s(space, path) - _LEAST_GAIN_S
    return tried if is_quicker and all(space.is_free_line(a, b) for a, b in lines) else path


def _duration_s(space: SearchSpace, path: list[Array]) -> float:
    return sum(space.duration_s(a, b) + _STOP_S for a, b in pairwise(path))
