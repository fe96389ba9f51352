"""What a page says that a run does, and why it asks anew."""

from __future__ import annotations

import pytest

from builders_words import CALLS, STUD
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.events import ApprovalRejected, ProposalMade, StepSummary
from sitewright.central_controller.site_state import Rejection, SiteState
from sitewright.interaction_twin.state_document import Phase, Standing, asked_plan, phase_of

PLAN = "f" * 64
STEPS = tuple(
    StepSummary(number=n, call=c, duration_s=1.0, trajectories=0, closest_distance_m=None)
    for n, c in enumerate(CALLS, start=1)
)
MADE = ProposalMade(fingerprint=PLAN, target=STUD, site_serial=0, steps=STEPS)


def open_plan() -> CycleState:
    return CycleState(site=SiteState(), proposal=MADE, epoch=1)


@pytest.mark.parametrize(
    ("asks", "phase"),
    [
        ("", Phase.PLANNING),
        (asked_plan("0" * 64, 1), Phase.PLANNING),
        (asked_plan(PLAN, 2), Phase.PLANNING),
        (asked_plan(PLAN, 1), Phase.WAITING),
    ],
)
def test_a_plan_waits_for_a_person_once_an_answer_would_be_heard(asks: str, phase: Phase) -> None:
    assert phase_of(open_plan(), Standing(is_active=True, asks=asks)) is phase


@pytest.mark.parametrize("reason", ["wrong-robot", "path-unsafe", "site-differs", "other"])
def test_the_plan_after_a_no_says_who_said_no(reason: str) -> None:
    no = Rejection(fingerprint=PLAN, target=STUD, reason=reason, detail="too near the door")
    state = folded(open_plan(), ApprovalRejected(who="olga", rejection=no))
    assert state.proposal is None
    assert state.why.startswith("olga ")
    assert "too near the door" in state.why


def test_who_only_wants_another_motion_has_said_nothing_against_the_one_before() -> None:
    no = Rejection(fingerprint=PLAN, target=STUD, reason="path-unsafe", step=2)
    wish = DecisionRecord(key="k", body_sha256="", verb="new-motion", role="operator", session="s")
    state = folded(open_plan(), ApprovalRejected(who="olga", rejection=no, decision=wish))
    assert state.why == "olga asked for another motion."
