"""The as-built state goes into a copy of the IFC file: lines are added, none is touched."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from builders_ifc import ifcopenshell, wall_panel
from sitewright.building_model.as_built import InstallRecord, fold
from sitewright.building_model.component import BoxGeometry, Component, Layer, Source
from sitewright.building_model.formats.ifc_export import ForeignOriginalError, IfcPatch, export_ifc
from sitewright.building_model.formats.ifc_reader import read
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.object_states import ObjectState, object_states
from sitewright.errors import ModelRejectedError
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose, norm, rotation, translation

validate = pytest.importorskip("ifcopenshell.validate", reason="needs the extra 'ifc'")
get_psets = pytest.importorskip("ifcopenshell.util.element").get_psets

NOW = "2030-05-01T18:00:00+00:00"
SCHEMAS = ("IFC4", "IFC2X3", "IFC4X3")


def model_of_panel(path: Path) -> BuildingModel:
    """Return the panel's components with the ids of the file."""
    components = [
        Component(
            id=ComponentId(p["source_id"]),
            layer=Layer.TARGET,
            type=p["type"],
            name=p["name"],
            geometry=BoxGeometry((1.0, 0.1, 0.1)),
            source=Source(file=path.name, kind="ifc", id=p["source_id"]),
        )
        for p in read(str(path))["parts"]
    ]
    piece = replace(components[0], id=ComponentId("piece"), layer=Layer.MATERIAL, source=None)
    return BuildingModel(name="panel", component_by_id={c.id: c for c in [*components, piece]})


def built(model: BuildingModel, *names: str, minute: int = 0) -> BuildingModel:
    """Return the model with the named components installed one minute after another."""
    records = [
        InstallRecord(
            target=c.id,
            material=ComponentId("piece"),
            world_T_measured=translation(0.003, 0.004, 0.0) @ rotation((0.0, 0.0, 1.0), 0.01),
            robot="kr120-a",
            installed_at=f"2030-05-01T09:{minute + n:02d}:00+00:00",
            operations={OperationId("nail-1"): "done"},
        )
        for n, c in enumerate(
            c for c in model.component_by_id.values() if c.name in names and c.source
        )
    ]
    return fold(model, records)


def states(model: BuildingModel, *names: str, at: Pose | None = None) -> dict[str, ObjectState]:
    """Return what became of the elements after the named components were built."""
    return object_states(model, built(model, *names), at or Pose())


def export(original: Path, *names: str) -> IfcPatch:
    out = original.with_name("panel_asbuilt.ifc")
    return export_ifc(original, states(model_of_panel(original), *names), out, written_at=NOW)


@pytest.fixture(scope="module", params=SCHEMAS)
def original(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return wall_panel(request.param).write(tmp_path_factory.mktemp("ifc") / "panel.ifc")


@pytest.fixture(scope="module")
def patch(original: Path) -> IfcPatch:
    """Return a patch after the bottom plate and, a minute each later, the studs were built."""
    return export(original, "bottom", "stud")


def test_lines_are_only_added(original: Path, patch: IfcPatch) -> None:
    before, after = original.read_bytes().splitlines(), patch.path.read_bytes().splitlines()
    rest = iter(after)
    assert all(line in rest for line in before)  # every line, in its order
    assert len(after) - len(before) == patch.lines_added > 0


def test_a_plain_rewrite_of_the_copy_loses_no_line_of_a_plain_rewrite(
    original: Path, patch: IfcPatch
) -> None:
    texts = [ifcopenshell.open(p).to_string().splitlines() for p in (original, patch.path)]
    before, after = ([t for t in lines if t.startswith("#")] for lines in texts)
    assert set(before) - set(after) == set()


def test_each_built_element_gets_a_property_set_of_its_own(patch: IfcPatch) -> None:
    file = ifcopenshell.open(patch.path)
    identity = file.by_type("IfcMember")[0].GlobalId
    values = get_psets(file.by_guid(identity))["Sitewright_Construction"]
    assert (values["Status"], values["Layer"]) == ("verified", "as_built")
    assert (values["Robot"], values["MaterialUsed"]) == ("kr120-a", "piece")
    assert values["BuiltAt"] == "2030-05-01T09:00:00+00:00"
    assert values["DeviationMm"] == pytest.approx(5.0)
    assert values["DeviationDeg"] == pytest.approx(0.573)
    assert values["Operations"] == "nail-1: done"
    named = {
        e.GlobalId for e in file.by_type("IfcMember") if "Sitewright_Construction" in get_psets(e)
    }
    assert named == set(patch.written)
    assert len(named) == 4


def test_the_schedule_of_what_was_done_is_new_and_follows_time(
    original: Path, patch: IfcPatch
) -> None:
    file, old = ifcopenshell.open(patch.path), ifcopenshell.open(original)
    (schedule,) = file.by_type("IfcWorkSchedule")
    tasks = [t for r in schedule.Controls for t in r.RelatedObjects]
    assert len(tasks) == len(patch.written) == 4
    assert {t.Status for t in tasks} == {"COMPLETED"}
    outputs = [
        r.RelatingProduct.GlobalId
        for t in tasks
        for r in t.HasAssignments
        if r.is_a("IfcRelAssignsToProduct")
    ]
    assert outputs == list(patch.written)
    assert len(file.by_type("IfcRelSequence")) - len(old.by_type("IfcRelSequence")) == 3
    assert {t.GlobalId for t in old.by_type("IfcTask")}.isdisjoint({t.GlobalId for t in tasks})


def test_the_copy_is_as_valid_by_its_schema_as_the_original(
    original: Path, patch: IfcPatch
) -> None:
    loggers = [validate.json_logger(), validate.json_logger()]
    for path, logger in zip((original, patch.path), loggers, strict=True):
        validate.validate(ifcopenshell.open(path), logger)
    before, after = ([s["message"] for s in logger.statements] for logger in loggers)
    assert after == before


def test_imported_again_the_built_ones_are_as_built_and_the_order_is_the_designers(
    original: Path, patch: IfcPatch
) -> None:
    again, before = read(str(patch.path))["parts"], read(str(original))["parts"]
    assert [p["solids"] for p in again] == [p["solids"] for p in before]
    assert [p["order"] for p in again] == [p["order"] for p in before] == [1, 2, 2, 2, 3]
    layers = {p["source_id"]: p["user_text"].get("sitewright.layer") for p in again}
    assert {i for i, layer in layers.items() if layer == "as_built"} == set(patch.written)


def test_the_same_export_twice_gives_the_same_bytes(tmp_path: Path) -> None:
    original = wall_panel().write(tmp_path / "panel.ifc")
    first = export(original, "bottom").path.read_bytes()
    assert export(original, "bottom").path.read_bytes() == first


def test_an_export_of_an_export_hides_nothing(tmp_path: Path) -> None:
    original = wall_panel().write(tmp_path / "panel.ifc")
    out = export(original, "bottom").path
    second = tmp_path / "second.ifc"
    patch = export_ifc(out, states(model_of_panel(out), "top"), second, written_at=NOW)
    file = ifcopenshell.open(second)
    names = {n for e in file.by_type("IfcMember") for n in get_psets(e)}
    assert names == {"Sitewright_Construction", "Sitewright_Construction_2"}
    assert len(patch.written) == 1


def test_deviations_are_told_in_the_frame_of_the_model(tmp_path: Path) -> None:
    original = wall_panel().write(tmp_path / "panel.ifc")
    world_T_model = translation(2.0, 1.0, 0.5) @ rotation((0.0, 0.0, 1.0), 0.01)
    model = replace(model_of_panel(original), origin_shift_m=(100.0, 0.0, 0.0))
    out = tmp_path / "o.ifc"
    patch = export_ifc(original, states(model, "bottom", at=world_T_model), out, written_at=NOW)
    file = ifcopenshell.open(out)
    values = get_psets(file.by_guid(patch.written[0]))["Sitewright_Construction"]
    at = world_T_model.inverse().apply((0.003, 0.004, 0.0))
    assert values["DeviationMm"] == pytest.approx(1000.0 * norm(at), abs=1e-3)
    assert values["DeviationDeg"] == pytest.approx(0.0, abs=1e-4)
    x, y, z = (float(v) for v in values["MeasuredCentreM"].split())
    assert (x, y, z) == pytest.approx((at[0] + 100.0, at[1], at[2]), abs=1e-6)


def test_what_the_file_does_not_hold_is_named(tmp_path: Path) -> None:
    original = wall_panel().write(tmp_path / "panel.ifc")
    model = model_of_panel(original)
    stranger = next(c for c in model.component_by_id.values() if c.name == "top")
    moved = replace(stranger, source=Source(file="", kind="ifc", id="0000000000000000000000"))
    model = replace(model, component_by_id={**model.component_by_id, moved.id: moved})
    patch = export_ifc(original, states(model, "top", "bottom"), tmp_path / "o.ifc", written_at=NOW)
    assert patch.not_found == ("0000000000000000000000",)
    assert len(patch.written) == 1


def test_an_element_of_which_only_a_body_is_built_is_partly_built(tmp_path: Path) -> None:
    original = wall_panel().write(tmp_path / "panel.ifc")
    model = model_of_panel(original)
    bottom = next(c for c in model.component_by_id.values() if c.name == "bottom")
    assert bottom.source
    bodies = [
        replace(
            bottom, id=ComponentId(n), name=n, source=replace(bottom.source, id=f"{bottom.id}.{n}")
        )
        for n in ("1", "2")
    ]
    model = replace(
        model,
        component_by_id={b.id: b for b in [*bodies, model.component_by_id[ComponentId("piece")]]},
    )
    patch = export_ifc(original, states(model, "1"), tmp_path / "o.ifc", written_at=NOW)
    file = ifcopenshell.open(patch.path)
    values = get_psets(file.by_guid(patch.written[0]))
    assert values["Sitewright_Construction"]["Status"] == "partly"
    assert "Layer" not in values["Sitewright_Construction"]


def test_a_model_of_another_file_is_refused_and_nothing_is_written(tmp_path: Path) -> None:
    mine = model_of_panel(wall_panel().write(tmp_path / "mine.ifc"))
    other = wall_panel().write(tmp_path / "other.ifc")
    with pytest.raises(ForeignOriginalError, match="holds none"):
        export_ifc(other, states(mine, "bottom"), tmp_path / "out.ifc", written_at=NOW)
    assert sorted(f.name for f in tmp_path.iterdir()) == ["mine.ifc", "other.ifc"]


def test_the_original_is_never_the_target(tmp_path: Path) -> None:
    original = wall_panel().write(tmp_path / "panel.ifc")
    before = original.read_bytes()
    with pytest.raises(ForeignOriginalError, match="original itself"):
        export_ifc(original, states(model_of_panel(original)), original, written_at=NOW)
    assert original.read_bytes() == before


def test_a_broken_original_leaves_no_file_behind(tmp_path: Path) -> None:
    original = wall_panel().write(tmp_path / "panel.ifc")
    mine = states(model_of_panel(original), "bottom")
    original.write_bytes(original.read_bytes().replace(b"#11=", b"#10=", 1))
    with pytest.raises(ModelRejectedError, match="E2"):
        export_ifc(original, mine, tmp_path / "out.ifc", written_at=NOW)
    assert [f.name for f in tmp_path.iterdir()] == ["panel.ifc"]


def test_lines_of_a_windows_file_stay_windows_lines(tmp_path: Path) -> None:
    original = wall_panel().write(tmp_path / "panel.ifc")
    original.write_bytes(original.read_bytes().replace(b"\n", b"\r\n"))
    content = export(original, "bottom").path.read_bytes()
    assert content.count(b"\n") == content.count(b"\r\n")
