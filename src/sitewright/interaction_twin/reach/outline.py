"""Outlines of bodies as seen from above and from the side."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.shapes import Shape, moved

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Outline:
    """One body in both views, in metres.

    Attributes:
        plan: Convex polygons in x and y, one per convex part.
        elevation: Convex polygons in x and z.
        low_m, high_m: The box around it along the world's axes.
    """

    plan: tuple[tuple[Point, ...], ...]
    elevation: tuple[tuple[Point, ...], ...]
    low_m: Vector
    high_m: Vector

    @property
    def middle_m(self) -> Vector:
        """Middle of the box around it."""
        return tuple((a + b) / 2.0 for a, b in zip(self.low_m, self.high_m, strict=True))  # type: ignore[return-value]


def outline_of(shape: Shape, world_T_shape: Pose) -> Outline:
    """Return a body's outlines where it stands."""
    parts = [part.vertices_m() for part in moved(shape, world_T_shape)]
    points = [p for part in parts for p in part]
    low, high = (tuple(f(p[k] for p in points) for k in range(3)) for f in (min, max))
    return Outline(
        plan=tuple(hull([(x, y) for x, y, _ in part]) for part in parts),
        elevation=tuple(hull([(x, z) for x, _, z in part]) for part in parts),
        low_m=low,  # type: ignore[arg-type]
        high_m=high,  # type: ignore[arg-type]
    )


def hull(points: Iterable[Point]) -> tuple[Point, ...]:
    """Return the convex hull of points in the plane, counter-clockwise (Andrew's chains)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:  # noqa: PLR2004 - no polygon
        return tuple(ordered)
    return (*_chain(ordered)[:-1], *_chain(ordered[::-1])[:-1])


def _chain(points: Sequence[Point]) -> list[Point]:
    chain: list[Point] = []
    for p in points:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0.0:
            chain.pop()
        chain.append(p)
    return chain


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
