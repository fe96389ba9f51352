"""The engines of the planning twin together, in a cell of the case study's size."""

from __future__ import annotations

import pickle
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from motion_scenes import HOME, A, B, box, held_stud, kr120, lowering, one_arm, two_arms
from sitewright.foundation.ids import BodyId
from sitewright.foundation.pose import Pose, translation
from sitewright.planning_twin.backends.distances import EPS_M
from sitewright.planning_twin.backends.mujoco_cell import MujocoCells
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.search_scene import SearchScenes
from sitewright.planning_twin.backends.twin import make_backends
from sitewright.planning_twin.backends.two_trees import TwoTrees
from sitewright.planning_twin.free_motion import plan_free_motion
from sitewright.planning_twin.motion import (
    Agreement,
    Certificate,
    JointLimits,
    JointPath,
    MotionRequest,
    PathSegment,
    TimedPath,
)
from sitewright.planning_twin.refusal import BlockedBy, Disagreement, NoPath
from sitewright.planning_twin.scene import Attachment, SceneSnapshot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.kinematics import tip_pose

VELOCITY = tuple(j.velocity_rad_s for j in kr120().movable_joints)
LIMITS = JointLimits(
    velocity_rad_s=VELOCITY,
    acceleration_rad_s2=tuple(2.0 * v for v in VELOCITY),
    jerk_rad_s3=tuple(20.0 * v for v in VELOCITY),
)
SCENE = two_arms(held_stud())
BACKENDS = make_backends()


def random_postures(count: int, seed: int) -> list[Joints]:
    rng = np.random.default_rng(seed)
    lower = [max(j.lower_rad, -2.2) for j in kr120().movable_joints]
    upper = [min(j.upper_rad, 2.2) for j in kr120().movable_joints]
    return [tuple(row) for row in rng.uniform(lower, upper, (count, 6)).tolist()]


def free_goals(count: int, seed: int) -> list[Joints]:
    goals = [
        q
        for q in random_postures(10 * count, seed)
        if not BACKENDS.collision.violations(SCENE, A, q, {}, is_padded=True)
    ]
    assert len(goals) >= count
    return goals[:count]


def timed(*segments: PathSegment) -> TimedPath:
    return BACKENDS.timer.time(JointPath(robot=A, segments=segments), LIMITS)


def test_three_engines_agree_on_random_postures() -> None:
    touching = replace(SCENE, clearance_m=0.0)
    proofs = ProofScenes()
    search, cell = SearchScenes(proofs).of(touching, 0.0, (A,)), MujocoCells(proofs).of(touching)
    verdicts: Counter[tuple[bool, ...]] = Counter()
    for q in random_postures(400, seed=1):
        verdicts[
            bool(BACKENDS.collision.violations(touching, A, q, {})),
            search.is_hit(search.posture({A: q})),
            any(d < 0.0 for _, d in cell.contacts(A, np.array(q))),
        ] += 1
    assert set(verdicts) == {(True,) * 3, (False,) * 3}, verdicts
    assert min(verdicts.values()) > 30


@pytest.mark.parametrize("margin_m", [0.011, 0.05])
def test_the_search_scene_keeps_a_margin_exactly(margin_m: float) -> None:
    proofs = ProofScenes()
    search = SearchScenes(proofs).of(SCENE, margin_m, (A,))
    table = proofs.of(SCENE).layout.pairs_of[A]
    by_design = {table.names[n] for n in table.name[table.is_neighbour]}
    search.leave_out(by_design)
    off = dict.fromkeys(by_design, -np.inf)
    verdicts: Counter[bool] = Counter()
    for q in random_postures(300, seed=5):
        hit = search.is_hit(search.posture({A: q}))
        tight, wide = (
            bool(BACKENDS.collision.violations(replace(SCENE, clearance_m=m), A, q, off))
            for m in (margin_m - 2.0 * EPS_M, margin_m + EPS_M)
        )
        assert tight <= hit <= wide
        verdicts[hit] += 1
    assert min(verdicts[True], verdicts[False]) > 30


def test_mujoco_sees_the_same_pairs_within_the_clearance() -> None:
    cell = MujocoCells(ProofScenes()).of(SCENE)
    for q in random_postures(150, seed=2):
        needed_m = SCENE.clearance_m + EPS_M
        near = {p for p, d in cell.contacts(A, np.array(q)) if d < needed_m}
        assert near == set(BACKENDS.collision.violations(SCENE, A, q, {}))


def test_found_paths_are_certified_timed_and_confirmed() -> None:
    for k, goal in enumerate(free_goals(5, seed=3)):
        motion = plan_free_motion(BACKENDS, SCENE, A, goal, {}, seed=k)
        assert isinstance(motion, PathSegment), motion
        assert motion.waypoints_rad[0] == HOME
        assert motion.waypoints_rad[-1] == goal
        path = JointPath(robot=A, segments=(motion,))
        certificate = BACKENDS.certifier.certify(SCENE, path)
        assert isinstance(certificate, Certificate), certificate
        assert certificate.closest_distance_m >= SCENE.clearance_m
        opinion = BACKENDS.cross_check.check(SCENE, timed(motion))
        assert isinstance(opinion, Agreement), opinion
        assert opinion.samples > 50
        assert opinion.engine.startswith("mujoco 4")


def test_the_same_seed_gives_the_same_path_in_fresh_engines() -> None:
    goal = free_goals(3, seed=4)[2]
    request = MotionRequest(robot=A, goal_rad=goal)
    first, again = (make_backends().planner.plan(SCENE, request, seed=5) for _ in range(2))
    copied = pickle.loads(pickle.dumps(SCENE))  # noqa: S301 - our own bytes
    moved = make_backends().planner.plan(copied, request, seed=5)
    assert isinstance(first, tuple)
    assert first == again == moved


def test_a_search_is_not_changed_by_what_was_searched_before() -> None:
    goals = free_goals(4, seed=6)
    fresh = make_backends().planner.plan(SCENE, MotionRequest(robot=A, goal_rad=goals[3]), seed=9)
    used = make_backends().planner
    for goal in goals[:3]:
        used.plan(SCENE, MotionRequest(robot=A, goal_rad=goal), seed=1)
        used.plan(
            SCENE.with_joints(B, (0.4, *HOME[1:])), MotionRequest(robot=A, goal_rad=goal), seed=1
        )
    contacts = {("held", "table"): -0.001}
    used.plan(SCENE, MotionRequest(robot=A, goal_rad=goals[0], threshold_m=contacts), seed=1)
    assert used.plan(SCENE, MotionRequest(robot=A, goal_rad=goals[3]), seed=9) == fresh


def test_a_held_body_far_from_the_flange_is_where_it_is_in_the_search_too() -> None:
    """A box one metre before the flange, and a wall exactly there: hit, and missed beside it."""
    far = box("far", (0.1, 0.1, 0.1), Attachment(A, translation(0.0, 0.0, 0.5)))
    place = tip_pose(kr120(), HOME) @ translation(0.0, 0.0, 0.5)
    proofs = ProofScenes()
    for shift, is_hit in ((0.0, True), (0.09, True), (0.25, False)):
        wall = box("wall", (0.1, 0.1, 0.1), translation(0.0, shift, 0.0) @ Pose(place.position_m))
        scene = one_arm(far, wall, clearance_m=0.0)
        search = SearchScenes(proofs).of(scene, 0.0, (A,))
        assert search.is_hit(search.posture({})) is is_hit
        assert bool(BACKENDS.collision.violations(scene, A, HOME, {})) is is_hit


def test_a_blocked_goal_names_the_pairs() -> None:
    goal, cell = (0.3, *HOME[1:]), two_arms()
    at_goal = cell.robots[A].world_T_base @ tip_pose(kr120(), goal)
    scene = cell.with_body(box("pillar", (0.1, 0.1, 2.0), Pose(at_goal.position_m)))
    found = BACKENDS.planner.plan(scene, MotionRequest(robot=A, goal_rad=goal), seed=0)
    assert isinstance(found, BlockedBy)
    assert any("pillar" in pair for pair in found.pairs)
    assert "goal" in found.reason


def test_a_peg_in_a_deep_tube_ends_with_the_nodes_and_repeats() -> None:
    """Hardly a node can be added there; what was tried in vain counts as well."""
    peg = box("peg", (0.08, 0.08, 0.6), Attachment(A, translation(0.0, 0.0, 0.31)))
    middle = tip_pose(kr120(), HOME) @ translation(0.0, 0.0, 0.36)
    walls = [
        box(f"wall-{k}", size, middle @ translation(x, y, 0.0))
        for k, (size, x, y) in enumerate(
            [
                ((0.02, 0.18, 0.6), 0.08, 0.0),
                ((0.02, 0.18, 0.6), -0.08, 0.0),
                ((0.18, 0.02, 0.6), 0.0, 0.08),
                ((0.18, 0.02, 0.6), 0.0, -0.08),
            ]
        )
    ]
    request = MotionRequest(robot=A, goal_rad=(1.0, *HOME[1:]))
    scene = one_arm(peg, *walls)
    found = TwoTrees(ProofScenes()).plan(scene, request, seed=0)
    assert isinstance(found, NoPath), found
    assert found.is_reproducible
    assert found == TwoTrees(ProofScenes()).plan(scene, request, seed=0)


def test_a_search_that_needs_more_nodes_says_how_many_it_had() -> None:
    """A pillar between start and goal cannot be passed with three nodes."""
    middle = tip_pose(kr120(), (0.5, *HOME[1:])).position_m
    scene = one_arm(box("pillar", (0.3, 0.3, 6.0), Pose(middle)))
    request = MotionRequest(robot=A, goal_rad=(1.0, *HOME[1:]), max_nodes=3)
    found = BACKENDS.planner.plan(scene, request, seed=4)
    assert isinstance(found, NoPath), found
    assert (found.nodes, found.is_reproducible, found.seeds) == (3, True, (4,))
    more = BACKENDS.planner.plan(scene, replace(request, max_nodes=500), seed=4)
    assert isinstance(more, tuple)


@pytest.mark.parametrize("gap_m", [0.0102, 0.0107])
def test_an_end_between_clearance_and_pad_can_still_be_left(gap_m: float) -> None:
    probe = box("probe", (0.02, 0.02, 0.1), Attachment(A, translation(0.0, 0.0, 0.05)))
    beyond = tip_pose(kr120(), HOME) @ translation(0.0, 0.0, 0.1 + gap_m + 0.01)
    scene = one_arm(probe, box("wall", (0.02, 0.02, 0.02), beyond))
    found = plan_free_motion(BACKENDS, scene, A, (0.6, *HOME[1:]), {}, seed=0)
    assert isinstance(found, PathSegment), found


def test_mujoco_refuses_what_was_never_certified() -> None:
    """A path straight through a pillar, put past the certificate on purpose."""
    goal = (0.6, *HOME[1:])
    there = SCENE.robots[A].world_T_base @ tip_pose(kr120(), (0.3, *HOME[1:]))
    scene = SCENE.with_body(box("pillar", (0.05, 0.05, 2.0), Pose(there.position_m)))
    found = BACKENDS.cross_check.check(scene, timed(PathSegment(waypoints_rad=(HOME, goal))))
    assert isinstance(found, Disagreement)
    assert "pillar" in found.pair
    assert found.distance_m < found.threshold_m
    assert found.pair in BACKENDS.collision.violations(scene, A, found.q_rad, {})


def test_mujoco_uses_the_thresholds_of_each_segment() -> None:
    """A stud is set down on a table: a contact on the last stretch, none before."""
    scene, approach, last = lowering(0.12)
    near = {("held", "table"): -0.001}
    declared = timed(
        PathSegment(waypoints_rad=approach), PathSegment(waypoints_rad=last, threshold_m=near)
    )
    undeclared = timed(
        PathSegment(waypoints_rad=approach, threshold_m=near), PathSegment(waypoints_rad=last)
    )
    assert isinstance(BACKENDS.cross_check.check(scene, declared), Agreement)
    found = BACKENDS.cross_check.check(scene, undeclared)
    assert isinstance(found, Disagreement)
    assert found.pair == ("held", "table")
    assert found.threshold_m == scene.clearance_m


def test_mujoco_looks_at_pairs_that_stand_in_every_segment() -> None:
    """B's gun stands in a plank that only the first of A's two segments lets it touch."""
    gun = SCENE.robots[B].world_T_base @ tip_pose(kr120(), HOME)
    scene = SCENE.with_body(box("plank", (0.3, 0.3, 0.02), Pose(gun.apply((0.0, 0.0, 0.38)))))
    contact = {("nailer", "plank"): -0.05}
    turned = tuple((HOME[0] + turn, *HOME[1:]) for turn in (0.0, 0.02, 0.04))
    first = PathSegment(waypoints_rad=turned[:2], threshold_m=contact)
    second = PathSegment(waypoints_rad=turned[1:])
    declared = timed(first, replace(second, threshold_m=contact))
    assert isinstance(BACKENDS.cross_check.check(scene, declared), Agreement)
    found = BACKENDS.cross_check.check(scene, timed(first, second))
    assert isinstance(found, Disagreement)
    assert found.pair == ("nailer", "plank")


def test_scenes_with_moved_bodies_and_postures_are_not_confused() -> None:
    moved = SCENE.placed(BodyId("table"), translation(0.0, 0.0, -2.0)).with_joints(
        B, (0.8, *HOME[1:])
    )
    scenes: list[SceneSnapshot] = [SCENE, moved, SCENE]
    proofs = ProofScenes()
    searches, cells = SearchScenes(proofs), MujocoCells(proofs)
    answers = []
    for scene in scenes:
        search, cell = searches.of(scene, 0.0, (A,)), cells.of(scene)
        standing = proofs.of(scene).layout.standing_of[A].names
        row = []
        for q in random_postures(60, seed=8):
            hit = search.is_hit(search.posture({A: q}))
            seen = any(d < 0.0 and p not in standing for p, d in cell.contacts(A, np.array(q)))
            assert hit == seen
            row.append(hit)
        answers.append(row)
    assert answers[0] == answers[2] != answers[1]


def test_a_certificate_holds_for_the_path_that_was_planned_with_contacts() -> None:
    """B's gun stands on a stud all the time; A moves by, since the contact is declared."""
    gun = SCENE.robots[B].world_T_base @ tip_pose(kr120(), HOME)
    plank = box("plank", (0.3, 0.3, 0.02), Pose(gun.apply((0.0, 0.0, 0.38))))
    scene = SCENE.with_body(plank)
    goal = free_goals(1, seed=12)[0]
    contacts = {("nailer", "plank"): -0.05}
    motion = plan_free_motion(BACKENDS, scene, A, goal, contacts, seed=0)
    assert isinstance(motion, PathSegment), motion
    path = JointPath(robot=A, segments=(motion,))
    assert isinstance(BACKENDS.certifier.certify(scene, path), Certificate)
