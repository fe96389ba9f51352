"""How far two convex parts are apart at least, seen by planes between them."""

from __future__ import annotations

from typing import Any

import numpy as np

from sitewright.planning_twin.backends.audit.parts import Array, Part

Placed = tuple[Part, Array]
"""A part with world_T_frame."""


class GapFinder:
    """Finds separating planes; remembers the last one of each pair.

    Attributes:
        looked: How many gaps the distance engine was asked for.
    """

    def __init__(self) -> None:
        import coal

        self._coal = coal
        self._request, self._result = coal.DistanceRequest(), coal.DistanceResult()
        self._normals: dict[int, Array] = {}
        self.looked = 0

    def gap_m(self, number: int, a: Placed, b: Placed, enough_m: float) -> float:
        """Return a gap that two parts surely have, negative if they may overlap by so much.

        For any direction n, the least of n.b over the corners of b minus the greatest of n.a
        over those of a is no more than the signed distance of their hulls. The engine only
        proposes directions, so that nothing it gets wrong can make a gap too large.

        Args:
            number: Of the pair, to remember its plane by.
            a: First part with its frame.
            b: Second one.
            enough_m: Where the remembered plane already shows this gap, no other is looked for.
        """
        points_a, points_b = placed_points(*a), placed_points(*b)
        known = self._normals.get(number)
        if known is not None:
            gap = _slab(known, points_a, points_b)
            if gap >= enough_m:
                return gap
        best = -np.inf
        for normal in self._proposed(a, b):
            gap = _slab(normal, points_a, points_b)
            if gap > best:
                best = gap
                self._normals[number] = normal
        return best

    def _proposed(self, a: Placed, b: Placed) -> list[Array]:
        self.looked += 1
        self._result.clear()
        self._coal.distance(
            a[0].solid, self._pose(a[1]), b[0].solid, self._pose(b[1]), self._request, self._result
        )
        found = [
            np.asarray(self._result.normal),
            np.asarray(self._result.getNearestPoint2() - self._result.getNearestPoint1()),
        ]
        lengths = [float(np.linalg.norm(n)) for n in found]
        return [n / k for n, k in zip(found, lengths, strict=True) if np.isfinite(k) and k > 0.0]

    def _pose(self, frame: Array) -> Any:  # noqa: ANN401 - a compiled pose
        return self._coal.Transform3s(frame[:3, :3], frame[:3, 3])


def placed_points(part: Part, frame: Array) -> Array:
    """Return the corners of a part in the world."""
    return np.asarray(part.points_m @ frame[:3, :3].T + frame[:3, 3])


def _slab(normal: Array, points_a: Array, points_b: Array) -> float:
    return float((points_b @ normal).min() - (points_a @ normal).max())
