"""What a reach answer means for each target."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from sitewright.building_model.component import FastenerSpec, Process
from sitewright.foundation.ids import ComponentId, EndEffectorId, OperationId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.reachability.answer import (
    GraspWay,
    Handling,
    Operating,
    ReachAnswer,
    Refused,
    Steadying,
)
from sitewright.planning_twin.reachability.question import ReachQuestion, ReachTarget
from sitewright.planning_twin.reachability.verdict import (
    Standing,
    TargetVerdict,
    share_of,
    verdicts,
)
from sitewright.planning_twin.refusal import BlockedBy, NoIk, PayloadExceeded, Refusal
from sitewright.planning_twin.task import Task
from sitewright.robot_team.cell import Cell

A, B = RobotId("a"), RobotId("b")
WAY = GraspWay(face="+z", pitch_deg=0.0, is_turned=False, offset_m=0.0)
FAR = NoIk(is_proven=True, extension_m=0.3)
BLOCKED = BlockedBy(pairs=(("gripper", "fence"),))
EMPTY_CELL = Cell(robot_by_id={}, end_effector_by_id={})


def target(name: str, number: int = 0, *, waits_for: tuple[str, ...] = (), nails: int = 0) -> Any:
    spots = tuple(
        Spot(
            operation=OperationId(f"{name}.nail-{k}"),
            process=Process.NAIL,
            target=ComponentId(name),
            world_T_operation=Pose(),
            fastener=FastenerSpec(type="nail", d_m=0.003, l_m=0.07),
        )
        for k in range(nails)
    )
    task = Task(
        target=ComponentId(name), world_T_target=Pose(), candidates=(), touches=(), spots=spots
    )
    return ReachTarget(
        number=number,
        shape=PieceShape(shape=(), size_m=(1.0, 0.1, 0.1), mass_kg=5.0),
        task=task,
        waits_for=tuple(ComponentId(w) for w in waits_for),
    )


def handling(robot: RobotId, name: str, refusal: Refusal | None = None, **more: Any) -> Handling:
    return Handling(
        robot=robot,
        end_effector=EndEffectorId("gripper"),
        target=ComponentId(name),
        piece=None,
        ways=() if refusal else (WAY,),
        refused=Refused(where="target", refusal=refusal) if refusal else None,
        **more,
    )


def operating(robot: RobotId, name: str, refusal: Refusal | None = None) -> Operating:
    return Operating(
        robot=robot,
        end_effector=EndEffectorId("gun"),
        target=ComponentId(name.split(".", maxsplit=1)[0]),
        operation=OperationId(name),
        ways=() if refusal else ("upright",),
        refused=Refused(where=name, refusal=refusal) if refusal else None,
    )


def judged(*targets: ReachTarget, **answer: Any) -> dict[str, TargetVerdict]:
    question = ReachQuestion(cell=EMPTY_CELL, bodies=(), targets=targets)
    return {v.target: v for v in verdicts(question, ReachAnswer(**answer))}


def test_one_robot_that_serves_both_ends_is_enough() -> None:
    rows = (handling(A, "stud", FAR, never_at_target=True), handling(B, "stud"))
    found = judged(target("stud"), handlings=rows)["stud"]
    assert (found.standing, found.robots, found.reasons) == (Standing.BUILDABLE, (B,), ())


def test_it_is_impossible_only_if_nobody_ever_gets_to_the_same_end() -> None:
    never_there = handling(A, "stud", FAR, never_at_target=True)
    never_here = handling(B, "stud", FAR, never_at_stock=True)
    both = judged(target("stud"), handlings=(never_there, never_here))["stud"]
    assert both.standing is Standing.NOT_FOUND  # one could hand it to the other
    again = replace(never_there, robot=B)
    none = judged(target("stud"), handlings=(never_there, again))["stud"]
    assert none.standing is Standing.IMPOSSIBLE
    assert "out of reach by 300 mm (proven)" in none.reasons[0]


def test_what_is_blocked_is_not_called_impossible() -> None:
    found = judged(target("stud"), handlings=(handling(A, "stud", BLOCKED),))["stud"]
    assert found.standing is Standing.NOT_FOUND
    assert "gripper and fence" in found.reasons[0]


def test_a_piece_that_is_too_heavy_for_all_is_impossible() -> None:
    heavy = PayloadExceeded(mass_kg=150.0, payload_kg=120.0)
    row = handling(A, "stud", heavy, never_at_target=True, never_at_stock=True)
    found = judged(target("stud"), handlings=(row,))["stud"]
    assert found.standing is Standing.IMPOSSIBLE
    assert "150 kg" in found.reasons[0]


def test_without_a_gripper_nothing_is_placed() -> None:
    assert judged(target("stud"))["stud"].standing is Standing.IMPOSSIBLE


@pytest.mark.parametrize(
    ("refusals", "standing"),
    [
        ((FAR, None), Standing.BUILDABLE),
        ((FAR, FAR), Standing.IMPOSSIBLE),
        ((FAR, BLOCKED), Standing.NOT_FOUND),
    ],
)
def test_a_nail_needs_one_robot_that_reaches_it(
    refusals: tuple[Refusal | None, ...], standing: Standing
) -> None:
    rows = tuple(operating(r, "stud.nail-0", no) for r, no in zip((A, B), refusals, strict=True))
    placed = (handling(A, "stud"),)
    found = judged(target("stud", nails=1), handlings=placed, operatings=rows)["stud"]
    assert found.standing is standing


def test_an_operation_that_no_tool_does_is_impossible() -> None:
    found = judged(target("stud", nails=1), handlings=(handling(A, "stud"),))["stud"]
    assert found.standing is Standing.IMPOSSIBLE
    assert found.reasons == ("stud.nail-0: no robot has a tool for it",)


def test_what_rests_on_something_out_of_reach_waits_for_it() -> None:
    rows = (handling(A, "sill", FAR), handling(A, "stud"), handling(A, "roof"))
    chain = (
        target("sill"),
        target("stud", 1, waits_for=("sill",)),
        target("roof", 2, waits_for=("stud",)),
    )
    found = judged(*chain, handlings=rows)
    assert found["sill"].standing is Standing.NOT_FOUND
    assert found["stud"].standing is found["roof"].standing is Standing.WAITING
    assert found["roof"].waits_for == ("stud",)
    assert share_of(found.values()) == 0.0


def test_too_few_nails_while_it_is_held_are_a_reason_but_no_proof() -> None:
    rows = (operating(B, "stud.nail-0"), operating(B, "stud.nail-1"))
    few = Steadying(target=ComponentId("stud"), needed=2, robot=A, ways=3)
    placed = (handling(A, "stud"),)
    stud = target("stud", nails=2)
    found = judged(stud, handlings=placed, operatings=rows, steadyings=(few,))["stud"]
    assert found.standing is Standing.NOT_FOUND
    enough = replace(few, is_enough=True)
    found = judged(stud, handlings=placed, operatings=rows, steadyings=(enough,))["stud"]
    assert found.standing is Standing.BUILDABLE


def test_the_share_of_nothing_is_whole() -> None:
    assert share_of(()) == 1.0
