"""Convex solids of components in the model frame, as planes with their corners."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import combinations
from math import atan2

from sitewright.building_model.component import BoxGeometry, Component
from sitewright.foundation.pose import Vector, add, cross, dot, norm, scale, subtract, unit

_ON_PLANE_M = 1e-6
_SAME_CORNER_M = 1e-6
_SINGULAR = 1e-9


@dataclass(frozen=True, slots=True)
class Plane:
    """The side of a solid: all of it lies where ``normal . x <= offset_m``."""

    normal: Vector
    offset_m: float


@dataclass(frozen=True, slots=True)
class Face:
    """A side with its corners in order around the normal."""

    plane: Plane
    corners_m: tuple[Vector, ...]


@dataclass(frozen=True, slots=True)
class Solid:
    """A convex solid in the model frame.

    Attributes:
        corners_m: All corners.
        low_m: Lower end of the box around it along the model's axes.
        high_m: Upper end of that box.
    """

    faces: tuple[Face, ...]
    corners_m: tuple[Vector, ...] = field(init=False, repr=False, compare=False)
    low_m: Vector = field(init=False, repr=False, compare=False)
    high_m: Vector = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        corners = tuple(dict.fromkeys(c for face in self.faces for c in face.corners_m))
        xs, ys, zs = zip(*corners, strict=True)
        object.__setattr__(self, "corners_m", corners)
        object.__setattr__(self, "low_m", (min(xs), min(ys), min(zs)))
        object.__setattr__(self, "high_m", (max(xs), max(ys), max(zs)))

    def lowest_m(self, direction: Vector) -> float:
        """Return the smallest coordinate along a direction."""
        x, y, z = direction
        return min([x * c[0] + y * c[1] + z * c[2] for c in self.corners_m])

    def highest_m(self, direction: Vector) -> float:
        """Return the largest coordinate along a direction."""
        x, y, z = direction
        return max([x * c[0] + y * c[1] + z * c[2] for c in self.corners_m])

    def may_be_near(self, other: Solid, within_m: float) -> bool:
        """Whether the boxes around two solids, along the model's axes, come this near."""
        a, b, c, d = self.low_m, self.high_m, other.low_m, other.high_m
        return (
            a[0] <= d[0] + within_m
            and c[0] <= b[0] + within_m
            and a[1] <= d[1] + within_m
            and c[1] <= b[1] + within_m
            and a[2] <= d[2] + within_m
            and c[2] <= b[2] + within_m
        )


def solid_of(component: Component) -> Solid | None:
    """Return a component's box less its cuts, or None if its geometry is another or all is cut."""
    if not isinstance(component.geometry, BoxGeometry):
        return None
    planes = _distinct(_planes(component, component.geometry.size_m))
    corners = _corners(planes)
    faces = (_face(plane, corners) for plane in planes)
    found = tuple(f for f in faces if f is not None)
    return Solid(found) if found else None


def _planes(component: Component, size_m: Vector) -> list[Plane]:
    pose = component.world_T_component
    planes = []
    for axis, edge_m in zip((pose.x_axis, pose.y_axis, pose.z_axis), size_m, strict=True):
        for sign in (1.0, -1.0):
            normal = scale(axis, sign)
            planes.append(Plane(normal, dot(normal, pose.position_m) + edge_m / 2.0))
    for cut in component.cuts:
        normal = unit(pose.turn(cut.normal))
        planes.append(Plane(normal, dot(normal, pose.apply(cut.point_m))))
    return planes


def _distinct(planes: list[Plane]) -> list[Plane]:
    kept: list[Plane] = []
    for plane in planes:
        if not any(
            abs(plane.offset_m - k.offset_m) < _ON_PLANE_M
            and norm(subtract(plane.normal, k.normal)) < _ON_PLANE_M
            for k in kept
        ):
            kept.append(plane)
    return kept


def _corners(planes: list[Plane]) -> list[Vector]:
    corners: list[Vector] = []
    for a, b, c in combinations(planes, 3):
        point = _meeting_point(a, b, c)
        if (
            point is not None
            and all(dot(p.normal, point) <= p.offset_m + _ON_PLANE_M for p in planes)
            and all(norm(subtract(point, k)) > _SAME_CORNER_M for k in corners)
        ):
            corners.append(point)
    return corners


def _meeting_point(a: Plane, b: Plane, c: Plane) -> Vector | None:
    bc, ca, ab = cross(b.normal, c.normal), cross(c.normal, a.normal), cross(a.normal, b.normal)
    determinant = dot(a.normal, bc)
    if abs(determinant) < _SINGULAR:
        return None
    total = add(add(scale(bc, a.offset_m), scale(ca, b.offset_m)), scale(ab, c.offset_m))
    return scale(total, 1.0 / determinant)


def _face(plane: Plane, corners: list[Vector]) -> Face | None:
    on_it = [c for c in corners if abs(dot(plane.normal, c) - plane.offset_m) < 2 * _ON_PLANE_M]
    if len(on_it) < 3:  # noqa: PLR2004 - a polygon
        return None
    return Face(plane, tuple(around(on_it, plane.normal)))


def around(points_m: list[Vector], normal: Vector) -> list[Vector]:
    """Return the points of a convex polygon counter-clockwise about a normal."""
    middle = scale(_sum(points_m), 1.0 / len(points_m))
    u = unit(subtract(points_m[0], middle))
    v = cross(normal, u)
    return sorted(
        points_m, key=lambda p: atan2(dot(v, subtract(p, middle)), dot(u, subtract(p, middle)))
    )


def _sum(points_m: list[Vector]) -> Vector:
    total: Vector = (0.0, 0.0, 0.0)
    for point in points_m:
        total = add(total, point)
    return total
