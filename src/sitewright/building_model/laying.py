"""Lays a wall panel flat that is drawn standing, as it is nailed: its pose, and gravity."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import Extent, UnsupportedGeometryError, shape_of
from sitewright.foundation.pose import Pose, Vector, add, cross, dot, norm, scale, unit

THICKEST_M = 0.6
"""What is thicker is no panel."""
_STRADDLES = 0.5
"""A panel is less than half as thick as it is wide and high."""
_LEVEL = 1e-3
_THIN = 1.0 / 3.0
_ASIDE = 0.25


@dataclass(frozen=True, slots=True, kw_only=True)
class NoPanel:
    """What should be laid flat is none: its width, height and thickness as it stands."""

    size_m: Vector


@dataclass(frozen=True, slots=True)
class _Standing:
    """A panel as drawn: a frame of its own, and where its targets end along each axis.

    Attributes:
        along: Unit vector of its width, level.
        up: Unit vector of its height.
        front: Unit vector out of the face that looks at someone who sees `along` to the right.
    """

    along: Vector
    up: Vector
    bodies: tuple[tuple[Vector, ...], ...]

    @property
    def front(self) -> Vector:
        return cross(self.along, self.up)

    def span_m(self, axis: Vector) -> tuple[float, float]:
        return _span_m((p for body in self.bodies for p in body), axis)

    @property
    def size_m(self) -> Vector:
        width, height, thickness = (self.span_m(a) for a in (self.along, self.up, self.front))
        return (width[1] - width[0], height[1] - height[0], thickness[1] - thickness[0])


def laid_flat(model: BuildingModel, *, is_turned_over: bool = False) -> BuildingModel | NoPanel:
    """Return a model that is built lying: its gravity goes through the panel, from front to back.

    In the site of the cell the panel lies with its lower face at z = 0, its middle above the
    origin, its width along x, its height along y. The front is up; the other face is, if thin
    boards lie on it.

    Args:
        model: As drawn; gravity tells what is up there. Only its targets are looked at.
        is_turned_over: Lay it on its other face.
    """
    standing = _standing(model)
    if standing is None:
        return NoPanel(size_m=(0.0, 0.0, 0.0))
    width_m, height_m, thickness_m = standing.size_m
    if thickness_m > min(THICKEST_M, _STRADDLES * width_m, _STRADDLES * height_m):
        return NoPanel(size_m=standing.size_m)
    if is_turned_over != _has_boards_behind(standing):
        standing = replace(standing, along=scale(standing.along, -1.0))
    low_m = standing.span_m(standing.front)[0]
    middle = add(
        scale(standing.along, sum(standing.span_m(standing.along)) / 2.0),
        scale(standing.up, sum(standing.span_m(standing.up)) / 2.0),
    )
    origin = add(middle, scale(standing.front, low_m))
    return replace(
        model,
        gravity=scale(standing.front, -norm(model.gravity)),
        ground_z_m=round(low_m, 7) + 0.0,
        site_T_model=Pose.from_axes(origin, standing.along, standing.up).inverse(),
    )


def lying_as(model: BuildingModel, other: BuildingModel) -> BuildingModel:
    """Return a model that lies where another one does: what is built of it is not laid anew."""
    return replace(
        model,
        gravity=other.gravity,
        ground_z_m=other.ground_z_m,
        site_T_model=other.site_T_model,
    )


def extents_as_laid(model: BuildingModel) -> list[Extent]:
    """Return how far each target reaches along x, y and z of the cell's site."""
    found = []
    for body in _bodies(model):
        xs, ys, zs = zip(*(model.site_T_model.apply(p) for p in body), strict=True)
        found.append(Extent(low_m=(min(xs), min(ys), min(zs)), high_m=(max(xs), max(ys), max(zs))))
    return found


def size_as_laid_m(model: BuildingModel) -> Vector:
    """Return how far all targets reach together along x, y and z of the cell's site."""
    extents = extents_as_laid(model)
    x, y, z = (
        max(e.high_m[k] for e in extents) - min(e.low_m[k] for e in extents) for k in range(3)
    )
    return (x, y, z)


def _standing(model: BuildingModel) -> _Standing | None:
    """Return the panel, its thickness along the level direction in which it reaches least far."""
    bodies = tuple(_bodies(model))
    if not bodies or not any(model.gravity):
        return None
    up = unit(scale(model.gravity, -1.0))
    found = [
        _Standing(along=_towards_positive(unit(cross(up, axis))), up=up, bodies=bodies)
        for axis in _level_axes(model, up)
    ]
    return min(found, key=lambda panel: round(panel.size_m[2], 6), default=None)


def _bodies(model: BuildingModel) -> Iterator[tuple[Vector, ...]]:
    """Yield the corners of each target whose shape is known, in the model frame."""
    for component in _targets(model):
        try:
            shape = shape_of(component)
        except UnsupportedGeometryError:
            continue
        pose = component.world_T_component
        yield tuple(pose.apply(v) for part in shape for v in part.vertices_m())


def _targets(model: BuildingModel) -> Iterator[Component]:
    return (c for c in model.component_by_id.values() if c.layer is Layer.TARGET)


def _level_axes(model: BuildingModel, up: Vector) -> Iterator[Vector]:
    """Yield the level axes of the targets' own frames, each direction once."""
    seen: list[Vector] = []
    for component in _targets(model):
        pose = component.world_T_component
        for axis in (pose.x_axis, pose.y_axis, pose.z_axis):
            is_level = abs(dot(axis, up)) < _LEVEL
            if is_level and all(abs(dot(axis, other)) < 1.0 - _LEVEL for other in seen):
                seen.append(axis)
                yield axis


def _has_boards_behind(panel: _Standing) -> bool:
    """Tell whether thin boards lie on the back: sheathing goes on last, and from above."""
    spans = [_span_m(body, panel.front) for body in panel.bodies]
    low_m, high_m = panel.span_m(panel.front)
    thickness_m, middle_m = high_m - low_m, (high_m + low_m) / 2.0
    boards = [(a + b) / 2.0 - middle_m for a, b in spans if b - a < _THIN * thickness_m]
    return bool(boards) and sum(boards) / len(boards) < -_ASIDE * thickness_m


def _towards_positive(axis: Vector) -> Vector:
    largest = max(axis, key=lambda x: round(abs(x), 6))
    return axis if largest > 0.0 else scale(axis, -1.0)


def _span_m(points: Iterator[Vector] | Sequence[Vector], axis: Vector) -> tuple[float, float]:
    heights = [dot(p, axis) for p in points]
    return min(heights), max(heights)
