"""Which of many postures come too near to anything, by exact distances where boxes do not tell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sitewright.planning_twin.backends.collision_check import OFF_M, PAD_RESERVE_M
from sitewright.planning_twin.backends.convex_part import CompiledPart
from sitewright.planning_twin.backends.distances import EPS_M, ball_gaps, box_gaps
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.reach.load import Moving
from sitewright.planning_twin.backends.reach.surroundings import Surroundings, spreads
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.scene import Pair, pair_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Thresholds:
    """Distances that pairs must keep.

    Attributes:
        clearance_m: Of every pair that is not declared.
        declared_m: Of the others; minus infinity is never too near.
    """

    clearance_m: float
    declared_m: Mapping[Pair, float] = field(default_factory=dict)

    def of(self, pair: Pair) -> float:
        """Return the distance that a pair must keep, with the engine's reserve."""
        return self.declared_m.get(pair, self.clearance_m) + EPS_M

    def padded(self) -> Thresholds:
        """Return what the padded search scene asks for."""
        declared_m = {
            p: OFF_M if tau < 0.0 else tau + PAD_RESERVE_M for p, tau in self.declared_m.items()
        }
        return Thresholds(clearance_m=self.clearance_m + PAD_RESERVE_M, declared_m=declared_m)


@dataclass(frozen=True, slots=True, eq=False)
class Around:
    """Parts that stand still, and which of them are there."""

    still: Surroundings
    is_there: Flags


@dataclass(frozen=True, slots=True, eq=False)
class _Rows:
    """Questions: which posture, which moving part, and which part that stands still."""

    posture: Indices
    part: Indices
    other: Indices
    bound_m: Array


class Clearance:
    """Distances between what arms carry and what stands still."""

    def __init__(self) -> None:
        import coal

        self._coal = coal
        self._request, self._result = coal.DistanceRequest(), coal.DistanceResult()
        self._pose_a, self._pose_b = coal.Transform3s(), coal.Transform3s()
        self._queries: dict[tuple[int, int], tuple[Any, CompiledPart, CompiledPart]] = {}

    def too_near(
        self,
        moving: Moving,
        placed: Array,
        around: Sequence[Around],
        thresholds: Thresholds,
        *,
        is_thorough: bool = False,
    ) -> list[tuple[Pair, ...]]:
        """Return, for each posture, the pairs that are too near; the first one suffices.

        Args:
            moving: What moves.
            placed: m x p x 4 x 4, where its parts are.
            around: What stands still.
            thresholds: Distances to keep.
            is_thorough: Return all pairs, not just the first that is found.
        """
        found: list[set[Pair]] = [set() for _ in placed]
        widest_m = thresholds.clearance_m + EPS_M
        self._own(moving, placed, thresholds, widest_m, found, is_thorough=is_thorough)
        for a in around:
            rows = _near_rows(moving, placed, a, widest_m, found, is_thorough=is_thorough)
            for m, p, w in _by_bound(rows):
                if found[m] and not is_thorough:
                    continue
                pair = pair_of(moving.names[p], a.still.names[w])
                needed_m = thresholds.of(pair)
                if pair in found[m] or needed_m == OFF_M:
                    continue
                frames = (placed[m, p], a.still.frames[w])
                if self._distance(moving.parts[p], a.still.parts[w], frames) < needed_m:
                    found[m].add(pair)
        return [tuple(sorted(pairs)) for pairs in found]

    def _own(
        self,
        moving: Moving,
        placed: Array,
        thresholds: Thresholds,
        widest_m: float,
        found: list[set[Pair]],
        *,
        is_thorough: bool,
    ) -> None:
        count = len(moving.own_a)
        if not count:
            return
        posture = np.repeat(np.arange(len(placed)), count)
        a, b = np.tile(moving.own_a, len(placed)), np.tile(moving.own_b, len(placed))
        frames = (placed[posture, a], placed[posture, b])
        bounds = _bounds(
            frames,
            (moving.half_m[a], moving.half_m[b]),
            (moving.radius_m[a], moving.radius_m[b]),
            widest_m,
        )
        for k in np.flatnonzero(bounds < widest_m).tolist():
            m, row = divmod(k, count)
            pair = moving.own_names[row]
            if (found[m] and not is_thorough) or thresholds.of(pair) == OFF_M:
                continue
            parts = moving.parts[a[k]], moving.parts[b[k]]
            if self._distance(*parts, (frames[0][k], frames[1][k])) < thresholds.of(pair):
                found[m].add(pair)

    def _distance(self, a: CompiledPart, b: CompiledPart, frames: tuple[Array, Array]) -> float:
        key = (id(a), id(b))
        known = self._queries.get(key)
        if known is None:
            known = (self._coal.ComputeDistance(a.geometry, b.geometry), a, b)
            self._queries[key] = known
        self._pose_a.setTransform(frames[0][:3, :3], frames[0][:3, 3])
        self._pose_b.setTransform(frames[1][:3, :3], frames[1][:3, 3])
        # a result keeps the smallest distance that it ever saw until it is cleared
        self._result.clear()
        return float(known[0](self._pose_a, self._pose_b, self._request, self._result))


def _near_rows(
    moving: Moving,
    placed: Array,
    around: Around,
    widest_m: float,
    found: Sequence[set[Pair]],
    *,
    is_thorough: bool,
) -> _Rows:
    """Return the questions that enclosing boxes do not settle."""
    still = around.still
    is_open = np.array([is_thorough or not pairs for pairs in found], dtype=np.bool_)
    open_ = np.flatnonzero(is_open)
    there = np.flatnonzero(around.is_there)
    outer = moving.outer
    if not len(open_) or not len(there) or not len(moving.outer):
        none = np.zeros(0, dtype=np.intp)
        return _Rows(none, none, none, np.zeros(0))
    frames = placed[open_][:, outer]
    middles = frames[..., :3, 3]
    spread_m = spreads(frames, moving.half_m[outer]) + widest_m
    low_m, high_m = middles - spread_m, middles + spread_m
    is_near = _overlap(
        (low_m.min(axis=0)[:, None], high_m.max(axis=0)[:, None]),
        (still.low_m[there], still.high_m[there]),
    )
    part, other = np.nonzero(is_near)
    meets = _overlap(
        (low_m[:, part], high_m[:, part]),
        (still.low_m[there[other]], still.high_m[there[other]]),
    )
    row, column = np.nonzero(meets)
    posture, part, other = open_[row], outer[part[column]], there[other[column]]
    bounds = _bounds(
        (placed[posture, part], still.frames[other]),
        (moving.half_m[part], still.half_m[other]),
        (moving.radius_m[part], still.radius_m[other]),
        widest_m,
    )
    close = bounds < widest_m
    return _Rows(posture[close], part[close], other[close], bounds[close])


def _overlap(a: tuple[Array, Array], b: tuple[Array, Array]) -> Flags:
    """Return which boxes, given by their low and high corners, overlap."""
    (low_a, high_a), (low_b, high_b) = a, b
    out = (low_a[..., 0] <= high_b[..., 0]) & (low_b[..., 0] <= high_a[..., 0])
    for k in (1, 2):
        out &= (low_a[..., k] <= high_b[..., k]) & (low_b[..., k] <= high_a[..., k])
    return np.asarray(out)


def _bounds(
    frames: tuple[Array, Array],
    half_m: tuple[Array, Array],
    radius_m: tuple[Array, Array],
    widest_m: float,
) -> Array:
    """Return distances that are surely kept; boxes are looked at where balls come near."""
    bounds = ball_gaps(frames, radius_m)
    close = np.flatnonzero(bounds < widest_m)
    if len(close):
        boxes = box_gaps(
            (frames[0][close], frames[1][close]),
            (half_m[0][close], half_m[1][close]),
            (radius_m[0][close], radius_m[1][close]),
        )
        bounds[close] = np.maximum(bounds[close], boxes)
    return bounds


def _by_bound(rows: _Rows) -> list[tuple[int, int, int]]:
    """Return the questions in order of their bounds: what collides is found early."""
    order = np.argsort(rows.bound_m, kind="stable")
    columns = (rows.posture[order].tolist(), rows.part[order].tolist(), rows.other[order].tolist())
    return list(zip(*columns, strict=True))
