"""The corners of a convex hull, few enough to work with.

No hull library is asked: the ones at hand end the whole process on hostile points.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from sitewright.foundation.pose import Vector

Array = npt.NDArray[np.float64]

MAX_POINTS = 48
"""More corners than that are thinned out: every check of a shape looks at all of them."""
_DIRECTIONS = 400
_MOST_LOOKS = 1000
_EXACT_M = 1e-6
_GOLDEN_ANGLE = np.pi * (3.0 - np.sqrt(5.0))


def hull_of(points_m: Sequence[Vector]) -> tuple[tuple[Vector, ...], float]:
    """Return points with the same convex hull and how far they fall short of it (0: nowhere).

    Few points are all kept. Of many, those that reach furthest in some hundred directions are,
    and if these are too many, the ones farthest from each other.
    """
    cloud = np.unique(np.array(points_m, dtype=np.float64), axis=0)
    if len(cloud) <= MAX_POINTS:
        return _vectors(cloud), 0.0
    looks = _directions(cloud)
    reach = cloud @ looks.T
    chosen = cloud[np.unique(reach.argmax(axis=0))]
    if len(chosen) > MAX_POINTS:
        chosen = _apart(chosen)
    miss = float((reach.max(axis=0) - (chosen @ looks.T).max(axis=0)).max())
    return _vectors(chosen), miss if miss > _EXACT_M else 0.0


def _apart(corners: Array) -> Array:
    """Take corners far from each other until there are enough; deterministic."""
    chosen = [0]
    far = np.linalg.norm(corners - corners[0], axis=1)
    while len(chosen) < MAX_POINTS:
        chosen.append(int(far.argmax()))
        far = np.minimum(far, np.linalg.norm(corners - corners[chosen[-1]], axis=1))
    return np.asarray(corners[sorted(chosen)])


def _directions(cloud: Array) -> Array:
    """Return directions all around, and those from the middle to the points."""
    index = np.arange(_DIRECTIONS) + 0.5
    z = 1.0 - 2.0 * index / _DIRECTIONS
    flat, turn = np.sqrt(1.0 - z * z), _GOLDEN_ANGLE * index
    around = np.column_stack((flat * np.cos(turn), flat * np.sin(turn), z))
    outwards = cloud[:: max(1, len(cloud) // _MOST_LOOKS)] - cloud.mean(axis=0)
    length = np.linalg.norm(outwards, axis=1)
    real = length > 0.0
    return np.vstack((around, outwards[real] / length[real, None]))


def _vectors(rows: Array) -> tuple[Vector, ...]:
    return tuple((float(x), float(y), float(z)) for x, y, z in rows)
