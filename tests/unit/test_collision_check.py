"""Pairs that are too near in one posture: the quick answer and the named one are the same."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from motion_scenes import HOME, A, box, held_stud, kr120, one_arm, two_arms
from sitewright.foundation.pose import Pose, translation
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.collision_check import OFF_M, CoalCollisionCheck
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.motion import JointPath, PathSegment
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.kinematics import tip_pose

PAIR = ("block", "held")
BY_DESIGN = {("a/link_5", "held"): OFF_M, ("a/link_4", "held"): OFF_M}
PROOFS = ProofScenes()
CHECK = CoalCollisionCheck(PROOFS)
MARGIN_M = 2e-4
"""The engine's own reserve and error are far below this."""


def block_above_stud(gap_m: float) -> SceneSnapshot:
    """A block over the end of the held stud, along its normal."""
    at_stud = tip_pose(kr120(), HOME) @ held_stud().placement.tip_T_body  # type: ignore[union-attr]
    block = box("block", (0.1, 0.05, 0.04), at_stud @ translation(0.7, 0.0, -(0.04 + gap_m)))
    return one_arm(held_stud(), block)


@settings(max_examples=60, deadline=None)
@given(
    gap_m=st.floats(-0.005, 0.03),
    threshold_m=st.none() | st.floats(-0.003, 0.05) | st.just(OFF_M),
)
def test_a_pair_is_too_near_if_its_gap_is_under_its_threshold(
    gap_m: float, threshold_m: float | None
) -> None:
    scene = block_above_stud(gap_m)
    declared = dict(BY_DESIGN) if threshold_m is None else {**BY_DESIGN, PAIR: threshold_m}
    needed_m = scene.clearance_m if threshold_m is None else threshold_m
    found = CHECK.violations(scene, A, HOME, declared)
    assert CHECK.is_clear(scene, A, HOME, declared) == (not found)
    if abs(gap_m - needed_m) > MARGIN_M:
        assert found == ((PAIR,) if gap_m < needed_m else ())


def test_thresholds_of_one_question_do_not_stay_for_the_next() -> None:
    check, scene = CHECK, block_above_stud(0.005)
    for declared, is_clear in [
        (BY_DESIGN, False),
        ({**BY_DESIGN, PAIR: 0.001}, True),
        (BY_DESIGN, False),
        ({**BY_DESIGN, PAIR: OFF_M}, True),
        ({**BY_DESIGN, PAIR: 0.007}, False),
        ({**BY_DESIGN, PAIR: -0.001}, True),
        ({}, False),
    ]:
        assert check.is_clear(scene, A, HOME, declared) is is_clear
    assert not check.is_clear(block_above_stud(-0.002), A, HOME, {**BY_DESIGN, PAIR: -0.001})


def test_the_quick_answer_is_the_certifier_s_in_random_postures() -> None:
    scene, certifier = two_arms(held_stud()), ConservativeAdvancement(PROOFS)
    contacts = {
        ("held", "table"): -0.001,
        ("held", "support-1"): 0.001,
        ("gripper", "table"): OFF_M,
    }
    answers = Counter[bool]()
    for number, q in enumerate(np.random.default_rng(7).uniform(-2.0, 2.0, (300, 6)).tolist()):
        here = replace(scene, clearance_m=0.02) if number % 3 else scene
        declared = contacts if number % 2 else {}
        standing = PathSegment(waypoints_rad=(tuple(q),) * 2, threshold_m=declared)
        objection = certifier.objection(here, JointPath(robot=A, segments=(standing,)))
        answers[objection is None] += 1
        assert CHECK.is_clear(here, A, tuple(q), declared) == (objection is None)
        assert bool(CHECK.violations(here, A, tuple(q), declared)) == (objection is not None)
    assert min(answers[True], answers[False]) > 30


def test_what_other_robots_do_does_not_count() -> None:
    """A post in the other arm's hand's way is that arm's business."""
    scene = two_arms()
    hand = scene.robots[A].world_T_base @ tip_pose(kr120(), HOME)
    crowded = scene.with_body(box("post", (0.2, 0.2, 0.2), Pose(hand.position_m)))
    check = CHECK
    other = next(r for r in scene.robots if r != A)
    assert not check.is_clear(crowded, A, HOME, {})
    assert check.is_clear(crowded, other, HOME, {}) == check.is_clear(scene, other, HOME, {})
