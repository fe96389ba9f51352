"""Convex parts grown by a pad, for the search scene."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from sitewright.foundation.shapes import Box, ConvexPart, Hull
from sitewright.planning_twin.backends.kinematic_chain import Array

Indices = npt.NDArray[np.intp]
_PARTS_REMEMBERED = 2048
_SAME_PLANE = 1e-6
_LONGEST_SHIFT = 3.0
"""A sharp corner moves out by this many pads at most."""


@lru_cache(maxsize=_PARTS_REMEMBERED)
def padded(part: ConvexPart, pad_m: float) -> ConvexPart:
    """Return the part with every face moved out by a pad.

    Corners move further than the pad. That errs on the safe side, and the search scene proves
    nothing anyway.
    """
    match part:
        case Box(size_m=(x, y, z), body_T_box=body_T_box):
            return Box((x + 2.0 * pad_m, y + 2.0 * pad_m, z + 2.0 * pad_m), body_T_box)
        case Hull(points_m=points_m):
            return _padded_hull(np.array(points_m, dtype=np.float64), pad_m)


def _padded_hull(points: Array, pad_m: float) -> Hull:
    corners, triangles = surface(points)
    a, b, c = (corners[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    area = np.linalg.norm(normals, axis=1)
    solid = area > _SAME_PLANE * area.max()
    normals = normals[solid] / area[solid, None]
    moved = [
        corner + _shift(normals[(triangles[solid] == k).any(axis=1)], pad_m)
        for k, corner in enumerate(corners)
    ]
    return Hull(tuple((float(x), float(y), float(z)) for x, y, z in moved))


def _shift(normals: Array, pad_m: float) -> Array:
    """Return a shift of a corner that moves each of its faces out by the pad or more."""
    if not len(normals):
        return np.zeros(3)
    middle = normals.sum(axis=0)
    middle /= np.linalg.norm(middle)
    least = max(float((normals @ middle).min()), 1.0 / _LONGEST_SHIFT)
    return np.asarray(middle * (pad_m / least))


def surface(points: Array) -> tuple[Array, Indices]:
    """Return the corners of the hull of some points, and its triangles, outwards."""
    import coal

    rows = coal.StdVec_Vec3s()
    rows.extend(list(points))
    hull = coal.ConvexBase.convexHull(rows, True, "Qt")  # noqa: FBT003
    polygons = [hull.polygons(k) for k in range(hull.num_polygons)]
    triangles = np.array([[t[0], t[1], t[2]] for t in polygons], dtype=np.intp)
    corners = np.array(hull.points(), dtype=np.float64)
    a, b, c = (corners[triangles[:, k]] for k in range(3))
    is_inwards = np.einsum("ij,ij->i", np.cross(b - a, c - a), a - corners.mean(axis=0)) < 0.0
    triangles[is_inwards] = triangles[is_inwards][:, ::-1]
    return corners, triangles
