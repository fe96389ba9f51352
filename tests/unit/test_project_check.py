"""Model against cell: what no robot of the team can do."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import pytest

from builders_building import EXAMPLES, codes
from sitewright.building_model.component import BoxGeometry, FastenerSpec, Operation, Process
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.model import BuildingModel
from sitewright.construction_graph.project_check import check_project
from sitewright.construction_graph.siting import sited
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId, OperationId, RobotId, StockPlaceId
from sitewright.foundation.pose import rotation, translation
from sitewright.robot_team.cell import Capability, Cell
from sitewright.robot_team.formats.cell_toml import read_cell

STUD = ComponentId("stud-1")


@cache
def frame() -> BuildingModel:
    return read_building(EXAMPLES / "wooden_frame" / "building.json")


@cache
def cell() -> Cell:
    return read_cell(EXAMPLES / "wooden_frame" / "cell.toml")


def changed(name: ComponentId, **changes: object) -> BuildingModel:
    model = frame()
    component = replace(model.component_by_id[name], **changes)  # type: ignore[arg-type]
    return replace(model, component_by_id={**model.component_by_id, name: component})


def the(code: str, found: list[Problem]) -> Problem:
    assert code in codes(found), found
    return next(p for p in found if p.code == code)


@pytest.mark.parametrize(
    ("project", "cell_file"),
    [
        ("wooden_frame", "cell.toml"),
        ("wooden_frame", "cell.mirrored.toml"),
        ("wooden_frame", "cell.wide.toml"),
        ("painted_frame", "cell.toml"),
    ],
)
def test_the_examples_have_no_problems(project: str, cell_file: str) -> None:
    model = read_building(EXAMPLES / project / "building.json")
    assert check_project(model, read_cell(EXAMPLES / project / cell_file)) == []


def test_gravity_that_does_not_point_down_in_the_cell_is_told() -> None:
    sideways = replace(frame(), gravity=(0.0, 9.81, 0.0))
    assert "90 degrees" in the("L4", check_project(sideways, cell())).message
    laid = replace(sideways, site_T_model=rotation((1.0, 0.0, 0.0), -math.pi / 2.0))
    placed = sited(cell(), laid)
    assert placed.world_T_model.turn(laid.gravity) == pytest.approx((0.0, 0.0, -9.81))
    assert "L4" not in codes(check_project(laid, placed))


def test_too_heavy_is_told_with_the_figures() -> None:
    found = the("Q1", check_project(changed(STUD, mass_kg=100.0), cell()))
    assert "100.0 kg; with gripper-s (35.0 kg)" in found.message
    assert "120 kg of kr120-a" in found.message


def test_too_wide_for_every_gripper_is_told() -> None:
    wide = changed(STUD, geometry=BoxGeometry((1.8, 0.30, 0.20)))
    assert (
        "300 x 200 mm: gripper-s takes 30-140 mm" in the("Q2", check_project(wide, cell())).message
    )


def test_a_fastener_that_no_tool_drives_is_told_with_what_there_is() -> None:
    first, *rest = frame().component_by_id[STUD].operations
    long = replace(first, fastener=FastenerSpec(type="nail", d_m=0.0031, l_m=0.12))
    found = the("Q3", check_project(changed(STUD, operations=(long, *rest)), cell()))
    assert "nail 3.1 x 120 mm of 'stud-1.nail-1'" in found.message
    assert "nail-gun: nail 3.1 x 50-90 mm" in found.message


def test_drilling_needs_a_drill() -> None:
    drill = Operation(id=first_operation(), process=Process.DRILL, on=(STUD,))
    found = the("Q3", check_project(changed(STUD, operations=(drill,)), cell()))
    assert "drill" in found.message


def first_operation() -> OperationId:
    return frame().component_by_id[STUD].operations[0].id


def test_out_of_reach_is_proven_for_piece_and_nails() -> None:
    far = check_project(changed(STUD, world_T_component=translation(9, 0, 0.16)), cell())
    assert codes(far).count("Q4") == 5
    assert "within reach of kr120-a" in the("Q4", far).message


def test_a_stack_needs_its_stock_place() -> None:
    places = {StockPlaceId("pallet-thik"): cell().stock_place_by_id[StockPlaceId("pallet-thin")]}
    found = check_project(frame(), replace(cell(), stock_place_by_id=places))
    assert codes(found) == ["Q5", "Q5"]
    assert "Did you mean pallet-thik?" in found[0].message


def test_without_a_handler_nothing_can_be_placed() -> None:
    name = RobotId("kr120-a")
    idle = replace(cell().robot_by_id[name], can=frozenset({Capability.FASTENING}))
    team = {**cell().robot_by_id, name: idle}
    assert codes(check_project(frame(), replace(cell(), robot_by_id=team))) == ["Q6"] * 5


def test_a_broken_model_is_not_checked_against_the_cell() -> None:
    broken = changed(STUD, construction_parents=(ComponentId("nobody"),))
    found = check_project(broken, replace(cell(), stock_place_by_id={}))
    assert "P1" in codes(found)
    assert "Q5" not in codes(found)


@pytest.mark.parametrize("rise_m", [0.0, 0.004, -0.004])
def test_what_stands_on_the_floor_to_some_millimetres_is_no_problem(rise_m: float) -> None:
    raised = replace(cell(), world_T_model=translation(0.0, 0.0, rise_m) @ cell().world_T_model)
    assert check_project(frame(), raised) == []


def test_what_stands_on_the_ground_must_not_hang_in_the_air() -> None:
    raised = replace(cell(), world_T_model=translation(0.0, 0.0, 0.03) @ cell().world_T_model)
    found = check_project(frame(), raised)
    assert {p.where for p in found if p.code == "L5"} == {"support-1", "support-2"}
    assert "hangs 30 mm above" in the("L5", found).message


def test_what_stands_beside_every_floor_is_told() -> None:
    aside = replace(cell(), world_T_model=translation(50.0, 0.0, 0.0) @ cell().world_T_model)
    assert "nothing of the cell below it" in the("L5", check_project(frame(), aside)).message
