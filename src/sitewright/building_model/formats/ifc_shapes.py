"""Reads IFC shapes without a kernel: extrusions keep their grain, half-spaces stay saw cuts.

Everything is in the file's own unit. What this reader does not know raises `NotAnalyticError`
and goes to the kernel as a whole; it never guesses.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sitewright.building_model.formats.ifc_clips import (
    Clip,
    Point2,
    clip_of,
    demand_plain,
    polyline_corners,
)
from sitewright.building_model.formats.ifc_placement import (
    NotAnalyticError,
    axis_pose,
    direction,
    is_along_z,
    mapping_pose,
)
from sitewright.foundation.pose import Pose, Vector, dot, norm, scale, subtract

Record = dict[str, Any]
_CORNERS = 4
_SQUARE = 1e-9


def body_items(element: Any) -> list[Any]:  # noqa: ANN401 - untyped entities throughout
    """Return the items of the element's solid representation; none is a template."""
    shape = element.Representation
    shapes = list(shape.Representations) if shape is not None else []
    named = [r for r in shapes if r.RepresentationIdentifier in {"Body", "Facetation"}]
    solid = named or [r for r in shapes if not r.RepresentationIdentifier]
    return list(solid[0].Items) if solid else []


def read_solids(element: Any, world_T_object: Pose, *, is_linear: bool) -> list[Record]:  # noqa: ANN401
    """Return one record per body of an element, with its cuts.

    Args:
        element: An IfcElement.
        world_T_object: Its placement.
        is_linear: Its class runs along a grain (member, beam, column).

    Raises:
        NotAnalyticError: Some item needs the kernel.
    """
    if getattr(element, "HasOpenings", ()):
        raise NotAnalyticError("openings")
    found = []
    for item in body_items(element):
        found += _solids(item, world_T_object, is_linear)
    if len(found) > 1 and any(s["cuts"] for s in found):
        raise NotAnalyticError("cuts of several bodies")
    return found


def _solids(item: Any, frame: Pose, is_linear: bool) -> list[Record]:  # noqa: ANN401, FBT001
    if item.is_a("IfcMappedItem"):
        inner = frame @ mapping_pose(item)
        inside = item.MappingSource.MappedRepresentation.Items
        return [s for i in inside for s in _solids(i, inner, is_linear)]
    clips = []
    while item.is_a("IfcBooleanResult"):
        clips.append(clip_of(item))
        item = item.FirstOperand
    solid = _extrusion(item, is_linear)
    own: Pose = solid.pop("pose")
    _demand_plain(clips, own, solid)
    world_T_solid = frame @ own
    back = own.inverse()
    return [
        {
            **solid,
            "p": world_T_solid.position_m,
            "x": world_T_solid.x_axis,
            "y": world_T_solid.y_axis,
            "cuts": [list(c.seen_from(back)) for c in clips],
        }
    ]


def _demand_plain(clips: Sequence[Clip], own: Pose, solid: Record) -> None:
    for clip in clips:
        if solid["kind"] == "box":
            demand_plain(clip, own, solid["size"])
        elif clip.bound is not None:
            raise NotAnalyticError("a bounded half-space")


def _extrusion(item: Any, is_linear: bool) -> Record:  # noqa: ANN401, FBT001
    if item.is_a() != "IfcExtrudedAreaSolid":
        raise NotAnalyticError(item.is_a())
    along = direction(item.ExtrudedDirection, (0.0, 0.0, 1.0))
    depth = float(item.Depth)
    if not is_along_z(along) or not depth > 0.0:
        raise NotAnalyticError("oblique extrusion")
    frame = axis_pose(item.Position)
    low = 0.0 if along[2] > 0.0 else -depth
    profile = item.SweptArea
    if profile.is_a() == "IfcRectangleProfileDef":
        inner = frame @ axis_pose(profile.Position)
        sides = (float(profile.XDim), float(profile.YDim))
        return _box(inner, (0.0, 0.0), sides, (low, depth), has_grain=is_linear)
    outline = _outline(profile)
    rectangle = _rectangle(outline) if profile.is_a() == "IfcArbitraryClosedProfileDef" else None
    if rectangle is not None:
        centre, x_axis, sides = rectangle
        turned = frame @ Pose.from_axes((0.0, 0.0, 0.0), (*x_axis, 0.0), (-x_axis[1], x_axis[0], 0))
        at = turned.inverse().apply(frame.apply((*centre, 0.0)))
        has_grain = is_linear and depth >= max(sides)
        return _box(turned, (at[0], at[1]), sides, (low, depth), has_grain=has_grain)
    holes = [polyline_corners(c) for c in getattr(profile, "InnerCurves", ())]
    base = frame @ Pose((0.0, 0.0, low))
    return {"kind": "extrusion", "pose": base, "profile": outline, "depth": depth, "holes": holes}


def _box(
    frame: Pose, centre: Point2, sides: Point2, span: tuple[float, float], *, has_grain: bool
) -> Record:
    """Return a box whose x runs along the extrusion."""
    low, depth = span
    middle = frame.apply((centre[0], centre[1], low + depth / 2.0))
    pose = Pose.from_axes(middle, frame.z_axis, frame.x_axis)
    size = (depth, *sides)
    if not min(size) > 0.0:
        raise NotAnalyticError("a box without size")
    return {"kind": "box", "pose": pose, "size": size, "has_grain": has_grain}


def _outline(profile: Any) -> list[Point2]:  # noqa: ANN401
    kinds = ("IfcArbitraryClosedProfileDef", "IfcArbitraryProfileDefWithVoids")
    if profile.is_a() not in kinds:
        raise NotAnalyticError(profile.is_a())
    return polyline_corners(profile.OuterCurve)


def _rectangle(points: list[Point2]) -> tuple[Point2, Point2, Point2] | None:
    """Return centre, x direction and sides if four points form a rectangle."""
    if len(points) != _CORNERS:
        return None
    a, b, c, d = (_flat(p) for p in points)
    u, v, opposite = subtract(b, a), subtract(d, a), subtract(c, d)
    longest = max(norm(u), norm(v))
    is_square = abs(dot(u, v)) <= _SQUARE * longest * longest
    if not is_square or norm(subtract(u, opposite)) > _SQUARE * longest or norm(u) == 0.0:
        return None
    centre = ((a[0] + c[0]) / 2.0, (a[1] + c[1]) / 2.0)
    x = scale(u, 1.0 / math.hypot(u[0], u[1]))
    return centre, (x[0], x[1]), (norm(u), norm(v))


def _flat(point: Point2) -> Vector:
    return (point[0], point[1], 0.0)
