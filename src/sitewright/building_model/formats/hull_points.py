"""The corners of a convex hull, few enough to work with."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from sitewright.foundation.pose import Vector

MAX_POINTS = 48
"""More corners than that are thinned out: every check of a shape looks at all of them."""
_FLAT_M = 1e-6
_CORNERS = 4


def hull_of(points_m: Sequence[Vector]) -> tuple[tuple[Vector, ...], float]:
    """Return the corners of the hull and how far the thinned hull falls short (0: exact).

    Points in one plane are returned as they are; the model check refuses them by name.
    """
    cloud = np.unique(np.array(points_m, dtype=np.float64), axis=0)
    if len(cloud) < _CORNERS or _thickness_m(cloud) < _FLAT_M:
        return _vectors(cloud[:MAX_POINTS]), 0.0
    corners = _corners(cloud)
    if len(corners) <= MAX_POINTS:
        return _vectors(corners), 0.0
    return _thinned(corners)


def _thinned(corners: npt.NDArray[np.float64]) -> tuple[tuple[Vector, ...], float]:
    """Take corners far from each other until there are enough; deterministic."""
    chosen = [int(np.lexsort(corners.T)[0])]
    far = np.linalg.norm(corners - corners[chosen[0]], axis=1)
    while len(chosen) < MAX_POINTS:
        chosen.append(int(far.argmax()))
        far = np.minimum(far, np.linalg.norm(corners - corners[chosen[-1]], axis=1))
    return _vectors(_corners(corners[sorted(chosen)])), float(far.max())


def _corners(cloud: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    import coal

    middle = cloud.mean(axis=0)
    rows = coal.StdVec_Vec3s()
    rows.extend(list(cloud - middle))
    hull = coal.ConvexBase.convexHull(rows, True, "Qt")  # noqa: FBT003
    found = np.array(hull.points(), dtype=np.float64) + middle
    return np.asarray(found[np.lexsort(found.T[::-1])])


def _thickness_m(cloud: npt.NDArray[np.float64]) -> float:
    centred = cloud - cloud.mean(axis=0)
    axes = np.linalg.svd(centred, full_matrices=False)[2]
    return float(np.ptp(centred @ axes.T, axis=0).min())


def _vectors(rows: npt.NDArray[np.float64]) -> tuple[Vector, ...]:
    return tuple((float(x), float(y), float(z)) for x, y, z in rows)
