"""Each code of the model check: what triggers it, and its words."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from builders_building import STUD_M, codes, component, ids, model, nail, piece, stock
from sitewright.building_model.component import (
    BoxGeometry,
    Component,
    ConvexGeometry,
    ExtrusionGeometry,
    Layer,
    MeshGeometry,
    Operation,
    PlaneCut,
    Process,
    Source,
)
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.building_model.validation import check_model
from sitewright.errors import Problem
from sitewright.foundation.ids import OperationId

SUPPORT_M = (2.4, 0.09, 0.14)


def the(code: str, found: list[Problem]) -> Problem:
    (problem,) = [p for p in found if p.code == code]
    return problem


def frame(*operations: Operation, stud: dict[str, Any] | None = None) -> BuildingModel:
    """A stud on a support, both with stock."""
    support = component("support", kind="beam", size_m=SUPPORT_M, at_m=(0, 0, 0.07), ground=True)
    changes = {"at_m": (0, 0, 0.16), "on": ["support"], "operations": operations, **(stud or {})}
    return model(
        support,
        component("stud", **changes),
        stacks=[[piece("p1"), piece("p2", kind="beam", size_m=SUPPORT_M)]],
    )


def test_a_sound_model_has_no_problems() -> None:
    driven = nail("n1", on=["stud", "support"], at_m=(0, 0, 0.02))
    assert check_model(frame(driven)) == []


def test_an_unknown_construction_parent_comes_with_a_suggestion() -> None:
    found = the("P1", check_model(frame(stud={"on": ["suport"]})))
    assert found.where == "stud"
    assert "Did you mean support?" in found.message


def test_a_name_in_place_of_an_id_is_told_apart() -> None:
    a, b = (component(i, ground=True, name="Stud") for i in ("a", "b"))
    found = the("N1", check_model(model(a, b, component("x", on=["Stud"]), stacks=[stock(3)])))
    assert "'Stud' is a name that matches 2 objects" in found.message


def test_a_parent_on_the_material_layer_is_refused() -> None:
    found = the("P3", check_model(frame(stud={"on": ["p1"]})))
    assert "layer material" in found.message


def test_a_cycle_is_told_all_around() -> None:
    a, b, c = (component(i, on=[j]) for i, j in (("a", "b"), ("b", "c"), ("c", "a")))
    found = the("P2", check_model(model(a, b, c, stacks=[stock(3)])))
    assert "a -> b -> c -> a" in found.message


def test_relations_and_parents_together_may_not_form_a_cycle() -> None:
    a, b = component("a", ground=True), component("b", on=["a"])
    before = Relation(kind=RelationKind.BEFORE, a=b.id, b=a.id)
    assert "P2" in codes(check_model(model(a, b, stacks=[stock(2)], relations=[before])))


def test_operations_that_wait_for_each_other_are_refused() -> None:
    one = nail("n1", on=["stud", "support"], at_m=(0, 0, 0.02))
    two = nail("n2", on=["stud", "support"], at_m=(0.1, 0, 0.02))
    pair = (
        replace(one, after=(OperationId("n2"),)),
        replace(two, after=(OperationId("n1"),)),
    )
    assert "n1 -> n2 -> n1" in the("P2", check_model(frame(*pair))).message


def test_an_operation_after_an_unknown_one_is_refused() -> None:
    one = nail("n1", on=["stud", "support"], at_m=(0, 0, 0.02))
    found = the("P1", check_model(frame(replace(one, after=(OperationId("n7"),)))))
    assert "'n7', which does not exist" in found.message


def test_an_order_against_what_carries_is_refused() -> None:
    a = component("a", ground=True, order=5)
    b = component("b", on=["a"], order=3, at_m=(0, 0, 0.06))
    found = the("P4", check_model(model(a, b, stacks=[stock(2)])))
    assert found.message == "It (order 3) rests on a (order 5)."


@pytest.mark.parametrize(
    "broken",
    [
        {"geometry": BoxGeometry((1.8, 0.0, 0.04))},
        {"geometry": BoxGeometry((1.8, -0.1, 0.04))},
        {"geometry": ConvexGeometry(((0, 0, 0), (1, 0, 0), (0, 1, 0)))},
        {"geometry": ConvexGeometry(((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)))},
        {"geometry": ExtrusionGeometry(((0, 0), (1, 0), (0, 1)), 0.0)},
        {"geometry": ExtrusionGeometry(((0, 0), (1, 1), (1, 0), (0, 1)), 0.1)},
        {"geometry": ExtrusionGeometry(((0, 0), (1, 0), (2, 0)), 0.1)},
        {"geometry": MeshGeometry("meshes/x.stl", "0" * 64)},
        {"cuts": (PlaneCut((-5.0, 0, 0), (1.0, 0, 0)),)},
        {"cuts": (PlaneCut((0, 0, 0), (0, 0, 0)),)},
    ],
)
def test_geometry_that_is_no_solid_is_refused(broken: dict[str, Any]) -> None:
    bad = replace(component("a", ground=True), **broken)
    assert the("G6", check_model(model(bad))).where == "a"


def test_lengths_in_millimetres_are_suspected() -> None:
    big = component("a", ground=True, size_m=(2400.0, 90.0, 40.0))
    found = the("U2", check_model(model(big)))
    assert found.severity == "W"
    assert "2400 m" in found.message
    assert "mm" in found.fix


@pytest.mark.parametrize(("far_m", "severity"), [(2e4, "W"), (1.2e6, "E")])
def test_a_model_far_from_its_origin_is_told(far_m: float, severity: str) -> None:
    found = the("O1", check_model(model(component("a", ground=True, at_m=(far_m, 0, 0)))))
    assert found.severity == severity


@pytest.mark.parametrize(
    ("stacks", "code", "words"),
    [
        ([], "M1", "no stock of type 'stud'"),
        ([[piece("p", kind="studs")]], "M1", "Did you mean studs?"),
        ([[piece("p", size_m=(3.6, 0.09, 0.04))]], "M2", "needs 1.800 m; the stock is 3.600"),
        ([[piece("p", size_m=(1.8, 0.08, 0.04))]], "M3", "40 x 90 mm; the stock has 40 x 80"),
        ([[piece("p")]], "", ""),
        ([[piece("p", size_m=(1.8, 0.04, 0.09))]], "", ""),
    ],
)
def test_stock_must_fit(stacks: list[list[Component]], code: str, words: str) -> None:
    found = check_model(model(component("a", ground=True), stacks=stacks))
    if code:
        assert words in the(code, found).message
    else:
        assert found == []


def test_a_piece_serves_one_target_only() -> None:
    two = [component(i, ground=True) for i in ("a", "b")]
    found = the("M1", check_model(model(*two, stacks=[stock(1)])))
    assert "used up" in found.message


def test_a_stated_material_must_be_in_stock() -> None:
    wanted = component("a", ground=True, material="C24")
    assert codes(check_model(model(wanted, stacks=[stock(1)]))) == ["M1"]
    assert check_model(model(wanted, stacks=[stock(1, material="C24")])) == []


def test_material_must_lie_in_one_stack() -> None:
    loose = model(piece("loose"))
    assert "0 stacks" in the("M4", check_model(loose)).message
    mixed = model(component("a", ground=True), stacks=[stock(1)])
    bad = replace(mixed, stacks=(replace(mixed.stacks[0], items=ids("piece-1", "a")),))
    assert "layer target" in the("M4", check_model(bad)).message


def test_a_short_nail_is_told_with_its_figures() -> None:
    short = nail("n1", on=["stud", "support"], at_m=(0, 0, 0.02), length_m=0.05)
    found = the("C1", check_model(frame(short)))
    assert found.message == "50 mm nail 'n1' through 40 mm leaves 10 mm in support (< 30)."


def test_a_nail_beside_its_receiver_holds_nothing() -> None:
    beside = nail("n1", on=["stud", "support"], at_m=(0, 0.2, 0.02))
    assert "leaves 0 mm" in the("C1", check_model(frame(beside))).message


def test_a_nail_reaches_only_the_part_that_a_cut_left() -> None:
    driven = nail("n1", on=["stud", "support"], at_m=(0, 0, 0.02))
    sound = frame(driven)
    support = sound.component_by_id[ids("support")[0]]
    cut = replace(support, cuts=(PlaneCut((0, 0, 0.05), (0, 0, 1)),))
    lowered = replace(sound, component_by_id={**sound.component_by_id, support.id: cut})
    assert "C1" not in codes(check_model(lowered))
    deeper = replace(cut, cuts=(PlaneCut((0, 0, 0.04), (0, 0, 1)),))
    lowered = replace(sound, component_by_id={**sound.component_by_id, support.id: deeper})
    assert "leaves 20 mm" in the("C1", check_model(lowered)).message


@pytest.mark.parametrize(
    ("change", "words"),
    [({"fastener": None}, "no fastener"), ({"on": ids("stud")}, "receiver")],
)
def test_a_fastening_without_what_it_needs_is_refused(change: dict[str, Any], words: str) -> None:
    driven = nail("n1", on=["stud", "support"], at_m=(0, 0, 0.02))
    assert words in the("C2", check_model(frame(replace(driven, **change)))).message


def test_paint_without_a_patch_is_refused() -> None:
    paint = Operation(id=OperationId("p"), process=Process.PAINT, on=ids("stud"))
    assert "patch" in the("C2", check_model(frame(paint))).message


def test_a_process_without_a_skill_is_a_warning() -> None:
    glue = Operation(id=OperationId("g"), process=Process.GLUE, on=ids("stud", "support"))
    found = the("S1", check_model(frame(glue)))
    assert found.severity == "W"
    assert "'glue' has no built-in skill" in found.message


@pytest.mark.parametrize(("wanted", "has"), [(2, 1), (1, 0), (3, 1)])
def test_nothing_is_held_until_more_fasteners_are_in_than_it_has(wanted: int, has: int) -> None:
    driven = [nail("n1", on=["stud", "support"], at_m=(0, 0, 0.02))][:has]
    held = {"hold_until_fasteners": wanted}
    problem = the("F5", check_model(frame(*driven, stud=held)))
    assert (problem.severity, problem.where) == ("E", "stud")
    assert f"until {wanted} fasteners are in" in problem.message
    assert problem.fix.endswith(f"or lower 'hold_until_fasteners' to {has}.")


def test_all_fasteners_may_be_asked_for_and_finishes_are_none() -> None:
    driven = nail("n1", on=["stud", "support"], at_m=(0, 0, 0.02))
    paint = replace(driven, id=OperationId("p1"), process=Process.PAINT, fastener=None)
    assert "F5" not in codes(check_model(frame(driven, stud={"hold_until_fasteners": 1})))
    assert "F5" in codes(check_model(frame(driven, paint, stud={"hold_until_fasteners": 2})))


def test_a_floating_component_needs_fasteners_or_falsework() -> None:
    floating = {"at_m": (0, 0, 0.9)}
    assert "F2" in codes(check_model(frame(stud=floating)))
    driven = Operation(id=OperationId("w"), process=Process.WELD, on=ids("stud", "support"))
    assert the("F1", check_model(frame(driven, stud=floating))).severity == "W"
    assert check_model(frame(stud={**floating, "temporary_support": True})) == []


def test_what_lies_on_the_ground_plane_needs_no_flag() -> None:
    assert check_model(model(component("a"), stacks=[stock(1)])) == []
    raised = model(component("a", at_m=(0, 0, 1.02)), stacks=[stock(1)], ground_z_m=1.0)
    assert check_model(raised) == []


def test_a_parent_above_carries_nothing() -> None:
    lifted = component("support", kind="beam", size_m=SUPPORT_M, at_m=(0, 0, 0.5), ground=True)
    below = component("stud", at_m=(0, 0, 0.41), on=["support"])
    found = check_model(
        model(lifted, below, stacks=[[piece("p"), piece("q", kind="beam", size_m=SUPPORT_M)]])
    )
    assert codes(found) == ["F2"]


def test_a_relation_with_an_unknown_end_is_refused() -> None:
    a = component("a", ground=True)
    torn = Relation(kind=RelationKind.CONTACT, a=a.id, b=ids("aa")[0])
    found = the("P1", check_model(model(a, stacks=[stock(1)], relations=[torn])))
    assert "'a contact aa'" in found.message
    assert "Did you mean a?" in found.message


def test_an_operation_on_an_unknown_component_is_refused() -> None:
    driven = nail("n1", on=["stud", "suport"], at_m=(0, 0, 0.02))
    found = the("P1", check_model(frame(driven)))
    assert "component 'suport' of operation 'n1' does not exist" in found.message


def test_gravity_decides_what_is_below() -> None:
    a = component("a", ground=True, at_m=(0, 0, 5))
    b = component("b", on=["a"], at_m=(0, 0.09, 5), size_m=STUD_M)
    upright = model(a, b, stacks=[stock(2)])
    assert codes(check_model(upright)) == ["F2"]
    assert check_model(replace(upright, gravity=(0.0, -9.81, 0.0), ground_z_m=-9.0)) == []


def test_source_ids_are_told() -> None:
    source = Source(file="wall.json", kind="compas_timber", id="guid-7")
    found = check_model(model(component("a", on=["b"], source=source), stacks=[stock(1)]))
    assert the("P1", found).source_id == "guid-7"
    assert "[guid-7]" in str(the("P1", found))


def test_zones_and_standing_things_need_no_stock() -> None:
    zone = component("z", layer=Layer.VIRTUAL_COLLISION, at_m=(0, 0, 3))
    wall = component("w", layer=Layer.AS_BUILT, at_m=(0, 0, 3))
    assert check_model(model(zone, wall)) == []
