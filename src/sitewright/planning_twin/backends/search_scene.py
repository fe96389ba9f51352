"""The scene that paths are searched in: a quick yes or no, with a margin around everything."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from functools import lru_cache

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.layout import Layout
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.proof_scene import ProofScene, ProofScenes
from sitewright.planning_twin.backends.remembered import Remembered
from sitewright.planning_twin.backends.search_model import SearchModel
from sitewright.planning_twin.backends.team_pairs import tables_of
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.robot_team.description import Joints

_SCENES_REMEMBERED = 24


class SearchScene:
    """One layout's parts for pinocchio, with the pairs that count for the robots that move.

    Bodies and postures are put where a snapshot has them; who carries what stays the same.
    """

    def __init__(self, proof: ProofScene, margin_m: float) -> None:
        self.layout: Layout = proof.layout
        self._margin_m = margin_m
        self._model = SearchModel(proof, margin_m)
        self._columns_of = self._model.columns_of
        self._proof = proof
        self._robots: tuple[RobotId, ...] = ()
        self._kept: Mapping[Pair, float] = {}

    def place(self, proof: ProofScene, scene: SceneSnapshot, robots: tuple[RobotId, ...]) -> None:
        """Put everything where a snapshot has it, and look at all that some robots may hit."""
        if proof is not self._proof:
            self._model.place(proof.world_T_part)
            self._proof = proof
        self._scene = scene
        if robots != self._robots:
            self.keep({})
            self._robots = robots
            self._table = tables_of(self.layout, robots)[0]
            self.leave_out(())

    def leave_out(self, pairs: Iterable[Pair]) -> None:
        """Leave exactly these pairs out of the checks from now on."""
        is_on = ~self._table.is_declared(dict.fromkeys(pairs, 0.0))
        self._model.look_at(self._table.a[is_on], self._table.b[is_on])

    def keep(self, distance_m: Mapping[Pair, float]) -> None:
        """Let these pairs come nearer than the margin from now on, others not.

        Args:
            distance_m: Less than the margin; a pair with minus infinity is left out.
        """
        if distance_m is self._kept or not (distance_m or self._kept):
            return
        table = self._table
        changed = {**dict.fromkeys(self._kept, self._margin_m), **distance_m}
        rows = np.flatnonzero(table.is_declared(changed))
        values = table.thresholds(self._margin_m, changed)[rows]
        seen = np.isfinite(values)
        self._model.set_margins(table.a[rows[seen]], table.b[rows[seen]], values[seen])
        self.leave_out(p for p, least_m in distance_m.items() if least_m == -np.inf)
        self._kept = distance_m

    def posture(self, moved: Mapping[RobotId, Joints]) -> Array:
        """Return the positions of all joints, with some robots in other postures."""
        robots = self._scene.robots
        return np.concatenate(
            [np.array(moved.get(r, robots[r].q_rad), dtype=np.float64) for r in self._columns_of]
        )

    def columns_of(self, robot: RobotId) -> Indices:
        """Return where a robot's joints stand in a posture of all joints."""
        return self._columns_of[robot]

    def is_hit(self, q: Array) -> bool:
        """Tell whether anything that counts is too near in a posture of all joints."""
        return self._model.is_hit(q)

    def is_hit_between(self, a: Array, b: Array, step_rad: float) -> bool:
        """Tell whether a line is blocked behind its start.

        The end comes first, then the middles of ever smaller stretches, so that a blocked line is
        found out soon. A step is the length of the difference of two postures.
        """
        way = b - a
        shares = _shares(math.ceil(math.sqrt(way @ way) / step_rad))
        return any(map(self._model.is_hit, a + shares * way))

    def tip(self, robot: RobotId, q: Array) -> Array:
        """Return a robot's tip frame in the world, 4 x 4."""
        return self._model.tip(robot, q)

    def tip_rates(self, robot: RobotId, q: Array) -> Array:
        """Return how the tip moves and turns in the world per joint of its robot, 6 x joints."""
        return self._model.tip_rates(robot, q)


class SearchScenes:
    """Builds search scenes, and uses one again while shapes and what is carried stay the same."""

    def __init__(self, proofs: ProofScenes) -> None:
        self._proofs = proofs
        self._scenes: Remembered[SearchScene] = Remembered(size=_SCENES_REMEMBERED)

    def of(self, scene: SceneSnapshot, margin_m: float, robots: tuple[RobotId, ...]) -> SearchScene:
        """Return a search scene with everything where the snapshot has it.

        Args:
            scene: The cell.
            margin_m: Pairs that are nearer than this count as hit.
            robots: Who moves; only their pairs are looked at.
        """
        proof = self._proofs.of(scene)
        key = (
            margin_m,
            id(proof.layout),
        )  # the scene keeps its layout, so no other one gets its id
        found = self._scenes.of(key, lambda: SearchScene(proof, margin_m))
        found.place(proof, scene, robots)
        return found


@lru_cache(maxsize=1024)
def _shares(steps: int) -> Array:
    """Return k / steps for k = steps, then halfway, then the quarters, ...: a column."""
    order, stretches = [max(1, steps)], [(0, max(1, steps))]
    for low, high in stretches:
        middle = (low + high) // 2
        if low < middle:
            order.append(middle)
            stretches += [(low, middle), (middle, high)]
    return np.array(order, dtype=np.float64)[:, None] / order[0]
