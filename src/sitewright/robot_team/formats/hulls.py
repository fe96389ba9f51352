"""Convex hulls with few vertices: collision checks cost more with each vertex."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sitewright.robot_team.formats.mesh_points import Points

MAX_VERTICES = 100
"""Hulls with more are replaced by a slightly larger one."""
_GROWTH_M = 0.004
_GROWTH_SHARE = 0.01
"""How far the fewer vertices may miss the hull before they are pushed outwards: 4 mm, or this share
of the body's diagonal if that is more."""
_EXACT_M = 1e-9
_FLAT_M = 1e-4
_PUSH_STEP = 1.15


@dataclass(frozen=True, slots=True, eq=False)
class Facets:
    """The planes and triangles of a convex hull.

    Attributes:
        normals: Outward unit normals, one per row.
        offsets_m: ``normal . x <= offset`` inside.
        triangles: Indices into `corners`, outward by the right-hand rule.
        corners: The hull's own vertices.
    """

    normals: Points
    offsets_m: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int64]
    corners: Points

    def excess_m(self, points: Points) -> npt.NDArray[np.float64]:
        """Return, for each point (row) and facet (column), how far it is outside."""
        return np.asarray(points @ self.normals.T - self.offsets_m)

    def volume_m3(self) -> float:
        """Return the enclosed volume."""
        a, b, c = (self.corners[self.triangles[:, k]] for k in range(3))
        return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)


def hull_facets(points: Points) -> Facets:
    """Return the hull of some points; points in (nearly) one plane are a ValueError."""
    import coal

    if len(points) < 4 or _thickness_m(points) < _FLAT_M:  # noqa: PLR2004
        raise ValueError("the points lie in one plane and enclose nothing")
    rows = coal.StdVec_Vec3s()
    rows.extend(list(points))
    hull = coal.ConvexBase.convexHull(rows, True, "Qt")  # noqa: FBT003
    corners = np.array(hull.points(), dtype=np.float64)
    polygons = [hull.polygons(i) for i in range(hull.num_polygons)]
    triangles = np.array([[t[0], t[1], t[2]] for t in polygons], dtype=np.int64)
    return _outwards(corners, triangles)


def few_vertices(points: Points, *, limit: int = MAX_VERTICES) -> Points:
    """Return the vertices of a convex body that holds all points, not many more than `limit`.

    With up to `limit` vertices the hull is exact. Otherwise the vertices that matter most are
    taken until the hull is missed by little (4 mm, or 1 % of a body over 0.4 m), and then pushed
    outwards until all points are inside.
    """
    whole = hull_facets(points)
    if len(whole.corners) <= limit:
        return whole.corners
    growth_m = max(_GROWTH_M, _GROWTH_SHARE * float(np.linalg.norm(np.ptp(points, axis=0))))
    chosen = _extremes(points)
    while True:
        facets = hull_facets(points[chosen])
        excess = facets.excess_m(points)
        worst, facet = np.unravel_index(int(excess.argmax()), excess.shape)
        miss = float(excess[worst, facet])
        if miss <= _EXACT_M or int(worst) in chosen:
            return facets.corners
        if len(chosen) >= limit and miss <= growth_m:
            return _pushed_out(facets, points, miss)
        chosen.append(int(worst))


def _pushed_out(facets: Facets, points: Points, miss_m: float) -> Points:
    """Move every vertex along the mean of its facets' normals until all points are inside."""
    directions = np.zeros_like(facets.corners)
    for k in range(3):
        np.add.at(directions, facets.triangles[:, k], facets.normals)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    push_m = miss_m
    while True:
        grown = hull_facets(facets.corners + push_m * directions)
        if float(grown.excess_m(points).max()) <= 0.0:
            return grown.corners
        push_m *= _PUSH_STEP


def _extremes(points: Points) -> list[int]:
    """Return the points that reach furthest along 26 directions around the clock."""
    grid = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])
    around = grid[np.any(grid != 0, axis=1)].astype(np.float64)
    return sorted({int(i) for i in (points @ around.T).argmax(axis=0)})


def _thickness_m(points: Points) -> float:
    centred = points - points.mean(axis=0)
    axes = np.linalg.svd(centred, full_matrices=False)[2]
    along = centred @ axes.T
    return float(np.ptp(along, axis=0).min())


def _outwards(corners: Points, triangles: npt.NDArray[np.int64]) -> Facets:
    a, b, c = (corners[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    real = lengths > 0.0
    normals = normals[real] / lengths[real, None]
    inwards = np.einsum("ij,ij->i", normals, a[real] - corners.mean(axis=0)) < 0.0
    normals[inwards] *= -1.0
    ordered = triangles[real].copy()
    ordered[inwards] = ordered[inwards][:, ::-1]
    offsets = (normals @ corners.T).max(axis=1)
    return Facets(normals, np.asarray(offsets), ordered, corners)
