"""Placements of an IFC file as poses, in the file's own length unit.

Written here because the library's own functions leave an oblique reference direction oblique.
"""

from __future__ import annotations

from typing import Any

from sitewright.foundation.pose import Pose, Vector, cross, dot, norm

_ONE = 1e-9


class NotAnalyticError(Exception):
    """This shape or placement is left to the geometry kernel."""


def world_pose(placement: Any) -> Pose:  # noqa: ANN401 - untyped entity
    """Return ``world_T_object`` of an IfcObjectPlacement that has no circle.

    Raises:
        NotAnalyticError: A grid or linear placement is among them.
    """
    chain = []
    while placement is not None:
        if not placement.is_a("IfcLocalPlacement"):
            raise NotAnalyticError(placement.is_a())
        chain.append(placement.RelativePlacement)
        placement = placement.PlacementRelTo
    pose = Pose()
    for relative in reversed(chain):
        pose = pose @ axis_pose(relative)
    return pose


def axis_pose(placement: Any) -> Pose:  # noqa: ANN401
    """Return the pose of an IfcAxis2Placement3D or 2D; nothing is the identity."""
    if placement is None:
        return Pose()
    if placement.is_a("IfcAxis2Placement2D"):
        x, y = _ratios(placement.RefDirection, (1.0, 0.0))[:2]
        return Pose.from_axes(_point(placement.Location), (x, y, 0.0), (-y, x, 0.0))
    if not placement.is_a("IfcAxis2Placement3D"):
        raise NotAnalyticError(placement.is_a())
    z = direction(placement.Axis, (0.0, 0.0, 1.0))
    x_hint = direction(placement.RefDirection, (1.0, 0.0, 0.0))
    if norm(z) < _ONE:
        raise NotAnalyticError(placement.is_a())
    return Pose.from_z_axis(_point(placement.Location), z, x_hint)


def mapping_pose(item: Any) -> Pose:  # noqa: ANN401
    """Return where an IfcMappedItem puts its source.

    Raises:
        NotAnalyticError: The mapping scales or mirrors.
    """
    target = item.MappingTarget
    if not target.is_a("IfcCartesianTransformationOperator3D"):
        raise NotAnalyticError(target.is_a())
    scales = [getattr(target, name, None) for name in ("Scale", "Scale2", "Scale3")]
    if any(s is not None and abs(s - 1.0) > _ONE for s in scales):
        raise NotAnalyticError(target.is_a())
    x = direction(target.Axis1, (1.0, 0.0, 0.0))
    z = direction(target.Axis3, (0.0, 0.0, 1.0))
    pose = Pose.from_z_axis(_point(target.LocalOrigin), z, x)
    if target.Axis2 is not None and dot(direction(target.Axis2, (0.0, 1.0, 0.0)), pose.y_axis) < 0:
        raise NotAnalyticError(target.is_a())
    return pose @ axis_pose(item.MappingSource.MappingOrigin)


def direction(entity: Any, default: Vector) -> Vector:  # noqa: ANN401
    """Return the ratios of an IfcDirection in three dimensions."""
    x, y, z = (*_ratios(entity, default), 0.0)[:3]
    return (x, y, z)


def is_along_z(vector: Vector) -> bool:
    """Tell whether a direction is +z or -z."""
    return norm(cross(vector, (0.0, 0.0, 1.0))) < _ONE * norm(vector)


def _ratios(entity: Any, default: tuple[float, ...]) -> tuple[float, ...]:  # noqa: ANN401
    if entity is None:
        return default
    return tuple(float(v) for v in entity.DirectionRatios)


def _point(location: Any) -> Vector:  # noqa: ANN401
    coordinates = getattr(location, "Coordinates", None)
    if coordinates is None:
        raise NotAnalyticError("a location without coordinates")
    x, y, z = (*(float(v) for v in coordinates), 0.0)[:3]
    return (x, y, z)
