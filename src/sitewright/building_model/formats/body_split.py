"""The separate bodies of a surface: shared vertices merged, open edges counted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sitewright.foundation.pose import Vector

_SAME_M = 1e-5
"""Vertices are one if they round to the same hundredth of a millimetre."""
_TRIANGLE = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """One connected surface.

    Attributes:
        points_m: Its vertices, each once.
        faces: Polygons as indices into them.
        open_edges: Edges that an odd number of faces share; none in a closed surface.
    """

    points_m: tuple[Vector, ...]
    faces: tuple[tuple[int, ...], ...]
    open_edges: int


def bodies_of(points_m: Sequence[Vector], faces: Iterable[Sequence[int]]) -> list[Body]:
    """Return the connected bodies of a surface, in the order of their first face."""
    merged, index_of = _merged(points_m)
    polygons = [p for f in faces if (p := _without_repeats([index_of[i] for i in f]))]
    root = list(range(len(merged)))
    for polygon in polygons:
        first = _root(root, polygon[0])
        for index in polygon[1:]:
            root[_root(root, index)] = first
    grouped: dict[int, list[list[int]]] = {}
    for polygon in polygons:
        grouped.setdefault(_root(root, polygon[0]), []).append(polygon)
    return [_body(merged, group) for group in grouped.values()]


def _merged(points_m: Sequence[Vector]) -> tuple[list[Vector], list[int]]:
    seen: dict[tuple[int, int, int], int] = {}
    merged: list[Vector] = []
    index_of: list[int] = []
    for point in points_m:
        x, y, z = (round(c / _SAME_M) for c in point)
        if (x, y, z) not in seen:
            seen[x, y, z] = len(merged)
            merged.append(point)
        index_of.append(seen[x, y, z])
    return merged, index_of


def _without_repeats(polygon: list[int]) -> list[int]:
    kept = [v for i, v in enumerate(polygon) if v != polygon[i - 1]]
    return kept if len(kept) >= _TRIANGLE else []


def _root(root: list[int], index: int) -> int:
    while root[index] != index:
        root[index] = root[root[index]]
        index = root[index]
    return index


def _body(points_m: Sequence[Vector], polygons: Sequence[Sequence[int]]) -> Body:
    used = sorted({i for polygon in polygons for i in polygon})
    new = {old: i for i, old in enumerate(used)}
    edges = Counter(
        (min(a, b), max(a, b))
        for polygon in polygons
        for a, b in zip(polygon, (*polygon[1:], polygon[0]), strict=True)
    )
    return Body(
        points_m=tuple(points_m[i] for i in used),
        faces=tuple(tuple(new[i] for i in polygon) for polygon in polygons),
        open_edges=sum(n % 2 for n in edges.values()),
    )
