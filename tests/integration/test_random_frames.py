"""Seeded frames: what is drawn by lot is built, or refused with a reason."""

from __future__ import annotations

from builders_random_frames import random_frame
from sitewright.app.planning import plan_project


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
