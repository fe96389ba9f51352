"""Second opinion on a timed trajectory by MuJoCo's own collision detection."""

from __future__ import annotations

import numpy as np
from typing_extensions import override

from sitewright.planning_twin.backends.certifier import STANDING_SHARE
from sitewright.planning_twin.backends.mujoco_cell import MujocoCells
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.trajectory_samples import positions_at, sample_times
from sitewright.planning_twin.motion import Agreement, CrossCheck, TimedPath
from sitewright.planning_twin.refusal import Disagreement
from sitewright.planning_twin.scene import SceneSnapshot

_STEP_S = 0.010
_STEP_RAD = 0.005


class MujocoCrossCheck(CrossCheck):
    """Samples the trajectory and compares every pair within the clearance with its threshold.

    It shares with the proof what a scene is and which pairs count; kinematics and distances are
    MuJoCo's own. Its closest distance is at most the clearance: it does not see further.
    """

    def __init__(self, proofs: ProofScenes) -> None:
        self._proofs = proofs
        self._cells = MujocoCells(proofs)

    @override
    def check(self, scene: SceneSnapshot, timed: TimedPath) -> Agreement | Disagreement:
        import mujoco

        cell = self._cells.of(scene)
        robot = timed.path.robot
        standing = frozenset(self._proofs.of(scene).layout.standing_of[robot].names)
        times = sample_times(timed.trajectory, step_s=_STEP_S, step_rad=_STEP_RAD)
        postures = positions_at(timed.trajectory, times)
        segments = np.minimum(
            np.searchsorted(np.array(timed.segment_ends_s), times, side="left"),
            len(timed.path.segments) - 1,
        )
        closest_m = cell.margin_m
        for segment, q in zip(segments.tolist(), postures, strict=True):
            declared_m = timed.path.segments[segment].threshold_m
            for pair, distance_m in cell.contacts(robot, q):
                share = STANDING_SHARE if pair in standing else 1.0
                tau_m = declared_m.get(pair, share * scene.clearance_m)
                if distance_m < tau_m:
                    return Disagreement(
                        pair=pair,
                        q_rad=tuple(q.tolist()),
                        distance_m=distance_m,
                        threshold_m=tau_m,
                    )
                if pair not in declared_m and pair not in standing:
                    closest_m = min(closest_m, distance_m)
        return Agreement(
            samples=len(times), closest_distance_m=closest_m, engine=f"mujoco {mujoco.__version__}"
        )
