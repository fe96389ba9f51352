"""A frame drawn as a Rhino user draws it: to the building model, built, and back into a copy."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from builders_rhino import Drawing, brep_box, draw_frame
from sitewright.app.importing import ImportOptions, read_design
from sitewright.building_model.as_built import InstallRecord, fold
from sitewright.building_model.component import AsBuilt, BoxGeometry, Component, Layer
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.formats.rhino import read_rhino
from sitewright.building_model.formats.rhino_export import (
    ForeignDrawingError,
    RhinoCopy,
    asbuilt_path,
    export_rhino,
)
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.object_states import ObjectState, object_states
from sitewright.building_model.validation import check_model
from sitewright.errors import ModelRejectedError
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, translation

pytest.importorskip("rhino3dm", reason="needs rhino3dm: pip install 'sitewright[rhino]'")

ROOT = Path(__file__).parents[2]
MAP = '[user_text]\norder = "construction_order"\n'


@pytest.fixture(scope="module")
def design() -> BuildingModel:
    return read_building(ROOT / "examples" / "wooden_frame" / "building.json")


@pytest.fixture(scope="module")
def drawn(design: BuildingModel, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Any]:
    file = tmp_path_factory.mktemp("rhino") / "frame.3dm"
    ids = draw_frame(design, file)
    file.with_name("import.toml").write_text(MAP, encoding="utf-8")
    return file, ids


@pytest.fixture(scope="module")
def imported(drawn: tuple[Path, Any]) -> BuildingModel:
    return imported_from(drawn[0])


def imported_from(file: Path) -> BuildingModel:
    options = ImportOptions(map_file=file.with_name("import.toml"))
    _, model, problems = read_design(file, options)
    assert {p.code for p in problems} <= {"T1", "G7"}
    return model


def by_name(model: BuildingModel) -> Mapping[str, Component]:
    return {c.name: c for c in model.component_by_id.values() if c.name}


@pytest.fixture(scope="module")
def objects(imported: BuildingModel) -> Mapping[str, ObjectState]:
    """What is known after one support and the stud drawn as a block were installed."""
    found = by_name(imported)
    tops = [s.items[-1] for s in imported.stacks]
    records = [
        InstallRecord(
            target=found[name].id,
            material=piece,
            world_T_measured=translation(0.0, 0.0, 0.0005) @ found[name].world_T_component,
            robot="kr120-a",
            installed_at="2026-05-04T10:00:00+00:00",
        )
        for name, piece in zip(("support-1", "stud-3"), tops, strict=True)
    ]
    return object_states(imported, fold(imported, records), Pose())


@pytest.fixture(scope="module")
def copy(drawn: tuple[Path, Any], objects: Mapping[str, ObjectState]) -> RhinoCopy:
    return export_rhino(drawn[0], objects, asbuilt_path(drawn[0]))


def a_state(identity: str, **changes: Any) -> dict[str, ObjectState]:
    """Return the state of one object that was installed."""
    record = AsBuilt(status="verified")
    usual: dict[str, Any] = {"status": "verified", "layer": Layer.AS_BUILT, "record": record}
    facts = {"kind": "rhino", "components": (ComponentId(identity),), **usual, **changes}
    return {identity: ObjectState(source_id=identity, **facts)}


def test_a_drawn_frame_becomes_the_model_that_was_drawn(
    design: BuildingModel, imported: BuildingModel, drawn: tuple[Path, Mapping[str, str]]
) -> None:
    ids = drawn[1]
    found = by_name(imported)
    assert set(found) == set(ids)
    for name, component in found.items():
        wanted = design.component_by_id[ComponentId(name)]
        assert component.id == ids[name]
        assert (component.layer, component.type) == (wanted.layer, wanted.type)
        assert (component.order, component.ground) == (wanted.order, wanted.ground)
        assert (component.material, component.group) == ("C24", "Panel 1")
        assert {*component.construction_parents} == {ids[p] for p in wanted.construction_parents}
        assert isinstance(component.geometry, BoxGeometry)
        assert isinstance(wanted.geometry, BoxGeometry)
        sizes = sorted(wanted.geometry.size_m)
        assert sorted(component.geometry.size_m) == pytest.approx(sizes, abs=1e-7)
        at = wanted.world_T_component.position_m
        assert component.world_T_component.position_m == pytest.approx(at, abs=1e-7)
        assert component.raw["Fire class"] == "R30"


def test_nails_drawn_by_point_and_direction_stand_where_they_were(
    design: BuildingModel, imported: BuildingModel
) -> None:
    found = by_name(imported)
    for name in ("stud-1", "stud-3"):
        wanted, component = design.component_by_id[ComponentId(name)], found[name]
        assert len(component.operations) == 4
        for ours, theirs in zip(component.operations, wanted.operations, strict=True):
            here = component.world_T_component @ ours.component_T_operation
            there = wanted.world_T_component @ theirs.component_T_operation
            assert here.position_m == pytest.approx(there.position_m, abs=1e-7)
            assert here.z_axis == pytest.approx(there.z_axis, abs=1e-7)
            assert ours.fastener == theirs.fastener


def test_drawn_stock_is_piled_as_drawn_and_the_model_passes_the_check(
    design: BuildingModel, imported: BuildingModel
) -> None:
    assert [(s.place, len(s.items)) for s in imported.stacks] == [
        (s.place, len(s.items)) for s in design.stacks
    ]
    assert [p for p in check_model(imported) if p.severity == "E"] == []


def test_the_copy_carries_status_and_layer_of_what_was_built_and_used(
    copy: RhinoCopy, objects: Mapping[str, ObjectState], drawn: tuple[Path, Mapping[str, str]]
) -> None:
    file, ids = drawn
    used = {i for i, s in objects.items() if s.status == "consumed"}
    built = {ids["support-1"], ids["stud-3"]}
    assert copy.path.name == "frame_asbuilt.3dm"
    assert (set(copy.written), len(used)) == (built | used, 2)
    assert (copy.not_found, copy.losses) == ((), ())
    before = {p.source_id: p for p in read_rhino(file).parts}
    after = {p.source_id: p for p in read_rhino(copy.path).parts}
    assert before.keys() == after.keys()
    for identity, part in after.items():
        old = before[identity]
        assert (part.solids, part.name, part.group) == (old.solids, old.name, old.group)
        new = {k: v for k, v in part.user_text.items() if k not in old.user_text}
        if identity in built:
            assert part.layer_path == old.layer_path.replace("Target", "As-Built")
            assert new["sitewright.status"] == "verified"
            assert new["sitewright.robot"] == "kr120-a"
            assert new["sitewright.built_at"] == "2026-05-04T10:00:00+00:00"
            assert new["sitewright.deviation_mm"] == "0.50"
            assert new["sitewright.material_used"] in used
        elif identity in used:
            assert part.layer_path == old.layer_path.replace("Material", "Consumed")
            assert new.pop("sitewright.used_for") in built
            assert new == {"sitewright.status": "consumed"}
        else:
            assert (part.layer_path, new) == (old.layer_path, {})


def test_used_stock_is_out_of_sight_in_the_copy_and_all_else_is_as_it_was(
    copy: RhinoCopy, drawn: tuple[Path, Any]
) -> None:
    import rhino3dm

    before = {e.FullPath: e.Visible for e in rhino3dm.File3dm.Read(str(drawn[0])).Layers}
    after = {e.FullPath: e.Visible for e in rhino3dm.File3dm.Read(str(copy.path)).Layers}
    off = {path for path, is_visible in after.items() if not is_visible}
    assert all(before.values())
    assert off == {p for p in after if p.split("::")[0] == "Consumed"} != set()
    assert before.keys() <= after.keys()


def test_the_copy_comes_back_as_built_with_type_parents_and_pose(
    copy: RhinoCopy, imported: BuildingModel
) -> None:
    model = imported_from(copy.path)
    again = by_name(model)
    stock = {i for i, c in imported.component_by_id.items() if c.layer is Layer.MATERIAL}
    used = {i for i in stock if model.component_by_id[i].layer is Layer.AS_DESIGNED}
    assert len(used) == 2
    assert {i for s in model.stacks for i in s.items} == stock - used
    for name, component in by_name(imported).items():
        is_built = name in {"support-1", "stud-3"}
        assert again[name].layer is (Layer.AS_BUILT if is_built else Layer.TARGET)
        for field in ("id", "type", "geometry", "world_T_component", "operations", "order"):
            assert getattr(again[name], field) == getattr(component, field)
        assert again[name].construction_parents == component.construction_parents


def test_a_real_file_loses_its_preview_and_that_is_said(shared_data: Path, tmp_path: Path) -> None:
    original = shared_data / "rhino" / "object_UserStrings.3dm"
    untouched = original.read_bytes()
    identity = "eaa1f659-3127-4092-adfc-6cf01a04813a"
    states = {**a_state(identity), **a_state("gone")}
    copy = export_rhino(original, states, tmp_path / "out.3dm")
    assert original.read_bytes() == untouched
    assert (copy.written, copy.not_found) == ((identity,), ("gone",))
    (loss,) = copy.losses
    assert "preview image" in loss
    assert "3019161 bytes before" in loss
    (before,), (after,) = read_rhino(original).parts, read_rhino(copy.path).parts
    assert after.user_text == {**before.user_text, "sitewright.status": "verified"}
    assert after.layer_path == "As-Built::Default"


def test_a_layer_stated_as_a_key_is_changed_too(tmp_path: Path) -> None:
    drawing = Drawing()
    shape = brep_box((0, 0, 0), (1000, 100, 100))
    identity = drawing.add(shape, layer="Studs", text={"sitewright.layer": "target"})
    original = drawing.write(tmp_path / "x.3dm")
    copy = export_rhino(original, a_state(identity), asbuilt_path(original))
    (part,) = read_rhino(copy.path).parts
    assert part.user_text["sitewright.layer"] == "as_built"
    assert part.layer_path == "As-Built::Studs"


def test_an_object_that_is_only_partly_built_stays_on_its_layer(tmp_path: Path) -> None:
    drawing = Drawing()
    identity = drawing.add(brep_box((0, 0, 0), (1000, 100, 100)), layer="Target::Studs")
    original = drawing.write(tmp_path / "x.3dm")
    copy = export_rhino(
        original, a_state(identity, status="partly", layer=None), asbuilt_path(original)
    )
    (part,) = read_rhino(copy.path).parts
    assert part.user_text["sitewright.status"] == "partly"
    assert part.layer_path == "Target::Studs"


def test_another_drawing_and_the_original_itself_are_no_goal(
    drawn: tuple[Path, Any], tmp_path: Path
) -> None:
    states = a_state("no-such-object")
    with pytest.raises(ForeignDrawingError, match="none of the objects"):
        export_rhino(drawn[0], states, tmp_path / "out.3dm")
    with pytest.raises(ForeignDrawingError, match="the original itself"):
        export_rhino(drawn[0], states, drawn[0])
    cut = tmp_path / "cut.3dm"
    cut.write_bytes(drawn[0].read_bytes()[:-9])
    with pytest.raises(ModelRejectedError, match="E4"):
        export_rhino(cut, states, tmp_path / "out.3dm")
    assert [f.name for f in tmp_path.iterdir()] == ["cut.3dm"]
