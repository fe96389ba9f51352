"""Half-spaces that clip an IFC solid, as saw cuts; bounded ones only if they cut right through."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from typing import Any

from sitewright.building_model.formats.ifc_placement import NotAnalyticError, axis_pose
from sitewright.foundation.pose import Pose, Vector, add, dot, scale, subtract, unit

Point2 = tuple[float, float]
_FEWEST = 3
_TOLERANCE = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class Clip:
    """A plane in the frame of the clipped item; the side of the normal is removed.

    Attributes:
        bound: Frame and corners of the prism, along the frame's z, that alone is removed.
    """

    point: Vector
    normal: Vector
    bound: tuple[Pose, list[Point2]] | None = None

    def seen_from(self, frame_T_item: Pose) -> tuple[Vector, Vector]:
        """Return point and unit normal in another frame."""
        return frame_T_item.apply(self.point), unit(frame_T_item.turn(self.normal))


def clip_of(result: Any) -> Clip:  # noqa: ANN401 - untyped entities throughout
    """Return what an IfcBooleanResult takes away.

    Raises:
        NotAnalyticError: It is no half-space.
    """
    tool = result.SecondOperand
    kinds = ("IfcHalfSpaceSolid", "IfcPolygonalBoundedHalfSpace")
    if result.Operator != "DIFFERENCE" or tool.is_a() not in kinds:
        raise NotAnalyticError(tool.is_a())
    if not tool.BaseSurface.is_a("IfcPlane"):
        raise NotAnalyticError(tool.BaseSurface.is_a())
    plane = axis_pose(tool.BaseSurface.Position)
    bound = None
    if tool.is_a() == "IfcPolygonalBoundedHalfSpace":
        bound = axis_pose(tool.Position), polyline_corners(tool.PolygonalBoundary)
    side = -1.0 if tool.AgreementFlag else 1.0
    return Clip(point=plane.position_m, normal=scale(plane.z_axis, side), bound=bound)


def demand_plain(clip: Clip, item_T_box: Pose, size: Vector) -> None:
    """Accept a clip whose bound holds all that its plane cuts off a box.

    Raises:
        NotAnalyticError: Some of it would stay.
    """
    if clip.bound is None:
        return
    frame, corners = clip.bound
    back = frame.inverse()
    for point in _cut_off(clip, item_T_box, size):
        x, y, _ = back.apply(point)
        if not _is_inside((x, y), corners):
            raise NotAnalyticError("a bounded half-space")


def polyline_corners(curve: Any) -> list[Point2]:  # noqa: ANN401
    """Return the corners of a closed polyline, the first one not repeated.

    Raises:
        NotAnalyticError: It is another curve, or has no area.
    """
    if curve.is_a("IfcPolyline"):
        points = [_point2(p.Coordinates) for p in curve.Points]
    elif curve.is_a("IfcIndexedPolyCurve") and not curve.Segments:
        points = [_point2(c) for c in curve.Points.CoordList]
    else:
        raise NotAnalyticError(curve.is_a())
    if points and points[0] == points[-1]:
        points = points[:-1]
    distinct = [p for i, p in enumerate(points) if p != points[i - 1]]
    if len(distinct) < _FEWEST:
        raise NotAnalyticError("an outline without area")
    return distinct


def _point2(coordinates: Sequence[float]) -> Point2:
    return (float(coordinates[0]), float(coordinates[1]))


def _cut_off(clip: Clip, item_T_box: Pose, size: Vector) -> list[Vector]:
    """Return the corners of what the plane alone would cut off the box."""
    signs = list(product((-0.5, 0.5), repeat=3))
    corner = {s: item_T_box.apply((s[0] * size[0], s[1] * size[1], s[2] * size[2])) for s in signs}
    height = {s: dot(clip.normal, subtract(p, clip.point)) for s, p in corner.items()}
    found = [corner[s] for s in signs if height[s] > 0.0]
    for a, b in product(signs, signs):
        is_edge = sum(u != v for u, v in zip(a, b, strict=True)) == 1
        if is_edge and height[a] > 0.0 > height[b]:
            share = height[a] / (height[a] - height[b])
            found.append(add(corner[a], scale(subtract(corner[b], corner[a]), share)))
    return found


def _is_inside(point: Point2, corners: Sequence[Point2]) -> bool:
    """Tell whether a point lies in a convex polygon; one that is not convex holds nothing."""
    ring = [*corners, corners[0], corners[1]]
    turns = [_side(a, b, c) for (a, b), c in zip(pairwise(ring), ring[2:], strict=False)]
    way = 1.0 if turns[0] > 0.0 else -1.0
    if any(way * t < 0.0 for t in turns):
        return False
    extent = max(abs(v) for corner in corners for v in corner)
    slack = -_TOLERANCE * max(extent, 1.0) ** 2
    return all(way * _side(a, b, point) >= slack for a, b in pairwise(ring[:-1]))


def _side(a: Point2, b: Point2, c: Point2) -> float:
    """Return twice the signed area of a triangle."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
