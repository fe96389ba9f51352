"""Rejections become constraints of the next plan."""

from __future__ import annotations

from dataclasses import replace

from sitewright.central_controller.site_state import Rejection
from sitewright.central_controller.wishes import (
    another_seed,
    detours,
    put_off,
    wanted_pieces,
    without_refused_robots,
)
from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.site_view import GeometricFacts

STUD, THIN_1, THIN_2 = (ComponentId(i) for i in ("stud-1", "thin-1", "thin-2"))
A, B = RobotId("a"), RobotId("b")
GRASP = SkillCall(Skill.GRASP, A, (THIN_1, "pallet", "gripper"))


def rejected(reason: str, *, step: int = 1) -> Rejection:
    return Rejection(fingerprint="f", target=STUD, reason=reason, step=step, calls=(GRASP,))


def test_a_piece_refused_as_the_wrong_component_is_not_offered_again() -> None:
    assert wanted_pieces([THIN_1, THIN_2], [rejected("wrong-component")]) == [THIN_2]
    assert wanted_pieces([THIN_1, THIN_2], [rejected("path-unsafe")]) == [THIN_1, THIN_2]


def test_each_unsafe_path_asks_for_another_seed() -> None:
    once = another_seed(0, STUD, [rejected("path-unsafe")])
    twice = another_seed(0, STUD, [rejected("path-unsafe")] * 2)
    assert len({0, once, twice}) == 3
    assert another_seed(0, ComponentId("stud-2"), [rejected("path-unsafe")]) == 0


def test_a_target_wanted_later_is_put_off() -> None:
    assert put_off([rejected("later"), rejected("other")]) == {STUD}


def test_a_robot_refused_for_a_step_loses_that_fact_alone() -> None:
    tool = EndEffectorId("gripper")
    facts = GeometricFacts(
        can_grasp=frozenset({(A, tool, THIN_1), (A, tool, THIN_2), (B, tool, THIN_1)})
    )
    left = without_refused_robots(facts, STUD, [rejected("wrong-robot")])
    assert left.can_grasp == {(A, tool, THIN_2), (B, tool, THIN_1)}
    assert without_refused_robots(facts, STUD, [rejected("wrong-robot", step=0)]) == facts


def test_a_call_goes_another_way_as_often_as_its_way_was_called_unsafe() -> None:
    of_step = replace(rejected("path-unsafe"), step=1)
    (call,) = of_step.calls
    assert detours(STUD, [of_step, of_step]) == {call: 2}
    assert detours(ComponentId("stud-2"), [of_step]) == {}
    whole = replace(of_step, step=0)
    assert detours(STUD, [whole]) == {}  # another seed comes first
    assert detours(STUD, [whole], everywhere=1) == {call: 1}
    assert detours(STUD, [replace(of_step, reason="wrong-robot")]) == {}
