"""Why a step is as it is, in words and as a document."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from builders_words import LABELS, STUD, A, B, step
from sitewright.central_controller.causes import causal_links
from sitewright.central_controller.choosing import PieceOnSite
from sitewright.central_controller.doers import Doer
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.canonical import canonical_json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.interaction_twin.step_document import step_document
from sitewright.interaction_twin.step_reasons import Stance, StepReasons
from sitewright.interaction_twin.step_words import explanation
from sitewright.robot_team.skill import SkillCall

PIECE = ComponentId("thin.5")
IN_PLACE = "(in-place thin.5 stud-1)"
STEPS = (
    step(1, SkillCall("reach", A, ("pallet",)), effects=["(at kr120-a pallet)"]),
    step(
        2,
        SkillCall("grasp", A, (PIECE, "pallet", "gripper-s")),
        relies_on=["(at kr120-a pallet)", "(hand-empty kr120-a)", "(accessible thin.5)"],
        effects=["(holding kr120-a thin.5)", "(not (hand-empty kr120-a))"],
    ),
    step(
        3,
        SkillCall("position", A, (PIECE, STUD)),
        relies_on=["(holding kr120-a thin.5)"],
        effects=[IN_PLACE, "(positioned stud-1)", "(not (holding kr120-a thin.5))"],
    ),
    step(
        4,
        SkillCall("fasten", B, ("n1", STUD, "nailer")),
        relies_on=["(positioned stud-1)", "(not (standing stud-1))"],
        effects=["(fastened n1)"],
    ),
)
ABLE = Doer(robot=A, can_by="grasping, gripper-s holds 90 x 40 mm", obstacles=())
UNABLE = Doer(robot=B, can_by="", obstacles=("it is not made for grasping",))


def note(reason: str) -> RefusalNote:
    return RefusalNote(target=STUD, kind="NoIk", reason=reason, is_proven=True)


def reasons(number: int, **more: object) -> StepReasons:
    found = StepReasons(
        run="0001-ab",
        fingerprint="f" * 64,
        target=STUD,
        steps=STEPS,
        number=number,
        status="open",
        links=causal_links(STEPS),
        act=STEPS[number - 1].call,
        doers=(ABLE, UNABLE),
    )
    return replace(found, **more)  # type: ignore[arg-type]


def said(about: StepReasons) -> str:
    return "\n".join(explanation(about, LABELS))


def test_a_step_says_who_needs_it_what_it_is_for_and_what_makes_it_possible() -> None:
    text = said(reasons(2))
    assert text.startswith("Step 2 of 4 of the plan for Transverse stud 1: open\n")
    assert "kr120-a takes piece thin.5 from pallet with gripper-s." in text
    assert "thin.5 in its gripper: needed by step 3, kr120-a puts piece thin.5 in place" in text
    assert "kr120-a at pallet: brought about by step 1, kr120-a goes to the stock place" in text
    assert "an empty hand: so it was before the plan" in text
    assert "what the design asks for" not in text


def test_what_the_design_asks_for_is_told_from_what_only_stays() -> None:
    text = said(reasons(3))
    assert "thin.5 in place as Transverse stud 1: what the design asks for" in text
    assert "Transverse stud 1 in place: so it stays to the end of the plan" in text


def test_a_long_way_to_what_is_asked_for_is_told_with_its_steps() -> None:
    assert "it leads to step 3, kr120-a puts piece thin.5 in place" in said(reasons(1))
    assert "(by way of 2)" in said(reasons(1))
    assert "it leads to" not in said(reasons(2))


def test_a_fact_that_must_not_hold_is_said_as_such() -> None:
    assert "not Transverse stud 1 standing by itself: so it was before the plan" in said(reasons(4))


def test_the_other_robots_are_told_with_their_obstacles_or_that_they_could() -> None:
    text = said(reasons(2))
    assert "it does grasping, gripper-s holds 90 x 40 mm" in text
    assert "not kr120-b: it is not made for grasping" in text
    free = replace(UNABLE, obstacles=())
    assert "kr120-b might do it too" in said(reasons(2, doers=(ABLE, free)))


def on_site(name: str, distance_m: float, *under: str) -> PieceOnSite:
    return PieceOnSite(
        piece=ComponentId(name), distance_m=distance_m, under=tuple(map(ComponentId, under))
    )


@pytest.mark.parametrize(
    ("pieces", "words"),
    [
        ((), "it is in hand, or in place, already"),
        ((on_site("thin.5", 1.5),), "the only one that could be taken: 1.50 m"),
        ((on_site("thin.5", 1.5), on_site("x", 2.0)), "further away: x (2.00 m)"),
        ((on_site("x", 1.0), on_site("thin.5", 1.5)), "nearer ones were refused or not wanted"),
        ((on_site("x", 1.0, "thin.5"), on_site("thin.5", 1.5)), "under others: x"),
        ((on_site("x", 1.0),), "it is moved out of the way"),
    ],
)
def test_why_this_piece_is_told_with_the_others(
    pieces: tuple[PieceOnSite, ...], words: str
) -> None:
    assert words in said(reasons(2, piece=PIECE, pieces=pieces))


def test_how_a_tool_leans_and_where_a_gripper_holds_is_told() -> None:
    leaning = Stance(world_T_tcp=Pose(), lean_rad=math.radians(2.5))
    assert "the tool leans 2.5 degrees" in said(reasons(4, stance=leaning))
    upright = Stance(world_T_tcp=Pose(), lean_rad=0.0)
    assert "the tool stands upright on it" in said(reasons(4, stance=upright))
    grip = Stance(world_T_tcp=Pose(), from_middle_m=-0.2, from_above_rad=math.radians(30.0))
    text = said(reasons(2, stance=grip))
    assert "the gripper holds the piece 200 mm from its middle, 30.0 degrees from" in text


def test_refusals_about_the_step_come_before_those_of_others_and_none_is_left_out() -> None:
    mine, other = note("kr120-b cannot take thin.5: too far"), note("kr120-b cannot reach n1: no")
    lines = explanation(reasons(2, piece=PIECE, refusals=(other, mine)), LABELS)
    first, second = (f"  {LABELS.told(n.reason)}" for n in (mine, other))  # with names, no ids
    assert lines.index(first) < lines.index(second)
    assert "  nothing was refused on the way to this plan" not in lines
    assert "  nothing was refused on the way to this plan" in explanation(reasons(2), LABELS)


def test_the_document_says_the_same_in_ids_and_is_plain_json() -> None:
    document = step_document(reasons(2, piece=PIECE, refusals=(note("thin.5: no"),)))
    assert document["needed_by"] == [{"fact": "(holding kr120-a thin.5)", "step": 3}]
    assert {"fact": "(accessible thin.5)", "step": 0} in document["made_possible_by"]  # type: ignore[operator]
    assert document["leads_to"] == [2, 3]
    told = document["refusals"][0]  # type: ignore[index]
    assert told == {
        "kind": "NoIk",
        "reason": "thin.5: no",
        "is_proven": True,
        "verdict": "proven impossible",
        "then": "",
    }
    assert canonical_json(document)
