"""Convex solids as points: their planes, their volume, and what a saw cut leaves of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

from sitewright.foundation.pose import Vector, add, cross, dot, norm, scale, subtract, unit
from sitewright.foundation.shapes import Box, ConvexPart

_FLAT_M = 1e-7
"""Points this near to a plane are on it."""
_PARALLEL = 1e-12
_STRAIGHT_M2 = 1e-12
_LINE = 2


@dataclass(frozen=True, slots=True)
class Plane:
    """The half space ``normal . x <= offset_m``; the normal has length one."""

    normal: Vector
    offset_m: float

    def height_m(self, point_m: Vector) -> float:
        """Return the signed distance of a point, positive outside."""
        return dot(self.normal, point_m) - self.offset_m


def planes_of(part: ConvexPart) -> tuple[Plane, ...]:
    """Return the faces of a convex part as half spaces; none if the part is flat."""
    if isinstance(part, Box):
        return _box_planes(part) if min(part.size_m) > 0.0 else ()
    return tuple(plane for plane, _ in _faces(part.vertices_m()))


def _box_planes(box: Box) -> tuple[Plane, ...]:
    pose, axes = (
        box.body_T_box,
        (box.body_T_box.x_axis, box.body_T_box.y_axis, box.body_T_box.z_axis),
    )
    return tuple(
        Plane(normal := scale(axis, sign), dot(normal, pose.position_m) + size_m / 2.0)
        for axis, size_m in zip(axes, box.size_m, strict=True)
        for sign in (1.0, -1.0)
    )


def volume_m3(points_m: Sequence[Vector]) -> float:
    """Return the volume of the convex hull of some points."""
    if not points_m:
        return 0.0
    middle = _mean(points_m)
    return sum(
        _area_m2(polygon, plane.normal) * -plane.height_m(middle) / 3.0
        for plane, polygon in _faces(points_m)
    )


def clipped(points_m: Sequence[Vector], plane: Plane) -> tuple[Vector, ...]:
    """Return points whose hull is the part of the given hull inside a half space.

    The section is the hull of all crossings of lines between a kept and a lost point; only
    its corners are returned.
    """
    heights = [plane.height_m(p) for p in points_m]
    kept = [p for p, h in zip(points_m, heights, strict=True) if h <= _FLAT_M]
    lost = [(p, h) for p, h in zip(points_m, heights, strict=True) if h > _FLAT_M]
    if not lost:
        return tuple(points_m)
    crossings = [
        add(p, scale(subtract(q, p), hp / (hp - hq)))
        for p, hp in zip(points_m, heights, strict=True)
        if hp < -_FLAT_M
        for q, hq in lost
    ]
    edge = [p for p in kept if abs(plane.height_m(p)) <= _FLAT_M]
    section = _polygon([*edge, *crossings], plane.normal)
    return (*kept, *(corner for corner in section if _is_new(corner, kept)))


def inside_length_m(
    planes: Iterable[Plane], start_m: Vector, direction: Vector, length_m: float
) -> float:
    """Return how much of a segment lies inside the convex solid of some half spaces."""
    first, last = 0.0, length_m
    for plane in planes:
        height, rate = plane.height_m(start_m), dot(plane.normal, direction)
        if abs(rate) < _PARALLEL:
            if height > _FLAT_M:
                return 0.0
        elif rate > 0.0:
            last = min(last, -height / rate)
        else:
            first = max(first, -height / rate)
    return max(0.0, last - first)


def _faces(points_m: Sequence[Vector]) -> Iterator[tuple[Plane, list[Vector]]]:
    """Yield each face once: its plane and its corners in order."""
    seen: set[frozenset[int]] = set()
    for a, b, c in combinations(range(len(points_m)), 3):
        if any({a, b, c} <= face for face in seen):
            continue
        plane = _plane_through(points_m[a], points_m[b], points_m[c])
        if plane is None:
            continue
        heights = [plane.height_m(p) for p in points_m]
        on = frozenset(i for i, h in enumerate(heights) if abs(h) <= _FLAT_M)
        if (min(heights) < -_FLAT_M and max(heights) > _FLAT_M) or len(on) == len(points_m):
            continue
        seen.add(on)
        if max(heights) > _FLAT_M:
            plane = Plane(scale(plane.normal, -1.0), -plane.offset_m)
        yield plane, _polygon([points_m[i] for i in sorted(on)], plane.normal)


def _plane_through(a: Vector, b: Vector, c: Vector) -> Plane | None:
    normal = cross(subtract(b, a), subtract(c, a))
    size = norm(normal)
    if size < 1e-6 * norm(subtract(b, a)) * norm(subtract(c, a)) or size == 0.0:
        return None
    normal = scale(normal, 1.0 / size)
    return Plane(normal, dot(normal, a))


def _polygon(points_m: Sequence[Vector], normal: Vector) -> list[Vector]:
    """Return the corners of the hull of points in one plane, counter-clockwise about `normal`."""
    if not points_m:
        return []
    helper: Vector = (1.0, 0.0, 0.0) if abs(normal[0]) < abs(normal[1]) else (0.0, 1.0, 0.0)
    u = unit(cross(normal, helper))
    v = cross(normal, u)
    flat = sorted({(round(dot(p, u), 9), round(dot(p, v), 9)): p for p in points_m}.items())
    return [*_chain(flat), *_chain(flat[::-1])] if len(flat) > _LINE else [p for _, p in flat]


def _chain(flat: Sequence[tuple[tuple[float, float], Vector]]) -> list[Vector]:
    """Return one side of a flat hull (Andrew's monotone chain), its last point left out."""
    chain: list[tuple[tuple[float, float], Vector]] = []
    for item in flat:
        while len(chain) >= _LINE and _turn(chain[-2][0], chain[-1][0], item[0]) <= _STRAIGHT_M2:
            chain.pop()
        chain.append(item)
    return [p for _, p in chain[:-1]]


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _area_m2(polygon: Sequence[Vector], normal: Vector) -> float:
    total: Vector = (0.0, 0.0, 0.0)
    for p, q in zip(polygon, (*polygon[1:], *polygon[:1]), strict=True):
        total = add(total, cross(p, q))
    return abs(dot(total, normal)) / 2.0


def _is_new(point_m: Vector, others: Sequence[Vector]) -> bool:
    return all(norm(subtract(point_m, o)) > _FLAT_M for o in others)


def _mean(points_m: Sequence[Vector]) -> Vector:
    total: Vector = (0.0, 0.0, 0.0)
    for point in points_m:
        total = add(total, point)
    return scale(total, 1.0 / len(points_m))
