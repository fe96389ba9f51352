"""Laws of the second proof: its bounds, its pairs, and its verdicts against the first one."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import coal
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion_scenes import HOME, A, B, box, held_stud, kr120, one_arm, two_arms
from sitewright.foundation.pose import Pose, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.audit import Fault, Reproof
from sitewright.planning_twin.backends.audit.gaps import GapFinder
from sitewright.planning_twin.backends.audit.pairs import pairs_of
from sitewright.planning_twin.backends.audit.parts import (
    Array,
    Part,
    frames_of,
    parts_of,
    reaches_m,
)
from sitewright.planning_twin.backends.audit.reproof import SeparatingPlanes
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.motion import Certificate, JointPath, PathSegment, TeamPath
from sitewright.planning_twin.refusal import NotClear
from sitewright.planning_twin.scene import Attachment, RobotInScene, SceneSnapshot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.kinematics import tip_pose
from sitewright.robot_team.rails import Rail, on_rails

SCENE = two_arms(held_stud())
PROVER = ConservativeAdvancement(ProofScenes())
AUDIT = SeparatingPlanes()


def track_scene() -> SceneSnapshot:
    carriage = (Box((0.8, 0.8, 0.3)),)
    rail = Rail(axis=(1.0, 0.0, 0.0), travel_m=(-2.0, 3.0), speed_m_s=1.0, carriage=carriage)
    arm = on_rails(kr120(), [rail], translation(0.0, 0.0, 0.3))
    state = RobotInScene(description=arm, world_T_base=Pose(), q_rad=(0.0, *HOME))
    return SceneSnapshot(robots={A: state}, bodies={})


def line(*waypoints: Joints) -> JointPath:
    return JointPath(robot=A, segments=(PathSegment(waypoints_rad=waypoints),))


def near_home(seed: int, spread: float) -> tuple[Joints, ...]:
    rng = np.random.default_rng(seed)
    rows = (np.array(HOME) + rng.uniform(-spread, spread, (2, 6))).tolist()
    return (HOME, *(tuple(row) for row in rows))


def claimed(path: JointPath | TeamPath, scene: SceneSnapshot, closest_m: float) -> Certificate:
    return Certificate(
        scene_revision=scene.revision(),
        path_sha256=path.sha256(),
        clearance_m=scene.clearance_m,
        closest_distance_m=closest_m,
        closest_pair=None,
        closest_at=(0, 0.0),
        eps_m=1e-5,
        pairs=1,
        evaluations=1,
        engine="none",
    )


def faults(found: Reproof) -> set[Fault]:
    return {o.fault for o in found.objections}


@pytest.mark.parametrize("scene", [SCENE, track_scene()], ids=["two arms", "on a track"])
def test_no_point_travels_further_than_the_audits_reaches_allow(scene: SceneSnapshot) -> None:
    arm = scene.robots[A]
    parts = [p for p in parts_of(scene) if p.robot == A]
    rng = np.random.default_rng(1)
    joints = arm.description.movable_joints
    shares = []
    for _ in range(300):
        start = np.array([rng.uniform(j.lower_rad, j.upper_rad) for j in joints])
        change = rng.uniform(-0.2, 0.2, len(joints))
        before, after = (frames_of(arm, tuple(q)) for q in (start, start + change))
        for part in parts:
            points = np.concatenate((part.points_m.T, np.ones((1, len(part.points_m)))))
            moved = ((after[part.frame] - before[part.frame]) @ points)[:3]
            travel = float(np.linalg.norm(moved, axis=0).max())
            bound = float(np.abs(change) @ reaches_m(arm.description, part))
            assert travel <= bound + 1e-12
            if part.joint > 2:
                shares.append(travel / bound)
    assert 0.15 < np.mean(shares) < 0.9, "the bound is useless or suspiciously tight"


def test_both_proofs_speak_of_the_same_pairs() -> None:
    layout = ProofScenes().of(SCENE).layout
    proven = {*layout.pairs_of[A].names, *layout.standing_of[A].names}
    assert {p.name for p in pairs_of(SCENE, parts_of(SCENE))} == proven


@given(st.integers(0, 2**32 - 1))
def test_a_gap_is_never_larger_than_the_distance(seed: int) -> None:
    parts = _solids()
    rng = np.random.default_rng(seed)
    a, b = (parts[k] for k in rng.integers(0, len(parts), 2))
    frames = [_frame(rng) for _ in range(2)]
    gap = GapFinder().gap_m(0, (a, frames[0]), (b, frames[1]), np.inf)
    request = coal.DistanceRequest()
    request.gjk_tolerance = 1e-12
    poses = [coal.Transform3s(f[:3, :3], f[:3, 3]) for f in frames]
    distance = coal.distance(a.solid, poses[0], b.solid, poses[1], request, coal.DistanceResult())
    assert gap <= distance + 1e-9
    if 1e-3 < distance < 0.1:
        assert gap > distance - 1e-5


def test_a_plane_is_believed_whatever_the_engine_says() -> None:
    """With a lying engine the gap gets smaller, never larger."""
    parts = _solids()
    frames = (np.eye(4), np.eye(4))
    frames[1][:3, 3] = (3.0, 0.0, 0.0)
    honest = GapFinder().gap_m(0, (parts[0], frames[0]), (parts[1], frames[1]), np.inf)
    lying = GapFinder()
    rng = np.random.default_rng(0)
    for _ in range(100):
        normal = rng.normal(size=3)
        lying._normals[0] = normal / np.linalg.norm(normal)
        gap = lying.gap_m(0, (parts[0], frames[0]), (parts[1], frames[1]), -np.inf)
        assert gap <= honest + 1e-9


@lru_cache(maxsize=1)
def _solids() -> tuple[Part, ...]:
    return parts_of(SCENE)


def _frame(rng: np.random.Generator) -> Array:
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    frame = np.eye(4)
    frame[:3, :3] = turn * np.sign(np.linalg.det(turn))
    frame[:3, 3] = rng.uniform(-0.6, 0.6, 3)
    return frame


@pytest.mark.parametrize("seed", range(10))
def test_both_proofs_come_to_the_same_verdict(seed: int) -> None:
    path = line(*near_home(seed, spread=0.7))
    first = PROVER.certify(SCENE, path)
    if isinstance(first, Certificate):
        assert AUDIT.reprove(SCENE, path, first).objections == ()
    else:
        second = AUDIT.reprove(SCENE, path, claimed(path, SCENE, 0.0))
        assert faults(second) == {Fault.DISTANCE}


@pytest.mark.parametrize("seed", range(3))
def test_both_proofs_agree_on_robots_that_move_in_step(seed: int) -> None:
    ways = [near_home(seed, spread=0.4), near_home(seed + 100, spread=0.4)]
    rows = tuple((*a, *b) for a, b in zip(*ways, strict=True))
    path = TeamPath(robots=(A, B), segments=(PathSegment(waypoints_rad=rows),))
    first = PROVER.certify(SCENE, path)
    closest_m = first.closest_distance_m if isinstance(first, Certificate) else 0.0
    second = AUDIT.reprove(SCENE, path, claimed(path, SCENE, closest_m))
    assert bool(second.objections) == isinstance(first, NotClear)


def test_a_certificate_that_claims_too_much_is_refused() -> None:
    path = line(HOME, (HOME[0] + 0.3, *HOME[1:]))
    honest = PROVER.certify(SCENE, path)
    assert isinstance(honest, Certificate)
    lying = replace(honest, closest_distance_m=honest.closest_distance_m + 0.005)
    assert faults(AUDIT.reprove(SCENE, path, lying)) == {Fault.CLAIM}


def test_a_thin_fin_in_the_way_is_refused_and_named() -> None:
    start, end = HOME, (HOME[0] + 1.0, *HOME[1:])
    middle = tuple((a + b) / 2.0 for a, b in zip(start, end, strict=True))
    there = tip_pose(kr120(), middle).position_m
    probe = box("probe", (0.004, 0.004, 0.2), Attachment(A, Pose((0.0, 0.0, 0.1))))
    fin = box("fin", (0.001, 0.05, 0.3), Pose(there))
    scene = one_arm(fin, probe, clearance_m=0.0)
    path = line(start, end)
    (objection,) = AUDIT.reprove(scene, path, claimed(path, scene, 0.0)).objections
    assert objection.fault is Fault.DISTANCE
    assert "fin" in objection.what


def test_what_stands_too_near_to_a_robot_that_does_not_move_is_refused() -> None:
    gun = SCENE.robots[B].world_T_base @ tip_pose(kr120(), HOME)
    scene = SCENE.with_body(box("plank", (0.3, 0.3, 0.02), Pose(gun.apply((0.0, 0.0, 0.2)))))
    path = line(HOME, (HOME[0] + 0.1, *HOME[1:]))
    (objection,) = AUDIT.reprove(scene, path, claimed(path, scene, 0.0)).objections
    assert "nailer and plank" in objection.what
