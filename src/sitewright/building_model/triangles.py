"""Convex pieces of a flat polygon: itself, or triangles cut off ear by ear."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

Point2 = tuple[float, float]

_FLAT_M2 = 1e-12
_CORNERS = 3


def convex_pieces(profile_m: Sequence[Point2]) -> list[tuple[Point2, ...]]:
    """Return convex polygons that together make up the profile; none if it crosses itself."""
    corners = _counter_clockwise(_without_repeats(profile_m))
    if len(corners) < _CORNERS or _signed_area_m2(corners) < _FLAT_M2:
        return []
    if _crosses_itself(corners):
        return []
    if _is_convex(corners):
        return [tuple(corners)]
    return _ears(corners)


def _ears(corners: list[Point2]) -> list[tuple[Point2, ...]]:
    rest, triangles = list(corners), []
    while len(rest) > _CORNERS:
        ear = next((i for i in range(len(rest)) if _is_ear(rest, i)), None)
        if ear is None:
            return []
        a, b, c = rest[ear - 1], rest[ear], rest[(ear + 1) % len(rest)]
        if _cross(a, b, c) > _FLAT_M2:
            triangles.append((a, b, c))
        del rest[ear]
    return [*triangles, tuple(rest)]


def _is_ear(corners: Sequence[Point2], index: int) -> bool:
    a, b, c = corners[index - 1], corners[index], corners[(index + 1) % len(corners)]
    if _cross(a, b, c) < -_FLAT_M2:
        return False
    others = (p for p in corners if p not in (a, b, c))
    return not any(_is_inside(p, a, b, c) for p in others)


def _is_inside(p: Point2, a: Point2, b: Point2, c: Point2) -> bool:
    return all(_cross(u, v, p) >= -_FLAT_M2 for u, v in ((a, b), (b, c), (c, a)))


def _crosses_itself(corners: Sequence[Point2]) -> bool:
    edges = list(zip(corners, (*corners[1:], *corners[:1]), strict=True))
    return any(
        _are_apart(p, q, *b) and _are_apart(*b, p, q) for (p, q), b in combinations(edges, 2)
    )


def _are_apart(p: Point2, q: Point2, a: Point2, b: Point2) -> bool:
    """Return whether a and b lie on different sides of the line through p and q."""
    return _cross(p, q, a) * _cross(p, q, b) < -(_FLAT_M2**2)


def _is_convex(corners: Sequence[Point2]) -> bool:
    count = len(corners)
    turns = (_cross(corners[i - 1], corners[i], corners[(i + 1) % count]) for i in range(count))
    return all(turn >= -_FLAT_M2 for turn in turns)


def _counter_clockwise(corners: list[Point2]) -> list[Point2]:
    return corners if _signed_area_m2(corners) >= 0.0 else corners[::-1]


def _without_repeats(profile_m: Sequence[Point2]) -> list[Point2]:
    corners = list(profile_m)
    return [p for i, p in enumerate(corners) if p != corners[i - 1]]


def _signed_area_m2(corners: Sequence[Point2]) -> float:
    pairs = zip(corners, (*corners[1:], *corners[:1]), strict=True)
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in pairs) / 2.0


def _cross(a: Point2, b: Point2, c: Point2) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
