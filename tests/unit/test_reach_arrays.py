"""The reach check's arrays against the planner's own engines, which know nothing of them."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest

from builders_arms import offset_wrist_urdf
from builders_planning import EXAMPLES
from motion_scenes import HOME, kr120
from sitewright.app.engines import proposals_of
from sitewright.app.planning import start_of
from sitewright.app.project import open_project
from sitewright.central_controller.situation import jobsite_of
from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.arm_model import arm_model
from sitewright.planning_twin.backends.collision_check import CoalCollisionCheck
from sitewright.planning_twin.backends.kinematic_chain import chain_of, matrix_of
from sitewright.planning_twin.backends.numeric_kinematics import NumericSolver
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics, solver_of
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.reach.arm_poses import ArmPoses, shoulder_ball
from sitewright.planning_twin.backends.reach.clearance import Around, Clearance, Thresholds
from sitewright.planning_twin.backends.reach.load import Load, load_of, with_piece
from sitewright.planning_twin.backends.reach.surroundings import Surroundings, surroundings
from sitewright.planning_twin.grasp_trial import alone
from sitewright.planning_twin.jobsite import scene_of
from sitewright.planning_twin.reachability.question import TimedBody
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.scene import Attachment, Body, Pair, SceneSnapshot
from sitewright.robot_team.formats.urdf import read_urdf
from sitewright.robot_team.kinematics import without_turns

A = RobotId("kr120-a")
STUD = BodyId("thin.5")
HAND_M = 0.215
"""From the middle of the wrist to the flange."""
NEAR_HOME = np.array(HOME)


def tips(count: int, *, stretch: float = 1.0) -> np.ndarray:
    chain = chain_of(kr120())
    q = np.random.default_rng(5).uniform(chain.lower, chain.upper, (count, 6))
    found = chain.tips(q)
    found[:, :3, 3] *= stretch
    return found


@pytest.mark.parametrize("stretch", [1.0, 1.4])
def test_batches_find_the_postures_that_one_by_one_finds(stretch: float) -> None:
    poses = tips(60, stretch=stretch)
    found = ArmPoses(solver_of(kr120())).postures(poses, NEAR_HOME)
    shapes = [without_turns(kr120(), tuple(q)) for q in found.q.tolist()]
    for k, pose in enumerate(poses):
        alone_found = OpwKinematics().solve(kr120(), Pose.from_matrix(pose.tolist()), HOME)
        mine = [s for s, p in zip(shapes, found.pose, strict=True) if p == k]
        if isinstance(alone_found, NoIk):
            assert mine == []
            assert found.is_never[k] == alone_found.is_proven
            if alone_found.extension_m > 0.0:
                assert found.beyond_m[k] == pytest.approx(alone_found.extension_m, abs=1e-9)
            continue
        expected = {without_turns(kr120(), q) for q in alone_found}
        assert all(any(_near(s, e) for e in expected) for s in mine)
        assert all(any(_near(s, e) for s in mine) for e in expected)
        assert not found.is_never[k]


def test_a_wrist_further_than_its_ball_is_never_reached_and_told_by_how_much() -> None:
    (centre,), radius_m = shoulder_ball(solver_of(kr120()))
    far = np.tile(np.eye(4), (3, 1, 1))
    far[:, 0, 3] = centre[0] + radius_m + np.array([0.3, 0.5, 2.0])
    far[:, 2, 3] = centre[2] + HAND_M
    found = ArmPoses(solver_of(kr120())).postures(far, NEAR_HOME)
    assert found.is_never.all()
    assert np.diff(found.beyond_m) == pytest.approx([0.2, 1.5], abs=1e-6)


def test_an_arm_without_closed_form_proves_nothing(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:

    file = tmp_path_factory.mktemp("arm") / "own.urdf"
    file.write_text(offset_wrist_urdf())
    solver = solver_of(read_urdf(file))
    assert isinstance(solver, NumericSolver)
    far = np.tile(np.eye(4), (2, 1, 1))
    far[1, 0, 3] = 9.0
    found = ArmPoses(solver).postures(far, np.zeros(6))
    assert not found.is_never.any()


@lru_cache(maxsize=1)
def case_study() -> tuple[Surroundings, Load, SceneSnapshot]:
    """Return the first scene of the case study: in arrays, and as the planner has it."""
    project = open_project(EXAMPLES / "wooden_frame")
    proposals, context = proposals_of(project), start_of(project)
    kinematics = proposals.ports.backends.kinematics
    site = jobsite_of(proposals.design, proposals.shapes, context, kinematics)
    scene = alone(scene_of(site), A)
    still = [
        TimedBody(id=b.id, shape=b.shape, world_T_body=b.placement)
        for b in scene.bodies.values()
        if isinstance(b.placement, Pose)
    ]
    robot = project.cell.robot_by_id[A]
    tool = project.cell.end_effector_by_id[robot.end_effectors[0]]
    load = load_of(robot, arm_model(robot.description), tool, site.arms[A].aperture_m)
    return surroundings(still), load, scene


def postures(count: int, *, near_home: float = 0.0) -> np.ndarray:
    chain = chain_of(kr120())
    random = np.random.default_rng(11)
    if near_home:
        return NEAR_HOME + random.normal(0.0, near_home, (count, 6))
    return np.asarray(random.uniform(chain.lower, chain.upper, (count, 6)))


def expected_pairs(
    scene: SceneSnapshot, q: np.ndarray, declared_m: dict[Pair, float], *, is_padded: bool
) -> list[tuple[Pair, ...]]:
    check = CoalCollisionCheck(ProofScenes())
    return [
        check.violations(scene, A, tuple(row), declared_m, is_padded=is_padded)
        for row in q.tolist()
    ]


def seen(
    load: Load,
    q: np.ndarray,
    around: list[Around],
    thresholds: Thresholds,
    world_T_piece: np.ndarray | None = None,
) -> list[tuple[Pair, ...]]:
    """Return what the arm, its hand and the piece in it see between them."""
    clearance, hand, piece = Clearance(), load.hand(), load.piece()
    tips_of = load.world_T_base @ load.arm.chain.tips(q)
    shares = [(load.moving, load.placed(q, world_T_piece)), (hand.moving, hand.placed(tips_of))]
    if piece is not None and world_T_piece is not None:
        shares.append((piece.moving, piece.placed(world_T_piece)))
    found = [clearance.too_near(*s, around, thresholds, is_thorough=True) for s in shares]
    return [tuple(sorted({p for pairs in row for p in pairs})) for row in zip(*found, strict=True)]


@pytest.mark.parametrize("is_padded", [False, True])
def test_batches_see_the_pairs_that_the_collision_check_sees(
    is_padded: bool,  # noqa: FBT001 - a parameter of the test
) -> None:
    still, load, scene = case_study()
    q = np.concatenate((postures(80), postures(80, near_home=0.4)))
    declared_m: dict[Pair, float] = {("assembly-table", "gripper-s"): -0.001}
    around = [Around(still, np.ones(len(still.parts), dtype=np.bool_))]
    thresholds = Thresholds(clearance_m=scene.clearance_m, declared_m=declared_m)
    wanted = thresholds.padded() if is_padded else thresholds
    found = seen(load, q, around, wanted)
    expected = expected_pairs(scene, q, declared_m, is_padded=is_padded)
    assert found == expected
    assert 20 < sum(bool(pairs) for pairs in expected) < 150


def test_a_quick_look_names_one_of_the_pairs_and_frees_nobody() -> None:
    still, load, _ = case_study()
    q = postures(60)
    around = [Around(still, np.ones(len(still.parts), dtype=np.bool_))]
    thresholds = Thresholds(clearance_m=0.01)
    clearance, placed = Clearance(), load.placed(q)
    quick = clearance.too_near(load.moving, placed, around, thresholds)
    whole = clearance.too_near(load.moving, placed, around, thresholds, is_thorough=True)
    assert [bool(pairs) for pairs in quick] == [bool(pairs) for pairs in whole]
    assert all(set(a) <= set(b) for a, b in zip(quick, whole, strict=True))


def test_a_carried_piece_is_looked_at_where_it_is_said_to_be() -> None:
    still, load, scene = case_study()
    body = scene.bodies[STUD]
    tip_T_piece = Pose((0.0, 0.0, 0.26))
    held = Body(id=STUD, shape=body.shape, placement=Attachment(A, tip_T_piece))
    carrying = scene.without(STUD).with_body(held)
    q = postures(80, near_home=0.5)
    loaded = with_piece(load, body.shape, STUD)
    tips_of = load.world_T_base @ load.arm.chain.tips(q)
    there = np.ones(len(still.parts), dtype=np.bool_)
    there[still.rows(STUD)] = False
    world_T_piece = tips_of @ matrix_of(tip_T_piece)
    thresholds = Thresholds(clearance_m=0.01)
    found = seen(loaded, q, [Around(still, there)], thresholds, world_T_piece)
    assert found == expected_pairs(carrying, q, {}, is_padded=False)
    assert any(STUD in name for pairs in found for pair in pairs for name in pair)


def _near(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    apart = (math.remainder(x - y, math.tau) for x, y in zip(a, b, strict=True))
    return max(map(abs, apart)) < 1e-4
