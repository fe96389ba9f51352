"""Which pairs are too near in one posture, by exact distances."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from typing_extensions import override

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.distances import EPS_M, DistanceEngine, lower_bounds
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.motion import CollisionCheck
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.robot_team.description import Joints

PAD_RESERVE_M = 0.001
"""The padded search scene keeps this much more than the clearance."""
OFF_M = -np.inf
"""Threshold of a pair that is not looked at."""


class CoalCollisionCheck(CollisionCheck):
    """Looks at all pairs that one robot changes, with whatever it carries."""

    def __init__(self, scenes: ProofScenes) -> None:
        self._scenes = scenes
        self._engine = DistanceEngine()

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
        proof = self._scenes.of(scene)
        table = proof.layout.pairs_of[robot]
        clearance_m = scene.clearance_m + (PAD_RESERVE_M if is_padded else 0.0)
        declared_m = _padded(threshold_m) if is_padded else threshold_m
        needed = table.thresholds(clearance_m, declared_m) + EPS_M
        placed = proof.placed(robot, np.array([q_rad], dtype=np.float64))
        rows = np.arange(len(table.a))
        first = np.zeros(len(rows), dtype=np.intp)
        open_rows = rows[lower_bounds(proof.layout, placed, table, first, rows) < needed]
        distances = self._engine.distances(
            proof.layout, placed, table, first[: len(open_rows)], open_rows
        )
        too_near = open_rows[distances < needed[open_rows]]
        return tuple(sorted({table.names[n] for n in table.name[too_near]}))


def _padded(threshold_m: Mapping[Pair, float]) -> dict[Pair, float]:
    return {p: OFF_M if tau < 0.0 else tau + PAD_RESERVE_M for p, tau in threshold_m.items()}
