"""Paths made quicker: same ends, still free, never slower, the same for the same seed."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from motion_scenes import HOME, A, box, kr120, one_arm
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.search_scene import SearchScene, SearchScenes
from sitewright.planning_twin.backends.search_space import SearchSpace
from sitewright.planning_twin.backends.shortcuts import quicker
from sitewright.planning_twin.backends.tree_search import found_path
from sitewright.robot_team.kinematics import tip_pose

STEP_RAD = 0.02
MARGIN_M = 0.011
AWAY = (1.2, *HOME[1:])
PILLAR = box("pillar", (0.1, 0.1, 2.6), Pose(tip_pose(kr120(), (0.6, *HOME[1:])).position_m))
SCENE = one_arm(PILLAR)
SEARCH: SearchScene = SearchScenes(ProofScenes()).of(SCENE, MARGIN_M, (A,))


def space() -> SearchSpace:
    joints = SCENE.robots[A].description.movable_joints
    limits = tuple(j.lower_rad for j in joints), tuple(j.upper_rad for j in joints)
    return SearchSpace(SEARCH, SCENE, {A: limits}, STEP_RAD)


def seconds(path: list[Array]) -> float:
    """Time along the path, with half a second for each stop at a corner."""
    return sum(space().duration_s(a, b) for a, b in pairwise(path)) + 0.5 * len(path)


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_a_path_around_a_pillar_gets_quicker_and_stays_free(seed: int) -> None:
    ends = np.array(HOME), np.array(AWAY)
    path = found_path(space(), ends[0], [ends[1]], max_lines=4000, seed=seed)
    assert path is not None
    assert len(path) > 2
    found = quicker(space(), path, seed)
    assert np.array_equal(found[0], ends[0])
    assert np.array_equal(found[-1], ends[1])
    assert seconds(found) <= seconds(path)
    for a, b in pairwise(found):
        for share in np.linspace(0.0, 1.0, int(np.ceil(np.linalg.norm(b - a) / STEP_RAD)) + 1):
            assert not SEARCH.is_hit(a + share * (b - a))
    again = quicker(space(), path, seed)
    assert all(np.array_equal(a, b) for a, b in zip(found, again, strict=True))


def test_corners_that_nothing_asks_for_are_left_out() -> None:
    start, end = np.array(HOME), np.array((-0.8, *HOME[1:]))
    detour = [start, start + 0.2, end + 0.1, end]
    assert [q.tolist() for q in quicker(space(), detour, seed=0)] == [start.tolist(), end.tolist()]


def test_a_line_is_looked_at_between_its_ends() -> None:
    start, end = np.array(HOME), np.array(AWAY)
    assert not SEARCH.is_hit(start)
    assert not SEARCH.is_hit(end)
    assert SEARCH.is_hit_between(start, end, STEP_RAD)
    assert not SEARCH.is_hit_between(start, start, STEP_RAD)


def test_a_free_line_is_looked_at_in_every_step() -> None:
    """What stands in the way for one step only is found, wherever it is."""
    scenes = SearchScenes(ProofScenes())
    for share in np.random.default_rng(3).uniform(0.05, 0.95, 12):
        there = (1.2 * float(share), *HOME[1:])
        fin = box("fin", (0.02, 0.02, 0.02), Pose(tip_pose(kr120(), there).position_m))
        search = scenes.of(one_arm(fin), 0.0, (A,))
        assert search.is_hit_between(np.array(HOME), np.array(AWAY), STEP_RAD)
