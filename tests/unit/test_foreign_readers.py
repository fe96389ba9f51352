"""Readers in pure Python: BTLx, OBJ, compas_assembly and bar frames, each by small files."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sitewright.building_model.component import BoxGeometry
from sitewright.building_model.formats.bar_frame import read_bar_frame
from sitewright.building_model.formats.btlx import read_btlx
from sitewright.building_model.formats.compas_assembly import read_compas_assembly
from sitewright.building_model.formats.cut_joints import cut_joints
from sitewright.building_model.formats.detect import FileKind, kind_of
from sitewright.building_model.formats.from_neutral import model_of
from sitewright.building_model.formats.import_map import read_map
from sitewright.building_model.formats.neutral import BoxSolid, FacesSolid, NeutralFile
from sitewright.building_model.formats.obj import read_obj
from sitewright.building_model.model import BuildingModel, Relation
from sitewright.building_model.shapes import volume_of
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.pose import norm, subtract

UPRIGHT = ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0))
Place = tuple[tuple[float, float, float], ...]


def xyz(tag: str, at: tuple[float, float, float]) -> str:
    return f'<{tag} X="{at[0]}" Y="{at[1]}" Z="{at[2]}"/>'


def place(frame: Place, guid: str) -> str:
    origin, x, y = frame
    inner = xyz("ReferencePoint", origin) + xyz("XVector", x) + xyz("YVector", y)
    return f'<Transformation GUID="{{{guid}}}"><Position>{inner}</Position></Transformation>'


def cut(where: str, x: float, side: int = 1, angle: float = 90.0, incline: float = 90.0) -> str:
    return (
        f'<JackRafterCut ReferencePlaneID="{side}"><Orientation>{where}</Orientation>'
        f"<StartX>{x}</StartX><StartY>0</StartY><StartDepth>0</StartDepth>"
        f"<Angle>{angle}</Angle><Inclination>{incline}</Inclination></JackRafterCut>"
    )


def timber(
    number: int,
    *places: Place,
    work: str = "",
    size: tuple[float, float, float] = (1000.0, 120.0, 60.0),
    **attributes: Any,
) -> str:
    stated = {
        "SingleMemberNumber": number,
        "Designation": "Beam",
        "Annotation": "stud",
        "Count": len(places),
        "Length": size[0],
        "Height": size[1],
        "Width": size[2],
        **attributes,
    }
    words = " ".join(f'{k}="{v}"' for k, v in stated.items())
    where = "".join(place(p, f"g{number}-{i}") for i, p in enumerate(places))
    return (
        f"<Part {words}><Transformations>{where}</Transformations>"
        f"<Processings>{work}</Processings></Part>"
    )


def btlx(*parts: str, namespace: str = "https://www.design2machine.com") -> str:
    body = "".join(parts)
    return f'<BTLx xmlns="{namespace}"><Project><Parts>{body}</Parts></Project></BTLx>'


@pytest.fixture
def file(tmp_path: Path) -> Callable[[str | bytes], Path]:
    def write(content: str | bytes) -> Path:
        path = tmp_path / "design"
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    return write


Write = Callable[[str | bytes], Path]


def refusal(read: Callable[[Path], NeutralFile], path: Path) -> Problem:
    with pytest.raises(ModelRejectedError) as rejected:
        read(path)
    return rejected.value.problems[0]


def timber_model(path: Path) -> tuple[BuildingModel, list[Problem]]:
    return model_of(read_btlx(path), path)


# BTLx


def test_a_blank_stands_where_its_corner_says(file: Write) -> None:
    model, problems = timber_model(file(btlx(timber(7, UPRIGHT, Material="C24", Group="A"))))
    ((name, component),) = model.component_by_id.items()
    assert (name, component.name, component.type) == ("g7-0", "Beam 7", "stud")
    assert component.geometry == BoxGeometry(pytest.approx((1.0, 0.12, 0.06)))  # type: ignore[arg-type]
    assert component.world_T_component.position_m == pytest.approx((-0.03, 0.06, 0.5))
    assert component.material == "C24"
    assert component.raw["Group"] == "A"
    assert problems == []


@pytest.mark.parametrize("side", [1, 2, 3, 4])
def test_square_cuts_shorten_the_blank_from_both_ends(file: Write, side: int) -> None:
    work = cut("start", 30.0, side) + cut("end", 900.0, side)
    model, _ = timber_model(file(btlx(timber(1, UPRIGHT, work=work))))
    (component,) = model.component_by_id.values()
    assert volume_of(component) == pytest.approx(0.87 * 0.12 * 0.06)


@pytest.mark.parametrize(
    ("side", "turned", "depth_m"), [(1, "angle", 0.06), (2, "angle", 0.12), (1, "incline", 0.12)]
)
def test_slanted_cuts_take_half_a_wedge(
    file: Write, side: int, turned: str, depth_m: float
) -> None:
    """Side 1 is as wide as the width and as deep as the height, side 2 the other way round."""
    work = cut("end", 800.0, side, **{turned: 45.0})
    model, _ = timber_model(file(btlx(timber(1, UPRIGHT, work=work))))
    (component,) = model.component_by_id.values()
    straight, wedge = 0.8 * 0.12 * 0.06, depth_m * 0.12 * 0.06 / 2.0
    assert abs(volume_of(component) - straight) == pytest.approx(wedge, rel=1e-6)


def test_a_part_at_two_places_is_two_components(file: Write) -> None:
    other = ((500.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0))
    model, problems = timber_model(file(btlx(timber(1, UPRIGHT, other))))
    assert set(model.component_by_id) == {"g1-0", "g1-1"}
    assert problems == []


def test_pieces_without_a_place_are_refused(file: Write) -> None:
    path = file(btlx(timber(12, UPRIGHT, Count=8)))
    with pytest.raises(ModelRejectedError) as rejected:
        timber_model(path)
    (problem,) = rejected.value.problems
    assert problem.code == "P5"
    assert "Part 12: Count 8, 1 placements; 7 pieces have no pose." in problem.message


def test_drillings_are_kept_in_metres(file: Write) -> None:
    hole = (
        '<Drilling ReferencePlaneID="1"><StartX>500</StartX><StartY>30</StartY>'
        "<DepthLimited>no</DepthLimited><Diameter>14</Diameter></Drilling>"
    )
    model, problems = timber_model(file(btlx(timber(1, UPRIGHT, work=hole))))
    (component,) = model.component_by_id.values()
    assert component.raw["drillings"] == [
        {"start_m": [0.0, -0.06, 0.0], "direction": [0.0, 1.0, 0.0], "diameter_m": 0.014}
    ]
    assert problems == []


def test_other_processings_are_kept_and_told(file: Write) -> None:
    lap = '<Lap ReferencePlaneID="2"><StartX>100</StartX><Orientation>start</Orientation></Lap>'
    model, problems = timber_model(file(btlx(timber(1, UPRIGHT, work=lap + lap))))
    (component,) = model.component_by_id.values()
    kept = {"kind": "Lap", "@ReferencePlaneID": "2", "StartX": 100.0, "Orientation": "start"}
    assert component.raw["processings"] == [kept, kept]
    assert [p.code for p in problems] == ["G7"]
    assert "Lap (2 times)" in problems[0].message


def test_a_part_of_no_size_is_refused_by_its_id(file: Write) -> None:
    path = file(btlx(timber(1, UPRIGHT), timber(2, UPRIGHT, Length="long")))
    with pytest.raises(ModelRejectedError) as rejected:
        timber_model(path)
    assert [(p.code, p.where) for p in rejected.value.problems] == [("G6", "g2-0")]


def corner() -> tuple[str, str]:
    """Return an upright and a lying beam whose end is cut to the upright's side."""
    post = timber(1, UPRIGHT)
    along = ((-60.0, 0.0, 200.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    return post, timber(2, along, work=cut("start", 60.0))


def joined(relations: tuple[Relation, ...]) -> set[tuple[str, str]]:
    return {(r.a, r.b) for r in relations}


def test_a_cut_in_the_side_of_a_neighbour_is_a_joint(file: Write) -> None:
    model, _ = timber_model(file(btlx(*corner())))
    assert joined(cut_joints(model)) == {("g2-0", "g1-0")}


@pytest.mark.parametrize("by", [(2.0, 0.0), (0.0, 130.0), (0.0, -119.5)])
def test_a_cut_that_misses_the_neighbour_is_no_joint(file: Write, by: tuple[float, float]) -> None:
    post, _ = corner()
    along = ((-60.0 + by[0], by[1], 200.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    model, _ = timber_model(file(btlx(post, timber(2, along, work=cut("start", 60.0)))))
    near = by == (0.0, -119.5)
    assert joined(cut_joints(model)) == ({("g2-0", "g1-0")} if near else set())


@pytest.mark.parametrize(
    ("content", "code", "words"),
    [
        ("", "E2", "empty"),
        (btlx(namespace="http://example.org"), "E3", "expected BTLx of"),
        ("<BTLx/>", "E3", "namespace ''"),
        (btlx(timber(1, UPRIGHT))[:400], "E4", "cut off"),
        ("<BTLx></Part>", "E5", "mismatched tag"),
        ('<!DOCTYPE x [<!ENTITY a "b">]>' + btlx(), "E2", "DOCTYPE"),
        (btlx("<a>" * 100 + "</a>" * 100), "E2", "deeper than 64"),
        ('<?xml version="1.0" encoding="klingon"?>' + btlx(), "E5", "no XML"),
        ("version https://git-lfs.github.com/spec/v1\n", "E2", "Git LFS"),
    ],
)
def test_broken_btlx_is_one_clear_error(file: Write, content: str, code: str, words: str) -> None:
    problem = refusal(read_btlx, file(content))
    assert problem.code == code
    assert words in problem.message
    assert problem.fix


# OBJ

CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1))
SIDES = ("1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4")
FACES = "".join(f"f {side}\n" for side in SIDES)


def test_objects_are_parts_and_groups_inside_them_are_not(file: Write) -> None:
    text = f"mtllib a.mtl\no one\n{CUBE}g left\n{FACES}o two\nusemtl oak\n{FACES}o none\nl 1 2\n"
    neutral = read_obj(file(text))
    assert [(p.source_id, p.material) for p in neutral.parts] == [("one", ""), ("two", "oak")]
    assert neutral.metres_per_unit is None


def test_without_objects_groups_are_parts_and_go_on_where_they_stopped(file: Write) -> None:
    text = f"{CUBE}g a\nf {SIDES[0]}\nf {SIDES[1]}\ng b\n{FACES}g a\n" + "".join(
        f"f {side}\n" for side in SIDES[2:]
    )
    neutral = read_obj(file(text))
    assert [p.source_id for p in neutral.parts] == ["a", "b"]
    assert all(
        isinstance(s, FacesSolid) and len(s.faces) == 6 for p in neutral.parts for s in p.solids
    )


def test_two_objects_of_one_name_stay_two(file: Write) -> None:
    neutral = read_obj(file(f"{CUBE}o a\n{FACES}o a\n{FACES}"))
    assert [(p.source_id, p.name) for p in neutral.parts] == [("a", "a"), ("a.2", "a")]


def test_negative_indices_and_textures_and_long_lines_are_understood(file: Write) -> None:
    face = "f -8/1/1 -7//2 \\\n -5 -6/3\n"
    (part,) = read_obj(file(CUBE + face)).parts
    (solid,) = part.solids
    assert isinstance(solid, FacesSolid)
    assert solid.vertices == ((0, 0, 0), (0, 0, 1), (0, 1, 0), (0, 1, 1))
    assert solid.faces == ((0, 1, 3, 2),)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("v 0 0", "Line 1: a vertex needs three numbers"),
        ("v 0 0 x", "Line 1: a vertex needs three numbers"),
        ("f 1 2", "Line 1: a face needs three corners"),
        ("f 1 2 3", "does not stand above it"),
        ("f 0 0 0", "does not stand above it"),
        ("f 1 2 2147483648", "does not stand above it"),
        ("f a b c", "whole numbers"),
    ],
)
def test_a_broken_line_is_told_by_its_number(file: Write, line: str, words: str) -> None:
    problem = refusal(read_obj, file(line + "\n"))
    assert problem.code == "E5"
    assert words in problem.message


# compas_assembly


def block(dx: float = 0.0, **more: Any) -> dict[str, Any]:
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    vertex = {str(i): {"x": x + dx, "y": y, "z": z} for i, (x, y, z) in enumerate(corners)}
    face = {str(i): [int(n) - 1 for n in side.split()] for i, side in enumerate(SIDES)}
    return {"block": {"data": {"vertex": vertex, "face": face}}, **more}


def assembly(nodes: dict[str, Any], edges: dict[str, Any] | None = None) -> str:
    graph = {"data": {"node": nodes, "edge": edges or {}}}
    kind = "compas_assembly.datastructures/Assembly"
    return json.dumps({"dtype": kind, "data": {"graph": graph}})


def test_blocks_supports_and_interfaces_are_read(file: Write) -> None:
    frame = {"data": {"point": [1, 0.5, 0.5], "xaxis": [0, 1, 0], "yaxis": [0, 0, 1]}}
    edges = {"0": {"1": {"interfaces": [{"data": {"size": 1.0, "frame": frame}}]}}}
    path = file(assembly({"0": block(is_support=True), "1": block(1.0)}, edges))
    assert kind_of(path.read_bytes()) is FileKind.COMPAS_ASSEMBLY
    model, problems = model_of(read_compas_assembly(path), path, unit="m")
    assert problems == []
    assert [c.ground for c in model.component_by_id.values()] == [True, False]
    assert {c.type for c in model.component_by_id.values()} == {"block"}
    (contact,) = model.relations
    assert contact.data["area_m2"] == 1.0
    assert contact.data["location_m"] == [1.0, 0.5, 0.5]
    assert contact.data["plane_normal"] == [1.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("content", "code", "words"),
    [
        ("{", "E4", "cut off"),
        ('{"data": {"graph": {}}}', "K1", "missing"),
        ("[]", "K1", "dictionary"),
        (assembly({"0": block()}).replace('"x": 1.0', '"x": NaN', 1), "K3", "NaN"),
        (assembly({"0": block()}).replace('"x": 1.0', '"x": 1e999', 1), "K3", "too large"),
        (assembly({"0": block()}).replace("[0, 1, 3, 2]", "[0, 1, 99]"), "E5", "'99'"),
        ('{"a": ' + "[" * 50 + "]" * 50 + "}", "E5", "deeper than 32"),
    ],
)
def test_a_broken_assembly_is_told(file: Write, content: str, code: str, words: str) -> None:
    problem = refusal(read_compas_assembly, file(content))
    assert problem.code == code
    assert words in problem.message


# bar frames


def bars(**changes: Any) -> str:
    nodes = [((0, 0, 0), 1), ((0, 0, 1000), 0), ((1000, 0, 1000), 0)]
    document = {
        "unit": "millimeter",
        "material_properties": {
            "material_name": "PLA",
            "cross_sec_area": 16.0,
            "cross_sec_area_unit": "centimeter^2",
        },
        "base_frame_in_rob_base": {"Origin": {"X": 700.0}},
        "node_list": [
            {"node_id": i, "point": dict(zip("XYZ", p, strict=True)), "is_grounded": g}
            for i, (p, g) in enumerate(nodes)
        ],
        "element_list": [
            {"element_id": 0, "end_node_ids": [0, 1]},
            {"element_id": 1, "end_node_ids": [1, 2]},
        ],
        **changes,
    }
    return json.dumps(document)


def test_bars_lie_on_their_lines_with_the_stated_section(file: Write) -> None:
    path = file(bars())
    model, problems = model_of(read_bar_frame(path), path)
    assert problems == []
    upright, level = model.component_by_id.values()
    assert upright.geometry == BoxGeometry(pytest.approx((1.0, 0.04, 0.04)))  # type: ignore[arg-type]
    assert norm(subtract(upright.world_T_component.x_axis, (0.0, 0.0, 1.0))) < 1e-9
    assert level.world_T_component.position_m == pytest.approx((0.5, 0.0, 1.0))
    assert (upright.ground, level.ground, level.material) == (True, False, "PLA")
    assert joined(model.relations) == {("0", "1")}
    assert level.raw["base_frame_in_rob_base"] == {"Origin": {"X": 700.0}}


def test_a_frame_without_unit_counts_its_section_in_its_own_unit(file: Write) -> None:
    (first, _) = read_bar_frame(file(bars(unit=None))).parts
    (solid,) = first.solids
    assert isinstance(solid, BoxSolid)
    assert solid.size == pytest.approx((1000.0, 4.0, 4.0))


@pytest.mark.parametrize(
    ("changes", "code", "words"),
    [
        ({"unit": "millimetre"}, "U1", "Did you mean millimeter"),
        ({"material_properties": {}}, "K1", "missing"),
        ({"element_list": [{"element_id": 0, "end_node_ids": [0, 9]}]}, "P1", "not in the list"),
        ({"element_list": [{"element_id": 0, "end_node_ids": [0]}]}, "K1", "at least 2"),
        (
            {"material_properties": {"cross_sec_area": 1.0, "cross_sec_area_unit": "cm"}},
            "U1",
            "no squared length",
        ),
    ],
)
def test_a_broken_frame_is_told(
    file: Write, changes: dict[str, Any], code: str, words: str
) -> None:
    problem = refusal(read_bar_frame, file(bars(**changes)))
    assert problem.code == code
    assert words in problem.message


def test_a_bar_without_length_is_refused_by_its_id(file: Write) -> None:
    path = file(bars(element_list=[{"element_id": 4, "end_node_ids": [1, 1]}]))
    with pytest.raises(ModelRejectedError) as rejected:
        model_of(read_bar_frame(path), path)
    assert [(p.code, p.where) for p in rejected.value.problems] == [("G6", "4")]


# kinds and maps


@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (b"3D Geometry File Format 8", FileKind.RHINO),
        (b"\n ISO-10303-21;", FileKind.IFC),
        (b"\xef\xbb\xbf<?xml?><BTLx xmlns='https://www.design2machine.com'>", FileKind.BTLX),
        (b"# made by x\nmtllib a\nv 0 0 0\n", FileKind.OBJ),
        (b'{"schema": "sitewright.building/1"}', FileKind.NATIVE),
        (b'{"node_list": [], "element_list": []}', FileKind.BAR_FRAME),
        (b'{"dtype": "compas_timber.model/TimberModel"}', FileKind.COMPAS_TIMBER),
        (b'{"a": 1}', FileKind.JSON),
        (b"vertical text\nof no kind\n", FileKind.UNKNOWN),
        (b"PK\x03\x04", FileKind.UNKNOWN),
    ],
)
def test_the_kind_is_told_by_the_content(content: bytes, kind: FileKind) -> None:
    assert kind_of(content) is kind


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("[user_text]\nordr = 'x'", "Did you mean order"),
        ("[user_text]\norder = 3", "no list of keys"),
        ("[layers]\nHolz = 'wood'", "is no layer"),
        ("[user_txt]\norder = 'x'", "Did you mean user_text"),
        ("user_text = 3", "no key 'user_text'"),
        ("[user_text", "no TOML"),
        ("[[layers]]\nHolz = 'wood'", "is no layer"),
    ],
)
def test_a_broken_map_is_told(file: Write, content: str, words: str) -> None:
    with pytest.raises(ModelRejectedError) as rejected:
        read_map(file(content))
    assert words in rejected.value.problems[0].message


def test_a_map_names_keys_and_layers(file: Write) -> None:
    words = read_map(
        file("[user_text]\norder = ['Step', 'No']\n[layers]\n'Rohmaterial' = 'material'")
    )
    assert words.foreign_keys == {"order": ("Step", "No")}
    assert words.layers.role_of("roh-material") == "material"
