"""A refusal says how sure it is: proven, blocked by something, or not found."""

from __future__ import annotations

import pytest

from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import (
    RefusalMet,
    TargetRefused,
    event_from_json,
    event_to_json,
)
from sitewright.central_controller.ports import PUT_OFF, CounterProposal, Escalation, RefusalNote
from sitewright.central_controller.site_fold import site_after
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.labels import Kind, Label, Labels
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.trouble_document import trouble_document
from sitewright.planning_twin.refusal import (
    BlockedBy,
    Disagreement,
    NoIk,
    NotClear,
    Refusal,
    pair_of,
)

TARGET = ComponentId("stud-1")
PAIR = ("kr120-a/link_5", "thin.1")


@pytest.mark.parametrize(
    ("kind", "is_proven", "blockers", "verdict"),
    [
        ("NoIk", True, (), "proven impossible"),
        ("PayloadExceeded", True, (), "proven impossible"),
        ("NoIk", False, (), "not found within budget"),
        ("NoPath", False, (), "not found within budget"),
        ("NoGrasp", False, (), "not found within budget"),
        ("BlockedBy", False, ("thin.1",), "blocked by thin.1"),
        ("NotClear", False, ("thin.1", "kr120-b"), "blocked by thin.1 and kr120-b"),
        (PUT_OFF, False, (), "a person's wish"),
    ],
)
def test_a_note_says_one_of_three_things_unless_a_person_put_the_target_off(
    kind: str, blockers: tuple[str, ...], verdict: str, *, is_proven: bool
) -> None:
    note = RefusalNote(
        target=TARGET, kind=kind, reason="no", is_proven=is_proven, blockers=blockers
    )
    assert note.verdict == verdict


def test_a_proof_says_more_than_what_is_in_the_way() -> None:
    refused = Escalation(target=TARGET, reason="no", is_proven=True, blockers=("thin.1",))
    assert refused.verdict == "proven impossible"


def test_what_a_person_is_asked_holds_what_was_tried_on_a_copy_and_works() -> None:
    refused = TargetRefused(
        target=TARGET,
        reason="thin.1 is in its place",
        is_proven=False,
        exit_code=6,
        blockers=("thin.1",),
        counter_proposals=(CounterProposal(words="take thin.1 away", steps=9, duration_s=11.5),),
    )
    stored = event_from_json(refused.kind, refused.version, event_to_json(refused))
    assert stored == refused
    state = CycleState(site=site_after(SiteState(targets=(TARGET,)), stored))
    history = [Stamped(at_utc_ns=1, event=stored)]
    (asked,) = trouble_document(state, history, Labels(label_by_id={}))
    assert isinstance(asked, dict)
    assert asked["verdict"] == "blocked by thin.1"
    assert asked["counter_proposals"] == [
        {"words": "take thin.1 away", "steps": 9, "duration_s": 11.5}
    ]


def test_what_a_person_is_asked_names_what_is_in_the_way_and_shows_no_id() -> None:
    refused = TargetRefused(
        target=TARGET,
        reason="thin.1 is in the way of stud-1.",
        is_proven=False,
        exit_code=6,
        blockers=("thin.1", "arm-7/link_3"),
        counter_proposals=(CounterProposal(words="take thin.1 away", steps=9, duration_s=11.5),),
    )
    state = CycleState(site=site_after(SiteState(targets=(TARGET,)), refused))
    labels = Labels(
        label_by_id={
            "stud-1": Label(Kind.COMPONENT, "Left stud"),
            "thin.1": Label(Kind.COMPONENT, "Thin board"),
            "arm-7": Label(Kind.ROBOT, "North arm"),
        }
    )
    (asked,) = trouble_document(state, [Stamped(at_utc_ns=1, event=refused)], labels)
    assert isinstance(asked, dict)
    assert asked["name"] == "Left stud"
    assert asked["reason"] == "Thin board is in the way of Left stud."
    assert asked["verdict"] == "blocked by Thin board and North arm"
    assert asked["blocker_names"] == ["Thin board", "North arm"]
    assert asked["counter_proposals"] == [
        {"words": "take Thin board away", "steps": 9, "duration_s": 11.5}
    ]


@pytest.mark.parametrize(
    ("refusal", "pair"),
    [
        (BlockedBy(pairs=(("kr120-a/link_5", "thin.1"), ("table", "thin.1"))), PAIR),
        (BlockedBy(pairs=()), ()),
        (NotClear(pair=PAIR, q_rad=(), distance_m=0.0, threshold_m=0.01, segment=3), PAIR),
        (Disagreement(pair=PAIR, q_rad=(), distance_m=0.0, threshold_m=0.01), PAIR),
        (NoIk(is_proven=True), ()),
    ],
)
def test_a_refusal_for_nearness_tells_which_two_come_too_near(
    refusal: Refusal, pair: tuple[str, ...]
) -> None:
    assert pair_of(refusal) == pair


def test_what_needs_help_shows_the_pair_that_was_met_last() -> None:
    def met(*pair: str) -> Stamped:
        note = RefusalNote(target=TARGET, kind="BlockedBy", reason="", is_proven=False, pair=pair)
        event = RefusalMet(refusal=note)
        stored = event_from_json(event.kind, event.version, event_to_json(event))
        return Stamped(at_utc_ns=1, event=stored)

    refused = TargetRefused(target=TARGET, reason="no", is_proven=False, exit_code=6)
    state = CycleState(site=site_after(SiteState(targets=(TARGET,)), refused))
    end = Stamped(at_utc_ns=2, event=refused)
    (entry,) = trouble_document(state, [met("table", "thin.9"), met(*PAIR), met(), end], Labels())
    assert isinstance(entry, dict)
    assert entry["pair"] == list(PAIR)
    (entry,) = trouble_document(state, [met(), end], Labels())
    assert isinstance(entry, dict)
    assert entry["pair"] is None


def test_a_journal_of_before_has_no_pair() -> None:
    note = RefusalNote(target=TARGET, kind="NoIk", reason="no", is_proven=True)
    document = event_to_json(RefusalMet(refusal=note))
    assert isinstance(document, dict)
    told = document["refusal"]
    assert isinstance(told, dict)
    del told["pair"]
    assert event_from_json("refusal_met", 1, document) == RefusalMet(refusal=note)
