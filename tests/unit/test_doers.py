"""Which robots could do an act, and what keeps the others from it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from builders_building import EXAMPLES
from sitewright.building_model.formats.native import read_building
from sitewright.central_controller.design import Design
from sitewright.central_controller.doers import Doer, doers
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId
from sitewright.robot_team.cell import Capability, Cell
from sitewright.robot_team.formats.cell_toml import read_cell
from sitewright.robot_team.skill import Skill, SkillCall

A, B = RobotId("kr120-a"), RobotId("kr120-b")
NAIL = SkillCall(Skill.FASTEN, B, ("stud-1.nail-3", "stud-1", "nail-gun"))
TAKE = SkillCall(Skill.GRASP, A, ("thin.5", "pallet-thin", "gripper-s"))


@cache
def design() -> Design:
    folder = EXAMPLES / "wooden_frame"
    return Design(
        model=read_building(folder / "building.json"), cell=read_cell(folder / "cell.toml")
    )


def with_robot(robot: RobotId, **changes: object) -> Design:
    cell: Cell = design().cell
    changed = replace(cell.robot_by_id[robot], **changes)  # type: ignore[arg-type]
    return replace(design(), cell=replace(cell, robot_by_id={**cell.robot_by_id, robot: changed}))


def asked(found: tuple[Doer, ...], robot: RobotId) -> Doer:
    return next(d for d in found if d.robot == robot)


def test_the_handler_takes_and_the_finisher_nails_each_with_its_end_effector() -> None:
    assert asked(doers(design(), TAKE, ()), A) == Doer(
        robot=A, can_by="grasping, gripper-s holds 90 x 40 mm", obstacles=()
    )
    assert asked(doers(design(), NAIL, ()), B).can_by == (
        "fastening, nail-gun drives a nail 3.1 x 90 mm"
    )


def test_who_is_not_made_for_it_or_has_no_tool_for_it_is_told_both() -> None:
    handler = asked(doers(design(), NAIL, ()), A)
    assert handler.obstacles == (
        "it is not made for fastening (it does grasping, positioning, releasing, retracting)",
        "none of its end effectors drives a nail 3.1 x 90 mm",
    )


def test_a_robot_that_could_do_it_too_has_no_obstacle() -> None:
    both = with_robot(
        A,
        can=frozenset(Capability),
        end_effectors=(EndEffectorId("gripper-s"), EndEffectorId("nail-gun")),
    )
    assert asked(doers(both, NAIL, ()), A).obstacles == ()


@pytest.mark.parametrize(
    ("reason", "is_told"),
    [
        ("kr120-a cannot reach stud-1.nail-3: out of reach by 38 mm (proven)", True),
        ("kr120-a cannot reach stud-1.nail-33: out of reach by 38 mm (proven)", False),
        ("kr120-b cannot reach stud-1.nail-3: out of reach by 38 mm (proven)", False),
    ],
)
def test_what_geometry_refused_a_robot_about_the_very_spot_is_told(
    reason: str, *, is_told: bool
) -> None:
    able = with_robot(A, can=frozenset(Capability), end_effectors=(EndEffectorId("nail-gun"),))
    note = RefusalNote(target=ComponentId("stud-1"), kind="NoIk", reason=reason, is_proven=True)
    assert asked(doers(able, NAIL, (note,)), A).obstacles == ((reason,) if is_told else ())
