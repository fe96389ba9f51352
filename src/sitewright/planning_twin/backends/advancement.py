"""The search behind the certificate: intervals of a path, halved until every pair is proven."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sitewright.planning_twin.backends.distances import EPS_M, DistanceEngine, lower_bounds
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.path_lines import Intervals, PathLines, equal_intervals
from sitewright.planning_twin.backends.placed_parts import PlacedParts
from sitewright.planning_twin.backends.proof_scene import ProofScene
from sitewright.planning_twin.backends.team_pairs import tables_of
from sitewright.planning_twin.motion import JointPath, TeamPath
from sitewright.planning_twin.scene import Pair

_FIRST_TRAVEL_M = 1.0
"""Lines are first cut so that no pair can come nearer than this within an interval's half."""
_SMALLEST_TRAVEL_M = 1e-4
"""A pair that is still open when it can come nearer by less than this is refused."""
_HOPEFUL_M = 0.10
"""An exact distance is asked for where the quick bound misses by less than this."""
_REFINEMENTS = 24
_BATCH = 24
_CLOSE_ENOUGH = 0.03
_CLOSE_ENOUGH_M = 0.001


@dataclass(frozen=True, slots=True, kw_only=True)
class TooNear:
    """A pair that is not proven, with the place where it was seen."""

    pair: Pair
    line: int
    share: float
    distance_m: float
    threshold_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Closest:
    """The smallest proven distance of the path over undeclared pairs."""

    distance_m: float
    pair: Pair | None
    at: tuple[int, float]


@dataclass(slots=True, eq=False)
class Questions:
    """Pairs to prove, each on an interval.

    Attributes:
        interval: Number in `intervals`.
        row: Row in the pair table.
        value_m: Distance in the middle of the interval, or a lower bound of it.
    """

    intervals: Intervals
    interval: Indices
    row: Indices
    value_m: Array

    def take(self, chosen: Indices) -> Questions:
        """Return some of the questions on the same intervals."""
        return Questions(
            self.intervals, self.interval[chosen], self.row[chosen], self.value_m[chosen]
        )


class Advancement:
    """Proves one path in one scene.

    Attributes:
        evaluations: How many exact distances it took so far.
    """

    def __init__(
        self,
        proof: ProofScene,
        path: JointPath | TeamPath,
        lines: PathLines,
        engine: DistanceEngine,
    ) -> None:
        self._proof, self._lines, self._engine = proof, lines, engine
        self._robots = path.robots
        self._table, _ = tables_of(proof.layout, path.robots)
        self._travel_m = np.abs(lines.change) @ self._table.weights.T
        taus = [self._table.thresholds(proof.clearance_m, s.threshold_m) for s in path.segments]
        declared = [self._table.is_declared(s.threshold_m) for s in path.segments]
        self._tau_m = np.array(taus)[lines.segment]
        self._is_declared = np.array(declared)[lines.segment]
        self._proven: list[Questions] = []
        self.evaluations = 0

    def prove(self) -> TooNear | None:
        """Return the first pair found too near, None if all are proven."""
        pieces = np.ceil(self._travel_m.max(axis=1, initial=0.0) / 2.0 / _FIRST_TRAVEL_M)
        intervals = equal_intervals(np.maximum(pieces, 1).astype(np.intp))
        count, rows = len(intervals.line), len(self._table.a)
        open_questions = Questions(
            intervals,
            np.repeat(np.arange(count), rows),
            np.tile(np.arange(rows), count),
            np.full(count * rows, -np.inf),
        )
        while len(open_questions.row):
            rest = self._settle(open_questions)
            if isinstance(rest, TooNear):
                return rest
            open_questions = _halved(rest)
        return None

    def _settle(self, asked: Questions) -> Questions | TooNear:
        """Return the questions that need smaller intervals; the proven ones are kept."""
        placed = self._placed(asked.intervals)
        tau, travel = self._needs(asked)
        needed = tau + travel + EPS_M
        values = lower_bounds(self._proof.layout, placed, self._table, asked.interval, asked.row)
        worth = (values < needed) & ((values > needed - _HOPEFUL_M) | (travel < _HOPEFUL_M))
        exact = np.flatnonzero(worth)
        distances = self._distances(placed, asked.interval[exact], asked.row[exact])
        values[exact] = np.maximum(values[exact], distances)
        asked.value_m = values
        failed = (distances < tau[exact] + EPS_M) | (
            (travel[exact] < _SMALLEST_TRAVEL_M) & (distances < needed[exact])
        )
        if failed.any():
            return self._too_near(asked, exact[failed], tau)
        is_proven = values >= needed
        self._proven.append(asked.take(np.flatnonzero(is_proven)))
        return asked.take(np.flatnonzero(~is_proven))

    def _needs(self, asked: Questions) -> tuple[Array, Array]:
        """Return threshold and possible approach within the interval's half, per question."""
        line = asked.intervals.line[asked.interval]
        travel = self._travel_m[line, asked.row] * asked.intervals.half[asked.interval]
        return self._tau_m[line, asked.row], travel

    def _placed(self, intervals: Intervals) -> PlacedParts:
        q = self._lines.at(intervals.line, intervals.middle)
        return self._proof.placed_together(self._robots, q)

    def _distances(self, placed: PlacedParts, posture: Indices, row: Indices) -> Array:
        self.evaluations += len(row)
        return self._engine.distances(self._proof.layout, placed, self._table, posture, row)

    def _too_near(self, asked: Questions, failed: Indices, tau: Array) -> TooNear:
        worst = int(failed[np.argmin((asked.value_m - tau)[failed])])
        interval = int(asked.interval[worst])
        return TooNear(
            pair=self._pair(int(asked.row[worst])),
            line=int(asked.intervals.line[interval]),
            share=float(asked.intervals.middle[interval]),
            distance_m=float(asked.value_m[worst]),
            threshold_m=float(tau[worst]),
        )

    def _pair(self, row: int) -> Pair:
        return self._table.names[self._table.name[row]]

    def closest(self) -> Closest:
        """Return a distance that no undeclared pair goes below anywhere on the path.

        Parts of one arm with one joint between them are proven like all others but left out
        here: their distance says more about the arm's design than about the path. The answer
        is a proven lower bound, at most 3 % or 1 mm (and the reserve) under the true smallest
        distance; where that takes too many steps it stays lower.
        """
        leaves = _joined([self._telling(q) for q in self._proven if len(q.row)])
        if leaves is None or not len(leaves.row):
            return Closest(distance_m=float("inf"), pair=None, at=(0, 0.0))
        seen_m = np.inf
        for _ in range(_REFINEMENTS):
            floor_m = leaves.value_m - self._needs(leaves)[1] - EPS_M
            nearest = _smallest(floor_m, _BATCH)
            if floor_m[nearest[0]] >= min(seen_m * (1 - _CLOSE_ENOUGH), seen_m - _CLOSE_ENOUGH_M):
                break
            is_left = np.ones(len(floor_m), dtype=np.bool_)
            is_left[nearest] = False
            finer = self._finer(leaves.take(nearest))
            seen_m = min(seen_m, float(finer.value_m.min()))
            both = _joined([leaves.take(np.flatnonzero(is_left & (floor_m < seen_m))), finer])
            leaves = both if both is not None else finer
        return self._closest_of(leaves)

    def _closest_of(self, leaves: Questions) -> Closest:
        floor_m = leaves.value_m - self._needs(leaves)[1] - EPS_M
        k = int(np.argmin(floor_m))
        interval = int(leaves.interval[k])
        line = int(leaves.intervals.line[interval])
        share = self._lines.share_of_segment(line, float(leaves.intervals.middle[interval]))
        return Closest(
            distance_m=float(floor_m[k]),
            pair=self._pair(int(leaves.row[k])),
            at=(int(self._lines.segment[line]), share),
        )

    def _telling(self, asked: Questions) -> Questions:
        line = asked.intervals.line[asked.interval]
        is_left_out = self._is_declared[line, asked.row] | self._table.is_neighbour[asked.row]
        return asked.take(np.flatnonzero(~is_left_out))

    def _finer(self, leaves: Questions) -> Questions:
        """Return the same questions on half the intervals with exact distances."""
        finer = _halved(leaves)
        placed = self._placed(finer.intervals)
        finer.value_m = self._distances(placed, finer.interval, finer.row)
        return finer


def _halved(asked: Questions) -> Questions:
    used, interval = np.unique(asked.interval, return_inverse=True)
    halves = asked.intervals.take(used).halves()
    return Questions(
        halves,
        np.concatenate((interval, interval + len(used))),
        np.concatenate((asked.row, asked.row)),
        np.concatenate((asked.value_m, asked.value_m)),
    )


def _joined(many: list[Questions]) -> Questions | None:
    if not many:
        return None
    offsets = np.cumsum([0, *(len(q.intervals.line) for q in many)])
    return Questions(
        Intervals(
            line=np.concatenate([q.intervals.line for q in many]),
            middle=np.concatenate([q.intervals.middle for q in many]),
            half=np.concatenate([q.intervals.half for q in many]),
        ),
        np.concatenate([q.interval + n for q, n in zip(many, offsets, strict=False)]),
        np.concatenate([q.row for q in many]),
        np.concatenate([q.value_m for q in many]),
    )


def _smallest(values: Array, count: int) -> npt.NDArray[np.intp]:
    """Return the indices of the smallest values, in order."""
    if len(values) <= count:
        return np.argsort(values, kind="stable")
    chosen = np.sort(np.argpartition(values, count)[:count])
    return np.asarray(chosen[np.argsort(values[chosen], kind="stable")])
