"""Shape, size and mass of a component, from its geometry and its saw cuts."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sitewright.building_model.component import (
    BoxGeometry,
    Component,
    CompoundGeometry,
    ConvexGeometry,
    ExtrusionGeometry,
    Geometry,
    MeshGeometry,
)
from sitewright.building_model.convex import Plane, clipped, volume_m3
from sitewright.building_model.triangles import convex_pieces
from sitewright.errors import BuildingModelError
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector, dot, unit
from sitewright.foundation.shapes import Box, ConvexPart, Hull, Shape, moved

TIMBER_KG_M3 = 450.0
"""Density when neither the component nor its material states one: softwood."""
_CORNERS = 4
"""No solid has fewer corners."""
DENSITY_KG_M3: Mapping[str, float] = {
    "aluminium": 2700.0,
    "brick": 1900.0,
    "concrete": 2400.0,
    "glulam": 460.0,
    "hardwood": 700.0,
    "osb": 620.0,
    "plywood": 550.0,
    "softwood": 450.0,
    "steel": 7850.0,
    "timber": 450.0,
}
"""Usual densities of materials that the model names but does not describe."""


class UnsupportedGeometryError(BuildingModelError):
    """No convex pieces can be made of a component's geometry."""

    def __init__(self, component: str, reason: str) -> None:
        self.component, self.reason = component, reason
        super().__init__(f"Component {component!r} has no usable shape: {reason}.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Extent:
    """An axis-aligned box in some frame."""

    low_m: Vector
    high_m: Vector

    @property
    def size_m(self) -> Vector:
        """Edge lengths."""
        low, high = self.low_m, self.high_m
        return (high[0] - low[0], high[1] - low[1], high[2] - low[2])


def shape_of(component: Component) -> Shape:
    """Return the component's convex pieces in its own frame, saw cuts taken off."""
    shape = _uncut(component.geometry, component.id)
    if not component.cuts:
        return shape
    planes = [Plane(n := unit(c.normal), dot(n, c.point_m)) for c in component.cuts]
    rest = [part for p in shape if (part := _cut(p, planes)) is not None]
    if not rest:
        raise UnsupportedGeometryError(component.id, "its cuts leave nothing of it")
    return tuple(rest)


def size_of(component: Component) -> Vector:
    """Return the box of the component in its own frame before it is cut (the blank)."""
    if isinstance(component.geometry, BoxGeometry):
        return component.geometry.size_m
    return extent_of(_uncut(component.geometry, component.id)).size_m


def extent_of(shape: Shape, frame_T_shape: Pose | None = None) -> Extent:
    """Return the axis-aligned box of a shape in a frame (its own by default)."""
    placed = shape if frame_T_shape is None else moved(shape, frame_T_shape)
    points = [v for part in placed for v in part.vertices_m()]
    xs, ys, zs = zip(*points, strict=True)
    return Extent(low_m=(min(xs), min(ys), min(zs)), high_m=(max(xs), max(ys), max(zs)))


def volume_of(component: Component) -> float:
    """Return the volume in m3, saw cuts taken off."""
    return sum(
        math.prod(part.size_m) if isinstance(part, Box) else volume_m3(part.vertices_m())
        for part in shape_of(component)
    )


def mass_of(component: Component, materials: Mapping[str, Json] | None = None) -> float:
    """Return the mass in kg: as stated, else density times volume.

    Args:
        component: The component.
        materials: `BuildingModel.materials`; a material's ``density_kg_m3`` counts before the
            usual value of its name, and both after the component's own density.
    """
    if component.mass_kg is not None:
        return component.mass_kg
    return density_of(component, materials or {}) * volume_of(component)


def is_mass_known(component: Component, materials: Mapping[str, Json]) -> bool:
    """Whether a mass is stated, or follows from a density that is; else it is a guess."""
    if component.mass_kg is not None or component.density_kg_m3 is not None:
        return True
    stated = materials.get(component.material)
    has_density = isinstance(stated, Mapping) and "density_kg_m3" in stated
    return has_density or component.material.lower() in DENSITY_KG_M3


def density_of(component: Component, materials: Mapping[str, Json]) -> float:
    """Return the density in kg/m3."""
    if component.density_kg_m3 is not None:
        return component.density_kg_m3
    stated = materials.get(component.material)
    density = stated.get("density_kg_m3") if isinstance(stated, Mapping) else None
    if isinstance(density, int | float):
        return float(density)
    return DENSITY_KG_M3.get(component.material.lower(), TIMBER_KG_M3)


def _uncut(geometry: Geometry, name: str) -> Shape:
    match geometry:
        case BoxGeometry(size_m=size):
            return (Box(size),)
        case ConvexGeometry(points_m=points):
            return (Hull(points),)
        case ExtrusionGeometry():
            return _extruded(geometry, name)
        case CompoundGeometry(parts=parts):
            return tuple(q for pose, g in parts for q in moved(_uncut(g, name), pose))
        case MeshGeometry(uri=uri):
            raise UnsupportedGeometryError(name, f"mesh {uri!r} is not decomposed yet")


def _extruded(geometry: ExtrusionGeometry, name: str) -> Shape:
    if geometry.holes_m:
        raise UnsupportedGeometryError(name, "an extrusion with holes is not supported")
    pieces = convex_pieces(geometry.profile_m)
    if not pieces:
        raise UnsupportedGeometryError(name, "its profile crosses itself")
    return tuple(_prism(polygon, geometry.depth_m) for polygon in pieces)


def _prism(polygon: Sequence[tuple[float, float]], depth_m: float) -> Hull:
    return Hull(tuple((x, y, z) for z in (0.0, depth_m) for x, y in polygon))


def _cut(part: ConvexPart, planes: Sequence[Plane]) -> ConvexPart | None:
    """Return what the cuts leave of a convex part; untouched parts stay what they are."""
    before = points = part.vertices_m()
    for plane in planes:
        points = clipped(points, plane)
    if points == before:
        return part
    return Hull(points) if len(points) >= _CORNERS and volume_m3(points) > 0.0 else None
