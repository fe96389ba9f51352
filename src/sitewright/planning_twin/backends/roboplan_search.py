"""Free paths by RRT-Connect and shortcutting in the padded scene."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from typing_extensions import override

from sitewright.errors import BackendError
from sitewright.planning_twin.backends.collision_check import CoalCollisionCheck
from sitewright.planning_twin.backends.extensions import extension
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.search_scene import SearchScene, SearchScenes
from sitewright.planning_twin.motion import MotionPlanner, MotionRequest
from sitewright.planning_twin.refusal import BlockedBy, NoPath
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.robot_team.description import Joints

_PAD_RESERVE_M = 0.0005
_CORNER_PADS = 4.0
"""Corners of padded parts stand out by up to two pads each."""
_MAX_EDGE_RAD = 1.0
WATCHDOG_S = 5.0
"""In a narrow place hardly any node is ever added, so that nodes alone bound nothing."""
_SHORTCUTS = 200
_OUT_OF_NODES = "maximum number of nodes"
_OUT_OF_TIME = "timed out"


class RoboplanSearch(MotionPlanner):
    """Searches paths; the certificate judges them.

    The ends are checked first, by exact distances against the clearance. Pairs that stand
    between clearance and pad at an end are left out of the search, as are declared pairs and
    pairs that the robot does not move: they are the certificate's business alone.
    """

    def __init__(self, proofs: ProofScenes, *, watchdog_s: float = WATCHDOG_S) -> None:
        self._watchdog_s = watchdog_s
        self._proofs = proofs
        self._scenes = SearchScenes(proofs)
        self._check = CoalCollisionCheck(proofs)

    @override
    def plan(
        self, scene: SceneSnapshot, request: MotionRequest, *, seed: int
    ) -> tuple[Joints, ...] | BlockedBy | NoPath:
        pad_m = request.pad_m
        if pad_m is None:
            pad_m = scene.clearance_m / 2.0 + _PAD_RESERVE_M
        ends = (scene.robots[request.robot].q_rad, request.goal_rad)
        for q_rad, where in zip(ends, ("start", "goal"), strict=True):
            if pairs := self._check.violations(scene, request.robot, q_rad, request.threshold_m):
                return BlockedBy(pairs=pairs, reason=f"the {where} is blocked")
        search = self._scenes.of(scene, pad_m)
        standing = self._proofs.of(scene).layout.standing_of[request.robot].names
        declared = [p for p, tau in request.threshold_m.items() if tau < scene.clearance_m]
        search.leave_out({*standing, *declared})
        near = self._near_an_end(scene, search, request, pad_m)
        search.leave_out({*standing, *declared, *near})
        return self._path(search, request, ends, seed)

    def _near_an_end(
        self, scene: SceneSnapshot, search: SearchScene, request: MotionRequest, pad_m: float
    ) -> set[Pair]:
        """Return the undeclared pairs that only the pads let collide at an end."""
        found: set[Pair] = set()
        wide = replace(scene, clearance_m=_CORNER_PADS * pad_m)
        off = dict.fromkeys(request.threshold_m, -np.inf)
        for q_rad in (scene.robots[request.robot].q_rad, request.goal_rad):
            if search.roboplan.hasCollisions(search.posture(scene, {request.robot: q_rad})):
                found.update(self._check.violations(wide, request.robot, q_rad, off))
        return found

    def _path(
        self, search: SearchScene, request: MotionRequest, ends: tuple[Joints, Joints], seed: int
    ) -> tuple[Joints, ...] | NoPath:
        from roboplan.core import JointConfiguration

        # roboplan.core registers the types that this module speaks of
        roboplan_rrt = extension("roboplan.rrt", "_rrt_ext", role="path search")

        joints = search.joints_of(request.robot)
        options = roboplan_rrt.RRTOptions(
            group_name=request.robot,
            rrt_connect=True,
            max_connection_distance=_MAX_EDGE_RAD,
            collision_check_step_size=request.step_rad,
            max_nodes=request.max_nodes,
            max_planning_time=self._watchdog_s,
        )
        rrt = roboplan_rrt.RRT(search.roboplan, options)
        rrt.setRngSeed(seed)
        start, goal = (JointConfiguration(joints, np.array(q, dtype=np.float64)) for q in ends)
        try:
            path: Any = rrt.plan(start, goal)
            if request.is_shortcut:
                path = _shortened(search, request, path, seed)
        except RuntimeError as error:
            return _no_path(str(error), request, seed)
        inner = [tuple(float(v) for v in q) for q in path.positions][1:-1]
        return (ends[0], *inner, ends[1])


def _shortened(search: SearchScene, request: MotionRequest, path: Any, seed: int) -> Any:  # noqa: ANN401
    from roboplan.core import PathShortcutter, PathShortcuttingOptions

    options = PathShortcuttingOptions(
        group_name=request.robot,
        max_step_size=request.step_rad,
        max_iters=_SHORTCUTS,
        seed=seed,
    )
    return PathShortcutter(search.roboplan, options).shortcut(path)


def _no_path(message: str, request: MotionRequest, seed: int) -> NoPath:
    if _OUT_OF_NODES in message:
        return NoPath(nodes=request.max_nodes, seeds=(seed,), reason="no path within the nodes")
    if _OUT_OF_TIME in message:
        return NoPath(
            nodes=request.max_nodes,
            seeds=(seed,),
            is_reproducible=False,
            reason=f"no path in the time; {message}",
        )
    raise BackendError(f"roboplan could not search for {request.robot}: {message}")
