"""The ends of a search: which are clear, and which pairs only the pads let collide there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.backends.collision_check import CoalCollisionCheck
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.search_scene import SearchScene
from sitewright.planning_twin.backends.search_space import Bounds, SearchSpace
from sitewright.planning_twin.backends.team_pairs import tables_of
from sitewright.planning_twin.moment import by_robot, moment_of
from sitewright.planning_twin.motion import MotionRequest
from sitewright.planning_twin.refusal import BlockedBy
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.robot_team.description import Joints


@dataclass(frozen=True, slots=True, kw_only=True)
class SearchEnds:
    """Postures to search between; the goals that are welcome most come first."""

    start: Joints
    goals: tuple[Joints, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class SearchQuestion:
    """A padded scene that is ready for a search, until the next one is asked of it.

    Attributes:
        left_out: Pairs that the scene does not look at.
        near: Those of them that only the pads let collide at these ends.
    """

    search: SearchScene
    space: SearchSpace
    ends: SearchEnds
    left_out: frozenset[Pair]
    near: frozenset[Pair]


class EndsCheck:
    """Looks at the ends of requests."""

    def __init__(self, proofs: ProofScenes) -> None:
        self._proofs = proofs
        self._check = CoalCollisionCheck(proofs)

    def clear_ends(self, scene: SceneSnapshot, request: MotionRequest) -> SearchEnds | BlockedBy:
        """Return the start and the goals that keep the clearance."""
        start = tuple(q for r in request.robots for q in scene.robots[r].q_rad)
        if pairs := self._violations(scene, request, start, request.threshold_m):
            return _blocked(scene, request, start, pairs, Sentence("the start is blocked"))
        blocked: list[tuple[Joints, tuple[Pair, ...]]] = []
        goals: list[Joints] = []
        for goal in request.goals_rad:
            if pairs := self._violations(scene, request, goal, request.threshold_m):
                blocked.append((goal, pairs))
            else:
                goals.append(goal)
        if not goals:
            goal, pairs = min(blocked, key=lambda b: len(b[1]))
            return _blocked(scene, request, goal, pairs, Sentence("the goal is blocked"))
        return SearchEnds(start=start, goals=tuple(goals))

    def question(
        self,
        scene: SceneSnapshot,
        search: SearchScene,
        request: MotionRequest,
        ends: SearchEnds,
        pad_m: float,
        bounds: Mapping[RobotId, Bounds],
    ) -> SearchQuestion:
        """Return the scene as a search needs it.

        Pairs that the robots do not move and declared pairs are left out. Where an end is hit,
        parts of one arm with a single joint between them are left out too, since they are near by
        design; other near pairs only if they touch at the start, or at every goal.
        """
        moving, _ = tables_of(self._proofs.of(scene).layout, request.robots)
        off = {p for p, tau in request.threshold_m.items() if tau < scene.clearance_m}
        search.leave_out(off)
        close_at = {
            q: self._close(scene, request, q, pad_m)
            for q in (ends.start, *ends.goals)
            if search.is_hit(search.posture(by_robot(scene, request.robots, q)))
        }
        joined = {moving.names[n] for n in moving.name[moving.is_neighbour]}
        off |= joined & _all(close_at.values())
        free = tuple(q for q in ends.goals if not close_at.get(q, set()) - off)
        ends = replace(ends, goals=free or ends.goals[:1])
        still = (ends.start, *(() if free else ends.goals))
        near = _all(close_at.get(q, set()) for q in still) - off
        search.leave_out(off | near)
        return SearchQuestion(
            search=search,
            space=SearchSpace(search, scene, bounds, request.step_rad),
            ends=ends,
            left_out=frozenset(off | near),
            near=frozenset(near),
        )

    def _close(
        self, scene: SceneSnapshot, request: MotionRequest, end: Joints, pad_m: float
    ) -> set[Pair]:
        """Return the pairs whose pads touch at an end."""
        wide = replace(scene, clearance_m=2.0 * pad_m)
        off = dict.fromkeys(request.threshold_m, -np.inf)
        return set(self._violations(wide, request, end, off))

    def _violations(
        self,
        scene: SceneSnapshot,
        request: MotionRequest,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
    ) -> tuple[Pair, ...]:
        """Return the pairs of all robots that move that are too near at a posture."""
        if len(request.robots) == 1:
            return self._check.violations(scene, request.robot, q_rad, threshold_m)
        found: list[Pair] = []
        posture = by_robot(scene, request.robots, q_rad)
        for robot, mine in posture.items():
            scene = scene.with_joints(robot, mine)
        for robot, mine in posture.items():
            found += self._check.violations(scene, robot, mine, threshold_m)
        return tuple(sorted(set(found)))


def _all(sets: Iterable[set[Pair]]) -> set[Pair]:
    return {pair for pairs in sets for pair in pairs}


def _blocked(
    scene: SceneSnapshot,
    request: MotionRequest,
    end: Joints,
    pairs: tuple[Pair, ...],
    reason: str,
) -> BlockedBy:
    moved = by_robot(scene, request.robots, end)
    return BlockedBy(pairs=pairs, reason=reason, moment=moment_of(scene, moved, pairs[0]))
