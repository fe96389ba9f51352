"""A frame drawn as a Rhino user draws it: to the building model, built, and back into a copy."""

from __future__ import annotations

import json
import runpy
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from builders_rhino import Drawing, brep_box, draw_frame
from sitewright.app.importing import ImportOptions, read_design
from sitewright.building_model.as_built import InstallRecord, fold
from sitewright.building_model.as_built_table import status_by_source
from sitewright.building_model.component import BoxGeometry, Component, Layer
from sitewright.building_model.formats.layer_rules import LayerNames
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.formats.rhino import read_rhino
from sitewright.building_model.formats.rhino_export import (
    ForeignDrawingError,
    RhinoCopy,
    asbuilt_path,
    export_rhino,
)
from sitewright.building_model.formats.rhino_patch import new_path
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.validation import check_model
from sitewright.errors import ModelRejectedError
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, translation

pytest.importorskip("rhino3dm", reason="needs rhino3dm: pip install 'sitewright[rhino]'")

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / "docs" / "rhino" / "apply_status.py"
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
def status(imported: BuildingModel) -> Mapping[str, Json]:
    """What is known after one support and the stud drawn as a block were installed."""
    found = by_name(imported)
    pieces = [c.id for c in imported.component_by_id.values() if c.layer is Layer.MATERIAL]
    records = [
        InstallRecord(
            target=found[name].id,
            material=ComponentId(piece),
            world_T_measured=translation(0.0, 0.0, 0.0005) @ found[name].world_T_component,
            robot="kr120-a",
            installed_at="2026-05-04T10:00:00+00:00",
        )
        for name, piece in zip(("support-1", "stud-3"), pieces, strict=False)
    ]
    return status_by_source(fold(imported, records), Pose())


@pytest.fixture(scope="module")
def copy(drawn: tuple[Path, Any], status: Mapping[str, Json]) -> RhinoCopy:
    return export_rhino(drawn[0], status, asbuilt_path(drawn[0]))


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


def test_the_copy_carries_status_and_layer_of_what_was_built(
    copy: RhinoCopy, status: Mapping[str, Json], drawn: tuple[Path, Mapping[str, str]]
) -> None:
    file, ids = drawn
    assert copy.path.name == "frame_asbuilt.3dm"
    assert set(copy.written) == set(status) == {ids["support-1"], ids["stud-3"]}
    assert (copy.not_found, copy.losses) == ((), ())
    before = {p.source_id: p for p in read_rhino(file).parts}
    after = {p.source_id: p for p in read_rhino(copy.path).parts}
    assert before.keys() == after.keys()
    for identity, part in after.items():
        old = before[identity]
        assert (part.solids, part.name, part.group) == (old.solids, old.name, old.group)
        new = {k: v for k, v in part.user_text.items() if k not in old.user_text}
        if identity not in status:
            assert (part.layer_path, new) == (old.layer_path, {})
            continue
        assert part.layer_path == old.layer_path.replace("Target", "As-Built")
        assert new["sitewright.status"] == "verified"
        assert new["sitewright.robot"] == "kr120-a"
        assert new["sitewright.built_at"] == "2026-05-04T10:00:00+00:00"
        assert new["sitewright.deviation_mm"] == "0.50"
        assert new["sitewright.material_used"] in before


def test_the_copy_comes_back_as_built_with_type_parents_and_pose(
    copy: RhinoCopy, imported: BuildingModel
) -> None:
    again = by_name(imported_from(copy.path))
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
    state: Json = {"layer": "as_built", "keys": {"status": "verified", "robot": ""}}
    copy = export_rhino(original, {identity: state, "gone": state}, tmp_path / "out.3dm")
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
    status: dict[str, Json] = {identity: {"layer": "as_built", "keys": {"status": "verified"}}}
    copy = export_rhino(original, status, asbuilt_path(original))
    (part,) = read_rhino(copy.path).parts
    assert part.user_text["sitewright.layer"] == "as_built"
    assert part.layer_path == "As-Built::Studs"


def test_another_drawing_and_the_original_itself_are_no_goal(
    drawn: tuple[Path, Any], tmp_path: Path
) -> None:
    status: dict[str, Json] = {"no-such-object": {"layer": "as_built", "keys": {}}}
    with pytest.raises(ForeignDrawingError, match="none of the objects"):
        export_rhino(drawn[0], status, tmp_path / "out.3dm")
    with pytest.raises(ForeignDrawingError, match="the original itself"):
        export_rhino(drawn[0], status, drawn[0])
    cut = tmp_path / "cut.3dm"
    cut.write_bytes(drawn[0].read_bytes()[:-9])
    with pytest.raises(ModelRejectedError, match="E4"):
        export_rhino(cut, status, tmp_path / "out.3dm")
    assert [f.name for f in tmp_path.iterdir()] == ["cut.3dm"]


PATHS = (
    ("", "As-Built"),
    ("Studs", "As-Built::Studs"),
    ("Target", "As-Built"),
    ("Frame::TARGETS::Studs", "Frame::As-Built::Studs"),
    ("target [x]::Target[y]::Studs", "target [x]::As-Built::Studs"),
    ("as built::Studs", "as built::Studs"),
    ("Storey 1[IfcStorey]::IfcWall", "As-Built::Storey 1[IfcStorey]::IfcWall"),
)


@pytest.mark.parametrize(("path", "wanted"), PATHS)
def test_the_role_layer_is_exchanged_and_the_others_stay(path: str, wanted: str) -> None:
    assert new_path(path, Layer.AS_BUILT, LayerNames()) == wanted
    assert runpy.run_path(str(SCRIPT))["new_path"](path, "as_built") == wanted


def test_layers_of_the_users_own_are_known_by_the_map() -> None:
    names = LayerNames(role_by_name={"zubauen": Layer.TARGET})
    assert new_path("Zu bauen::Stiele", Layer.AS_BUILT, names) == "As-Built::Stiele"


class FakeRhino:
    """Keeps what the script asks of ``rhinoscriptsyntax``; Rhino itself is not here."""

    def __init__(self, layer_by_id: dict[str, str], text: dict[tuple[str, str], str]) -> None:
        self.layer_by_id, self.text = layer_by_id, text
        self.layers = set(layer_by_id.values())

    def IsObject(self, identity: str) -> bool:
        return identity in self.layer_by_id

    def SetUserText(self, identity: str, key: str, value: str) -> None:
        self.text[identity, key] = value

    def GetUserText(self, identity: str, key: str) -> str | None:
        return self.text.get((identity, key))

    def ObjectLayer(self, identity: str, layer: str | None = None) -> str:
        if layer is not None:
            assert layer in self.layers
            self.layer_by_id[identity] = layer
        return self.layer_by_id[identity]

    def IsLayer(self, layer: str) -> bool:
        return layer in self.layers

    def LayerColor(self, layer: str) -> str:
        assert layer in self.layers
        return "red"

    def AddLayer(self, layer: str, color: str) -> None:
        assert color == "red"
        self.layers.add(layer)


def test_the_script_for_inside_rhino_does_what_the_copy_does(
    copy: RhinoCopy, status: Mapping[str, Json], drawn: tuple[Path, Any]
) -> None:
    parts = read_rhino(drawn[0]).parts
    rhino = FakeRhino({p.source_id: p.layer_path for p in parts}, {})
    told = json.loads(json.dumps({**status, "gone": {"layer": "as_built", "keys": {}}}))
    written, missing = runpy.run_path(str(SCRIPT))["apply_status"](rhino, told)
    assert (tuple(written), missing) == (copy.written, ["gone"])
    for part in read_rhino(copy.path).parts:
        assert rhino.layer_by_id[part.source_id] == part.layer_path
        ours = {k: v for (i, k), v in rhino.text.items() if i == part.source_id and v}
        assert ours.items() <= part.user_text.items()
