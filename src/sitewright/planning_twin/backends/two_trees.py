"""Free paths by two trees and shortcuts in the scene with margins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from typing_extensions import override

from sitewright.foundation.ids import RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.pad_exit import way_out_of_pads
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.search_ends import EndsCheck, SearchEnds, SearchQuestion
from sitewright.planning_twin.backends.search_scene import SearchScenes
from sitewright.planning_twin.backends.search_space import Bounds
from sitewright.planning_twin.backends.shortcuts import quicker
from sitewright.planning_twin.backends.tree_search import found_path
from sitewright.planning_twin.moment import by_robot
from sitewright.planning_twin.motion import MotionPlanner, MotionRequest, PathSegment
from sitewright.planning_twin.refusal import BlockedBy, NoPath
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.waiting import rails_of

_PAD_RESERVE_M = 0.0005
_ALONG_M = 4.0
"""Rails may go so far beyond both ends of a motion."""
_LINES_PER_NODE = 4
"""A node of the budget pays for so many lines, whether they are free or not."""


class TwoTrees(MotionPlanner):
    """Searches paths; the certificate judges them.

    The ends are checked first, by exact distances against the clearance. Pairs that are
    declared, that the robots do not move, or that are near by design are the certificate's
    business alone. An end where only pads touch something is left by a straight way that holds
    by exact distances; only if there is none, the search leaves out the pairs that touch.
    """

    def __init__(self, proofs: ProofScenes) -> None:
        self._proofs = proofs
        self._scenes = SearchScenes(proofs)
        self._ends = EndsCheck(proofs)
        self._proof = ConservativeAdvancement(proofs)

    @override
    def plan(
        self, scene: SceneSnapshot, request: MotionRequest, *, seed: int
    ) -> tuple[Joints, ...] | BlockedBy | NoPath:
        question = self.asked(scene, request)
        if isinstance(question, BlockedBy):
            return question
        if question.near:
            return self._path_out_of_pads(scene, question, request, seed)
        return _path(question, request, seed)

    def asked(self, scene: SceneSnapshot, request: MotionRequest) -> SearchQuestion | BlockedBy:
        """Return the padded scene as a request needs it: who moves, what counts, which ends."""
        ends = self._ends.clear_ends(scene, request)
        if isinstance(ends, BlockedBy):
            return ends
        pad_m = request.pad_m
        if pad_m is None:
            pad_m = scene.clearance_m / 2.0 + _PAD_RESERVE_M
        bounds = self._bounds(scene, request, ends)
        scene = self._proofs.around(scene, bounds).scene
        search = self._scenes.of(scene, 2.0 * pad_m, request.robots)
        return self._ends.question(scene, search, request, ends, pad_m, bounds)

    def _bounds(
        self, scene: SceneSnapshot, request: MotionRequest, ends: SearchEnds
    ) -> dict[RobotId, Bounds]:
        """Return the limits of the joints of each robot that moves; rails stay near the ends."""
        found: dict[RobotId, Bounds] = {}
        postures = [by_robot(scene, request.robots, q) for q in (ends.start, *ends.goals)]
        for robot in request.robots:
            description = scene.robots[robot].description
            joints = description.movable_joints
            low, high = ([j.lower_rad for j in joints], [j.upper_rad for j in joints])
            for k in range(rails_of(description)):
                at_m = [q[robot][k] for q in postures]
                low[k] = max(low[k], min(at_m) - _ALONG_M)
                high[k] = min(high[k], max(at_m) + _ALONG_M)
            found[robot] = (tuple(low), tuple(high))
        return found

    def _path_out_of_pads(
        self, scene: SceneSnapshot, question: SearchQuestion, request: MotionRequest, seed: int
    ) -> tuple[Joints, ...] | NoPath:
        """Leave the near pairs by proven straight ways, and search between their ends."""

        def is_proven(way: list[Array]) -> bool:
            waypoints = tuple(_joints(q) for q in way)
            segment = PathSegment(waypoints_rad=waypoints, threshold_m=request.threshold_m)
            return self._proof.objection(scene, request.path(segment)) is None

        ends = (question.ends.start, question.ends.goals[0])
        first, last = (way_out_of_pads(question, np.array(q), is_proven) for q in ends)
        if first is None or last is None:
            return _path(question, request, seed)
        between = SearchEnds(start=_joints(first[-1]), goals=(_joints(last[-1]),))
        question.search.leave_out(question.left_out - question.near)
        middle = _path(replace(question, ends=between), request, seed)
        if isinstance(middle, NoPath):
            return middle
        return (*map(_joints, first[:-1]), *middle, *map(_joints, last[-2::-1]))


def _joints(q: Array) -> Joints:
    return tuple(float(v) for v in q)


def _path(
    question: SearchQuestion, request: MotionRequest, seed: int
) -> tuple[Joints, ...] | NoPath:
    ends = question.ends
    found = found_path(
        question.space,
        np.array(ends.start),
        [np.array(q) for q in ends.goals],
        max_lines=_LINES_PER_NODE * request.max_nodes,
        seed=seed,
    )
    if found is None:
        return NoPath(
            nodes=request.max_nodes, seeds=(seed,), reason=Sentence("no path within the nodes")
        )
    goal = _joints(found[-1])
    if request.is_shortcut:
        found = quicker(question.space, found, seed)
    return (ends.start, *map(_joints, found[1:-1]), goal)
