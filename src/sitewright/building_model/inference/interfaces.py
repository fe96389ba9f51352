"""Face contacts between components of any convex shape: all patches of each touching pair."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from sitewright.building_model.inference.bodies import Body, Part, Points, stacked
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector

GAP_M = 0.001
"""Faces nearer than this touch."""
MIN_AREA_M2 = 1e-4
CURVED_AREA_M2 = 1e-3
"""Smallest contact where a curved surface is made of facets: slivers are no contacts."""
_CURVED_FACES = 20
_ANTIPARALLEL = -0.99985
"""cos of 179 degrees."""
_ROWS = 512
_TRIANGLE = 3


@dataclass(frozen=True, slots=True)
class Patch:
    """A plane piece of contact.

    Attributes:
        normal: Unit vector in the model frame, from the first component into the second.
        corners_m: Convex polygon in the model frame.
    """

    normal: Vector
    corners_m: tuple[Vector, ...]
    area_m2: float


@dataclass(frozen=True, slots=True)
class Interface:
    """Two components that touch face to face; `a` sorts before `b`."""

    a: ComponentId
    b: ComponentId
    patches: tuple[Patch, ...]

    @property
    def area_m2(self) -> float:
        """Area of all patches."""
        return sum(p.area_m2 for p in self.patches)

    @property
    def largest(self) -> Patch:
        """The largest patch."""
        return max(self.patches, key=lambda p: p.area_m2)


def interfaces_of(bodies: Mapping[ComponentId, Body], gap_m: float = GAP_M) -> list[Interface]:
    """Return every touching pair with its patches, in order of id."""
    names = sorted(bodies)
    found = []
    for a, b in near_pairs([bodies[i] for i in names], gap_m):
        interface = interface_between(bodies[names[a]], bodies[names[b]], gap_m)
        if interface is not None:
            found.append(interface)
    return found


def interface_between(one: Body, other: Body, gap_m: float = GAP_M) -> Interface | None:
    """Return the contact of two bodies, if they have one."""
    is_curved = max(one.faces_total, other.faces_total) > _CURVED_FACES
    smallest_m2 = CURVED_AREA_M2 if is_curved else MIN_AREA_M2
    patches = [p for a in one.parts for b in other.parts for p in _patches(a, b, gap_m)]
    kept = tuple(p for p in patches if p.area_m2 > smallest_m2)
    return Interface(one.id, other.id, kept) if kept else None


def near_pairs(bodies: list[Body], within_m: float) -> Iterator[tuple[int, int]]:
    """Yield pairs (first < second) whose boxes along the model's axes come this near."""
    low, high = stacked(bodies)
    for start in range(0, len(bodies), _ROWS):
        rows = slice(start, start + _ROWS)
        meet = np.all(low[rows, None] <= high[None] + within_m, axis=2)
        meet &= np.all(low[None] <= high[rows, None] + within_m, axis=2)
        for k, other in np.argwhere(meet):
            if start + k < other:
                yield int(start + k), int(other)


def _patches(one: Part, other: Part, gap_m: float) -> Iterator[Patch]:
    facing = one.normals @ other.normals.T < _ANTIPARALLEL
    for i, j in np.argwhere(facing):
        normal = one.normals[i]
        corners = other.corners_m[list(other.polygons[j])]
        heights = corners @ normal - one.offsets_m[i]
        if heights.min() > gap_m or heights.max() < -gap_m:
            continue
        base = one.corners_m[list(one.polygons[i])]
        patch = _shared(base, corners, normal, gap_m)
        if patch is not None:
            yield patch


def _shared(base: Points, corners: Points, normal: Points, gap_m: float) -> Patch | None:
    """Clip one face by the other; both are convex and nearly parallel."""
    u = base[1] - base[0]
    u = u / np.linalg.norm(u)
    v = np.cross(normal, u)
    frame = np.array([u, v, normal])
    origin = base[0]
    polygon: list[Vector] = [
        (float(x), float(y), float(z)) for x, y, z in (corners - origin) @ frame.T
    ]
    edges = [(float(x), float(y)) for x, y, _ in (base - origin) @ frame.T]
    for k in range(len(edges)):
        polygon = _clipped(polygon, edges[k - 1], edges[k])
        if len(polygon) < _TRIANGLE:
            return None
    if abs(sum(p[2] for p in polygon)) / len(polygon) > gap_m:
        return None
    area_m2 = _area_m2(polygon)
    placed = np.array([(x, y, 0.0) for x, y, _ in polygon]) @ frame + origin
    return Patch(_vector(normal), tuple(_vector(p) for p in placed), area_m2)


def _clipped(
    polygon: list[Vector], start: tuple[float, float], end: tuple[float, float]
) -> list[Vector]:
    """Return what lies to the left of an edge (counter-clockwise: inside)."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    sides = [dx * (p[1] - start[1]) - dy * (p[0] - start[0]) for p in polygon]
    if min(sides) >= 0.0:
        return polygon
    kept: list[Vector] = []
    for k, point in enumerate(polygon):
        before, now, last = sides[k - 1], sides[k], polygon[k - 1]
        if (before < 0.0) != (now < 0.0):
            share = before / (before - now)
            kept.append(_between(last, point, share))
        if now >= 0.0:
            kept.append(point)
    return kept


def _between(a: Vector, b: Vector, share: float) -> Vector:
    return (
        a[0] + share * (b[0] - a[0]),
        a[1] + share * (b[1] - a[1]),
        a[2] + share * (b[2] - a[2]),
    )


def _area_m2(polygon: list[Vector]) -> float:
    total = 0.0
    for k, point in enumerate(polygon):
        last = polygon[k - 1]
        total += last[0] * point[1] - point[0] * last[1]
    return abs(total) / 2.0


def _vector(row: Points) -> Vector:
    return (float(row[0]), float(row[1]), float(row[2]))
