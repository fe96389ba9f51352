"""Second opinion on a timed trajectory by MuJoCo's own collision detection."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from typing_extensions import override

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.certifier import STANDING_SHARE
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.mujoco_cell import MujocoCell, MujocoCells
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.trajectory_samples import positions_at, sample_times
from sitewright.planning_twin.moment import moment_of
from sitewright.planning_twin.motion import Agreement, CrossCheck, TimedPath
from sitewright.planning_twin.refusal import Disagreement
from sitewright.planning_twin.scene import SceneSnapshot

_STEP_S = 0.010
_STEP_RAD = 0.005


class MujocoCrossCheck(CrossCheck):
    """Samples the trajectory and compares every pair within the clearance with its threshold.

    It shares with the proof what a scene is and which pairs count; kinematics and distances are
    MuJoCo's own. Bodies that no arm comes near to are left out as in the proof. Its closest
    distance is at most the clearance: it does not see further.
    """

    def __init__(self, proofs: ProofScenes) -> None:
        self._proofs = proofs
        self._cells = MujocoCells(proofs)

    @override
    def check(self, scene: SceneSnapshot, timed: TimedPath) -> Agreement | Disagreement:
        import mujoco

        robot = timed.path.robot
        times = sample_times(timed.trajectory, step_s=_STEP_S, step_rad=_STEP_RAD)
        postures = positions_at(timed.trajectory, times)
        reach = (postures.min(axis=0).tolist(), postures.max(axis=0).tolist())
        cell = self._cells.of(self._proofs.around(scene, {robot: reach}).scene)
        segments = np.minimum(
            np.searchsorted(np.array(timed.segment_ends_s), times, side="left"),
            len(timed.path.segments) - 1,
        )
        firsts = np.searchsorted(segments, np.unique(segments))
        seen = _seen(cell, robot, postures, set(firsts.tolist()))
        closest_m = cell.margin_m
        if seen is not None:
            limits = _limits(cell, timed, scene.clearance_m)
            a, b = seen.bodies.T
            tau_m = limits.tau_m[segments[seen.sample], a, b]
            too_near = np.flatnonzero(seen.distance_m < tau_m)
            if len(too_near):
                k = int(too_near[0])
                pair = cell.pair(int(a[k]), int(b[k]))
                q_rad = tuple(postures[seen.sample[k]].tolist())
                return Disagreement(
                    pair=pair,
                    q_rad=q_rad,
                    distance_m=float(seen.distance_m[k]),
                    threshold_m=float(tau_m[k]),
                    moment=moment_of(scene, {robot: q_rad}, pair),
                )
            telling = limits.is_telling[segments[seen.sample], a, b] > 0.0
            closest_m = float(seen.distance_m[telling].min(initial=closest_m))
        return Agreement(
            samples=len(times), closest_distance_m=closest_m, engine=f"mujoco {mujoco.__version__}"
        )


@dataclass(frozen=True, slots=True, eq=False)
class _Limits:
    """Per segment and pair of bodies: the threshold, and 1 where the distance is read out."""

    tau_m: Array
    is_telling: Array


def _limits(cell: MujocoCell, timed: TimedPath, clearance_m: float) -> _Limits:
    robot, share_m = timed.path.robot, STANDING_SHARE * clearance_m
    declared = [s.threshold_m for s in timed.path.segments]
    telling = [cell.table(robot, 0.0, 1.0, dict.fromkeys(d, 0.0)) for d in declared]
    tau_m = [cell.table(robot, share_m, clearance_m, d) for d in declared]
    return _Limits(tau_m=np.array(tau_m), is_telling=np.array(telling))


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """Everything that came within the margin: at which sample, who, how near."""

    sample: Array
    bodies: Array
    distance_m: Array


def _seen(cell: MujocoCell, robot: RobotId, postures: Array, whole: set[int]) -> _Seen | None:
    """Return what is within the margin; pairs that stay as they are, only in `whole` samples."""
    found: list[tuple[int, tuple[Array, Array]]] = []
    cell.look_at(robot)
    for number, q in enumerate(postures):
        if number in whole:
            cell.look_at(None)
        near = cell.touching(robot, q)
        if near is not None:
            found.append((number, near))
        if number in whole:
            cell.look_at(robot)
    cell.look_at(None)
    if not found:
        return None
    return _Seen(
        sample=np.repeat([n for n, _ in found], [len(near[1]) for _, near in found]),
        bodies=np.concatenate([near[0] for _, near in found]),
        distance_m=np.concatenate([near[1] for _, near in found]),
    )
