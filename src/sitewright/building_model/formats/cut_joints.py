"""Joints that a machine file does not name: a saw cut that lies in a face of another beam."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

from sitewright.building_model.component import BoxGeometry, Component, Origin, PlaneCut
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.foundation.pose import Pose, Vector, add, distance, dot, norm, scale, subtract

_SAME_PLANE_M = 1e-3
_PARALLEL = 2e-4
"""Machine files round angles to 0.001 degrees and lengths to 0.001 mm."""
_SHORTEST_M = 0.02
"""Corners that only graze each other are no joint."""
_CONFIDENCE = 0.9
_UNITS: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True, slots=True, kw_only=True)
class _Beam:
    component: Component
    axes: tuple[Vector, Vector, Vector]
    middle_m: Vector
    half_m: Vector


def cut_joints(model: BuildingModel) -> tuple[Relation, ...]:
    """Return a relation ``connection`` for every pair of beams of which one is cut to the other.

    A beam's cut and a side of another beam's blank that lie in one plane, facing each other or
    alike (the lap end of a corner), and overlap there, are taken for a joint.
    """
    known = [b for c in model.component_by_id.values() if (b := _beam(c)) is not None]
    joined = {
        (a.component.id, b.component.id)
        for a, b in _near(known)
        for cut in a.component.cuts
        if _lies_in_side(a, cut, b)
    }
    pairs = {(min(p), max(p)): p for p in sorted(joined, reverse=True)}
    return tuple(
        Relation(
            kind=RelationKind.CONNECTION,
            a=a,
            b=b,
            origin=Origin.INFERRED,
            confidence=_CONFIDENCE,
            data={"type": "butt", "evidence": "a saw cut of one lies in a side of the other"},
        )
        for a, b in (pairs[key] for key in sorted(pairs))
    )


def _near(beams: Sequence[_Beam]) -> Iterator[tuple[_Beam, _Beam]]:
    """Yield the pairs, both ways, whose blanks come near each other along the model's axes."""
    extents = {b.component.id: _extent(b) for b in beams}
    ordered = sorted(beams, key=lambda b: (extents[b.component.id][0], b.component.id))
    for i, a in enumerate(ordered):
        low, high = extents[a.component.id]
        for b in ordered[i + 1 :]:
            other_low, other_high = extents[b.component.id]
            if other_low[0] > high[0]:
                break
            if all(other_low[k] <= high[k] and low[k] <= other_high[k] for k in (1, 2)):
                yield a, b
                yield b, a


def _extent(beam: _Beam) -> tuple[Vector, Vector]:
    reach = [
        sum(abs(axis[k]) * half for axis, half in zip(beam.axes, beam.half_m, strict=True))
        + _SAME_PLANE_M
        for k in range(3)
    ]
    x, y, z = beam.middle_m
    return (
        (x - reach[0], y - reach[1], z - reach[2]),
        (x + reach[0], y + reach[1], z + reach[2]),
    )


def _beam(component: Component) -> _Beam | None:
    if not isinstance(component.geometry, BoxGeometry):
        return None
    pose = component.world_T_component
    return _Beam(
        component=component,
        axes=(pose.x_axis, pose.y_axis, pose.z_axis),
        middle_m=pose.position_m,
        half_m=scale(component.geometry.size_m, 0.5),
    )


def _lies_in_side(beam: _Beam, cut: PlaneCut, other: _Beam) -> bool:
    pose = beam.component.world_T_component
    normal, point = pose.turn(cut.normal), pose.apply(cut.point_m)
    offset = subtract(point, other.middle_m)
    for axis, half in zip(other.axes, other.half_m, strict=True):
        is_parallel = abs(abs(dot(axis, normal)) - 1.0) < _PARALLEL
        if is_parallel and abs(abs(dot(normal, offset)) - half) < _SAME_PLANE_M:
            return _meeting_m(beam, cut, other) > _SHORTEST_M
    return False


def _meeting_m(beam: _Beam, cut: PlaneCut, other: _Beam) -> float:
    """Return the greatest length over which a cut face lies on or in the other beam."""
    sides = list(zip(_UNITS, beam.half_m, strict=True))
    polygon = _section(cut, sum(beam.half_m))
    for half_space in (*_box(sides), *((c.normal, c.point_m) for c in beam.component.cuts)):
        polygon = _clipped(polygon, *half_space)
    pose = other.component.world_T_component.inverse() @ beam.component.world_T_component
    polygon = [pose.apply(p) for p in polygon]
    around = list(zip(_UNITS, other.half_m, strict=True))
    for half_space in (*_box(around), *((c.normal, c.point_m) for c in other.component.cuts)):
        polygon = _clipped(polygon, *half_space)
    return max((distance(p, q) for p, q in combinations(polygon, 2)), default=0.0)


def _box(sides: Sequence[tuple[Vector, float]]) -> Iterator[tuple[Vector, Vector]]:
    for axis, half in sides:
        yield axis, scale(axis, half)
        yield scale(axis, -1.0), scale(axis, -half)


def _section(cut: PlaneCut, reach_m: float) -> list[Vector]:
    """Return a square in the plane of a cut, large enough for the whole beam."""
    frame = Pose.from_z_axis(cut.point_m, cut.normal)
    far = 2.0 * (reach_m + norm(cut.point_m))
    return [frame.apply((x * far, y * far, 0.0)) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def _clipped(polygon: list[Vector], normal: Vector, point_m: Vector) -> list[Vector]:
    """Return the part of a polygon behind a plane, what lies just before it included."""
    heights = [dot(normal, subtract(p, point_m)) - _SAME_PLANE_M for p in polygon]
    kept: list[Vector] = []
    for i, (p, h) in enumerate(zip(polygon, heights, strict=True)):
        q, g = polygon[i - 1], heights[i - 1]
        if (h > 0.0) is not (g > 0.0):
            kept.append(add(q, scale(subtract(p, q), g / (g - h))))
        if h <= 0.0:
            kept.append(p)
    return kept
