"""Rhino files: those of Rhino itself by their figures, drawn shapes, and what is refused."""

from __future__ import annotations

import random
import subprocess
import sys
from collections import Counter
from itertools import pairwise
from pathlib import Path

import pytest

from builders_rhino import Drawing, brep_box, extrusion, instance, moved, outline
from sitewright.building_model.formats.detect import FileKind
from sitewright.building_model.formats.foreign_files import read_foreign
from sitewright.building_model.formats.import_process import Limits
from sitewright.building_model.formats.neutral import ExtrusionSolid, FacesSolid, NeutralPart
from sitewright.building_model.formats.rhino import read_rhino
from sitewright.building_model.formats.rhino_units import METRES_PER_RHINO_UNIT
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.pose import cross, dot

rhino3dm = pytest.importorskip("rhino3dm", reason="needs rhino3dm: pip install 'sitewright[rhino]'")

SQUARE = [(0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (100.0, 50.0, 0.0), (0.0, 50.0, 0.0)]
ANGLE = [
    *((0.0, 0.0, 0.0), (40.0, 0.0, 0.0), (40.0, 10.0, 0.0)),
    *((10.0, 10.0, 0.0), (10.0, 30.0, 0.0), (0.0, 30.0, 0.0)),
]

SAVED_MESH = """
import os, sys, rhino3dm
mesh = rhino3dm.Mesh()
for corner in [(0, 0, 0), (6, 0, 0), (0, 6, 0), (0, 0, 6)]:
    mesh.Vertices.Add(*corner)
for face in [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]:
    mesh.Faces.AddFace(*face)
ball = rhino3dm.Brep.CreateFromSphere(rhino3dm.Sphere(rhino3dm.Point3d(0, 0, 0), 3.0))
assert ball.Faces[0].SetMesh(mesh, rhino3dm.MeshType.Render)
model = rhino3dm.File3dm()
model.Objects.AddBrep(ball)
assert model.Write(sys.argv[1], 8)
os._exit(0)  # SetMesh leaves the mesh with two owners; tidying up would crash
"""


def only_part(drawing: Drawing, tmp_path: Path) -> NeutralPart:
    (part,) = read_rhino(drawing.write(tmp_path / "drawing.3dm")).parts
    return part


def volume(solid: FacesSolid) -> float:
    v = solid.vertices
    fans = ((f[0], a, b) for f in solid.faces for a, b in pairwise(f[1:]))
    return sum(dot(v[a], cross(v[b], v[c])) / 6.0 for a, b, c in fans)


def is_closed(solid: FacesSolid) -> bool:
    edges = Counter(e for f in solid.faces for e in zip(f, (*f[1:], f[0]), strict=True))
    return all(n == 1 and edges[b, a] == 1 for (a, b), n in edges.items())


def refusal(path: Path, limits: Limits | None = None) -> Problem:
    with pytest.raises(ModelRejectedError) as rejected:
        read_foreign(path, FileKind.RHINO, limits=limits)
    (problem,) = rejected.value.problems
    return problem


def test_a_file_with_layers_of_bim_classes_gives_a_slab_and_two_walls(shared_data: Path) -> None:
    file = read_rhino(shared_data / "rhino" / "layer_template.3dm")
    assert file.metres_per_unit == 0.001
    assert [p.layer_path.rpartition("::")[2] for p in file.parts] == [
        "IfcSlab",
        "IfcWall",
        "IfcWall",
    ]
    assert all("Storey 1[IfcStorey]" in p.layer_path for p in file.parts)
    assert all(isinstance(s, ExtrusionSolid) for p in file.parts for s in p.solids)
    (slab,) = file.parts[0].solids
    assert isinstance(slab, ExtrusionSolid)
    assert slab.depth == pytest.approx(0.7479734922)


def test_two_instances_of_a_block_are_two_parts_and_its_sphere_is_named(shared_data: Path) -> None:
    file = read_rhino(shared_data / "rhino" / "blocks.3dm")
    assert [p.source_id for p in file.parts] == [
        "b6466e28-c56a-43f4-8f22-2aeabbc021f3",
        "0ea3a94a-840a-4896-8ae3-9cf252160512",
    ]
    assert {p.type for p in file.parts} == {"Block 01"}
    left, right = (p.solids[0] for p in file.parts)
    assert isinstance(left, ExtrusionSolid)
    assert isinstance(right, ExtrusionSolid)
    apart = right.file_T_profile.position_m[0] - left.file_T_profile.position_m[0]
    assert apart == pytest.approx(42.29887373318087 + 78.83008444266686, abs=1e-9)
    for part in file.parts:
        assert [code for code, _, _ in part.problems] == ["G3", "G7"]
        assert "1 of its 1 faces have no saved mesh" in part.problems[0][1]
        assert "round profile" in part.problems[1][1]


def test_user_text_is_kept_and_its_formulas_are_named_once(shared_data: Path) -> None:
    (part,) = read_rhino(shared_data / "rhino" / "object_UserStrings.3dm").parts
    assert part.user_text["firstKey"] == "123456"
    assert part.user_text["secondKey"] == "a value"
    assert len(part.user_text) == 5
    ((code, message, _),) = part.problems
    assert code == "T1"
    assert message.startswith("'Date', 'ObjectLayer', 'volume'")


def test_text_of_attributes_wins_over_text_of_geometry(tmp_path: Path) -> None:
    drawing = Drawing()
    shape = brep_box((0, 0, 0), (1, 1, 1))
    shape.SetUserString("a", "geometry")
    shape.SetUserString("b", "geometry")
    drawing.add(shape, text={"a": "attributes", "$made-by-rhino": "x"})
    assert only_part(drawing, tmp_path).user_text == {"a": "attributes", "b": "geometry"}


def test_a_concave_extrusion_keeps_profile_and_depth(tmp_path: Path) -> None:
    drawing = Drawing()
    drawing.add(extrusion(ANGLE, 500.0))
    (solid,) = only_part(drawing, tmp_path).solids
    assert isinstance(solid, ExtrusionSolid)
    placed = [solid.file_T_profile.apply((x, y, 0.0)) for x, y in solid.profile]
    assert sorted(placed) == [pytest.approx(p, abs=1e-6) for p in sorted(ANGLE)]
    assert solid.depth == pytest.approx(500.0)
    assert solid.file_T_profile.z_axis == pytest.approx((0.0, 0.0, 1.0))


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_hole_of_a_brep_is_no_material(tmp_path: Path, sign: float) -> None:
    drawing = Drawing()
    tube = extrusion(SQUARE, sign * 20.0)
    assert tube.AddInnerProfile(outline([(10, 10, 0), (20, 10, 0), (20, 30, 0), (10, 30, 0)]))
    drawing.add(tube.ToBrep(True))  # noqa: FBT003 - takes no keyword
    drawing.add(tube)
    brep, pulled = read_rhino(drawing.write(tmp_path / "tube.3dm")).parts
    (faces,), (solid,) = brep.solids, pulled.solids
    assert isinstance(faces, FacesSolid)
    assert is_closed(faces)
    assert volume(faces) == pytest.approx((5000.0 - 200.0) * 20.0)
    assert isinstance(solid, ExtrusionSolid)
    assert len(solid.holes) == 1


def test_a_mirrored_block_in_a_block_is_no_solid_turned_inside_out(tmp_path: Path) -> None:
    drawing = Drawing()
    inner = drawing.block("piece", brep_box((0, 0, 0), (10, 20, 30)))
    mirror = rhino3dm.Transform.Mirror(rhino3dm.Point3d(0, 0, 0), rhino3dm.Vector3d(1, 0, 0))
    outer = drawing.block("pair", instance(inner, mirror), brep_box((50, 0, 0), (60, 20, 30)))
    drawing.add(instance(outer, moved(1000, 0, 0)), name="Pair", text={"k": "v"})
    part = only_part(drawing, tmp_path)
    assert (part.name, part.type, part.kind, part.user_text) == (
        "Pair",
        "pair",
        "rhino block",
        {"k": "v"},
    )
    spans = []
    for solid in part.solids:
        assert isinstance(solid, FacesSolid)
        assert is_closed(solid)
        assert volume(solid) == pytest.approx(6000.0)
        spans.append((min(v[0] for v in solid.vertices), max(v[0] for v in solid.vertices)))
    assert spans == [pytest.approx((990.0, 1000.0)), pytest.approx((1050.0, 1060.0))]


def test_an_extrusion_of_a_sheared_block_becomes_oblique_faces(tmp_path: Path) -> None:
    drawing = Drawing()
    shear = rhino3dm.Transform.Identity()
    shear.M02 = 0.5
    drawing.add(instance(drawing.block("slanted", extrusion(SQUARE, 40.0)), shear))
    (solid,) = only_part(drawing, tmp_path).solids
    assert isinstance(solid, FacesSolid)
    assert is_closed(solid)
    assert volume(solid) == pytest.approx(5000.0 * 40.0)


def test_an_extrusion_without_caps_stays_open(tmp_path: Path) -> None:
    drawing = Drawing()
    drawing.add(extrusion(SQUARE, 40.0, is_capped=False))
    (solid,) = only_part(drawing, tmp_path).solids
    assert isinstance(solid, FacesSolid)
    assert not is_closed(solid)


def test_a_mesh_with_doubled_corners_is_welded(tmp_path: Path) -> None:
    mesh = rhino3dm.Mesh()
    corners = [(0, 0, 0), (6, 0, 0), (0, 6, 0), (0, 0, 6)]
    for number, face in enumerate([(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]):
        for i in face:
            mesh.Vertices.Add(*corners[i])
        mesh.Faces.AddFace(3 * number, 3 * number + 1, 3 * number + 2)
    drawing = Drawing()
    drawing.add(mesh)
    (solid,) = only_part(drawing, tmp_path).solids
    assert isinstance(solid, FacesSolid)
    assert len(solid.vertices) == 4
    assert is_closed(solid)
    assert volume(solid) == pytest.approx(36.0)


def test_a_curved_face_is_read_from_the_mesh_that_was_saved_with_it(tmp_path: Path) -> None:
    file = tmp_path / "saved.3dm"
    subprocess.run([sys.executable, "-c", SAVED_MESH, str(file)], check=True, timeout=60)
    (part,) = read_rhino(file).parts
    (solid,) = part.solids
    assert part.problems == ()
    assert isinstance(solid, FacesSolid)
    assert is_closed(solid)
    assert volume(solid) == pytest.approx(36.0)


def test_a_coarse_tolerance_of_the_file_does_not_eat_a_thin_plate(tmp_path: Path) -> None:
    drawing = Drawing("Meters")
    drawing.model.Settings.ModelAbsoluteTolerance = 0.01  # as in a template of Rhino
    drawing.add(brep_box((0, 0, 0), (2.0, 1.0, 0.005)))
    (solid,) = only_part(drawing, tmp_path).solids
    assert isinstance(solid, FacesSolid)
    assert is_closed(solid)
    assert volume(solid) == pytest.approx(0.01)


def test_groups_and_names_come_along_and_curves_are_counted(tmp_path: Path) -> None:
    drawing = Drawing()
    drawing.add(brep_box((0, 0, 0), (1, 1, 1)), name="Plate", layer="A::B", group="Panel 7")
    drawing.add(outline([(0, 0, 0), (1, 0, 0), (1, 1, 0)]))
    file = read_rhino(drawing.write(tmp_path / "x.3dm"))
    (part,) = file.parts
    assert (part.name, part.layer_path, part.group) == ("Plate", "A::B", "Panel 7")
    assert file.notes == ("1 x PolylineCurve: no solid; left out.",)


@pytest.mark.parametrize("unit", ["None", "Unset", "CustomUnits"])
def test_a_file_may_state_no_unit(tmp_path: Path, unit: str) -> None:
    drawing = Drawing(unit)
    drawing.add(brep_box((0, 0, 0), (1, 1, 1)))
    assert read_rhino(drawing.write(tmp_path / "x.3dm")).metres_per_unit is None


def test_every_unit_of_rhino_that_has_a_length_has_a_factor() -> None:
    names = {n for n in rhino3dm.UnitSystem.__members__ if n not in {"None", "Unset"}}
    assert names - {"CustomUnits"} == set(METRES_PER_RHINO_UNIT)


@pytest.mark.parametrize("share", [0.001, 0.3, 0.9, 0.9999])
def test_a_cut_off_file_is_told(shared_data: Path, tmp_path: Path, share: float) -> None:
    whole = (shared_data / "rhino" / "layer_template.3dm").read_bytes()
    half = tmp_path / "half.3dm"
    half.write_bytes(whole[: int(len(whole) * share)])
    assert refusal(half).code == "E4"


def test_a_damaged_file_is_told_by_the_library(shared_data: Path, tmp_path: Path) -> None:
    content = bytearray((shared_data / "rhino" / "layer_template.3dm").read_bytes())
    content[600:40000] = bytes(39400)
    damaged = tmp_path / "damaged.3dm"
    damaged.write_bytes(content)
    assert refusal(damaged).code in {"E2", "E4"}


def test_other_files_and_files_without_solids_are_told(tmp_path: Path) -> None:
    other = tmp_path / "other.3dm"
    other.write_text("ISO-10303-21;", encoding="utf-8")
    assert refusal(other).code == "E3"
    other.write_text("version https://git-lfs.github.com/spec/v1", encoding="utf-8")
    assert (refusal(other).code, refusal(other).fix) == ("E2", "Run: git lfs pull")
    drawing = Drawing()
    drawing.add(outline([(0, 0, 0), (1, 0, 0), (1, 1, 0)]))
    empty = refusal(drawing.write(tmp_path / "curves.3dm"))
    assert empty.code == "E3"
    assert "PolylineCurve" in empty.message


@pytest.mark.parametrize("seed", range(4))
def test_changed_bytes_give_records_or_one_clear_refusal(
    shared_data: Path, tmp_path: Path, seed: int
) -> None:
    content = bytearray((shared_data / "rhino" / "layer_template.3dm").read_bytes())
    chance = random.Random(seed)  # noqa: S311 - no secret
    objects = content.index(bytes.fromhex("13000010"))  # where the table of objects begins
    for _ in range(3):
        content[chance.randrange(objects, len(content))] = chance.randrange(256)
    changed = tmp_path / "changed.3dm"
    changed.write_bytes(content)
    try:
        told = {"parts"} if read_foreign(changed, FileKind.RHINO).parts else set()
    except ModelRejectedError as error:
        told = {p.code for p in error.problems}
    assert len(told) == 1
    assert told <= {"parts", "D1", "E2", "E3", "E4"}


def test_a_child_process_reads_the_same_as_we_do(shared_data: Path) -> None:
    file = shared_data / "rhino" / "blocks.3dm"
    assert read_foreign(file, FileKind.RHINO) == read_rhino(file)


def test_a_reader_without_time_is_no_crash(shared_data: Path) -> None:
    problem = refusal(shared_data / "rhino" / "blocks.3dm", Limits(wall_s=0.01))
    assert (problem.code, problem.severity) == ("E2", "E")
    assert "took longer" in problem.message
