"""Seeded frames: what is drawn by lot is built, or refused with a reason."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from builders_held import frame_of_one_stud, stud_of_frame
from builders_random_frames import random_frame
from independent_holding import held_check
from independent_reach import matrix, unreachable
from sitewright.app.planning import plan_project
from sitewright.foundation.ids import ComponentId
from sitewright.robot_team.gripper import mount_T_tcp as gripper_tcp


def test_a_stud_with_a_near_and_a_far_nail_is_held_in_the_one_way_that_lets_both_be_driven() -> (
    None
):
    """One nail at each end, both to be driven while it is held: few of the ways to hold it serve.

    Of 182 grasps those that serve come late; a search in strides passes over them.
    """
    report = plan_project(random_frame(16), target="stud-1")
    assert report.escalated == ()
    stud = report.planned[-1].proposal
    assert stud.target == "stud-1"
    skills = [s.call.skill for s in stud.steps]
    held = skills[skills.index("position") : skills.index("release")]
    assert held.count("fasten") == 2


def test_what_is_called_impossible_is_out_of_reach_by_a_check_that_shares_no_code() -> None:
    """The nailer stands 0.35 m too far off: some far nails are out of its reach, by millimetres."""
    project = random_frame(3, nailer_away_m=0.35)
    report = plan_project(project)
    impossible = {e.target for e in report.escalated if e.is_proven}
    assert impossible == {"stud-1", "stud-3"}
    assert {e.target for e in report.escalated} == impossible
    assert all(unreachable(project, t) for t in impossible)
    assert {p.proposal.target for p in report.planned} == {"support-1", "support-2", "stud-2"}
    assert unreachable(project, ComponentId("stud-2")) is None


def test_a_stud_that_its_holder_is_in_the_way_of_is_impossible_by_a_check_that_shares_no_code() -> (
    None
):
    """Own kinematics, all postures anew, distances by MuJoCo: nothing that might move is in it."""
    project, target = frame_of_one_stud(7), ComponentId("stud-1")
    report = plan_project(project)
    (refused,) = report.escalated
    assert refused.is_proven
    assert refused.verdict == "proven impossible"
    assert "since kr120-a, which holds it, is in the way of stud-1.nail-1" in refused.reason
    assert "let go of stud-1 with fewer fasteners driven" in refused.reason
    assert [c.words for c in refused.counter_proposals] == [
        "let go of stud-1 with 1 of its fasteners driven"
    ]
    found = held_check(project, target, quarter_turns=False)
    assert found.is_impossible
    assert found.ways == 468
    assert found.posts > 100


def test_grasp_by_grasp_a_proof_says_what_the_check_that_shares_no_code_says() -> None:
    """Frame 16 looks the same and has a few ways out: every tenth of its grasps is looked at."""
    project, stud = frame_of_one_stud(16), stud_of_frame(16)
    found = held_check(project, ComponentId("stud-1"), every=10)
    assert not found.is_impossible
    assert 0 < sum(serves for _, serves in found.grasps) < len(found.grasps) / 4
    mount_T_tcp = gripper_tcp(stud.gripper.description)
    ours = [matrix(g.piece_T_tcp @ mount_T_tcp.inverse()) for g in stud.grasps]
    for piece_T_tip, serves in found.grasps:
        (same,) = (k for k, g in enumerate(ours) if np.abs(g - piece_T_tip).max() < 1e-9)
        alone = replace(stud, grasps=stud.grasps[same : same + 1])
        assert (alone.proof() is None) is serves, stud.grasps[same]
