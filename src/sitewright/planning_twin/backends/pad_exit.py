"""The way out of a place that is wide enough, but not for padded bodies."""

from __future__ import annotations

from collections.abc import Callable

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.search_ends import SearchQuestion
from sitewright.planning_twin.backends.search_space import SearchSpace
from sitewright.planning_twin.backends.tree_search import CORRIDOR_M, directions


def way_out_of_pads(
    question: SearchQuestion, q: Array, is_proven: Callable[[list[Array]], bool]
) -> list[Array] | None:
    """Return a proven straight way to the first posture where no pad touches anything.

    A search that leaves the near pairs out all along would find ways right through them.

    Args:
        question: The scene, with the near pairs left out; it is left so.
        q: Where pads may touch; without a touch the way is this posture alone.
        is_proven: Judges a way by exact distances.
    """
    search, space = question.search, question.space
    ways = [
        [q, *space.straight(tip, q, direction, CORRIDOR_M)]
        for tip in space.tips
        for direction in directions(space.tip_axes(tip, q))
    ]
    search.leave_out(question.left_out - question.near)
    cut = [_until_free(space, way) for way in ways]
    search.leave_out(question.left_out)
    for way in sorted((w for w in cut if w is not None), key=len):
        if len(way) == 1 or is_proven(way):
            return way
    return None


def _until_free(space: SearchSpace, way: list[Array]) -> list[Array] | None:
    for k, q in enumerate(way):
        if space.is_free(q):
            return way[: k + 1]
    return None
