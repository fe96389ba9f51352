"""Order, holds, contradictions and idempotence for models of any convex shapes."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace

import pytest

from builders_frame import beam, upright
from sitewright.building_model.component import (
    BoxGeometry,
    Component,
    ConvexGeometry,
    ExtrusionGeometry,
    Layer,
    MeshGeometry,
    Origin,
)
from sitewright.building_model.inference.bare import without_inferred
from sitewright.building_model.inference.completion import Surroundings, complete
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.building_model.validation import check_model
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, StockPlaceId
from sitewright.foundation.pose import Pose

PLACES = (StockPlaceId("yard-1"), StockPlaceId("yard-2"))


def model_of(components: Sequence[Component], *relations: Relation) -> BuildingModel:
    return BuildingModel(
        name="any",
        component_by_id={c.id: c for c in sorted(components, key=lambda c: c.id)},
        relations=relations,
    )


def relation(kind: RelationKind, a: str, b: str) -> Relation:
    return Relation(kind=kind, a=ComponentId(a), b=ComponentId(b))


def get(model: BuildingModel, name: str) -> Component:
    return model.component_by_id[ComponentId(name)]


def edges(model: BuildingModel, kind: RelationKind) -> list[tuple[str, str]]:
    return [(r.a, r.b) for r in model.relations if r.kind is kind]


def block(name: str, x: float, z: float, size: tuple[float, float, float]) -> Component:
    return beam(name, (x, 0.0, z), size, word="block")


def tower() -> list[Component]:
    return [
        block("low", 0.0, 0.1, (0.4, 0.4, 0.2)),
        block("middle", 0.0, 0.3, (0.4, 0.4, 0.2)),
        block("top", 0.0, 0.5, (0.4, 0.4, 0.2)),
    ]


def wall_panel(storeys: int, studs: int) -> BuildingModel:
    """Return wall panels upon each other: sole plate, studs, top plate."""
    long_m = (studs - 1) * 0.6
    parts = []
    for k in range(storeys):
        base = k * 2.49
        middle = long_m / 2.0
        parts.append(
            beam(f"sole-{k}", (middle, 0.0, base + 0.0225), (long_m + 0.045, 0.095, 0.045))
        )
        parts.append(beam(f"top-{k}", (middle, 0.0, base + 2.4675), (long_m + 0.045, 0.095, 0.045)))
        parts += [
            upright(f"stud-{k}-{j:03d}", (j * 0.6, 0.0, base + 1.245), (2.4, 0.045, 0.095))
            for j in range(studs)
        ]
    return model_of(parts)


def test_a_tower_is_built_from_below_each_fact_with_its_evidence() -> None:
    model, problems = complete(model_of(tower()), Surroundings(places=PLACES))
    assert [get(model, n).order for n in ("low", "middle", "top")] == [1, 2, 3]
    assert get(model, "low").ground
    assert get(model, "top").construction_parents == ("middle",)
    assert edges(model, RelationKind.CONTACT) == [("low", "middle"), ("middle", "top")]
    assert problems == []
    for component in model.component_by_id.values():
        assert all(o is Origin.INFERRED and why for o, why in component.origins.values())
    assert all(r.origin is Origin.INFERRED for r in model.relations)


def test_inferring_twice_changes_nothing_and_can_be_undone() -> None:
    given = model_of(tower())
    once, _ = complete(given, Surroundings(places=PLACES))
    twice, _ = complete(once, Surroundings(places=PLACES))
    assert twice == once
    assert without_inferred(once) == given


def test_what_is_inferred_follows_the_geometry_once_that_changes() -> None:
    once, _ = complete(model_of(tower()))
    moved = replace(get(once, "top"), world_T_component=Pose((2.0, 0.0, 0.1)))
    again, _ = complete(replace(once, component_by_id={**once.component_by_id, moved.id: moved}))
    assert get(again, "top").ground
    assert get(again, "top").construction_parents == ()


def test_a_hull_and_an_extrusion_touch_like_boxes_do() -> None:
    corners = tuple((x, y, z) for x in (-0.2, 0.2) for y in (-0.2, 0.2) for z in (0.0, 0.2))
    hull = replace(tower()[0], geometry=ConvexGeometry(corners), world_T_component=Pose())
    ell = ((-0.2, -0.2), (0.2, -0.2), (0.2, 0.0), (0.0, 0.0), (0.0, 0.2), (-0.2, 0.2))
    bent = replace(
        tower()[1],
        geometry=ExtrusionGeometry(profile_m=ell, depth_m=0.2),
        world_T_component=Pose((0.0, 0.0, 0.2)),
    )
    model, problems = complete(model_of([hull, bent]))
    contact = next(r for r in model.relations if r.kind is RelationKind.CONTACT)
    assert contact.data["area_m2"] == pytest.approx(0.12)
    assert get(model, "middle").construction_parents == ("low",)
    assert problems == []


def test_a_component_without_usable_shape_is_named_and_left_as_it_is() -> None:
    mesh = replace(tower()[2], geometry=MeshGeometry("meshes/a.stl", "0" * 64))
    model, problems = complete(model_of([*tower()[:2], mesh]))
    assert [(p.code, p.where) for p in problems] == [("G7", "top")]
    assert get(model, "top") == mesh


def test_a_bar_in_a_box_waits_for_nothing_but_the_lid_waits_for_the_bar() -> None:
    base = block("base", 0.0, 0.05, (1.0, 1.0, 0.1))
    sides = [
        beam("left", (-0.45, 0.0, 0.3), (0.1, 1.0, 0.4)),
        beam("right", (0.45, 0.0, 0.3), (0.1, 1.0, 0.4)),
        beam("front", (0.0, -0.45, 0.3), (0.8, 0.1, 0.4)),
        beam("rear", (0.0, 0.45, 0.3), (0.8, 0.1, 0.4)),
    ]
    bar = beam("zz-bar", (0.0, 0.0, 0.2), (0.5, 0.1, 0.1))
    lid = block("aa-lid", 0.0, 0.55, (1.0, 1.0, 0.1))
    model, problems = complete(model_of([base, *sides, bar, lid]))
    assert ("zz-bar", "aa-lid") in edges(model, RelationKind.BEFORE)
    assert (get(model, "zz-bar").order or 0) < (get(model, "aa-lid").order or 0)
    assert not [p for p in problems if p.code == "F3"]


def test_a_notch_tells_the_way_in_along_its_cheeks() -> None:
    """The tongue lies between two cheeks under a bridge: only sideways along y it goes in."""
    fork = [
        block("floor", 0.0, 0.05, (0.6, 0.4, 0.1)),
        block("cheek-1", -0.2, 0.2, (0.2, 0.4, 0.2)),
        block("cheek-2", 0.2, 0.2, (0.2, 0.4, 0.2)),
        block("bridge", 0.0, 0.35, (0.6, 0.4, 0.1)),
    ]
    fork = [replace(c, layer=Layer.AS_BUILT) for c in fork]
    model, _ = complete(model_of([*fork, block("tongue", 0.0, 0.2, (0.2, 0.4, 0.2))]))
    way = get(model, "tongue").ext["insertion"]
    assert isinstance(way, dict)
    assert [abs(x) for x in way["from"]] == [0.0, 1.0, 0.0]
    assert way["slide_m"] == pytest.approx(0.411, abs=1e-3)


def test_what_is_walled_in_has_no_way_in_and_is_named() -> None:
    walls = [
        beam("w1", (-0.3, 0.0, 0.2), (0.2, 0.8, 0.4)),
        beam("w2", (0.3, 0.0, 0.2), (0.2, 0.8, 0.4)),
        beam("w3", (0.0, 0.3, 0.2), (0.4, 0.2, 0.4)),
        beam("w4", (0.0, -0.3, 0.2), (0.4, 0.2, 0.4)),
        beam("lid", (0.0, 0.0, 0.45), (0.8, 0.8, 0.1)),
    ]
    walls = [replace(c, layer=Layer.AS_BUILT) for c in walls]
    _, problems = complete(model_of([*walls, block("inner", 0.0, 0.2, (0.4, 0.4, 0.4))]))
    assert [(p.code, p.where) for p in problems] == [("F3", "inner")]


def test_pieces_that_carry_each_other_get_a_hold_and_no_cycle() -> None:
    """A hook and the tongue in its throat: each rests on the other."""
    upright_profile = Pose.from_axes((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    hook = ((0.0, 1.0), (0.6, 1.0), (0.6, 1.6), (0.0, 1.6))
    throat = ((0.0, 1.4), (0.4, 1.4), (0.4, 1.2), (0.0, 1.2))
    parts = [
        _prism("hook", (*hook, *throat), upright_profile),
        _prism("tongue", (*throat[::-1],), upright_profile),
        block("post", 0.3, 0.5, (0.6, 0.6, 1.0)),
    ]
    model, problems = complete(model_of(parts))
    assert edges(model, RelationKind.SUPPORTS) == [("hook", "tongue"), ("post", "hook")]
    assert edges(model, RelationKind.HOLD) == [("tongue", "hook")]
    assert "P2" not in {p.code for p in check_model(model)}
    assert not [p for p in problems if p.code == "P6"]


def _prism(name: str, profile: tuple[tuple[float, float], ...], pose: Pose) -> Component:
    return replace(
        block(name, 0.0, 0.0, (1.0, 1.0, 1.0)),
        geometry=ExtrusionGeometry(profile_m=profile, depth_m=0.2),
        world_T_component=pose,
    )


def test_given_order_and_parents_win_and_contradictions_are_reported() -> None:
    low, middle, top = tower()
    stated = [replace(low, order=9), replace(middle, order=1), top]
    model, problems = complete(model_of(stated))
    assert get(model, "low").order == 9
    assert get(model, "middle").order == 1
    said = [p for p in problems if p.code == "P6"]
    assert [p.where for p in said] == ["middle"]
    assert "low" in said[0].message


def test_a_parent_that_is_not_touched_and_a_ground_in_the_air_are_reported() -> None:
    low, middle, top = tower()
    stated = [low, replace(middle, ground=True), replace(top, construction_parents=(low.id,))]
    model, problems = complete(model_of(stated))
    assert sorted(p.where for p in problems if p.code == "P6") == ["middle", "top"]
    assert get(model, "top").construction_parents == ("low",)


def test_a_given_before_is_kept_and_obeyed() -> None:
    parts = [block("a", 0.0, 0.1, (0.4, 0.4, 0.2)), block("b", 2.0, 0.1, (0.4, 0.4, 0.2))]
    model, _ = complete(model_of(parts, relation(RelationKind.BEFORE, "b", "a")))
    assert (get(model, "b").order or 0) < (get(model, "a").order or 0)


def test_gravity_is_an_input_a_panel_lying_flat_rests_all_on_the_table() -> None:
    panel = replace(wall_panel(1, 4), gravity=(0.0, 9.81, 0.0))
    model, problems = complete(panel)
    assert all(c.ground for c in model.component_by_id.values())
    assert edges(model, RelationKind.SUPPORTS) == []
    assert problems == []


def test_existing_components_carry_but_are_not_built() -> None:
    low, middle, top = tower()
    model, problems = complete(model_of([replace(low, layer=Layer.AS_BUILT), middle, top]))
    assert get(model, "low").order is None
    assert get(model, "middle").construction_parents == ("low",)
    assert get(model, "middle").order == 1
    assert problems == []


def test_a_wall_panel_of_425_members_takes_less_than_five_seconds() -> None:
    panel = wall_panel(5, 83)
    assert len(panel.component_by_id) == 425
    begin = time.process_time()
    model, problems = complete(panel)
    assert time.process_time() - begin < 5.0
    assert len(edges(model, RelationKind.CONTACT)) == 5 * 83 * 2 + 4
    assert not [p for p in problems if p.severity == "E"]
    orders = {i: c.order or 0 for i, c in model.component_by_id.items()}
    assert all(
        orders[r.a] < orders[r.b] for r in model.relations if r.kind is RelationKind.SUPPORTS
    )


def test_stock_is_piled_so_that_the_next_piece_lies_on_top_and_cut_from_boards() -> None:
    rule: dict[str, Json] = {"id": "kvh", "kind": "stock", "type": "*", "lengths_m": [5.0, 3.0]}
    given = replace(wall_panel(1, 3), rules=(rule,))
    model, problems = complete(given, Surroundings(places=PLACES))
    pieces = {i: c for i, c in model.component_by_id.items() if c.layer is Layer.MATERIAL}
    assert len(pieces) == 5
    assert not [p for p in problems if p.code.startswith("M")]
    for stack in model.stacks:
        uses = [
            model.component_by_id[ComponentId(i.removeprefix("piece."))].order for i in stack.items
        ]
        assert uses == sorted(uses, key=lambda n: -(n or 0))
    boards: dict[str, float] = {}
    for piece in pieces.values():
        cut = piece.ext["cut_from"]
        assert isinstance(cut, dict)
        assert isinstance(piece.geometry, BoxGeometry)
        boards[str(cut["board"])] = boards.get(str(cut["board"]), 0.0) + piece.geometry.size_m[0]
    assert all(length <= 5.0 for length in boards.values())
    assert not [p for p in check_model(model) if p.code.startswith("M")]


def test_an_overlap_is_measured_and_a_large_one_is_an_error() -> None:
    low, middle, _ = tower()
    little = replace(middle, world_T_component=Pose((0.0, 0.0, 0.29)))
    deep = replace(middle, world_T_component=Pose((0.0, 0.0, 0.2)))
    _, problems = complete(model_of([low, little]))
    assert [(p.code, p.severity, p.where) for p in problems if p.code == "G1"] == [
        ("G1", "W", "low")
    ]
    assert "1600 cm3 (5 %" in problems[0].message
    _, problems = complete(model_of([low, deep]))
    said = [p for p in problems if p.code == "G1"]
    assert [p.severity for p in said] == ["E"]
    assert "16000 cm3 (50 %" in said[0].message


def test_faces_that_just_miss_each_other_are_named_with_the_gap() -> None:
    low, middle, _ = tower()
    _, problems = complete(
        model_of([low, replace(middle, world_T_component=Pose((0.0, 0.0, 0.3023)))])
    )
    assert [(p.code, p.where) for p in problems] == [("G5", "low"), ("F2", "middle")]
    assert "2.3 mm" in problems[0].message


def test_a_stated_ground_level_is_kept_and_reported_if_nothing_stands_there() -> None:
    model, problems = complete(replace(model_of(tower()), ground_z_m=0.5))
    assert model.ground_z_m == 0.5
    assert [(p.code, p.where) for p in problems] == [("P6", "build")]
    raised = [replace(c, world_T_component=_up(c)) for c in tower()]
    model, problems = complete(model_of(raised))
    assert (model.ground_z_m, problems) == (1.0, [])


def _up(component: Component) -> Pose:
    x, y, z = component.world_T_component.position_m
    return Pose((x, y, z + 1.0))
