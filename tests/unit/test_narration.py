"""Skill calls in plain words."""

from __future__ import annotations

from pathlib import Path

import pytest

from builders_words import CALLS, LABELS, STUD, A, B, proposal, request
from sitewright.app.project import open_project
from sitewright.central_controller.ports import Alternative, RefusalNote
from sitewright.central_controller.statuses import where_it_fell
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.labels import Kind, Label, Labels, labels_of
from sitewright.interaction_twin.languages import PHRASEBOOKS
from sitewright.interaction_twin.measures import in_millimetres, in_seconds
from sitewright.interaction_twin.narration import ARGUMENT_NAMES, folded, narrate, reason
from sitewright.interaction_twin.proposal_view import (
    alternative_lines,
    plan_lines,
    proposal_view,
    view_of,
)
from sitewright.interaction_twin.text_gantt import text_gantt
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.vocabulary import built_in_domain

EXAMPLE = Path(__file__).parents[2] / "examples" / "wooden_frame"


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (CALLS[1], "kr120-a goes to the stock place pallet"),
        (CALLS[2], "kr120-a takes piece thin.5 from pallet with gripper-s"),
        (CALLS[4], "kr120-a goes to where Transverse stud 1 belongs"),
        (
            CALLS[5],
            "kr120-a puts piece thin.5 in place as Transverse stud 1 and keeps holding it",
        ),
        (CALLS[7], "kr120-b drives nail 1 of Transverse stud 1 with nailer"),
        (CALLS[11], "kr120-a lets go of Transverse stud 1"),
        (
            SkillCall("change-end-effector", B, ("nailer", "painter", "tools-b")),
            "kr120-b puts away nailer and takes up painter at tools-b",
        ),
        (
            SkillCall("change-end-effector", B, ("bare-kr120-b", "painter", "tools-b")),
            "kr120-b takes up painter at tools-b",
        ),
        (
            SkillCall("apply-finish", B, ("p1", STUD, "painter")),
            "kr120-b paints face 1 of Transverse stud 1 with painter",
        ),
        (SkillCall("retract", A, ("home-a",)), "kr120-a leaves its waiting place"),
    ],
)
def test_each_skill_has_its_sentence(call: SkillCall, words: str) -> None:
    assert narrate(call, LABELS) == words


@pytest.mark.parametrize("language", sorted(PHRASEBOOKS))
@pytest.mark.parametrize("skill", list(Skill))
def test_no_built_in_skill_is_left_without_words(skill: Skill, language: str) -> None:
    book = PHRASEBOOKS[language]
    arguments = tuple(f"x{n}" for n in range(len(ARGUMENT_NAMES[skill])))
    words = narrate(SkillCall(skill, A, arguments), LABELS, book)
    assert words.startswith("kr120-a ")
    assert "(" not in words
    assert "{" not in words


def test_the_arguments_of_the_templates_are_those_of_the_domain() -> None:
    actions = built_in_domain().actions
    assert {a.name for a in actions} == set(ARGUMENT_NAMES)
    for action in actions:
        assert len(action.parameters) - 1 == len(ARGUMENT_NAMES[action.name]), action.name


def test_an_unknown_skill_is_spelled_out_and_never_hidden() -> None:
    assert narrate(SkillCall("weld", A, ("mat-066",)), LABELS) == "kr120-a weld(kr120-a, mat-066)"
    odd = SkillCall("grasp", A, ("mat-066",))
    assert narrate(odd, LABELS) == "kr120-a grasp(kr120-a, mat-066)"


def test_an_id_without_label_is_its_own_name() -> None:
    call = SkillCall("release", A, ("stud-99",))
    assert narrate(call, LABELS) == "kr120-a lets go of stud-99"


def test_runs_fold_and_numbers_stay() -> None:
    runs = folded(list(enumerate(CALLS, start=1)), LABELS)
    assert [(r.first, r.last, r.robot, r.words) for r in runs] == [
        (3, 3, "kr120-a", "takes piece thin.5 from pallet with gripper-s"),
        (6, 6, "kr120-a", "puts piece thin.5 in place as Transverse stud 1 and keeps holding it"),
        (7, 11, "kr120-b", "drives 2 nails into Transverse stud 1"),
        (12, 12, "kr120-a", "lets go of Transverse stud 1"),
    ]


def test_nails_before_and_after_another_act_are_two_runs() -> None:
    calls = [CALLS[7], CALLS[11], CALLS[10]]
    runs = folded(list(enumerate(calls, start=1)), LABELS)
    assert [r.words for r in runs] == [
        "drives 1 nail into Transverse stud 1",
        "lets go of Transverse stud 1",
        "drives 1 nail into Transverse stud 1",
    ]


def test_a_reason_names_the_robot_that_waits() -> None:
    steps = proposal().steps
    assert reason(steps, 5, LABELS) == "because kr120-b needs Transverse stud 1 in place"
    assert reason(steps, 1, LABELS) == ""


def test_labels_come_from_the_names_of_the_model() -> None:
    project = open_project(EXAMPLE)
    labels = labels_of(project.model, project.cell)
    assert labels.name("stud-1") == "Transverse stud 1"
    assert labels.label("stud-1.nail-2").name == "nail 2"
    assert labels.label("stud-1.nail-2").of == "stud-1"
    assert labels.label("thin.5").kind is Kind.PIECE
    assert labels.label("kr120-b").kind is Kind.ROBOT
    fallen = SkillCall("reach", A, (where_it_fell(ComponentId("thin.5")),))
    assert narrate(fallen, labels) == "Robot 1 goes to where thin 5 lies"
    assert labels.name("assembly-table") == "assembly table"
    assert labels.name("walkway") == "walkway", "without a name of its own"
    taken = SkillCall("grasp", A, ("thin.5", "pallet-thin", "gripper-s"))
    assert narrate(taken, labels) == "Robot 1 takes piece thin 5 from pallet 2 with gripper"


def test_a_reason_of_the_controller_is_told_with_names() -> None:
    project = open_project(EXAMPLE)
    labels = labels_of(project.model, project.cell)
    told = labels.told("stud-1: kr120-b cannot drive stud-1.nail-2 into stud-1. 4 mm, stud-10")
    assert told == (
        "Transverse stud 1: Robot 2 cannot drive nail 2 of Transverse stud 1 into "
        "Transverse stud 1. 4 mm, stud-10"
    )
    numbered = Labels({"4": Label(Kind.COMPONENT, "block")})
    assert numbered.told("4 is 4 mm off") == "4 is 4 mm off", "digits may be a figure"


def test_a_plan_is_shown_with_code_times_and_what_was_refused() -> None:
    note = RefusalNote(target=STUD, kind="NoIk", reason="too far", is_proven=True)
    view = proposal_view(request(refusals=[note], why="the site changed"), LABELS)
    text = "\n".join(plan_lines(view))
    assert text.startswith("Plan for Transverse stud 1: 12 steps, 24.0 s, closest distance -")
    assert "Check code 7KQ2-M9TD" in text
    assert "drives 2 nails into Transverse stud 1" in text
    assert "Refused on the way: Transverse stud 1: too far (NoIk, proven impossible)" in text
    assert view.why == "the site changed"
    for number in range(1, 13):
        assert f" {number} " in text


def test_steps_that_are_done_are_marked_and_do_not_count_in_the_time() -> None:
    view = proposal_view(request(next_step=11), LABELS)
    assert [s.number for s in view.steps if s.is_done] == list(range(1, 11))
    assert view.duration_s == pytest.approx(4.0)


def test_other_ways_show_their_price_and_where_they_lead() -> None:
    ways = [
        Alternative(call=CALLS[2], price_s=12.0),
        Alternative(call=CALLS[7], leads_nowhere=True, note="nobody can hold the stud"),
        Alternative(call=CALLS[11], note="not priced"),
    ]
    lines = alternative_lines(ways, LABELS)
    assert lines[0].endswith("  +12 s")
    assert lines[1].endswith("  -- leads nowhere: nobody can hold the stud")
    assert lines[2].endswith("  (not priced)")


def test_a_schedule_in_text_has_a_row_per_robot_and_every_step_in_it() -> None:
    lines = text_gantt(view_of(proposal(), LABELS).steps, width=48)
    assert len(lines) == 3
    assert "111122223333444455556666" in lines[0]
    assert lines[1].strip().startswith("kr120-b  ........................7777")
    assert lines[2].endswith("24.0 s")


@pytest.mark.parametrize(
    ("value_s", "words"),
    [(8.24, "8.2 s"), (59.94, "59.9 s"), (59.96, "1 min 00 s"), (92.0, "1 min 32 s")],
)
def test_times_are_read_aloud_easily(value_s: float, words: str) -> None:
    assert in_seconds(value_s) == words


@pytest.mark.parametrize(
    ("value_m", "words"), [(None, "-"), (0.0389, "38 mm"), (0.012, "12 mm"), (-0.001, "touching")]
)
def test_distances_are_never_rounded_up(value_m: float | None, words: str) -> None:
    assert in_millimetres(value_m) == words
