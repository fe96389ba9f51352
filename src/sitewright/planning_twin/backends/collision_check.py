"""Which pairs are too near in one posture, by exact distances."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from typing_extensions import override

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.distances import EPS_M, DistanceEngine, lower_bounds
from sitewright.planning_twin.backends.identity_cache import IdentityCache
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.search_scene import SearchScenes
from sitewright.planning_twin.motion import CollisionCheck
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.robot_team.description import Joints

PAD_RESERVE_M = 0.001
"""The padded search scene keeps this much more than the clearance."""
_NEEDS_REMEMBERED = 64
OFF_M = -np.inf
"""Threshold of a pair that is not looked at."""


class CoalCollisionCheck(CollisionCheck):
    """Looks at all pairs that one robot changes, with whatever it carries.

    A quick check with margins tells whether there is anything to measure at all.
    """

    def __init__(self, scenes: ProofScenes) -> None:
        self._scenes = scenes
        self._engine = DistanceEngine()
        self._quick = SearchScenes(scenes)
        self._needs = IdentityCache(_with_reserve, size=_NEEDS_REMEMBERED)
        self._padded_needs = IdentityCache(_padded, size=_NEEDS_REMEMBERED)

    @override
    def is_clear(
        self,
        scene: SceneSnapshot,
        robot: RobotId,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
        *,
        is_padded: bool = False,
    ) -> bool:
        scene = self._scenes.around(scene, {robot: (q_rad,)}).scene
        return self._is_clear(scene, robot, q_rad, threshold_m, is_padded=is_padded)

    def _is_clear(
        self,
        scene: SceneSnapshot,
        robot: RobotId,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
        *,
        is_padded: bool,
    ) -> bool:
        clearance_m, needs_m = self._needed(scene, threshold_m, is_padded=is_padded)
        if any(least_m > clearance_m for least_m in needs_m.values()):
            return not self._measured(scene, robot, q_rad, clearance_m, needs_m)
        search = self._quick.of(scene, clearance_m, (robot,))
        search.keep(needs_m)
        return not search.is_hit(search.posture({robot: q_rad}))

    @override
    def violations(
        self,
        scene: SceneSnapshot,
        robot: RobotId,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
        *,
        is_padded: bool = False,
    ) -> tuple[Pair, ...]:
        scene = self._scenes.around(scene, {robot: (q_rad,)}).scene
        if self._is_clear(scene, robot, q_rad, threshold_m, is_padded=is_padded):
            return ()
        needed = self._needed(scene, threshold_m, is_padded=is_padded)
        return self._measured(scene, robot, q_rad, *needed)

    def _needed(
        self, scene: SceneSnapshot, threshold_m: Mapping[Pair, float], *, is_padded: bool
    ) -> tuple[float, Mapping[Pair, float]]:
        """Return what pairs must keep, the engine's reserve included: all, and declared ones."""
        if is_padded:
            return scene.clearance_m + PAD_RESERVE_M + EPS_M, self._padded_needs(threshold_m)
        return scene.clearance_m + EPS_M, self._needs(threshold_m)

    def _measured(
        self,
        scene: SceneSnapshot,
        robot: RobotId,
        q_rad: Joints,
        clearance_m: float,
        needs_m: Mapping[Pair, float],
    ) -> tuple[Pair, ...]:
        proof = self._scenes.of(scene)
        table = proof.layout.pairs_of[robot]
        needed = table.thresholds(clearance_m, needs_m)
        placed = proof.placed(robot, np.array([q_rad], dtype=np.float64))
        rows = np.arange(len(table.a))
        first = np.zeros(len(rows), dtype=np.intp)
        open_rows = rows[lower_bounds(proof.layout, placed, table, first, rows) < needed]
        distances = self._engine.distances(
            proof.layout, placed, table, first[: len(open_rows)], open_rows
        )
        too_near = open_rows[distances < needed[open_rows]]
        return tuple(sorted({table.names[n] for n in table.name[too_near]}))


def _with_reserve(threshold_m: Mapping[Pair, float]) -> Mapping[Pair, float]:
    return {p: tau + EPS_M for p, tau in threshold_m.items()}


def _padded(threshold_m: Mapping[Pair, float]) -> Mapping[Pair, float]:
    return {
        p: OFF_M if tau < 0.0 else tau + PAD_RESERVE_M + EPS_M for p, tau in threshold_m.items()
    }
