"""Neutral records become a model: unit, frames, layers, ids, references, all that is wrong."""

from __future__ import annotations

import json
import math

import pytest

from builders_neutral import (
    box,
    box_surface,
    one,
    part,
    read,
    refusals,
    shifted,
    together,
)
from sitewright.building_model.component import (
    BoxGeometry,
    CompoundGeometry,
    ConvexGeometry,
    ExtrusionGeometry,
    Layer,
    PlaneCut,
    Process,
)
from sitewright.building_model.formats.import_map import ImportMap
from sitewright.building_model.formats.layer_rules import LayerNames
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    ExtrusionSolid,
    FacesSolid,
    NeutralRelation,
)
from sitewright.building_model.model import RelationKind
from sitewright.building_model.shapes import extent_of, shape_of, volume_of
from sitewright.errors import ModelRejectedError
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector, rotation

TILTED = rotation((0.3, 1.0, 0.2), 0.7)


def close(values: Vector, expected: Vector) -> bool:
    return all(math.isclose(a, b, abs_tol=1e-6) for a, b in zip(values, expected, strict=True))


# unit and origin


def test_a_file_without_unit_is_refused_with_both_readings() -> None:
    (problem,) = refusals([part("a", box(size=(2400.0, 100.0, 60.0)))], metres=None)
    assert problem.code == "U1"
    assert "Longest part 2400: as mm 2.4 m, as m 2400 m" in problem.message
    assert "--unit mm" in problem.fix


def test_the_unit_of_the_user_is_taken() -> None:
    model, problems = read(
        [part("a", box(at=(1000.0, 0.0, 0.0), size=(2400.0, 100.0, 60.0)))], metres=None, unit="mm"
    )
    component = model.component_by_id["a"]  # type: ignore[index]
    assert component.geometry == BoxGeometry(pytest.approx((2.4, 0.1, 0.06)))  # type: ignore[arg-type]
    assert component.world_T_component.position_m == pytest.approx((1.0, 0.0, 0.0))
    assert problems == []


def test_metres_in_place_of_millimetres_are_suspected() -> None:
    _, problems = read([part("a", box(size=(2400.0, 100.0, 60.0)))])
    assert [(p.code, p.severity) for p in problems] == [("U2", "W")]
    assert "mm" in problems[0].fix


def test_a_unit_against_the_file_is_told_and_wins() -> None:
    model, problems = read([part("a")], metres=0.001, unit="m")
    assert [p.code for p in problems] == ["U2"]
    assert "states mm, you say m" in problems[0].message
    assert next(iter(model.component_by_id.values())).geometry == BoxGeometry((2.0, 0.1, 0.2))


def test_a_far_model_is_shifted_and_told() -> None:
    model, problems = read([part("a", box(at=(1.0e6, 5.0e5, 12.0)))])
    assert [p.code for p in problems] == ["O1"]
    assert model.origin_shift_m == (1.0e6, 5.0e5, 12.0)
    assert model.component_by_id["a"].world_T_component.position_m == (0.0, 0.0, 0.0)  # type: ignore[index]


def test_a_stray_far_off_the_others_is_refused() -> None:
    parts = [part("a"), part("b"), part("stray", box(at=(3.0e5, 0.0, 0.0)))]
    (problem,) = refusals(parts)
    assert (problem.code, problem.where) == ("O1", "stray")


@pytest.mark.parametrize("number", [math.nan, math.inf])
def test_a_number_that_is_none_is_refused(number: float) -> None:
    surface = box_surface((1.0, 1.0, 1.0))
    broken = FacesSolid(vertices=((number, 0.0, 0.0), *surface.vertices[1:]), faces=surface.faces)
    (problem,) = refusals([part("a", broken)])
    assert problem.code == "K3"


# frames and shapes


def test_a_box_with_grain_keeps_its_frame() -> None:
    solid = BoxSolid(file_T_box=TILTED, size=(0.1, 2.0, 0.2), has_grain=True)
    component = one("a", solid)
    assert component.geometry == BoxGeometry((0.1, 2.0, 0.2))
    assert component.world_T_component == TILTED


def test_a_box_without_grain_has_its_longest_edge_along_x_and_points_upwards() -> None:
    down = Pose.from_axes((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0))
    component = one("a", BoxSolid(file_T_box=down, size=(0.1, 2.0, 0.2)))
    assert component.geometry == BoxGeometry((2.0, 0.2, 0.1))
    assert close(component.world_T_component.x_axis, (0.0, 0.0, 1.0))
    assert close(component.world_T_component.y_axis, (1.0, 0.0, 0.0))


def test_a_tilted_box_of_faces_is_found_exactly() -> None:
    component = one("a", box_surface((2.0, 0.06, 0.12), TILTED))
    assert isinstance(component.geometry, BoxGeometry)
    assert close(component.geometry.size_m, (2.0, 0.12, 0.06))
    assert (
        abs(abs(sum(map(float.__mul__, component.world_T_component.x_axis, TILTED.x_axis))) - 1)
        < 1e-9
    )


def test_a_box_of_triangles_with_doubled_corners_is_a_box() -> None:
    surface = box_surface((1.0, 0.5, 0.25), TILTED)
    vertices: list[Vector] = []
    faces = []
    for a, b, c, d in surface.faces:
        for triangle in ((a, b, c), (a, c, d)):
            faces.append(tuple(range(len(vertices), len(vertices) + 3)))
            vertices += [surface.vertices[i] for i in triangle]
    component = one("a", FacesSolid(vertices=tuple(vertices), faces=tuple(faces)))
    assert isinstance(component.geometry, BoxGeometry)
    assert close(component.geometry.size_m, (1.0, 0.5, 0.25))


def wedge() -> FacesSolid:
    corners = ((0, 0, 0), (2, 0, 0), (1.5, 0, 0.2), (0, 0, 0.2))
    vertices = tuple((float(x), y, float(z)) for y in (0.0, 0.1) for x, _, z in corners)
    faces = ((0, 1, 2, 3), (7, 6, 5, 4), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))
    return FacesSolid(vertices=vertices, faces=faces)


def test_a_slanted_end_makes_a_convex_shape_along_its_length() -> None:
    component = one("a", wedge())
    assert isinstance(component.geometry, ConvexGeometry)
    assert volume_of(component) == pytest.approx(1.75 * 0.2 * 0.1)
    assert extent_of(shape_of(component)).size_m == pytest.approx((2.0, 0.2, 0.1))
    assert close(component.world_T_component.position_m, (1.0, 0.05, 0.1))


def test_a_notched_beam_is_told_to_be_filled() -> None:
    notch = ((0, 0), (1, 0), (1, 0.1), (0.6, 0.1), (0.6, 0.05), (0.4, 0.05), (0.4, 0.1), (0, 0.1))
    vertices = tuple((float(x), y, float(z)) for y in (0.0, 0.06) for x, z in notch)
    sides = [(i, (i + 1) % 8, (i + 1) % 8 + 8, i + 8) for i in range(8)]
    faces = (tuple(range(8)), tuple(range(15, 7, -1)), *sides)
    model, problems = read([part("a", FacesSolid(vertices=vertices, faces=faces))])
    assert [(p.code, p.severity) for p in problems] == [("G7", "W")]
    assert "not convex" in problems[0].message
    assert volume_of(model.component_by_id["a"]) == pytest.approx(0.006)  # type: ignore[index]


def test_a_round_shape_keeps_few_corners() -> None:
    turns = [2.0 * math.pi * i / 200 for i in range(200)]
    vertices = tuple((0.1 * math.cos(t), 0.1 * math.sin(t), z) for z in (0.0, 1.0) for t in turns)
    sides = [(i, (i + 1) % 200, (i + 1) % 200 + 200, i + 200) for i in range(200)]
    faces = (tuple(range(199, -1, -1)), tuple(range(200, 400)), *sides)
    model, problems = read([part("a", FacesSolid(vertices=vertices, faces=faces))])
    component = model.component_by_id["a"]  # type: ignore[index]
    assert isinstance(component.geometry, ConvexGeometry)
    assert len(component.geometry.points_m) <= 48
    assert "many corners" in problems[0].message
    assert volume_of(component) == pytest.approx(0.0314, rel=0.05)


def test_a_rectangular_profile_is_a_box() -> None:
    profile = ((0.0, 0.0), (0.0, 0.12), (0.06, 0.12), (0.06, 0.0), (0.0, 0.0))
    component = one("a", ExtrusionSolid(file_T_profile=TILTED, profile=profile, depth=-2.0))
    assert isinstance(component.geometry, BoxGeometry)
    assert close(component.geometry.size_m, (2.0, 0.12, 0.06))
    assert close(component.world_T_component.position_m, TILTED.apply((0.03, 0.06, -1.0)))


def test_another_profile_stays_an_extrusion_in_the_fitted_frame() -> None:
    profile = ((0.0, 0.0), (0.3, 0.0), (0.3, 0.1), (0.1, 0.1), (0.1, 0.3), (0.0, 0.3))
    component = one("a", ExtrusionSolid(file_T_profile=TILTED, profile=profile, depth=2.0))
    assert isinstance(component.geometry, CompoundGeometry)
    ((_, inner),) = component.geometry.parts
    assert inner == ExtrusionGeometry(profile, 2.0)
    assert extent_of(shape_of(component)).size_m == pytest.approx((2.0, 0.3, 0.3))
    assert extent_of(shape_of(component)).low_m == pytest.approx((-1.0, -0.15, -0.15))
    assert volume_of(component) == pytest.approx(0.05 * 2.0)


def test_openings_in_a_profile_are_told_to_be_filled() -> None:
    profile = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0))
    hole = ((0.5, 0.5), (0.7, 0.5), (0.7, 0.7))
    solid = ExtrusionSolid(file_T_profile=Pose(), profile=profile, depth=0.1, holes=(hole,))
    _, problems = read([part("a", solid)])
    assert [p.code for p in problems] == ["G7"]
    assert "1 openings" in problems[0].message


def test_saw_cuts_come_into_the_frame_of_the_component() -> None:
    solid = BoxSolid(file_T_box=TILTED, size=(100.0, 60.0, 2000.0))
    cut = PlaneCut((0.0, 0.0, 900.0), (0.0, 0.0, 2.0))
    model, _ = read([part("a", solid, cuts=(cut,))], metres=0.001)
    component = model.component_by_id["a"]  # type: ignore[index]
    assert volume_of(component) == pytest.approx(1.9 * 0.1 * 0.06)


def test_an_open_mesh_is_refused_or_closed_by_its_hull() -> None:
    surface = box_surface((1.0, 0.5, 0.25))
    holey = FacesSolid(vertices=surface.vertices, faces=surface.faces[:-1])
    (problem,) = refusals([part("a", holey)])
    assert problem.code == "G2"
    assert "4 boundary edges" in problem.message
    assert problem.fix == "--repair hull"
    model, problems = read([part("a", holey)], repair="hull")
    assert volume_of(model.component_by_id["a"]) == pytest.approx(0.125)  # type: ignore[index]
    assert [(p.code, p.severity) for p in problems] == [("G2", "W")]


def test_separate_solids_of_one_part_are_refused_or_split() -> None:
    studs = together(*(shifted(box_surface((0.06, 0.12, 2.0)), (i, 0.0, 0.0)) for i in range(20)))
    (problem,) = refusals([part("Studs", studs)])
    assert problem.code == "G4"
    assert "20 separate solids" in problem.message
    assert "--split makes 20 components" in problem.fix
    model, _ = read([part("Studs", studs)], split=True)
    assert set(model.component_by_id) == {f"Studs.{i}" for i in range(1, 21)}


def test_solids_that_touch_are_one_component() -> None:
    flange, web = box(size=(2.0, 0.3, 0.02)), box(at=(0.0, 0.0, 0.11), size=(2.0, 0.02, 0.2))
    model, problems = read([part("a", flange, web)])
    component = model.component_by_id["a"]  # type: ignore[index]
    assert isinstance(component.geometry, CompoundGeometry)
    assert len(component.geometry.parts) == 2
    assert volume_of(component) == pytest.approx(2.0 * 0.3 * 0.02 + 2.0 * 0.02 * 0.2)
    assert [(p.code, p.severity) for p in problems] == [("G4", "W")]


def test_a_block_of_separate_solids_is_one_component() -> None:
    solids = (box(), box(at=(0.0, 5.0, 0.0)))
    model, problems = read([part("a", *solids, kind="block instance")])
    assert len(model.component_by_id) == 1
    assert problems == []


@pytest.mark.parametrize(
    "solid",
    [
        box(size=(1.0, 0.0, 1.0)),
        FacesSolid(
            vertices=((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
            faces=((0, 1, 2), (2, 1, 0)),
        ),
        ExtrusionSolid(file_T_profile=Pose(), profile=((0.0, 0.0), (1.0, 0.0), (1, 1)), depth=0.0),
    ],
)
def test_what_has_no_volume_is_refused(solid: BoxSolid | FacesSolid | ExtrusionSolid) -> None:
    assert {p.code for p in refusals([part("good"), part("flat", solid)])} == {"G6"}


def test_parts_without_solids_are_left_out_and_told_together() -> None:
    curves = [
        part(f"c{i}", kind="curve").__class__(source_id=f"c{i}", kind="curve") for i in range(5)
    ]
    model, problems = read([part("a"), *curves])
    assert set(model.component_by_id) == {"a"}
    (problem,) = problems
    assert (problem.code, problem.where) == ("G7", "curve")
    assert "5 of this kind" in problem.message


# words


@pytest.mark.parametrize(
    ("path", "layer", "type_", "group"),
    [
        ("", Layer.TARGET, "component", ""),
        ("Default", Layer.TARGET, "component", ""),
        ("Target::Studs", Layer.TARGET, "Studs", ""),
        ("As-Built::Wall 1::sill", Layer.AS_BUILT, "sill", "Wall 1"),
        ("as_designed", Layer.AS_DESIGNED, "component", ""),
        ("VIRTUAL COLLISION::crane", Layer.VIRTUAL_COLLISION, "crane", ""),
        ("Target::House::Material::boards", Layer.MATERIAL, "boards", "House"),
        ("Storey 1[IfcStorey]::IfcWall", Layer.TARGET, "IfcWall", "Storey 1"),
        ("Wall A[IfcWall]", Layer.TARGET, "IfcWall", "Wall A"),
    ],
)
def test_layers_say_role_type_and_group(path: str, layer: Layer, type_: str, group: str) -> None:
    component = one("a", layer_path=path)
    assert (component.layer, component.type, component.group) == (layer, type_, group)


def test_our_keys_win_over_layers_and_records() -> None:
    text = {
        "id": "stud-1",
        "name": "Stud",
        "type": "stud",
        "layer": "As Built",
        "order": "3",
        "material": "softwood",
        "group": "wall",
        "mass_kg": "4,5",
        "ground": "yes",
        "process": "nail",
        "method": "two-sided",
    }
    component = one("guid", text=text, layer_path="Target::Beams", order=7, material="oak")
    assert component.id == "stud-1"
    assert component.source is not None
    assert component.source.id == "guid"
    assert (component.name, component.type, component.layer) == ("Stud", "stud", Layer.AS_BUILT)
    assert (component.order, component.material, component.group) == (3, "softwood", "wall")
    assert (component.mass_kg, component.ground) == (4.5, True)
    assert component.ext == {"process": "nail", "method": "two-sided"}
    assert component.raw == {}


def test_unknown_attributes_are_kept_and_misspelt_keys_are_told() -> None:
    model, problems = read(
        [part("a", text={"ordr": "4", "status": "verified"}, other={"Fire": "R30"}, raw={"n": 1})]
    )
    component = model.component_by_id["a"]  # type: ignore[index]
    assert component.raw == {"Fire": "R30", "n": 1, "sitewright.ordr": "4"}, "status is an export's"
    assert [p.code for p in problems] == ["K1"]
    assert "Did you mean order" in problems[0].message


def test_formulas_are_told_and_not_taken() -> None:
    model, problems = read([part("a", text={"order": "%<Volume('x')>%"})])
    assert [p.code for p in problems] == ["T1"]
    assert model.component_by_id["a"].order is None  # type: ignore[index]


def test_the_users_map_names_foreign_keys_and_layers() -> None:
    words = ImportMap(
        foreign_keys={"order": ("Step", "Pset_X.Order"), "material": ("Holz",)},
        layers=LayerNames(role_by_name={"lager": Layer.MATERIAL}),
    )
    parts = [
        part("a", other={"Step": "2"}, raw={"Holz": "oak"}),
        part("b", raw={"Pset_X": {"Order": 5}}, layer_path="Lager"),
    ]
    model, _ = read(parts, mapping=words)
    a, b = model.component_by_id["a"], model.component_by_id["b"]  # type: ignore[index]
    assert (a.order, a.material, b.order, b.layer) == (2, "oak", 5, Layer.MATERIAL)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("order", "soon"),
        ("order", "1.5"),
        ("mass_kg", "-1"),
        ("mass_kg", "nan"),
        ("ground", "maybe"),
        ("layer", "tarjet"),
    ],
)
def test_values_that_cannot_be_read_are_refused(key: str, value: str) -> None:
    (problem,) = refusals([part("a", text={key: value})])
    assert problem.code == "K1"
    assert value in problem.message


def test_names_lose_control_and_direction_marks_and_length() -> None:
    component = one("a", name="stud\u202e\x00 1\n" + "x" * 500)
    assert component.name.startswith("stud 1x")
    assert len(component.name) == 256


# ids and references


def test_ids_get_our_characters_and_keep_their_source() -> None:
    component = one("Mesh 0/ä")
    assert component.id == "Mesh_0__"
    assert component.source is not None
    assert component.source.id == "Mesh 0/ä"
    assert len(one("x" * 200).id) == 64
    assert one("x" * 200).id != one("x" * 201).id


def test_one_id_twice_is_refused() -> None:
    parts = [part("a", text={"id": "s"}), part("b", text={"id": "s"}), part("c")]
    (problem,) = refusals(parts)
    assert (problem.code, problem.where) == ("D1", "s")
    assert "2 components" in problem.message


def test_parents_are_found_by_id_source_id_or_unique_name() -> None:
    parts = [
        part("guid-1", text={"id": "sill"}),
        part("guid-2", name="Plate"),
        part("guid-3", text={"parent": "sill; guid-2 ;guid-1;"}),
        part("guid-4", parents=("Plate",)),
    ]
    model, _ = read(parts)
    assert model.component_by_id["guid-3"].construction_parents == ("sill", "guid-2")  # type: ignore[index]
    assert model.component_by_id["guid-4"].construction_parents == ("guid-2",)  # type: ignore[index]


def test_a_name_that_many_have_and_one_that_nobody_has_are_both_told() -> None:
    parts = [part(f"s{i}", name="Stud") for i in range(7)]
    parts += [part("x", text={"parent": "Stud;Stub"})]
    named, unknown = refusals(parts)
    assert (named.code, unknown.code) == ("N1", "P1")
    assert "'Stud' matches 7 components" in named.message
    assert "Did you mean" in unknown.message


def test_parents_in_a_circle_are_refused() -> None:
    parts = [part("a", parents=("b",)), part("b", parents=("a",))]
    assert [p.code for p in refusals(parts)] == ["P2"]


def test_relations_come_along_in_metres() -> None:
    data: dict[str, Json] = {"area": 4.0, "location": [100.0, 0.0, 0.0], "type": "interface"}
    relation = NeutralRelation(kind="contact", a="a", b="b", data=data)
    parts = [part("a", box(size=(2000.0, 100.0, 100.0))), part("b", box(size=(2000.0, 90.0, 90.0)))]
    model, _ = read(parts, metres=0.001, relations=(relation,))
    (found,) = model.relations
    assert found.kind is RelationKind.CONTACT
    assert found.data["area_m2"] == pytest.approx(4e-6)
    assert found.data["location_m"] == pytest.approx([0.1, 0.0, 0.0])


def test_operations_are_read_from_text() -> None:
    ops = [
        {
            "process": "nail",
            "at": [1000.0, 0.0, 50.0],
            "direction": [0, 0, -1],
            "on": ["a", "Plate"],
            "fastener": {"type": "nail", "d_m": 0.003, "l_m": 0.09},
        }
    ]
    parts = [
        part("a", box(size=(2000.0, 100.0, 100.0)), text={"ops": json.dumps(ops)}),
        part("b", box(at=(0.0, 0.0, -100.0), size=(2000.0, 100.0, 100.0)), name="Plate"),
    ]
    model, _ = read(parts, metres=0.001)
    (operation,) = model.component_by_id["a"].operations  # type: ignore[index]
    assert (operation.id, operation.process, operation.on) == ("a.op1", Process.NAIL, ("a", "b"))
    assert operation.component_T_operation.position_m == pytest.approx((1.0, 0.0, 0.05))
    assert close(operation.component_T_operation.z_axis, (0.0, 0.0, -1.0))


@pytest.mark.parametrize(
    ("name", "reference"),
    [
        ("Obere Platte 2 (Achse A)", "Obere Platte 2 (Achse A)"),
        ("Obere Platte 2 (Achse A)", " Obere Platte 2 (Achse A) "),
        ("Träger 1", "Tra\u0308ger 1"),  # the same letter, composed by one program only
        ("x" * 100, "x" * 100),
    ],
)
def test_operations_mean_components_by_any_name(name: str, reference: str) -> None:
    text = json.dumps([{"process": "nail", "on": ["a", reference]}])
    model, _ = read([part("a", text={"ops": text}), part("b 1", name=name)])
    (operation,) = model.component_by_id["a"].operations  # type: ignore[index]
    assert operation.on == ("a", "b_1")


def test_an_ambiguous_name_in_operations_is_told_by_that_name() -> None:
    text = json.dumps([{"process": "nail", "on": ["a", "Obere Platte"]}])
    parts = [part("a", text={"ops": text}), *(part(i, name="Obere Platte") for i in "bc")]
    (problem,) = refusals(parts)
    assert (problem.code, problem.where) == ("N1", "a")
    assert "Component of operation 1 'Obere Platte' matches 2" in problem.message


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("nail", "not JSON"),
        ('{"process": "nail"}', "no JSON list"),
        ("[" * 5000, "nested deeper"),
        ('[{"process": "nail", "process": "screw"}]', "stands twice"),
        (
            '[{"process": "nail", "at": [1%s, 0, 0], "direction": [0,0,1]}]' % ("0" * 250),
            "no place",
        ),
        ('[{"process": "nail", "at": [1e400, 0, 0], "direction": [0,0,1]}]', "too large"),
        ('[{"process": "nail", "on": [["Plate"]]}]', "on[1]"),
        ('[{"process": "nail", "on": "Plate"}]', "on:"),
        ('[{"process": "nail", "at": [1, 2]}]', "no list of three numbers"),
        ('[{"process": "nial"}]', "process"),
        ('[{"process": "nail", "at": [0,0,0], "direction": [0,0,0]}]', "no length"),
        ('[{"process": "nail", "on": ["nobody"]}]', "does not exist"),
        ('[{"process": "nail", "params": {"x": NaN}}]', "NaN is not a number"),
    ],
)
def test_operations_that_cannot_be_read_are_refused(text: str, words: str) -> None:
    problems = refusals([part("a", text={"ops": text})])
    assert problems
    assert any(words in p.message for p in problems)


def test_drawn_stacks_are_piled_by_index_in_the_frame_of_their_place() -> None:
    def piece(name: str, z: float, index: str) -> object:
        return part(
            name,
            box(at=(5.0, 3.0, z), size=(2.0, 0.1, 0.1)),
            layer_path="Material",
            text={"stack": "pile 1", "stack_index": index},
        )

    model, _ = read([piece("top", 0.15, "2"), piece("low", 0.05, "1")])  # type: ignore[list-item]
    (stack,) = model.stacks
    assert (stack.id, stack.place, stack.items) == ("pile_1", "pile_1", ("low", "top"))
    low = model.component_by_id[stack.items[0]].world_T_component
    assert low.position_m == pytest.approx((0.0, 0.0, 0.05))


def test_what_the_reader_could_not_read_is_told_and_drawn_things_are_spared() -> None:
    said = (("G3", "3 curved faces without saved mesh.", "Save it shaded."),)
    (problem,) = refusals([part("a"), part("b", problems=said)])
    assert (problem.code, problem.where) == ("G3", "b")
    _, problems = read([part("a"), part("b", problems=said, layer_path="As-Designed")])
    assert [(p.code, p.severity) for p in problems] == [("G3", "W")]


def test_everything_wrong_is_told_at_once() -> None:
    parts = [
        part("a", text={"order": "soon", "parent": "nobody"}),
        part("b", box(size=(0.0, 1.0, 1.0))),
        part("c", text={"id": "a"}),
    ]
    assert {p.code for p in refusals(parts)} == {"K1", "P1", "G6", "D1"}


def test_a_file_without_parts_is_refused() -> None:
    assert [p.code for p in refusals([])] == ["E3"]
    with pytest.raises(ModelRejectedError, match="no solids"):
        read([part("a").__class__(source_id="a", kind="curve")])
