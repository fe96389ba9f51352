"""The box around points: its axes along the faces of a body, least volume wins."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from sitewright.building_model.formats.body_split import Body
from sitewright.foundation.pose import Pose, Vector, add, cross, dot, norm, scale, subtract

Array = npt.NDArray[np.float64]

_SAME_DIRECTION = 1e-4
_MOST_DIRECTIONS = 12
_STEEP = 0.1
_SAME_SIZE_DECIMALS = 5
_CORNER_M = 2e-4
_CORNER_SHARE = 1e-3


@dataclass(frozen=True, slots=True)
class FittedBox:
    """A box in the model frame, centred on its pose, x along its longest edge."""

    world_T_box: Pose
    size_m: Vector


@dataclass(frozen=True, slots=True)
class Facing:
    """A direction that some surface faces, and how much of it."""

    direction: Vector
    area_m2: float


def facings_of(body: Body) -> list[Facing]:
    """Return the directions of a body's faces, opposite ones as one, largest area first."""
    found: list[tuple[Vector, float]] = []
    for area, direction in sorted(_facing(body.points_m, f) for f in body.faces)[::-1]:
        if area <= 0.0:
            continue
        same = next((i for i, (d, _) in enumerate(found) if _is_same(d, direction)), None)
        if same is None:
            found.append((direction, area))
        else:
            found[same] = (found[same][0], found[same][1] + area)
    ranked = sorted(found, key=lambda item: (-round(item[1], 9), item[0]))
    return [Facing(direction, area) for direction, area in ranked[:_MOST_DIRECTIONS]]


def fit_box(points_m: Sequence[Vector], facings: Iterable[Facing]) -> FittedBox | None:
    """Return the smallest box whose sides lie along two of the facings; None if all is flat."""
    cloud = np.array(points_m, dtype=np.float64)
    directions = [f.direction for f in facings]
    best: tuple[float, tuple[Vector, Vector, Vector], Array, Array] | None = None
    for first in directions:
        for second in directions:
            axes = _axes(first, second)
            if axes is None:
                continue
            along = cloud @ np.array(axes).T
            low, high = along.min(axis=0), along.max(axis=0)
            volume = float(np.prod(high - low))
            if best is None or volume < best[0] * (1.0 - 1e-6):
                best = (volume, axes, low, high)
    if best is None:
        return None
    _, axes, low, high = best
    middle: Vector = (0.0, 0.0, 0.0)
    for axis, value in zip(axes, (low + high) / 2.0, strict=True):
        middle = add(middle, scale(axis, float(value)))
    sizes = high - low
    return oriented(middle, axes, (float(sizes[0]), float(sizes[1]), float(sizes[2])))


def oriented(middle_m: Vector, axes: Sequence[Vector], size_m: Vector) -> FittedBox:
    """Return a box with the longest edge as x and axes that point where the model's do."""
    ranked = sorted(
        zip(size_m, axes, strict=True),
        key=lambda item: (-round(item[0], _SAME_SIZE_DECIMALS), _leading(item[1])),
    )
    x, y = (positive(axis) for _, axis in ranked[:2])
    a, b, c = (size for size, _ in ranked)
    return FittedBox(Pose.from_axes(middle_m, x, y), (a, b, c))


def is_box(body: Body, box: FittedBox) -> bool:
    """Whether a body is exactly its fitted box: all eight corners, nothing inside."""
    tolerance = min(_CORNER_M, _CORNER_SHARE * min(box.size_m))
    half = np.array(box.size_m) / 2.0
    back = box.world_T_box.inverse()
    local = np.array([back.apply(p) for p in body.points_m])
    on_side = np.abs(np.abs(local) - half) <= tolerance
    corners = {tuple(np.sign(p)) for p, on in zip(local, on_side, strict=True) if on.all()}
    if len(corners) != 8:  # noqa: PLR2004 - a box
        return False
    sides = np.where(on_side, np.sign(local), 0.0)
    return all(_is_on_one_side(sides[list(face)]) for face in body.faces)


def is_convex(body: Body, tolerance_m: float = 1e-4) -> bool:
    """Whether no vertex lies beyond both sides of any face's plane."""
    cloud = np.array(body.points_m)
    for face in body.faces:
        area, normal = _facing(body.points_m, face)
        if area <= 0.0:
            continue
        height = (cloud - cloud[list(face)].mean(axis=0)) @ np.array(normal)
        if height.max() > tolerance_m and height.min() < -tolerance_m:
            return False
    return True


def positive(axis: Vector) -> Vector:
    """Return the axis, or its opposite, so that its largest part is positive."""
    return scale(axis, -1.0) if axis[_leading(axis)] < 0.0 else axis


def _is_on_one_side(sides: Array) -> bool:
    return bool((np.abs(sides.sum(axis=0)) == len(sides)).any())


def _leading(axis: Vector) -> int:
    parts = [round(abs(c), 6) for c in axis]
    return parts.index(max(parts))


def _facing(points_m: Sequence[Vector], face: Sequence[int]) -> tuple[float, Vector]:
    origin = points_m[face[0]]
    total: Vector = (0.0, 0.0, 0.0)
    for a, b in pairwise(face[1:]):
        total = add(total, cross(subtract(points_m[a], origin), subtract(points_m[b], origin)))
    length = norm(total)
    if length == 0.0:
        return 0.0, total
    return length / 2.0, positive(scale(total, 1.0 / length))


def _is_same(a: Vector, b: Vector) -> bool:
    return norm(subtract(a, b)) < _SAME_DIRECTION or norm(add(a, b)) < _SAME_DIRECTION


def _axes(first: Vector, second: Vector) -> tuple[Vector, Vector, Vector] | None:
    rest = subtract(second, scale(first, dot(first, second)))
    length = norm(rest)
    if length < _STEEP:
        return None
    y = scale(rest, 1.0 / length)
    return first, y, cross(first, y)
