"""An IFC frame goes the whole way: import, check, infer, plan, export, import again."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from builders_ifc import lying_frame
from sitewright.app.checking import check
from sitewright.app.importing import ImportOptions, import_file, read_design
from sitewright.app.inferring import infer_project
from sitewright.app.planning import plan_project
from sitewright.app.project import example_folder, open_project
from sitewright.building_model.as_built import InstallRecord, fold
from sitewright.building_model.component import BoxGeometry, Component, Layer
from sitewright.building_model.formats.ifc_export import export_ifc
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.object_states import object_states
from sitewright.foundation.pose import Pose

NOW = "2030-05-01T18:00:00+00:00"


@pytest.fixture(scope="module")
def ifc(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return lying_frame().write(tmp_path_factory.mktemp("ifc") / "frame.ifc")


@pytest.fixture(scope="module")
def imported(ifc: Path) -> Path:
    """Return a project of the file, in the cell with a table; nothing inferred yet."""
    folder = ifc.with_name("project")
    folder.mkdir()
    shutil.copy(example_folder("wooden_frame") / "cell.toml", folder)
    assert import_file(ifc, folder).problems == ()
    return folder


@pytest.fixture(scope="module")
def project(imported: Path) -> Path:
    """Return a copy of the project with everything inferred."""
    folder = imported.with_name("inferred")
    shutil.copytree(imported, folder)
    assert infer_project(folder, write=True).is_written
    return folder


def targets_of(folder: Path) -> list[Component]:
    model = read_building(folder / "building.json")
    return [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]


def test_the_imported_model_is_the_one_that_was_drawn(imported: Path) -> None:
    model = read_building(imported / "building.json")
    targets = sorted(targets_of(imported), key=lambda c: c.name)
    assert [c.name for c in targets] == ["stud 1", "stud 2", "stud 3", "support 1", "support 2"]
    assert targets[0].type == "member-stud"
    assert targets[0].geometry == BoxGeometry((1.8, 0.04, 0.09))
    assert targets[0].world_T_component.position_m == pytest.approx((0.0, -0.8, 0.16))
    assert targets[3].type == "member-supporting-stud"
    assert {(c.order, c.group, c.material) for c in targets} == {
        (1, "frame", "C24"),
        (2, "frame", "C24"),
    }
    assert {s.place: len(s.items) for s in model.stacks} == {"pallet-thick": 2, "pallet-thin": 3}


def test_the_check_misses_only_what_the_file_cannot_say(imported: Path) -> None:
    problems = [p for p in check(imported) if p.severity == "E"]
    studs = {c.id for c in targets_of(imported) if c.type == "member-stud"}
    assert {p.code for p in problems} == {"F4"}, "they touch what they do not say they rest on"
    assert {p.where for p in problems} == studs


def test_what_is_inferred_makes_the_project_whole(project: Path) -> None:
    assert [p for p in check(project) if p.severity == "E"] == []
    supports = {c.id for c in targets_of(project) if c.type == "member-supporting-stud"}
    for component in targets_of(project):
        resting = set(component.construction_parents)
        assert resting == (set() if component.id in supports else supports)


def test_every_member_of_the_frame_is_planned(project: Path) -> None:
    report = plan_project(open_project(project))
    assert (report.targets_planned, report.targets_total) == (5, 5)


def test_what_was_built_comes_back_as_built(project: Path, ifc: Path, tmp_path: Path) -> None:
    model = read_building(project / "building.json")
    support = min(c.id for c in targets_of(project) if c.type == "member-supporting-stud")
    piece = next(s for s in model.stacks if s.place == "pallet-thick").items[-1]
    at = model.component_by_id[support].world_T_component
    record = InstallRecord(target=support, material=piece, world_T_measured=at, installed_at=NOW)
    out = tmp_path / "frame_asbuilt.ifc"
    states = object_states(model, fold(model, [record]), Pose())
    patch = export_ifc(ifc, states, out, written_at=NOW)
    assert (set(patch.written), patch.not_found) == ({support, piece}, ())
    _, again, problems = read_design(out, ImportOptions())
    assert problems == []
    assert again.component_by_id[support].layer is Layer.AS_BUILT
    assert again.component_by_id[piece].layer is Layer.AS_DESIGNED, "it is stock no more"
    assert piece not in {i for s in again.stacks for i in s.items}
    _, before, _ = read_design(ifc, ImportOptions())
    for name, component in before.component_by_id.items():
        if name == piece:  # it is where it was, but no longer in the frame of a pile
            continue
        assert again.component_by_id[name].geometry == component.geometry
        assert again.component_by_id[name].world_T_component == component.world_T_component
        assert again.component_by_id[name].order == component.order
