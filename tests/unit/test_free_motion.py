"""What is tried, and in which order, when a proof or a search says no."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any, cast

from motion_scenes import HOME, A, one_arm
from sitewright.planning_twin.free_motion import plan_free_motion
from sitewright.planning_twin.motion import (
    Certificate,
    JointPath,
    MotionRequest,
    PathSegment,
    PlanningBackends,
    TeamPath,
)
from sitewright.planning_twin.refusal import BlockedBy, NoPath, NotClear
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.description import Joints

GOAL: Joints = (0.5, *HOME[1:])
LINE = (HOME, GOAL)
UNCLEAR = NotClear(
    pair=("a/link_2", "wall"), q_rad=HOME, distance_m=0.004, threshold_m=0.01, segment=0
)


@dataclass
class ScriptedPlanner:
    """Gives prepared answers and remembers what it was asked."""

    answers: Iterator[tuple[Joints, ...] | BlockedBy | NoPath]
    asked: list[tuple[MotionRequest, int]] = field(default_factory=list)

    def plan(
        self, scene: SceneSnapshot, request: MotionRequest, *, seed: int
    ) -> tuple[Joints, ...] | BlockedBy | NoPath:
        assert scene.robots[A].q_rad == HOME
        self.asked.append((request, seed))
        return next(self.answers)


@dataclass
class ScriptedCertifier:
    answers: Iterator[bool]

    def certify(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> Certificate | NotClear:
        raise NotImplementedError

    def objection(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> NotClear | None:
        assert isinstance(path, JointPath)
        assert scene.robots[A].q_rad == path.start_rad
        return None if next(self.answers) else UNCLEAR


def run(
    planned: Iterable[tuple[Joints, ...] | BlockedBy | NoPath], proofs: Iterable[bool]
) -> tuple[object, ScriptedPlanner]:
    planner = ScriptedPlanner(iter(planned))
    absent = cast("Any", None)
    backends = PlanningBackends(
        kinematics=absent,
        collision=absent,
        planner=planner,
        certifier=ScriptedCertifier(iter(proofs)),
        timer=absent,
        cross_check=absent,
    )
    contacts = {("gripper", "stud"): -0.001}
    found = plan_free_motion(backends, one_arm(), A, GOAL, contacts, seed=7, max_nodes=100)
    return found, planner


def no_path(nodes: int) -> NoPath:
    return NoPath(nodes=nodes, seeds=(7,))


def test_a_path_that_is_proven_at_once_is_taken() -> None:
    found, planner = run([LINE], [True])
    assert isinstance(found, PathSegment)
    assert found.waypoints_rad == LINE
    assert found.threshold_m == {("gripper", "stud"): -0.001}
    assert len(planner.asked) == 1


def test_after_a_failed_proof_the_unshortened_path_the_next_seed_and_finer_steps_follow() -> None:
    found, planner = run([LINE] * 4, [False, False, False, True])
    assert isinstance(found, PathSegment)
    tried = [(r.is_shortcut, seed, r.step_rad) for r, seed in planner.asked]
    assert tried == [(True, 7, 0.02), (False, 7, 0.02), (True, 8, 0.02), (True, 7, 0.01)]


def test_a_search_out_of_nodes_is_repeated_once_with_more() -> None:
    found, planner = run([no_path(100), LINE], [True])
    assert isinstance(found, PathSegment)
    assert [r.max_nodes for r, _ in planner.asked] == [100, 600]


def test_an_exhausted_search_names_its_nodes_and_seeds() -> None:
    found, planner = run([no_path(100), no_path(600)], [])
    assert found == NoPath(nodes=600, seeds=(7,))
    assert len(planner.asked) == 2


def test_a_search_out_of_time_is_not_repeated() -> None:
    found, planner = run([NoPath(nodes=100, seeds=(7,), is_reproducible=False)], [])
    assert found == NoPath(nodes=100, seeds=(7,), is_reproducible=False)
    assert len(planner.asked) == 1


def test_a_blocked_end_is_final() -> None:
    blocked = BlockedBy(pairs=(("a/link_6", "table"),))
    found, planner = run([blocked], [])
    assert found is blocked
    assert len(planner.asked) == 1


def test_a_proof_that_always_objects_is_reported_as_such() -> None:
    found, planner = run([LINE] * 6, [False] * 6)
    assert found is UNCLEAR
    assert len(planner.asked) == 6
