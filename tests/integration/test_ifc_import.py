"""IFC files as authoring programs write them: shapes, words, order, and files that are bad."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from builders_ifc import STUD_MM, IfcDraft, wall_panel
from sitewright.building_model.formats.detect import FileKind
from sitewright.building_model.formats.foreign_files import read_foreign
from sitewright.building_model.formats.ifc import read_ifc
from sitewright.building_model.formats.ifc_reader import read
from sitewright.building_model.formats.import_process import Limits
from sitewright.building_model.formats.neutral import BoxSolid, ExtrusionSolid, NeutralFile
from sitewright.building_model.formats.unreadable import UnreadableError
from sitewright.errors import ModelRejectedError
from sitewright.foundation.pose import Pose

L_SHAPE = [(0, 0), (400, 0), (400, 100), (100, 100), (100, 300), (0, 300)]


def refusal(path: Path, limits: Limits | None = None) -> str:
    with pytest.raises(ModelRejectedError) as caught:
        read_foreign(path, FileKind.IFC, limits=limits)
    return str(caught.value)


def part_of(draft: IfcDraft, path: Path) -> dict[str, Any]:
    """Return the only part of a draft, read in this process."""
    (part,) = read(str(draft.write(path / "one.ifc")))["parts"]
    return dict(part)


def volume(faces: dict[str, Any]) -> float:
    """Return the volume of a closed surface; negative if its faces look inwards."""
    v = faces["vertices"]
    return sum(_determinant(v[a], v[b], v[c]) for a, b, c in faces["faces"]) / 6.0


def _determinant(a: list[float], b: list[float], c: list[float]) -> float:
    return (
        a[0] * (b[1] * c[2] - b[2] * c[1])
        - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
    )


@pytest.fixture(scope="module")
def panel_path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return wall_panel().write(tmp_path_factory.mktemp("ifc") / "panel.ifc")


@pytest.fixture(scope="module")
def panel(panel_path: Path) -> NeutralFile:
    return read_ifc(panel_path)


def test_a_panel_comes_with_its_five_members_in_millimetres(panel: NeutralFile) -> None:
    assert panel.metres_per_unit == 0.001
    assert [p.name for p in panel.parts] == ["bottom", "stud", "stud", "stud", "top"]
    assert {p.type for p in panel.parts} == {"member-plate", "member-stud"}
    assert {p.material for p in panel.parts} == {"C24"}


def test_members_are_boxes_along_their_grain(panel: NeutralFile) -> None:
    stud = panel.parts[2].solids
    assert len(stud) == 1
    assert isinstance(stud[0], BoxSolid)
    assert stud[0].has_grain
    assert stud[0].size == (2400.0, *STUD_MM)
    assert stud[0].file_T_box.position_m == pytest.approx((645.0, 0.0, 1245.0))
    assert stud[0].file_T_box.x_axis == pytest.approx((0.0, 0.0, 1.0))


def test_an_assembly_is_a_group_and_no_parent(panel: NeutralFile) -> None:
    assert {p.group for p in panel.parts} == {"panel A"}
    assert {p.parents for p in panel.parts} == {()}


def test_tasks_give_the_order_and_equal_tasks_equal_numbers(panel: NeutralFile) -> None:
    assert [p.order for p in panel.parts] == [1, 2, 2, 2, 3]


@pytest.mark.parametrize("schema", ["IFC2X3", "IFC4X3"])
def test_other_schemas_give_the_same_shapes_and_order(
    schema: str, panel_path: Path, tmp_path: Path
) -> None:
    other = read(str(wall_panel(schema).write(tmp_path / "panel.ifc")))["parts"]
    assert [p["solids"] for p in other] == [p["solids"] for p in read(str(panel_path))["parts"]]
    assert [p["order"] for p in other] == [1, 2, 2, 2, 3]


def test_a_half_space_is_a_saw_cut_that_the_kernel_confirms(tmp_path: Path) -> None:
    clipped = []
    for has_twin in (False, True):  # cuts of two bodies go to the kernel
        draft = IfcDraft()
        bar = draft.clipped(
            draft.extruded(draft.rectangle(), 2400.0), (0, 0, 2300), (0.5, 0, 1), agreement=False
        )
        twin = [draft.extruded(draft.rectangle(), 10.0, position=draft.axes((500, 0, 0)))]
        shape = draft.shape(bar, *(twin if has_twin else []))
        draft.element("IfcMember", "rafter", draft.placed((100, 0, 0)), shape)
        clipped.append(part_of(draft, tmp_path))
    (box,), (mesh, _) = clipped[0]["solids"], clipped[1]["solids"]
    ((point, normal),) = box["cuts"]
    assert math.hypot(*normal) == pytest.approx(1.0)
    pose = Pose.from_axes(box["p"], box["x"], box["y"]).inverse()
    heights = [
        sum(n * (a - b) for n, a, b in zip(normal, pose.apply(tuple(v)), point, strict=True))
        for v in mesh["vertices"]
    ]
    assert max(heights) == pytest.approx(0.0, abs=1e-6)  # nothing stands above the cut
    assert sum(abs(h) < 1e-6 for h in heights) == 4
    assert volume(mesh) == pytest.approx(45.0 * 95.0 * 2300.0, rel=1e-9)


@pytest.mark.parametrize("agreement", [True, False])
def test_the_agreement_flag_says_which_side_is_sawn_off(*, agreement: bool, tmp_path: Path) -> None:
    draft = IfcDraft()
    bar = draft.extruded(draft.rectangle(), 2400.0)
    shape = draft.shape(draft.clipped(bar, (0, 0, 2000), (0, 0, 1), agreement=agreement))
    draft.element("IfcMember", "rafter", draft.placed(), shape)
    ((_, normal),) = part_of(draft, tmp_path)["solids"][0]["cuts"]
    along_bar = -1.0 if agreement else 1.0
    assert normal == pytest.approx([along_bar, 0.0, 0.0])


@pytest.mark.parametrize(
    ("half_width", "kinds"), [(22.5, ["box"]), (30.0, ["box"]), (0.0, ["faces"])]
)
def test_a_bounded_half_space_is_a_saw_cut_only_if_it_cuts_right_through(
    half_width: float, kinds: list[str], tmp_path: Path
) -> None:
    draft = IfcDraft()
    corners = [(-30, -50), (half_width, -50), (half_width, 50), (-30, 50)]
    bar = draft.extruded(draft.rectangle(), 2400.0)
    shape = draft.shape(draft.clipped_within(bar, (0, 0, 2300), (0.5, 0, 1), corners))
    draft.element("IfcMember", "rafter", draft.placed(), shape)
    solids = part_of(draft, tmp_path)["solids"]
    assert [s["kind"] for s in solids] == kinds
    if kinds == ["faces"]:  # the half of the end, cut at 45 x 95 x 2300 less what is left of it
        left = 22.5 * 95.0 * (2300.0 + 0.5 * 11.25) + 22.5 * 95.0 * 2400.0
        assert volume(solids[0]) == pytest.approx(left, rel=1e-9)


def test_a_slab_keeps_its_outline_and_a_rectangle_becomes_a_box(tmp_path: Path) -> None:
    draft = IfcDraft()
    shape = draft.shape(draft.extruded(draft.outline(L_SHAPE), 60.0))
    draft.element("IfcSlab", "slab", draft.placed((0, 0, 100)), shape)
    plain = [(0, 0), (300, 0), (300, 200), (0, 200)]
    draft.element(
        "IfcPlate", "sheet", draft.placed(), draft.shape(draft.extruded(draft.outline(plain), 15.0))
    )
    slab, sheet = read_ifc(draft.write(tmp_path / "slab.ifc")).parts
    (outline,), (box,) = slab.solids, sheet.solids
    assert isinstance(outline, ExtrusionSolid)
    assert outline.profile == tuple((float(x), float(y)) for x, y in L_SHAPE)
    assert (outline.depth, outline.file_T_profile.position_m[2]) == (60.0, 100.0)
    assert isinstance(box, BoxSolid)
    assert not box.has_grain
    assert box.size == (15.0, 300.0, 200.0)
    assert box.file_T_box.position_m == pytest.approx((150.0, 100.0, 7.5))


def test_an_opening_goes_to_the_kernel_and_is_cut_out(tmp_path: Path) -> None:
    draft = IfcDraft()
    wall = draft.element(
        "IfcWall",
        "wall",
        draft.placed(),
        draft.shape(draft.extruded(draft.rectangle((3000, 200)), 2500)),
    )
    hole = draft.element(
        "IfcOpeningElement", "hole", draft.placed((0, 0, 800)),
        draft.shape(draft.extruded(draft.rectangle((1000, 400)), 1000)),
    )  # fmt: skip
    draft.rooted("IfcRelVoidsElement", RelatingBuildingElement=wall, RelatedOpeningElement=hole)
    part = part_of(draft, tmp_path)
    assert part["name"] == "wall"
    assert sum(volume(s) for s in part["solids"]) == pytest.approx(
        3000 * 200 * 2500 - 1000 * 200 * 1000
    )


def test_one_member_may_hold_several_bodies(tmp_path: Path) -> None:
    draft = IfcDraft()
    bars = [
        draft.extruded(draft.rectangle(), 500.0, position=draft.axes((100.0 * n, 0, 0)))
        for n in range(3)
    ]
    draft.element("IfcMember", "bundle", draft.placed(), draft.shape(*bars))
    assert len(part_of(draft, tmp_path)["solids"]) == 3


def test_a_mapped_shape_lands_where_its_instance_lies(tmp_path: Path) -> None:
    draft = IfcDraft()
    body = draft.file.create_entity(
        "IfcShapeRepresentation", draft.body, "Body", "SweptSolid",
        [draft.extruded(draft.rectangle(), 1000.0)],
    )  # fmt: skip
    source = draft.file.create_entity("IfcRepresentationMap", draft.axes((0, 0, 50)), body)
    target = draft.file.create_entity(
        "IfcCartesianTransformationOperator3D", None, None, draft.point(10, 20, 30), None, None
    )
    mapped = draft.file.create_entity("IfcMappedItem", source, target)
    draft.element("IfcMember", "stud", draft.placed((1000, 0, 0)), draft.shape(mapped))
    (box,) = part_of(draft, tmp_path)["solids"]
    assert box["p"] == pytest.approx((1010.0, 20.0, 580.0))


def test_chained_and_oblique_placements_are_followed(tmp_path: Path) -> None:
    draft = IfcDraft()
    site = draft.placed((1000, 0, 0), (0, 0, 1), (0, 1, 0))
    inner = draft.placed((500, 0, 0), (0, 0, 1), (1, 0, 0.7), within=site)  # x is not square to z
    draft.element("IfcColumn", "post", inner, draft.shape(draft.extruded(draft.rectangle(), 200)))
    (box,) = part_of(draft, tmp_path)["solids"]
    assert box["p"] == pytest.approx((1000.0, 500.0, 100.0))
    assert box["y"] == pytest.approx((0.0, 1.0, 0.0))


def test_a_wall_with_parts_stands_for_nothing_but_the_group(tmp_path: Path) -> None:
    draft = IfcDraft()
    studs = [draft.member(f"stud {n}", (600 * n, 0, 0), (0, 0, 1), 2400) for n in range(2)]
    body = draft.shape(draft.extruded(draft.rectangle((700, 95)), 2400))
    draft.whole("IfcWall", "north wall", studs, shape=body)
    records = read(str(draft.write(tmp_path / "wall.ifc")))
    assert [p["name"] for p in records["parts"]] == ["stud 0", "stud 1"]
    assert {p["group"] for p in records["parts"]} == {"north wall"}
    assert records["notes"] == ["1 x IfcWall: its parts stand for it; left out."]


def test_groups_of_equal_name_stay_apart(tmp_path: Path) -> None:
    draft = IfcDraft()
    for n in range(2):
        draft.whole("IfcElementAssembly", "panel", [draft.member("s", (n, 0, 0), (0, 0, 1), 100)])
    records = read(str(draft.write(tmp_path / "two.ifc")))
    assert len({p["group"] for p in records["parts"]}) == 2


def test_a_template_without_shape_and_a_door_are_left_out_by_name(tmp_path: Path) -> None:
    draft = wall_panel()
    draft.element("IfcMember", "template", draft.placed(), None)
    body = draft.shape(draft.extruded(draft.rectangle(), 10))
    draft.element("IfcDoor", "door", draft.placed(), body)
    records = read(str(draft.write(tmp_path / "x.ifc")))
    assert len(records["parts"]) == 5
    assert any("IfcDoor" in n for n in records["notes"])
    assert any("IfcMember: no body" in n for n in records["notes"])


def test_every_attribute_is_kept_and_own_keys_are_found(tmp_path: Path) -> None:
    draft = IfcDraft()
    stud = draft.member("stud", (0, 0, 0), (0, 0, 1), 2400.0, Tag="S1")
    draft.properties(stud, "Sitewright", {"Layer": "material", "Order": 7, "MassKg": 4.5})
    draft.properties(stud, "Vendor", {"Robot ready": True, "Price": 1.25, "Note": "Tür"})
    text = part_of(draft, tmp_path)["user_text"]
    assert text["sitewright.layer"] == "material"
    assert not any(k.startswith("Sitewright.") for k in text)
    assert (text["sitewright.order"], text["sitewright.mass_kg"]) == ("7", "4.5")
    assert (text["Vendor.Robot ready"], text["Vendor.Price"]) == ("true", "1.25")
    assert (text["Vendor.Note"], text["Tag"]) == ("Tür", "S1")


def test_planned_starts_order_the_tasks_that_no_sequence_joins(tmp_path: Path) -> None:
    draft = IfcDraft()
    for n, day in enumerate(("03", "01", "02")):
        bar = draft.member(f"bar {n}", (100 * n, 0, 0), (0, 0, 1), 500)
        time = draft.file.create_entity("IfcTaskTime", ScheduleStart=f"2030-01-{day}T08:00:00")
        draft.task(f"task {n}", [bar], TaskTime=time)
    parts = read(str(draft.write(tmp_path / "x.ifc")))["parts"]
    assert [p["order"] for p in parts] == [3, 1, 2]


def test_a_sequence_of_summary_tasks_holds_for_what_is_below_them(tmp_path: Path) -> None:
    draft = IfcDraft()
    bars = [draft.member(f"bar {n}", (100 * n, 0, 0), (0, 0, 1), 500) for n in range(2)]
    leaves = [draft.task(f"leaf {n}", [b]) for n, b in enumerate(bars)]
    sums = [draft.task(f"summary {n}") for n in range(2)]
    for above, below in zip(sums, leaves, strict=True):
        draft.rooted("IfcRelNests", RelatingObject=above, RelatedObjects=[below])
    draft.sequence(sums[1], sums[0])
    assert [p["order"] for p in read(str(draft.write(tmp_path / "x.ifc")))["parts"]] == [2, 1]


def test_a_circle_of_tasks_gives_no_order_and_a_note(tmp_path: Path) -> None:
    draft = wall_panel()
    tasks = draft.file.by_type("IfcTask")
    draft.sequence(tasks[-1], tasks[0])
    records = read(str(draft.write(tmp_path / "x.ifc")))
    assert {p["order"] for p in records["parts"]} == {None}
    assert any("cycle" in n for n in records["notes"])


def test_a_file_without_unit_states_none(tmp_path: Path) -> None:
    draft = IfcDraft(prefix="none")
    draft.member("stud", (0, 0, 0), (0, 0, 1), 2400.0)
    assert read(str(draft.write(tmp_path / "x.ifc")))["metres_per_unit"] is None


def test_the_survey_origin_is_kept_with_the_file(tmp_path: Path) -> None:
    draft = wall_panel()
    crs = draft.file.create_entity("IfcProjectedCRS", Name="EPSG:25832")
    draft.file.create_entity(
        "IfcMapConversion", draft.context, crs, 500000.0, 5700000.0, 120.5, 1.0, 0.0, 1.0
    )
    file = read_ifc(draft.write(tmp_path / "x.ifc"))
    survey = file.raw["survey"]
    assert isinstance(survey, dict)
    assert any("EPSG:25832" in n for n in file.notes)
    assert (survey["Eastings"], survey["crs"]) == (500000.0, "EPSG:25832")


def test_connections_of_the_file_are_relations(tmp_path: Path) -> None:
    draft = wall_panel()
    bottom, stud = draft.file.by_type("IfcMember")[:2]
    draft.rooted("IfcRelConnectsElements", RelatingElement=stud, RelatedElement=bottom)
    (relation,) = read_ifc(draft.write(tmp_path / "x.ifc")).relations
    assert (relation.kind, relation.a, relation.b) == ("connection", stud.GlobalId, bottom.GlobalId)


def test_half_a_file_is_refused_though_the_library_opens_it(
    panel_path: Path, tmp_path: Path
) -> None:
    content = panel_path.read_bytes()
    half = tmp_path / "half.ifc"
    half.write_bytes(content[: len(content) // 2])
    assert "E4" in refusal(half)
    assert "END-ISO-10303-21" in refusal(half)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (b"IFCRECTANGLEPROFILEDEF", b"IFCNONSENSE", "not found in schema"),
        (b",45.,95.)", b",45.,#99999)", "#99999"),
        (b",45.,95.)", b",1e999,95.)", "1e999"),
        (b"#11=", b"#10=", "Instance reference #11"),
        (b"'IFC4'", b"'IFC9'", "IFC9"),
        (b"HEADER;", b"", "HEADER"),
    ],
)
def test_a_damaged_file_is_refused_with_the_damage_named(
    panel_path: Path, tmp_path: Path, old: bytes, new: bytes, said: str
) -> None:
    bad = tmp_path / "bad.ifc"
    bad.write_bytes(panel_path.read_bytes().replace(old, new, 1))
    with pytest.raises(UnreadableError) as caught:
        read(str(bad))
    assert said in caught.value.message
    assert caught.value.code in {"E2", "E3"}


def _placement_circle(draft: IfcDraft) -> None:
    first, second = draft.file.by_type("IfcLocalPlacement")[:2]
    first.PlacementRelTo, second.PlacementRelTo = second, first


def _clipping_circle(draft: IfcDraft) -> None:
    solid = draft.file.by_type("IfcExtrudedAreaSolid")[0]
    clipped = draft.clipped(solid, (0, 0, 10), (0, 0, 1))
    clipped.FirstOperand = clipped
    draft.file.by_type("IfcShapeRepresentation")[0].Items = [clipped]


def _circle_of_wholes(draft: IfcDraft) -> None:
    assembly = draft.file.by_type("IfcElementAssembly")[0]
    draft.rooted(
        "IfcRelAggregates",
        RelatingObject=draft.file.by_type("IfcMember")[0],
        RelatedObjects=[assembly],
    )


@pytest.mark.parametrize("spoil", [_placement_circle, _clipping_circle, _circle_of_wholes])
def test_circles_are_named_and_crash_nothing(
    spoil: Callable[[IfcDraft], None], tmp_path: Path
) -> None:
    draft = wall_panel()
    spoil(draft)
    with pytest.raises(UnreadableError) as caught:
        read(str(draft.write(tmp_path / "circle.ifc")))
    assert caught.value.code == "E2"
    assert "goes in a circle" in caught.value.message


def test_an_attribute_of_a_wrong_kind_names_its_element(panel_path: Path, tmp_path: Path) -> None:
    lines = panel_path.read_bytes().splitlines()
    at = next(n for n, line in enumerate(lines) if b"IFCEXTRUDEDAREASOLID(" in line)
    profile, _, rest = lines[at].partition(b",")
    lines[at] = profile + b",7.5" + rest[rest.index(b",") :]
    bad = tmp_path / "bad.ifc"
    bad.write_bytes(b"\n".join(lines))
    said = refusal(bad)
    assert "E2" in said
    assert "IfcMember" in said


def test_whatever_ends_the_child_is_one_refusal(panel_path: Path) -> None:
    starved = Limits(memory_bytes=150 * 1024**2)
    assert "E2" in refusal(panel_path, starved)


def test_a_child_process_reads_the_same_as_we_do(panel_path: Path, panel: NeutralFile) -> None:
    assert read_foreign(panel_path, FileKind.IFC) == panel


def test_two_elements_of_one_id_are_refused(tmp_path: Path) -> None:
    draft = wall_panel()
    first, second = draft.file.by_type("IfcMember")[:2]
    second.GlobalId = first.GlobalId
    assert "D1" in refusal(draft.write(tmp_path / "twice.ifc"))


def test_a_file_with_nothing_to_build_says_what_it_holds(tmp_path: Path) -> None:
    draft = IfcDraft()
    draft.element(
        "IfcWindow", "w", draft.placed(), draft.shape(draft.extruded(draft.rectangle(), 9))
    )
    said = refusal(draft.write(tmp_path / "empty.ifc"))
    assert "E3" in said
    assert "IfcWindow" in said


def test_a_flat_solid_is_named_and_left_without_shape(tmp_path: Path) -> None:
    draft = wall_panel()
    flat = draft.shape(draft.extruded(draft.rectangle((0.0, 95.0)), 100.0))
    draft.element("IfcMember", "flat", draft.placed(), flat)
    parts = read_ifc(draft.write(tmp_path / "flat.ifc")).parts
    (bad,) = [p for p in parts if p.name == "flat"]
    assert [code for code, _, _ in bad.problems] == ["G7"]
    assert all(not replace(p).problems for p in parts if p is not bad)


@pytest.mark.parametrize(
    "content", [b"", b"version https://git-lfs.github.com/spec/v1\n", b"PK\3\4"]
)
def test_what_is_no_step_file_is_refused(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "x.ifc"
    path.write_bytes(content)
    assert "problem" in refusal(path)
