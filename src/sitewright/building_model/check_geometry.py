"""Degenerate geometry, lengths in a wrong unit, models far from the origin."""

from __future__ import annotations

from collections.abc import Iterator
from statistics import median

from sitewright.building_model.component import (
    BoxGeometry,
    Component,
    CompoundGeometry,
    ConvexGeometry,
    ExtrusionGeometry,
    Geometry,
    MeshGeometry,
    PlaneCut,
)
from sitewright.building_model.convex import planes_of
from sitewright.building_model.findings import refused
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import UnsupportedGeometryError, shape_of, size_of
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import norm

MIN_SIZE_M = 1e-4
"""Smaller than that is no building component."""
_CORNERS = 4
_NO_LENGTH = 1e-9
_USUAL_M = (0.05, 30.0)
_FAR_M = 1e4
_TOO_FAR_M = 1e5


def geometry_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield components whose geometry is no solid."""
    for component in model.component_by_id.values():
        if reason := _broken(component):
            fix = "Give it a geometry with a volume."
            yield refused("G6", component, reason, fix)


def broken_components(model: BuildingModel) -> frozenset[ComponentId]:
    """Return the components whose shape cannot be used."""
    return frozenset(c.id for c in model.component_by_id.values() if _broken(c))


def scale_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield signs of a wrong unit or of a far origin."""
    sound = [c for c in model.component_by_id.values() if not _broken(c)]
    if not sound:
        return
    length_m = median(max(size_of(c)) for c in sound)
    if not _USUAL_M[0] <= length_m <= _USUAL_M[1]:
        is_large = length_m > _USUAL_M[1]
        size, unit = ("large", "mm") if is_large else ("small", "m")
        yield Problem(
            code="U2",
            severity="W",
            where=model.name or "model",
            message=f"The median length is {length_m:.4g} m (usual 0.05-30).",
            fix=f"If it is not that {size}: import it again with the right --unit ({unit}?).",
        )
    far_m = max(max(abs(x) for x in c.world_T_component.position_m) for c in sound)
    if far_m > _FAR_M:
        yield Problem(
            code="O1",
            severity="E" if far_m > _TOO_FAR_M else "W",
            where=model.name or "model",
            message=f"The model reaches {far_m / 1000:.0f} km off the origin.",
            fix="Shift it to the origin and note the shift in 'origin_shift_m'.",
        )


def _broken(component: Component) -> str:
    """Return why a component's geometry is no solid; empty if it is one."""
    if reason := _degenerate(component.geometry) or _bad_cut(component.cuts):
        return reason
    try:
        shape = shape_of(component)
    except UnsupportedGeometryError as error:
        return f"Its shape is unusable: {error.reason}."
    return "" if all(planes_of(part) for part in shape) else "Its points lie in one plane."


def _degenerate(geometry: Geometry) -> str:
    match geometry:
        case BoxGeometry(size_m=size):
            sizes = " x ".join(f"{s:g}" for s in size)
            return f"Its box is {sizes} m." if min(size) < MIN_SIZE_M else ""
        case ExtrusionGeometry(depth_m=depth):
            return f"Its depth is {depth:g} m." if depth < MIN_SIZE_M else ""
        case ConvexGeometry(points_m=points):
            return "" if len(points) >= _CORNERS else f"It has only {len(points)} points."
        case CompoundGeometry(parts=parts):
            return next((r for _, g in parts if (r := _degenerate(g))), "")
        case MeshGeometry():
            return ""


def _bad_cut(cuts: tuple[PlaneCut, ...]) -> str:
    flat = any(norm(c.normal) < _NO_LENGTH for c in cuts)
    return "The normal of a cut has no length." if flat else ""
