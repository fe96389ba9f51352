"""The scripts of examples/make_files: what they write is imported, completed, checked, planned."""

from __future__ import annotations

import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from sitewright.app.checking import check
from sitewright.app.importing import ImportOptions, import_file
from sitewright.app.inferring import infer_project
from sitewright.app.planning import plan_project
from sitewright.app.project import example_folder, open_project
from sitewright.building_model.component import BoxGeometry, Component, Layer
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.model import BuildingModel, RelationKind

SCRIPTS = Path(__file__).parents[2] / "examples" / "make_files"


@dataclass(frozen=True)
class Made:
    """What a script wrote and became: the file, its project, errors right after the import."""

    file: Path
    folder: Path
    errors: tuple[str, ...]

    @property
    def model(self) -> BuildingModel:
        return read_building(self.folder / "building.json")


def made(scratch: Path, script: str, name: str, *, unit: str | None = None) -> Made:
    file, folder = scratch / name, scratch / "project"
    code = subprocess.run([sys.executable, SCRIPTS / script, file], check=False).returncode
    assert code == 0
    folder.mkdir()
    if unit is None:
        shutil.copy(example_folder("wooden_frame") / "cell.toml", folder)
    import_file(file, folder, ImportOptions(unit=unit))
    errors = tuple(p.code for p in check(folder) if p.severity == "E")
    rules = SCRIPTS / "nails.toml" if name.endswith(".ifc") else None
    infer_project(folder, rules=rules, write=True)
    return Made(file, folder, errors)


@pytest.fixture(scope="module")
def rhino(tmp_path_factory: pytest.TempPathFactory) -> Made:
    pytest.importorskip("rhino3dm", reason="needs the extra 'rhino'")
    return made(tmp_path_factory.mktemp("made"), "rhino_frame.py", "frame.3dm")


@pytest.fixture(scope="module")
def ifc(tmp_path_factory: pytest.TempPathFactory) -> Made:
    pytest.importorskip("ifcopenshell", reason="needs the extra 'ifc'")
    return made(tmp_path_factory.mktemp("made"), "ifc_frame.py", "frame.ifc")


@pytest.fixture(scope="module")
def timber(tmp_path_factory: pytest.TempPathFactory) -> Made:
    pytest.importorskip("compas_timber", reason="needs the extra 'timber'")
    return made(tmp_path_factory.mktemp("made"), "timber_frame.py", "frame.json", unit="mm")


@pytest.fixture(params=["rhino", "ifc", "timber"])
def any_made(request: pytest.FixtureRequest) -> Made:
    found: Made = request.getfixturevalue(request.param)
    return found


def targets(model: BuildingModel) -> list[Component]:
    found = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    return sorted(found, key=lambda c: (c.type, c.name))


def test_after_inference_nothing_is_wrong(any_made: Made) -> None:
    assert [p for p in check(any_made.folder) if p.severity == "E"] == []


def test_the_frames_are_those_that_the_scripts_say(rhino: Made, ifc: Made) -> None:
    assert rhino.errors == ()
    assert ifc.errors == ("F4",) * 3, "IFC says nothing of what rests on what"
    for one in (rhino, ifc):
        *studs, _, _ = sorted(targets(one.model), key=lambda c: (c.order or 0, c.name))[::-1]
        assert [s.geometry for s in studs] == [BoxGeometry((1.8, 0.09, 0.04))] * 3
        assert {s.world_T_component.position_m[1] for s in studs} == {-0.8, 0.0, 0.8}
        assert {s.material for s in targets(one.model)} == {"C24"}
        assert {s.place: len(s.items) for s in one.model.stacks} == {
            "pallet-thick": 3,
            "pallet-thin": 4,
        }
        for stud in studs:
            assert len(stud.construction_parents) == 2
            assert len(stud.operations) == 4
            assert {o.process for o in stud.operations} == {"nail"}


def test_what_no_key_of_ours_says_is_kept(rhino: Made) -> None:
    assert {c.raw["Fire class"] for c in targets(rhino.model)} == {"R30"}


def test_the_wall_has_its_beams_joints_and_stock(timber: Made) -> None:
    assert timber.errors == ()
    found = targets(timber.model)
    assert [c.name for c in found] == ["head 1", "post 1", "post 2", "post 3", "sill 1"]
    assert {c.material for c in found} == {"C24"}
    joints = [r for r in timber.model.relations if r.kind is RelationKind.CONNECTION]
    assert sorted(str(r.data["type"]) for r in joints) == ["LButtJoint"] * 4 + ["TButtJoint"] * 2
    assert sum(len(s.items) for s in timber.model.stacks) == 5


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["rhino", "ifc"])
def test_every_component_is_planned_with_its_nails(
    kind: str, request: pytest.FixtureRequest
) -> None:
    report = plan_project(open_project(request.getfixturevalue(kind).folder))
    assert (report.targets_planned, report.targets_total) == (5, 5)
    steps = [s.call.skill for p in report.planned for s in p.proposal.steps]
    assert sum("nail" in s or "fasten" in s for s in steps) == 12, sorted(set(steps))
