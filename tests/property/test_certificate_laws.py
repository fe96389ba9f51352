"""Laws behind the certificate: travel bounds, quick bounds, strict and plain verdicts."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from motion_scenes import HOME, A, B, held_stud, one_arm, two_arms
from sitewright.planning_twin.backends.arm_model import CarriedPart, swing_radii
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.distances import DistanceEngine, lower_bounds
from sitewright.planning_twin.backends.proof_scene import ProofScene, ProofScenes
from sitewright.planning_twin.motion import Certificate, JointPath, PathSegment
from sitewright.robot_team.description import Joints

SCENE = two_arms(held_stud())
PROOFS = ProofScenes()


def proof() -> ProofScene:
    return PROOFS.of(SCENE)


def postures(count: int, seed: int) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    chain = proof().layout.arms[A].chain
    rows = np.random.default_rng(seed).uniform(chain.lower, chain.upper, (count, 6))
    return np.asarray(rows)


def near_home(count: int, seed: int, spread: float = 0.3) -> tuple[Joints, ...]:
    rng = np.random.default_rng(seed)
    rows = (np.array(HOME) + rng.uniform(-spread, spread, (count, 6))).tolist()
    return (HOME, *(tuple(row) for row in rows))


def path(*waypoints: Joints) -> JointPath:
    return JointPath(robot=A, segments=(PathSegment(waypoints_rad=waypoints),))


def test_no_point_travels_further_than_its_radii_allow() -> None:
    layout = proof().layout
    arm = layout.arms[A]
    start = postures(4000, seed=1)
    change = np.random.default_rng(2).uniform(-0.2, 0.2, start.shape)
    shares = []
    rows = layout.rows_of[A]
    before, after = (proof().placed(A, q).in_every_posture(rows) for q in (start, start + change))
    for k, row in enumerate(rows):
        part = layout.parts[row]
        points = np.concatenate((part.vertices_m.T, np.ones((1, len(part.vertices_m)))))
        travel = np.linalg.norm(((after[:, k] - before[:, k]) @ points)[:, :3], axis=1).max(axis=1)
        joint = layout.joints_of[A][k]
        carried = CarriedPart(part=part, joint=joint, joint_T_part=layout.joint_T_part_of[A][k])
        bound = np.abs(change) @ swing_radii(arm.chain, carried)
        assert (travel <= bound + 1e-12).all()
        if joint >= 0:
            shares.append(float((travel / bound).mean()))
    assert 0.2 < np.mean(shares) < 0.9, "the bound is useless or suspiciously tight"


def test_distances_change_no_faster_than_the_pair_weights_allow() -> None:
    layout, engine = proof().layout, DistanceEngine()
    table = layout.pairs_of[A]
    start = postures(60, seed=3)
    change = np.random.default_rng(4).uniform(-0.1, 0.1, start.shape)
    rng = np.random.default_rng(5)
    row = rng.integers(0, len(table.a), 600)
    posture = rng.integers(0, len(start), 600)
    first = engine.distances(layout, proof().placed(A, start), table, posture, row)
    second = engine.distances(layout, proof().placed(A, start + change), table, posture, row)
    allowed = np.einsum("ki,ki->k", np.abs(change[posture]), table.weights[row])
    assert (np.abs(first - second) <= allowed + 1e-5).all()
    assert (np.abs(first - second) > 1e-4).any()


def test_quick_bounds_never_exceed_the_exact_distance() -> None:
    layout, engine = proof().layout, DistanceEngine()
    table = layout.pairs_of[A]
    placed = proof().placed(A, postures(40, seed=6))
    posture, row = (i.ravel() for i in np.meshgrid(np.arange(40), np.arange(len(table.a))))
    bounds = lower_bounds(layout, placed, table, posture, row)
    close = np.flatnonzero(bounds < 0.4)
    exact = engine.distances(layout, placed, table, posture[close], row[close])
    assert (bounds[close] <= exact + 2e-6).all()
    assert (exact - bounds[close] < 0.05).mean() > 0.3


def test_strict_distances_are_lower_bounds_close_to_the_engines_own() -> None:
    layout = proof().layout
    table = layout.pairs_of[A]
    placed = proof().placed(A, postures(20, seed=7))
    posture, row = (i.ravel() for i in np.meshgrid(np.arange(20), np.arange(len(table.a))))
    bounds = lower_bounds(layout, placed, table, posture, row)
    close = np.flatnonzero(bounds < 0.15)
    plain, strict = (
        DistanceEngine(is_strict=s).distances(layout, placed, table, posture[close], row[close])
        for s in (False, True)
    )
    apart = (plain >= 0.0) & (plain < 0.1)
    assert apart.sum() > 20
    assert (strict <= plain + 1e-5).all()
    assert np.abs(strict - plain)[apart].max() < 1e-5


@pytest.mark.parametrize("seed", range(8))
def test_strict_and_plain_proofs_come_to_the_same_verdict(seed: int) -> None:
    line = path(*near_home(3, seed, spread=0.8))
    verdicts = [
        type(ConservativeAdvancement(PROOFS, is_strict=s).certify(SCENE, line))
        for s in (False, True)
    ]
    assert verdicts[0] is verdicts[1]


def test_certified_paths_are_clear_wherever_they_are_sampled() -> None:
    layout, engine = proof().layout, DistanceEngine()
    table = layout.pairs_of[A]
    certified = 0
    for seed in range(10):
        line = path(*near_home(2, seed + 50, spread=0.5))
        found = ConservativeAdvancement(PROOFS).certify(SCENE, line)
        if not isinstance(found, Certificate):
            continue
        certified += 1
        waypoints = np.array(line.segments[0].waypoints_rad)
        q = np.concatenate(
            [a + np.linspace(0, 1, 30)[:, None] * (b - a) for a, b in pairwise(waypoints)]
        )
        placed = proof().placed(A, q)
        posture, row = (i.ravel() for i in np.meshgrid(np.arange(len(q)), np.arange(len(table.a))))
        near = np.flatnonzero(lower_bounds(layout, placed, table, posture, row) < 0.10)
        exact = engine.distances(layout, placed, table, posture[near], row[near])
        assert exact.min() >= SCENE.clearance_m
        telling = ~table.is_neighbour[row[near]]
        assert exact[telling].min(initial=1.0) >= found.closest_distance_m - 1e-6
    assert certified >= 4


def test_the_same_question_gives_the_same_certificate() -> None:
    line = path(*near_home(3, 11))
    first = ConservativeAdvancement(ProofScenes()).certify(SCENE, line)
    second = ConservativeAdvancement(ProofScenes()).certify(SCENE, line)
    assert first == second


def test_only_pairs_that_the_moving_robot_changes_have_weights() -> None:
    layout = proof().layout
    assert layout.pairs_of[A].weights.any(axis=1).all()
    assert not layout.standing_of[A].weights.any()
    counted = {*layout.pairs_of[A].names, *layout.standing_of[A].names}
    assert counted == {*layout.pairs_of[B].names, *layout.standing_of[B].names}


def test_joints_that_move_both_parts_do_not_count() -> None:
    table = ProofScenes().of(one_arm()).layout.pairs_of[A]
    rows = [k for k, n in enumerate(table.name) if table.names[n] == ("a/link_2", "a/link_5")]
    assert rows
    assert (table.weights[rows, :2] == 0.0).all()
    assert (table.weights[rows, 2:5] > 0.0).all()
    assert (table.weights[rows, 5] == 0.0).all()
