"""Real files of every format go the whole way: import, check, infer, export, and back again."""

from __future__ import annotations

import csv
import io
import json
import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from builders_gltf import bodies_in
from builders_history import built, stock_of, targets_of, wrote_run
from builders_ids import (
    elements_of_bars,
    elements_of_ifc,
    elements_of_timber,
    nodes_of_assembly,
    objects_of_obj,
    objects_of_rhino,
    transformations_of_btlx,
)
from builders_ifc import wall_panel
from sitewright.app.built_state import BuiltState, Moment, state_at
from sitewright.app.checking import check
from sitewright.app.exporting import Export, export_as
from sitewright.app.importing import ImportOptions, import_file, read_design
from sitewright.app.inferring import infer_project
from sitewright.app.reimporting import reimport_file
from sitewright.building_model.component import Component, Layer
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.same_value import is_same
from sitewright.building_model.shapes import extent_of, shape_of, volume_of
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId

pytest.importorskip("rhino3dm", reason="needs rhino3dm: pip install 'sitewright[rhino]'")
pytest.importorskip("compas_timber", reason="needs compas_timber: pip install 'sitewright[timber]'")


@dataclass(frozen=True)
class Case:
    """A file of one format.

    Attributes:
        ids: Reads the ids of its parts, without the importer.
        patch: Kind of export that goes back into a copy of it; empty if there is none.
    """

    path: str
    ids: Callable[[Path], set[str]]
    unit: str | None = None
    patch: str = ""


CASES = {
    "rhino": Case("rhino/layer_template.3dm", objects_of_rhino, patch="rhino"),
    "rhino-text": Case("rhino/object_UserStrings.3dm", objects_of_rhino, patch="rhino"),
    "ifc": Case("", elements_of_ifc, patch="ifc"),
    "compas_timber": Case("timber/frame_house.json", elements_of_timber, unit="mm"),
    "btlx": Case("timber/frame_house.btlx", transformations_of_btlx),
    "obj": Case("masonry/wall_simple.obj", objects_of_obj, unit="m"),
    "compas_assembly": Case("masonry/wall_assembly.json", nodes_of_assembly, unit="m"),
    "arch": Case("masonry/arch_assembly.json", nodes_of_assembly, unit="m"),
    "bars": Case("bars/four_frame.json", elements_of_bars),
}
PATCHED = sorted(name for name, case in CASES.items() if case.patch)


@dataclass(frozen=True)
class Journey:
    """What came of a file.

    Attributes:
        read: The model as the importer read it.
        checked: Problems right after the import.
        target: The component that was built, in a run that was written down, not run.
        exports: What was exported after it, by kind.
    """

    name: str
    original: Path
    folder: Path
    read: BuildingModel
    checked: list[Problem]
    target: ComponentId
    state: BuiltState
    exports: Mapping[str, Export]

    @property
    def case(self) -> Case:
        return CASES[self.name]


def _travelled(name: str, data: Path, scratch: Path) -> Journey:
    case = CASES[name]
    if case.path:
        original = Path(shutil.copy(data / case.path, scratch))
    else:
        original = wall_panel().write(scratch / "panel.ifc")
    folder = scratch / "project"
    options = ImportOptions(unit=case.unit)
    import_file(original, folder, options)
    checked = check(folder)
    infer_project(folder, write=True)
    design = state_at(folder)
    target = ComponentId(targets_of(design.design)[0])
    at = design.world_T_model @ design.design.component_by_id[target].world_T_component
    wrote_run(
        folder, "0001-aaaa", *built(design.design, target, stock_of(design.design, target), at)
    )
    state = state_at(folder)
    kinds = ["json", "csv", "glb", *([case.patch] if case.patch else [])]
    exports = {k: export_as(k, state, original=original) for k in kinds}
    read = read_design(original, options)[1]
    return Journey(name, original, folder, read, checked, target, state, exports)


@pytest.fixture(scope="module")
def journeys(shared_data: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Journey]:
    return {n: _travelled(n, shared_data, tmp_path_factory.mktemp("journey")) for n in CASES}


@pytest.fixture(params=sorted(CASES))
def journey(journeys: dict[str, Journey], request: pytest.FixtureRequest) -> Journey:
    return journeys[request.param]


def facts(component: Component) -> tuple[Any, ...]:
    """Return what must survive: name, type, group, material, shape, pose, attributes, source."""
    source = component.source and component.source.id
    words = (component.name, component.type, component.group, component.material, source)
    shape = (component.geometry, component.cuts, component.world_T_component)
    return (*words, *shape, component.raw)


def of_the_file(model: BuildingModel) -> dict[ComponentId, Component]:
    return {i: c for i, c in model.component_by_id.items() if c.source is not None}


def test_every_part_of_the_file_is_a_component_under_its_own_id(journey: Journey) -> None:
    wanted = journey.case.ids(journey.original)
    assert {c.source.id for c in journey.read.component_by_id.values() if c.source} == wanted
    assert len(of_the_file(journey.state.design)) == len(wanted)


def test_what_inference_adds_leaves_what_was_read_as_it_was(journey: Journey) -> None:
    now = of_the_file(journey.state.design)
    assert now.keys() == journey.read.component_by_id.keys()
    for name, component in journey.read.component_by_id.items():
        before, after = facts(component), facts(now[name])
        if journey.name in {"compas_timber", "btlx"}:  # beams are marked by their cuts
            before, after = (before[0], *before[2:]), (after[0], *after[2:])
        assert is_same(after, before), name


def test_the_status_file_knows_every_part_by_its_own_id(journey: Journey) -> None:
    (file,) = [f for f in journey.exports["csv"].files if f.name == "status.json"]
    found = json.loads(file.read_bytes())
    assert set(found) == journey.case.ids(journey.original)
    changed = {i for i, e in found.items() if e["changed"]}
    source = journey.state.design.component_by_id[journey.target].source
    assert source is not None
    assert changed == {source.id}
    assert found[source.id]["keys"]["status"] == "verified"
    assert found[source.id]["measured"]["p_m"] == pytest.approx(
        list(journey.read.component_by_id[journey.target].world_T_component.position_m), abs=1e-6
    )
    others = {e["keys"]["status"] for i, e in found.items() if i != source.id}
    assert others <= {"planned"}


def test_the_exported_model_reads_back_as_it_was(journey: Journey) -> None:
    model = read_building(journey.exports["json"].files[0], is_exported=True)
    assert is_same(model.component_by_id, journey.state.as_built.component_by_id)
    assert is_same(
        (model.relations, model.stacks),
        (journey.state.as_built.relations, journey.state.as_built.stacks),
    )
    assert model.component_by_id[journey.target].layer is Layer.AS_BUILT


def test_an_exported_design_can_be_imported_again(journey: Journey, tmp_path: Path) -> None:
    designed = state_at(journey.folder)
    out = tmp_path / "design.json"
    export_as("json", state_at(journey.folder, Moment(is_design=True)), out=out)
    import_file(out, tmp_path / "again")
    again = read_building(tmp_path / "again" / "building.json")
    assert again.component_by_id.keys() == designed.design.component_by_id.keys()
    for name, component in designed.design.component_by_id.items():
        assert is_same(facts(again.component_by_id[name]), facts(component))
        assert volume_of(again.component_by_id[name]) == pytest.approx(volume_of(component))


def test_the_table_has_every_component_with_its_pose(journey: Journey) -> None:
    text = journey.exports["csv"].files[0].read_text(encoding="utf-8")
    rows = {r["id"]: r for r in csv.DictReader(io.StringIO(text))}
    state = journey.state
    assert set(rows) == set(of_the_file(state.design))
    for name, component in of_the_file(state.design).items():
        pose = state.world_T_model @ component.world_T_component
        assert [float(rows[name][k]) for k in ("x_m", "y_m", "z_m")] == pytest.approx(
            list(pose.position_m), abs=1e-6
        )
        assert rows[name]["name"] == component.name
        assert rows[name]["status"] == ("verified" if name == journey.target else "planned")


def test_another_library_finds_every_shape_in_the_scene(journey: Journey) -> None:
    bodies, state = bodies_in(journey.exports["glb"].files[0]), journey.state
    assert set(bodies) == set(state.as_built.component_by_id)
    for name, component in of_the_file(state.as_built).items():
        wanted = extent_of(shape_of(component), state.world_T_model @ component.world_T_component)
        assert bodies[name].is_closed
        assert bodies[name].volume_m3 == pytest.approx(volume_of(component), rel=1e-3)
        assert bodies[name].low_m == pytest.approx(wanted.low_m, abs=1e-5)
        assert bodies[name].high_m == pytest.approx(wanted.high_m, abs=1e-5)


@pytest.mark.parametrize("name", PATCHED)
def test_a_patched_copy_is_imported_as_the_original_but_for_what_was_built(
    journeys: dict[str, Journey], name: str
) -> None:
    journey = journeys[name]
    copy = journey.exports[journey.case.patch].files[0]
    assert copy != journey.original
    again = read_design(copy, ImportOptions())[1]
    assert again.component_by_id.keys() == journey.read.component_by_id.keys()
    for identity, component in journey.read.component_by_id.items():
        other = again.component_by_id[identity]
        assert is_same(facts(other), facts(component))
        assert volume_of(other) == pytest.approx(volume_of(component), rel=1e-9)
        is_built = identity == journey.target
        assert other.layer is (Layer.AS_BUILT if is_built else Layer.TARGET)


def test_the_original_was_only_read_and_imports_again_without_a_difference(
    journey: Journey, shared_data: Path
) -> None:
    if journey.case.path:
        assert journey.original.read_bytes() == (shared_data / journey.case.path).read_bytes()
    found = reimport_file(journey.original, journey.folder, ImportOptions())
    assert (found.changes, found.conflicts) == ((), ())


@pytest.mark.parametrize("name", PATCHED)
def test_a_patched_copy_changes_nothing_in_the_project_that_built_it(
    journeys: dict[str, Journey], name: str
) -> None:
    journey = journeys[name]
    copy = journey.exports[journey.case.patch].files[0]
    found = reimport_file(copy, journey.folder, ImportOptions())
    assert (found.changes, found.conflicts, found.is_refused) == ((), (), False)


@pytest.mark.parametrize("name", ["obj", "compas_assembly", "arch", "bars"])
def test_check_says_why_the_cell_cannot_build_masonry_and_bars(
    journeys: dict[str, Journey], name: str
) -> None:
    journey = journeys[name]
    opening = {p.where: p.message for p in journey.checked if p.code == "Q2"}
    assert set(opening) == set(journey.read.component_by_id)
    assert all(
        "No gripper holds its section of" in m and "30-140 mm" in m for m in opening.values()
    )


@pytest.mark.parametrize(("name", "heavy"), [("obj", 38), ("compas_assembly", 50), ("arch", 30)])
def test_check_says_that_masonry_would_be_too_heavy(
    journeys: dict[str, Journey], name: str, heavy: int
) -> None:
    said = [p for p in journeys[name].checked if p.code == "Q1"]
    assert len(said) == heavy
    assert all("more than the 120 kg of kr120" in p.message for p in said)


def test_stated_to_be_concrete_masonry_is_an_error_of_payload(
    journeys: dict[str, Journey], tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(journeys["compas_assembly"].folder, tmp_path / "p"))
    document = json.loads((folder / "building.json").read_bytes())
    for component in document["components"]:
        component["material"] = "concrete"
    (folder / "building.json").write_text(json.dumps(document), encoding="utf-8")
    said = [p for p in check(folder) if p.code == "Q1"]
    assert {(p.severity, len(said)) for p in said} == {("E", 50)}
