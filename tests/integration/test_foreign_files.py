"""Real files of other programs: their figures, and the whole import command."""

from __future__ import annotations

import time
from collections import Counter
from itertools import combinations, pairwise
from pathlib import Path

import pytest
from click.testing import CliRunner

from sitewright.app.importing import ImportOptions, import_file, read_design
from sitewright.app.project import ProjectError
from sitewright.building_model.component import BoxGeometry, Component, ConvexGeometry, Layer
from sitewright.building_model.formats.compas_assembly import read_compas_assembly
from sitewright.building_model.formats.detect import FileKind
from sitewright.building_model.formats.native import read_building, write_building
from sitewright.building_model.formats.neutral import FacesSolid
from sitewright.building_model.inference.contact import contacts_of
from sitewright.building_model.inference.solid import solid_of
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.building_model.same_value import is_same
from sitewright.building_model.shapes import extent_of, shape_of, volume_of
from sitewright.building_model.validation import check_model
from sitewright.cli.main import commands
from sitewright.construction_graph.project_check import check_project
from sitewright.errors import BackendMissingError, ModelRejectedError
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import cross, dot
from sitewright.robot_team.formats.cell_toml import read_cell

CELL = Path(__file__).parents[2] / "examples" / "frame_house" / "cell.toml"


def design(path: Path, **options: str) -> tuple[FileKind, BuildingModel]:
    kind, model, problems = read_design(path, ImportOptions(**options))  # type: ignore[arg-type]
    assert not any(p.severity == "E" for p in problems)
    return kind, model


def pairs(model: BuildingModel, kind: RelationKind) -> set[frozenset[ComponentId]]:
    return {frozenset((r.a, r.b)) for r in model.relations if r.kind is kind}


def lengths_mm(model: BuildingModel) -> Counter[float]:
    return Counter(
        round(c.geometry.size_m[0] * 1000.0, 1)
        for c in model.component_by_id.values()
        if isinstance(c.geometry, BoxGeometry)
    )


def reach_m(component: Component) -> tuple[float, ...]:
    extent = extent_of(shape_of(component), component.world_T_component)
    return (*extent.low_m, *extent.high_m)


def enclosed(solid: FacesSolid) -> float:
    """Return the volume by summing up tetrahedra from the origin to the faces."""
    corners = [[solid.vertices[i] for i in face] for face in solid.faces]
    fans = ((f[0], a, b) for f in corners for a, b in pairwise(f[1:]))
    return abs(sum(dot(a, cross(b, c)) for a, b, c in fans)) / 6.0


# the frame house, in two formats


@pytest.fixture(scope="module")
def btlx_house(shared_data: Path) -> BuildingModel:
    kind, model = design(shared_data / "timber" / "frame_house.btlx")
    assert kind is FileKind.BTLX
    return model


@pytest.fixture(scope="module")
def json_house(shared_data: Path) -> BuildingModel:
    pytest.importorskip(
        "compas_timber", reason="needs compas_timber: pip install 'sitewright[timber]'"
    )
    return design(shared_data / "timber" / "frame_house.json", unit="mm")[1]


def test_the_btlx_house_has_its_beams_cuts_and_joints(btlx_house: BuildingModel) -> None:
    components = btlx_house.component_by_id.values()
    assert len(components) == 31
    assert sum(len(c.cuts) for c in components) == 84
    assert len(pairs(btlx_house, RelationKind.CONNECTION)) == len(btlx_house.relations) == 63
    assert all(r.origin.value == "inferred" for r in btlx_house.relations)


def test_both_formats_tell_of_the_same_house(
    btlx_house: BuildingModel, json_house: BuildingModel
) -> None:
    assert lengths_mm(btlx_house) == lengths_mm(json_house)
    assert set(btlx_house.component_by_id) == set(json_house.component_by_id)
    kind = RelationKind.CONNECTION
    assert pairs(btlx_house, kind) == pairs(json_house, kind)
    for name, beam in json_house.component_by_id.items():
        other = btlx_house.component_by_id[name]
        assert reach_m(other) == pytest.approx(reach_m(beam), abs=0.0005)
        assert volume_of(other) == pytest.approx(volume_of(beam), rel=2e-3)
        assert other.type == beam.type


def test_sawn_beams_of_the_btlx_house_touch_only_where_they_are_joined(
    btlx_house: BuildingModel,
) -> None:
    solids = {i: s for i, c in btlx_house.component_by_id.items() if (s := solid_of(c)) is not None}
    touching = {frozenset((c.a, c.b)) for c in contacts_of(solids)}
    assert touching
    assert touching <= pairs(btlx_house, RelationKind.CONNECTION)


def test_the_btlx_house_becomes_a_project_that_fits_the_cell(
    shared_data: Path, tmp_path: Path
) -> None:
    result = import_file(shared_data / "timber" / "frame_house.btlx", tmp_path / "house")
    assert (result.kind, result.targets_total, result.is_inferred) == ("btlx", 31, True)
    model = read_building(tmp_path / "house" / "building.json")
    found = [*check_model(model), *check_project(model, read_cell(CELL))]
    assert [p for p in found if p.severity == "E"] == []
    targets = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    assert sorted(c.order or 0 for c in targets) == list(range(1, 32))
    assert sum(len(s.items) for s in model.stacks) == 31


# masonry


@pytest.mark.parametrize(
    ("name", "blocks", "ground", "interfaces", "shape"),
    [
        ("wall_assembly.json", 52, 10, 80, BoxGeometry),
        ("arch_assembly.json", 30, 2, 29, ConvexGeometry),
        ("wall_simple.obj", 38, 0, 0, BoxGeometry),
    ],
)
def test_masonry_has_its_blocks_supports_and_interfaces(
    shared_data: Path, name: str, blocks: int, ground: int, interfaces: int, shape: type
) -> None:
    _, model = design(shared_data / "masonry" / name, unit="m")
    components = model.component_by_id.values()
    assert len(components) == len({c.name for c in components}) == blocks
    assert sum(c.ground for c in components) == ground
    assert len(pairs(model, RelationKind.CONTACT)) == interfaces
    assert {type(c.geometry) for c in components} == {shape}


def test_blocks_keep_the_volume_of_their_meshes(shared_data: Path) -> None:
    path = shared_data / "masonry" / "arch_assembly.json"
    _, arch = design(path, unit="m")
    for stated in read_compas_assembly(path).parts:
        (solid,) = stated.solids
        assert isinstance(solid, FacesSolid)
        volume = volume_of(arch.component_by_id[ComponentId(stated.source_id)])
        assert volume == pytest.approx(enclosed(solid), rel=1e-6)


# bars


@pytest.mark.parametrize(
    ("name", "bars", "grounded_nodes"), [("four_frame", 4, 2), ("topopt_101_tiny", 76, 8)]
)
def test_bars_are_read_with_their_contacts_and_grounded_nodes(
    shared_data: Path, name: str, bars: int, grounded_nodes: int
) -> None:
    import json

    path = shared_data / "bars" / f"{name}.json"
    kind, model = design(path)
    assert kind is FileKind.BAR_FRAME
    assert len(model.component_by_id) == bars
    document = json.loads(path.read_text())
    grounded = {n["node_id"] for n in document["node_list"] if n["is_grounded"]}
    assert len(grounded) == grounded_nodes
    ends = {str(e["element_id"]): set(e["end_node_ids"]) for e in document["element_list"]}
    standing = {i for i, c in model.component_by_id.items() if c.ground}
    assert standing == {i for i, nodes in ends.items() if nodes & grounded}
    sharing = {frozenset((a, b)) for a, b in combinations(ends, 2) if ends[a] & ends[b]}
    assert pairs(model, RelationKind.CONTACT) == sharing


def test_the_cell_cannot_build_printed_bars_and_check_says_why(
    shared_data: Path, tmp_path: Path
) -> None:
    import_file(shared_data / "bars" / "four_frame.json", tmp_path / "p")
    found = check_project(read_building(tmp_path / "p" / "building.json"), read_cell(CELL))
    reasons = [p.message for p in found if p.code == "Q2"]
    assert len(reasons) == 4
    assert all("2.6587 x 2.6587 mm" in r and "30-140" in r for r in reasons)


# the command


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("timber/frame_house.btlx", None),
        ("masonry/wall_assembly.json", "m"),
        ("masonry/arch_assembly.json", "m"),
        ("masonry/wall_simple.obj", "m"),
        ("bars/topopt_101_tiny.json", None),
    ],
)
def test_what_is_written_reads_back_the_same(
    shared_data: Path, tmp_path: Path, name: str, unit: str | None
) -> None:
    path = shared_data / name
    import_file(path, tmp_path / "one", ImportOptions(unit=unit))
    first = tmp_path / "one" / "building.json"
    model = read_building(first)
    write_building(model, tmp_path / "again.json")
    assert (tmp_path / "again.json").read_bytes() == first.read_bytes()
    import_file(path, tmp_path / "two", ImportOptions(unit=unit))
    assert (tmp_path / "two" / "building.json").read_bytes() == first.read_bytes()
    ids = {c.source.id for c in model.component_by_id.values() if c.source is not None}
    assert len(ids) == sum(c.source is not None for c in model.component_by_id.values())


def test_the_command_tells_kind_and_warnings(shared_data: Path, tmp_path: Path) -> None:
    path = str(shared_data / "bars" / "four_frame.json")
    run = CliRunner().invoke(commands, ["import", path, "-o", str(tmp_path / "p")])
    assert run.exit_code == 0
    assert "4 components to build (bar_frame)" in run.output
    assert "U2" in run.output
    assert "sitewright infer" in run.output


def test_a_refused_file_leaves_nothing_behind(shared_data: Path, tmp_path: Path) -> None:
    with pytest.raises(ModelRejectedError, match="U1"):
        import_file(shared_data / "masonry" / "wall_simple.obj", tmp_path / "p")
    assert list(tmp_path.iterdir()) == []


def test_a_building_that_is_there_is_not_overwritten(shared_data: Path, tmp_path: Path) -> None:
    (tmp_path / "building.json").write_text("{}")
    with pytest.raises(ProjectError, match="already"):
        import_file(shared_data / "bars" / "four_frame.json", tmp_path)
    assert (tmp_path / "building.json").read_text() == "{}"


def test_a_json_of_another_kind_is_told_what_is_read(shared_data: Path, tmp_path: Path) -> None:
    with pytest.raises(ModelRejectedError, match=r"E3 .*Rhino .3dm, IFC, BTLx, OBJ"):
        import_file(shared_data / "lego" / "tower.json", tmp_path / "p")


def test_a_missing_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "house.ifc"
    file.write_text("ISO-10303-21;\nEND-ISO-10303-21;\n")
    monkeypatch.setattr("sitewright.app.importing.find_spec", lambda _: None)
    with pytest.raises(BackendMissingError, match=r"pip install 'sitewright\[ifc\]'"):
        import_file(file, tmp_path / "p")


def test_a_native_building_is_taken_as_it_is(tmp_path: Path) -> None:
    example = Path(__file__).parents[2] / "examples" / "wooden_frame" / "building.json"
    result = import_file(example, tmp_path / "p")
    assert (result.kind, result.is_inferred) == ("native", False)
    design, written = read_building(example), read_building(tmp_path / "p" / "building.json")
    assert is_same(written.component_by_id, design.component_by_id)
    assert is_same((written.stacks, written.relations), (design.stacks, design.relations))
    assert [(s.file, s.kind) for s in written.sources] == [("building.json", "native")]


def test_a_wall_of_425_members_is_read_in_a_second(tmp_path: Path) -> None:
    lines, count = [], 0
    for k in range(425):
        x, z = 0.6 * (k % 25), 3.0 * (k // 25)
        corners = [(x + a, b, z + c) for a in (0, 0.06) for b in (0, 0.12) for c in (0, 2.4)]
        lines += [f"o stud {k}", *(f"v {p[0]:.3f} {p[1]:.3f} {p[2]:.3f}" for p in corners)]
        for side in (
            (1, 2, 4, 3),
            (5, 7, 8, 6),
            (1, 5, 6, 2),
            (3, 4, 8, 7),
            (1, 3, 7, 5),
            (2, 6, 8, 4),
        ):
            lines.append("f " + " ".join(str(count + i) for i in side))
        count += 8
    path = tmp_path / "wall.obj"
    path.write_text("\n".join(lines))
    begun = time.process_time()
    _, model = design(path, unit="m")
    assert time.process_time() - begun < 5.0
    assert lengths_mm(model) == {2400.0: 425}


def test_the_joints_of_the_btlx_house_outlive_another_inference(
    shared_data: Path, tmp_path: Path
) -> None:
    import_file(shared_data / "timber" / "frame_house.btlx", tmp_path / "house")
    run = CliRunner().invoke(commands, ["infer", str(tmp_path / "house")])
    assert run.exit_code == 0
    assert "Nothing to infer" in run.output
