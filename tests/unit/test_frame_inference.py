"""Ground, parents, order, holds and stock of small frames, each fact with its evidence."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest

from builders_building import component as any_component
from builders_frame import beam, frame, portal
from sitewright.building_model.component import Component, Layer, Origin, PlaneCut
from sitewright.building_model.inference.assembly import INSERTION, infer_assembly
from sitewright.building_model.inference.stock import piece_id, piece_name
from sitewright.building_model.matching import material_type_of
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.building_model.shapes import shape_of
from sitewright.foundation.ids import ComponentId


def inferred(model: BuildingModel) -> BuildingModel:
    return infer_assembly(model)[0]


def get(model: BuildingModel, name: str) -> Component:
    return model.component_by_id[ComponentId(name)]


def order(model: BuildingModel) -> list[str]:
    targets = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    return [c.id for c in sorted(targets, key=lambda c: c.order or 0)]


def test_a_portal_is_built_from_the_ground_up() -> None:
    model = inferred(portal())
    assert order(model)[0] == "sill"
    assert order(model)[-1] == "plate"
    assert get(model, "sill").ground
    assert get(model, "left").construction_parents == ("sill",)
    assert get(model, "plate").construction_parents == ("left", "right")


def test_what_nothing_carries_hangs_on_what_it_is_joined_to_and_needs_hold() -> None:
    model, problems = infer_assembly(portal())
    parents = get(model, "rail").construction_parents
    holds = [(r.a, r.b) for r in model.relations if r.kind is RelationKind.HOLD]
    assert parents
    assert set(parents) <= {"left", "right"}
    assert holds == [(p, "rail") for p in parents]
    assert [(p.code, p.severity, p.where) for p in problems] == [("F1", "W", "rail")]


def test_the_rail_comes_before_the_second_stud_so_that_nothing_has_to_slide() -> None:
    model = inferred(portal())
    ways = [c.ext[INSERTION] for c in model.component_by_id.values() if INSERTION in c.ext]
    assert len(ways) == 5
    assert all(isinstance(w, dict) and w["slide_m"] == 0.0 for w in ways)
    studs = sorted(order(model).index(n) for n in ("left", "right"))
    assert studs[0] < order(model).index("rail") < studs[1]


def test_every_new_fact_says_that_it_was_inferred_and_from_what() -> None:
    for component in inferred(portal()).component_by_id.values():
        origins = component.origins
        stated = {"order", "construction_parents"} if component.layer is Layer.TARGET else {"layer"}
        assert stated <= set(origins)
        assert all(origin is Origin.INFERRED and evidence for origin, evidence in origins.values())
    new = [r for r in inferred(portal()).relations if r.kind is not RelationKind.CONNECTION]
    assert new
    assert all(r.origin is Origin.INFERRED for r in new)


def test_a_beam_that_would_stand_on_nothing_is_refused_and_gets_no_piece() -> None:
    lone = beam("lone", (0.0, 0.0, 5.0), (1.0, 0.1, 0.1))
    shelf = beam("shelf", (0.0, 0.0, 5.1), (1.0, 0.1, 0.1))
    base = portal()
    model, problems = infer_assembly(
        frame(
            [*base.component_by_id.values(), lone, shelf],
            *(f"{r.a}-{r.b}" for r in base.relations),
            "shelf-lone",
        )
    )
    refused = {p.where for p in problems if p.code == "F2"}
    assert refused == {"lone", "shelf"}
    assert get(model, "lone").order is None
    assert not get(model, "lone").ground
    assert piece_id(ComponentId("lone")) not in model.component_by_id
    assert get(model, "plate").order == 5


def test_touching_from_below_without_a_joint_carries_nothing() -> None:
    unjoined = frame(
        [
            beam("sill", (0.0, 0.0, 0.05), (2.0, 0.1, 0.1)),
            beam("block", (0.0, 0.0, 0.15), (0.5, 0.1, 0.1)),
        ]
    )
    _, problems = infer_assembly(unjoined)
    assert [(p.code, p.where) for p in problems] == [("F2", "block")]


def test_gravity_decides_what_is_the_ground() -> None:
    lying = replace(portal(), gravity=(0.0, -9.81, 0.0))
    model, problems = infer_assembly(lying)
    assert all(c.ground for c in model.component_by_id.values() if c.layer is Layer.TARGET)
    assert problems == []


def test_what_the_designer_states_is_kept() -> None:
    model = portal()
    given = replace(get(model, "left"), order=40, construction_parents=(ComponentId("sill"),))
    known = replace(model, component_by_id={**model.component_by_id, given.id: given})
    assert get(inferred(known), "left").order == 40


def test_each_target_has_one_piece_of_its_own_shape_and_first_used_lies_on_top() -> None:
    model = inferred(portal())
    number = {piece_id(ComponentId(n)): k for k, n in enumerate(order(model))}
    pieces = [i for s in model.stacks for i in s.items]
    assert sorted(pieces) == sorted(number)
    for stack in model.stacks:
        assert [number[i] for i in stack.items] == sorted(number[i] for i in stack.items)[::-1]
    for piece in number:
        target = get(model, piece.removeprefix("piece."))
        assert shape_of(get(model, piece)) == shape_of(target)
        assert get(model, piece).type == target.type


def test_pieces_of_a_pile_lie_on_each_other_and_piles_keep_their_distance() -> None:
    model = inferred(portal())
    for stack in model.stacks:
        top_m = 0.0
        for item in stack.items:
            pose = get(model, item).world_T_component
            assert pose.position_m[2] == pytest.approx(top_m + 0.05)
            assert abs(pose.x_axis[0]) == pytest.approx(1.0)
            top_m += 0.1
    across = sorted(
        get(model, s.items[0]).world_T_component.position_m[1]
        for s in model.stacks
        if s.place == model.stacks[0].place
    )
    assert all(b - a >= 0.26 - 1e-9 for a, b in pairwise(across))


def test_equal_blanks_with_different_cuts_are_told_apart_by_a_mark() -> None:
    cut = PlaneCut((0.4, 0.0, 0.0), (1.0, 0.0, 0.0))
    model = inferred(
        frame(
            [
                beam("a", (0.0, 0.0, 0.05), (1.0, 0.1, 0.1), word="joist"),
                beam("b", (0.0, 1.0, 0.05), (1.0, 0.1, 0.1), word="joist"),
                beam("c", (0.0, 2.0, 0.05), (1.0, 0.1, 0.1), word="joist", cuts=[cut]),
                beam("d", (0.0, 3.0, 0.05), (1.0, 0.2, 0.1), word="joist"),
            ]
        )
    )
    assert [get(model, n).type for n in "abcd"] == ["joist-1", "joist-1", "joist-2", "joist"]
    assert get(model, "c").origins["type"][0] is Origin.INFERRED


def test_neighbours_without_room_for_a_clearance_are_noted() -> None:
    near = frame(
        [
            beam("a", (0.0, 0.0, 0.05), (1.0, 0.1, 0.1)),
            beam("b", (0.0, 0.105, 0.05), (1.0, 0.1, 0.1)),
            beam("c", (0.0, 0.3, 0.05), (1.0, 0.1, 0.1)),
        ]
    )
    contacts = [r for r in inferred(near).relations if r.kind is RelationKind.CONTACT]
    assert [(r.a, r.b) for r in contacts] == [("a", "b")]
    assert contacts[0].data["gap_m"] == pytest.approx(0.005)


def test_a_beam_that_fits_only_between_its_neighbours_is_told_how_far_it_slides() -> None:
    blocks = [
        beam(f"{name}{level}", (x, 0.0, 0.05 + 0.1 * level), (0.5, 0.1, 0.1))
        for name, x in (("l", -0.5), ("m", 0.0), ("r", 0.5))
        for level in (0, 1)
    ]
    model = inferred(frame(blocks, "l1-l0", "m1-m0", "r1-r0"))
    ways = {n: get(model, n).ext[INSERTION] for n in ("l1", "m1", "r1")}
    assert all(isinstance(w, dict) and w["slide_m"] == 0.0 for w in ways.values())
    assert order(model).index("m1") != max(order(model).index(n) for n in ways)


def test_beams_that_overlap_have_no_way_in_and_that_is_told() -> None:
    _, problems = infer_assembly(
        frame(
            [
                beam("sill", (0.0, 0.0, 0.05), (2.0, 0.1, 0.1)),
                beam("stub", (0.0, 0.0, 0.1), (0.3, 0.1, 0.1)),
            ],
            "stub-sill",
        )
    )
    assert "F3" in {p.code for p in problems}


def test_the_same_model_gives_the_same_facts() -> None:
    assert infer_assembly(portal()) == infer_assembly(portal())


def test_equal_pieces_may_be_swapped_without_burying_what_is_wanted_earlier() -> None:
    model = inferred(portal())
    wanted: dict[object, list[int]] = {}
    for number, name in enumerate(order(model)):
        wanted.setdefault(material_type_of(get(model, name)), []).append(number)
    for stack in model.stacks:
        kinds = [material_type_of(get(model, i)) for i in stack.items]
        for k, below in enumerate(kinds):
            others = [above for above in kinds[k + 1 :] if above != below]
            assert all(max(wanted[above]) < min(wanted[below]) for above in others)


def test_long_ids_give_pieces_of_their_own_and_names_fit_a_file() -> None:
    ids = [ComponentId("x" * 63 + end) for end in "ab"]
    pieces = {piece_id(i) for i in ids}
    assert len(pieces) == 2
    assert all(len(p) <= 64 for p in pieces)
    assert len(piece_name(any_component("a", name="n" * 256))) == 256
