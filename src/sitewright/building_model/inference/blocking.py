"""What stands in the way along straight lines: samples of them against many solids at once."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from itertools import combinations

import numpy as np
import numpy.typing as npt

from sitewright.building_model.inference.solid import Solid
from sitewright.foundation.pose import Vector

Points = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]

STEP_M = 0.05
"""A line is looked at in steps of this length."""
_SLACK_M = 1e-6
_SINGULAR = 1e-9


class Obstacles:
    """Solids in the order in which they come, each thicker by a distance on all its faces."""

    def __init__(self, solids: Sequence[Solid], within_m: float) -> None:
        self._normals = [np.array([f.plane.normal for f in s.faces]) for s in solids]
        self._offsets = [np.array([f.plane.offset_m for f in s.faces]) + within_m for s in solids]
        reaches = [_reach(n, o) for n, o in zip(self._normals, self._offsets, strict=True)]
        self._low = np.array([low for low, _ in reaches]).reshape(-1, 3) - _SLACK_M
        self._high = np.array([high for _, high in reaches]).reshape(-1, 3) + _SLACK_M

    def near(self, points_m: Points, first: int) -> Indices:
        """Return which of the first so many solids reach into the box around some points."""
        low, high = points_m.min(axis=0), points_m.max(axis=0)
        meets = (self._low[:first] <= high) & (self._high[:first] >= low)
        return np.flatnonzero(meets.all(axis=1))

    def held(self, points_m: Points, among: Iterable[int]) -> npt.NDArray[np.bool_]:
        """Return for each point whether it lies in one of some solids."""
        found = np.zeros(len(points_m), dtype=np.bool_)
        for index in among:
            found |= self._holds(index, points_m)
        return found

    def hide(
        self, start: Vector, direction: Vector, length_m: float, first: int, but: Collection[int]
    ) -> bool:
        """Whether one of the first so many solids, `but` some, holds a sample of a line."""
        points = samples(np.array([start]), np.array([direction]), length_m)
        if not len(points) or not first:
            return False
        enters, leaves = self._passes(start, direction, first)
        is_hit = (enters <= leaves) & (enters <= length_m) & (leaves >= 0.0)
        hit: list[int] = np.flatnonzero(is_hit).tolist()
        return any(
            self._holds(index, points[_span(enters[index], leaves[index])]).any()
            for index in hit
            if index not in but
        )

    def _passes(self, start: Vector, direction: Vector, first: int) -> tuple[Points, Points]:
        """Return how far along a line each of the first boxes begins and ends."""
        low, high = self._low[:first] - start, self._high[:first] - start
        along = np.array(direction)
        moves = along != 0.0
        a, b = low[:, moves] / along[moves], high[:, moves] / along[moves]
        enters, leaves = np.minimum(a, b).max(axis=1), np.maximum(a, b).min(axis=1)
        aside = ((low > 0.0) | (high < 0.0))[:, ~moves].any(axis=1)
        return np.where(aside, np.inf, enters), leaves

    def _holds(self, index: int, points_m: Points) -> npt.NDArray[np.bool_]:
        normals = self._normals[index]
        heights = (
            normals[:, 0] * points_m[:, None, 0]
            + normals[:, 1] * points_m[:, None, 1]
            + normals[:, 2] * points_m[:, None, 2]
        )
        return np.asarray((heights <= self._offsets[index]).all(axis=1))


def _reach(normals: Points, offsets_m: Points) -> tuple[Points, Points]:
    """Return the box along the model's axes around all that lies behind some planes."""
    three = np.array(list(combinations(range(len(normals)), 3)))
    three = three[np.abs(np.linalg.det(normals[three])) > _SINGULAR]
    corners = np.linalg.solve(normals[three], offsets_m[three][..., None])[..., 0]
    within = (corners @ normals.T <= offsets_m + _SLACK_M).all(axis=1)
    return corners[within].min(axis=0), corners[within].max(axis=0)


def samples(starts: Points, directions: Points, length_m: float) -> Points:
    """Return points along lines (rows), every 5 cm, without their starts, line after line."""
    along = np.arange(1, int(length_m / STEP_M) + 1) * STEP_M
    points = starts[:, None, :] + along[:, None] * directions[:, None, :]
    return np.asarray(points.reshape(-1, 3))


def _span(enters_m: float, leaves_m: float) -> slice:
    """Return which samples lie between two places on a line, one more at each end."""
    return slice(max(0, int(enters_m / STEP_M) - 2), max(0, int(leaves_m / STEP_M) + 2))
