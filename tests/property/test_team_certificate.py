"""Certificates of several robots that move in step."""

from __future__ import annotations

import itertools
from functools import lru_cache

import numpy as np
import pytest

from motion_scenes import HOME, A, B, held_stud, kr120, two_arms
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.distances import DistanceEngine
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.team_pairs import tables_of
from sitewright.planning_twin.motion import Certificate, JointPath, PathSegment, TeamPath
from sitewright.planning_twin.refusal import NotClear
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.description import Joints

TEAM = (A, B)
SAMPLES = 400


@lru_cache(maxsize=1)
def cell() -> tuple[SceneSnapshot, ProofScenes]:
    return two_arms(held_stud()), ProofScenes()


def turned(q: Joints, joint: int, by_rad: float) -> Joints:
    return tuple(v + by_rad if k == joint else v for k, v in enumerate(q))


def together(*waypoints: tuple[Joints, Joints]) -> TeamPath:
    rows = tuple((*a, *b) for a, b in waypoints)
    return TeamPath(robots=TEAM, segments=(PathSegment(waypoints_rad=rows),))


def closest_m(scene: SceneSnapshot, proofs: ProofScenes, path: TeamPath) -> float:
    """Return the smallest distance of the moving pairs at many samples of the path."""
    proof = proofs.of(scene)
    table, _ = tables_of(proof.layout, path.robots)
    rows = np.flatnonzero(~table.is_neighbour)
    points = np.array(path.segments[0].waypoints_rad)
    shares = np.linspace(0.0, 1.0, SAMPLES)[:, None]
    least = np.inf
    for a, b in itertools.pairwise(points):
        placed = proof.placed_together(path.robots, a + shares * (b - a))
        for posture in range(SAMPLES):
            numbers = np.full(len(rows), posture, dtype=np.intp)
            found = DistanceEngine().distances(proof.layout, placed, table, numbers, rows)
            least = min(least, float(found.min()))
    return least


def test_two_arms_that_turn_away_from_each_other_are_proven() -> None:
    scene, proofs = cell()
    path = together((HOME, HOME), (turned(HOME, 0, 0.3), turned(HOME, 0, -0.3)))
    found = ConservativeAdvancement(proofs).certify(scene, path)
    assert isinstance(found, Certificate)
    assert found.path_sha256 == path.sha256()


def test_two_arms_that_meet_midway_are_refused_although_both_ends_are_clear() -> None:
    scene, proofs = cell()
    ahead = turned(turned(HOME, 1, 0.55), 2, -0.3)
    start = (turned(ahead, 0, 0.35), turned(ahead, 0, 0.35))
    goal = (turned(ahead, 0, -0.35), turned(ahead, 0, -0.35))
    engine = ConservativeAdvancement(proofs)
    for a, b in (start, goal):
        standing = together((a, b), (a, b))
        assert isinstance(engine.certify(scene, standing), Certificate)
    assert isinstance(engine.certify(scene, together(start, goal)), NotClear)


@pytest.mark.parametrize("seed", range(4))
def test_no_sample_of_a_proven_path_is_nearer_than_its_certificate_says(seed: int) -> None:
    scene, proofs = cell()
    rng = np.random.default_rng(seed)
    q = tuple(tuple((np.array(HOME) + rng.uniform(-0.5, 0.5, 6)).tolist()) for _ in range(4))
    path = together((q[0], q[1]), (q[2], q[3]))
    found = ConservativeAdvancement(proofs).certify(scene, path)
    least_m = closest_m(scene, proofs, path)
    if isinstance(found, NotClear):
        assert found.distance_m < found.threshold_m + 0.001
    else:
        assert found.closest_distance_m <= least_m + 1e-6
        assert least_m >= scene.clearance_m


def test_a_robot_that_stands_in_a_team_is_proven_as_alone() -> None:
    scene, proofs = cell()
    goal = turned(HOME, 0, 0.4)
    engine = ConservativeAdvancement(proofs)
    alone = engine.certify(
        scene, JointPath(robot=A, segments=(PathSegment(waypoints_rad=(HOME, goal)),))
    )
    team = engine.certify(scene, together((HOME, HOME), (goal, HOME)))
    assert isinstance(alone, Certificate)
    assert isinstance(team, Certificate)
    assert alone.pairs == team.pairs
    assert alone.closest_distance_m == pytest.approx(team.closest_distance_m, abs=0.002)


def test_every_pair_is_either_moved_or_standing() -> None:
    scene, proofs = cell()
    layout = proofs.of(scene).layout
    moved, standing = tables_of(layout, TEAM)
    every = {*layout.pairs_of[A].names, *layout.standing_of[A].names}
    assert set(moved.names) | set(standing.names) == every
    assert not set(moved.names) & set(standing.names)
    assert moved.weights.shape[1] == 2 * len(kr120().movable_joints)
