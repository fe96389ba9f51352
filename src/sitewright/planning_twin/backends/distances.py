"""Distances between placed parts: quick lower bounds for many, exact ones for the few left."""

from __future__ import annotations

from typing import Any

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.layout import Layout
from sitewright.planning_twin.backends.pair_table import Indices, PairTable
from sitewright.planning_twin.backends.placed_parts import PlacedParts

EPS_M = 1e-5
"""Reserve for the distance engine's own error (2e-6 m measured at its default tolerance)."""
_BALL_SUFFICES_M = 1.0
"""Boxes are not looked at where the balls are further apart than this."""
Pairwise = tuple[Array, Array]
"""Rows for the first and for the second part of each pair."""


def lower_bounds(
    layout: Layout, placed: PlacedParts, table: PairTable, posture: Indices, row: Indices
) -> Array:
    """Return a distance that each pair surely keeps, negative where nothing can be said.

    Balls around the parts first; where they meet, the gap between the enclosing boxes along
    their six face normals and from each box to the other's ball.

    Args:
        layout: Parts.
        placed: The parts in every posture.
        table: Pairs.
        posture: For each question, the number of the posture.
        row: For each question, the row in `table`.
    """
    a, b = table.a[row], table.b[row]
    at_a, at_b = placed.at(posture, a), placed.at(posture, b)
    middles = placed.frames[:, :3, 3]
    between = middles[at_b] - middles[at_a]
    bounds = _lengths(between) - (layout.radius_m[a] + layout.radius_m[b])
    close = np.flatnonzero(bounds < _BALL_SUFFICES_M)
    if len(close):
        a, b = a[close], b[close]
        frames = (placed.frames[at_a[close]], placed.frames[at_b[close]])
        halves = (layout.half_m[a], layout.half_m[b])
        boxes = box_gaps(frames, halves, (layout.radius_m[a], layout.radius_m[b]))
        bounds[close] = np.maximum(bounds[close], boxes)
    return bounds


def ball_gaps(frames: Pairwise, radius_m: Pairwise) -> Array:
    """Return the gaps between balls around the origins of frames, row by row."""
    return _lengths(frames[1][:, :3, 3] - frames[0][:, :3, 3]) - radius_m[0] - radius_m[1]


def _lengths(vectors: Array) -> Array:
    return np.asarray(np.sqrt(np.einsum("ki,ki->k", vectors, vectors)))


def box_gaps(frames: Pairwise, half_m: Pairwise, radius_m: Pairwise) -> Array:
    """Return, row by row, a distance that two boxes surely keep, negative if nothing is sure.

    Args:
        frames: k x 4 x 4 each; the boxes stand in the middle of them.
        half_m: k x 3 each, half edges.
        radius_m: Of the balls around what is in the boxes.
    """
    turn_a, turn_b = frames[0][:, :3, :3], frames[1][:, :3, :3]
    between = frames[1][:, :3, 3] - frames[0][:, :3, 3]
    across = np.abs(turn_a.transpose(0, 2, 1) @ turn_b)
    half_a, half_b = half_m
    beyond_a = np.abs(np.einsum("kij,ki->kj", turn_a, between)) - half_a
    beyond_b = np.abs(np.einsum("kij,ki->kj", turn_b, between)) - half_b
    faces_a = beyond_a - np.einsum("kij,kj->ki", across, half_b)
    faces_b = beyond_b - np.einsum("kij,ki->kj", across, half_a)
    faces = np.maximum(faces_a.max(axis=1), faces_b.max(axis=1))
    ball_b = _beyond_box(beyond_a) - radius_m[1]
    ball_a = _beyond_box(beyond_b) - radius_m[0]
    return np.asarray(np.maximum(faces, np.maximum(ball_a, ball_b)))


def _beyond_box(beyond: Array) -> Array:
    """Return the signed distance of points from boxes, given how far they are past the faces."""
    outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
    return np.asarray(outside + np.minimum(beyond.max(axis=1), 0.0))


class DistanceEngine:
    """Signed distances of convex parts.

    Attributes:
        is_strict: Answer with the width of the slab between the parts along the normal that the
            engine found, computed from the vertices. That is a true lower bound whatever the
            engine did, at some cost.
    """

    def __init__(self, *, is_strict: bool = False) -> None:
        import coal

        self.is_strict = is_strict
        self._coal = coal
        self._request = coal.DistanceRequest()
        self._result = coal.DistanceResult()
        self._pose_a, self._pose_b = coal.Transform3s(), coal.Transform3s()

    @property
    def name(self) -> str:
        """Name and version of the library."""
        return f"coal {self._coal.__version__}"

    def distances(
        self,
        layout: Layout,
        placed: PlacedParts,
        table: PairTable,
        posture: Indices,
        row: Indices,
    ) -> Array:
        """Return the signed distance of each pair, minus the penetration depth if they overlap."""
        out = np.empty(len(row))
        parts = (table.a[row], table.b[row])
        places = (placed.at(posture, part) for part in parts)
        numbers = (n.tolist() for n in (row, *parts, *places))
        for k, (p, a, b, at_a, at_b) in enumerate(zip(*numbers, strict=True)):
            frame_a, frame_b = placed.frames[at_a], placed.frames[at_b]
            self._pose_a.setTransform(frame_a[:3, :3], frame_a[:3, 3])
            self._pose_b.setTransform(frame_b[:3, :3], frame_b[:3, 3])
            # a result keeps the smallest distance that it ever saw until it is cleared
            self._result.clear()
            query = table.queries.get(p)
            if query is None:
                query = self._query(layout, a, b)
                table.queries[p] = query
            out[k] = query(self._pose_a, self._pose_b, self._request, self._result)
            if self.is_strict:
                out[k] = self._slab(layout, (frame_a, frame_b), (a, b))
        return out

    def _query(self, layout: Layout, a: int, b: int) -> Any:  # noqa: ANN401 - a compiled functor
        return self._coal.ComputeDistance(layout.parts[a].geometry, layout.parts[b].geometry)

    def _slab(self, layout: Layout, frames: tuple[Array, Array], parts: tuple[int, int]) -> float:
        normal = np.asarray(self._result.normal)
        length = np.linalg.norm(normal)
        if not np.isfinite(length) or length == 0.0:
            return -np.inf
        normal = normal / length
        points_a, points_b = (
            layout.parts[p].vertices_m @ frame[:3, :3].T + frame[:3, 3]
            for p, frame in zip(parts, frames, strict=True)
        )
        return float((points_b @ normal).min() - (points_a @ normal).max())
