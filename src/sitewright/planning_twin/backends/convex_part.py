"""A convex piece, compiled for distance queries."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from sitewright.foundation.shapes import Box, ConvexPart, Hull
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of

_PARTS_REMEMBERED = 4096


@dataclass(frozen=True, slots=True, eq=False)
class CompiledPart:
    """A convex piece in a frame of its own, with the box and the ball that enclose it.

    Attributes:
        geometry: The piece for the distance engine, in the part frame.
        body_T_part: The part frame stands in the middle of the enclosing box, along its edges.
        vertices_m: k x 3, in the part frame.
        half_m: Half edges of the enclosing box.
        radius_m: Of the enclosing ball about the part frame's origin.
    """

    geometry: Any
    body_T_part: Array
    vertices_m: Array
    half_m: Array
    radius_m: float


@lru_cache(maxsize=_PARTS_REMEMBERED)
def compiled(part: ConvexPart) -> CompiledPart:
    """Compile a convex piece; equal pieces share one result."""
    import coal

    match part:
        case Box(size_m=size_m, body_T_box=body_T_box):
            half = np.array(size_m) / 2.0
            signs = np.array(np.meshgrid((-1, 1), (-1, 1), (-1, 1))).reshape(3, -1).T
            return _part(coal.Box(*size_m), matrix_of(body_T_box), signs * half)
        case Hull(points_m=points_m):
            points = np.array(points_m, dtype=np.float64)
            body_T_part = _snug_frame(points)
            local = (points - body_T_part[:3, 3]) @ body_T_part[:3, :3]
            rows = coal.StdVec_Vec3s()
            rows.extend(list(local))
            hull = coal.ConvexBase.convexHull(rows, False, "Qt")  # noqa: FBT003
            return _part(hull, body_T_part, np.array(hull.points(), dtype=np.float64))


def _part(geometry: object, body_T_part: Array, vertices_m: Array) -> CompiledPart:
    return CompiledPart(
        geometry=geometry,
        body_T_part=body_T_part,
        vertices_m=vertices_m,
        half_m=np.abs(vertices_m).max(axis=0),
        radius_m=float(np.linalg.norm(vertices_m, axis=1).max()),
    )


def _snug_frame(points: Array) -> Array:
    """Return the frame of the smaller of two boxes: along the axes, or along the main spread."""
    _, spread = np.linalg.eigh(np.cov(points.T))
    spread = spread * np.sign(np.linalg.det(spread))
    frames = [_boxed(points, axes) for axes in (np.eye(3), spread)]
    return min(frames, key=lambda frame: frame[1])[0]


def _boxed(points: Array, axes: Array) -> tuple[Array, float]:
    along = points @ axes
    low, high = along.min(axis=0), along.max(axis=0)
    frame = np.eye(4)
    frame[:3, :3] = axes
    frame[:3, 3] = axes @ ((low + high) / 2.0)
    return frame, float(np.prod(high - low))
