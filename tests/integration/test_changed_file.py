"""A changed IFC file goes into its project as a user does it: diff, protection, the run goes on."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

ifc = pytest.importorskip("builders_ifc", reason="needs the extra 'ifc'")

from sitewright.app.importing import ImportOptions  # noqa: E402
from sitewright.app.locks import locked  # noqa: E402
from sitewright.app.project import example_folder, open_project  # noqa: E402
from sitewright.app.reimporting import reimport_file  # noqa: E402
from sitewright.app.run_folder import chain_events, chain_of, run_folders  # noqa: E402
from sitewright.building_model.formats.native import read_building  # noqa: E402
from sitewright.central_controller.events import (  # noqa: E402
    ComponentInstalled,
    ComponentPositioned,
    DesignChanged,
    ProposalMade,
    ProposalSuperseded,
)
from sitewright.robot_team.drivers.mujoco.client import connect  # noqa: E402

SITEWRIGHT = "import sys; from sitewright.cli.main import main; main(sys.argv[1:])"


def drawn(
    path: Path, moves_mm: Mapping[str, tuple[float, float, float]], *, gone: str = ""
) -> Path:
    """Write the lying frame with members moved, or without one."""
    draft = ifc.lying_frame()
    for member in draft.file.by_type("IfcMember"):
        if member.Name in moves_mm:
            point = member.ObjectPlacement.RelativePlacement.Location
            shift = moves_mm[member.Name]
            point.Coordinates = [a + b for a, b in zip(point.Coordinates, shift, strict=True)]
        if member.Name == gone:
            member.Representation = None
    written: Path = draft.write(path)
    return written


def sitewright(*words: object, answers: str = "") -> tuple[int, str, str]:
    run = subprocess.run(
        [sys.executable, "-c", SITEWRIGHT, *map(str, words)],
        input=answers,
        capture_output=True,
        text=True,
        check=False,
    )
    return run.returncode, run.stdout, run.stderr


def document(*words: object) -> dict[str, Any]:
    code, out, err = sitewright(*words, "--json")
    found: dict[str, Any] = json.loads(out)
    return {**found, "code": code, "said": err}


@pytest.fixture(scope="module")
def imported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a project of the drawn frame, completed by inference, nothing built."""
    folder = tmp_path_factory.mktemp("changed") / "project"
    folder.mkdir()
    shutil.copy(example_folder("wooden_frame") / "cell.toml", folder)
    file = drawn(folder.with_name("frame.ifc"), {})
    assert sitewright("import", file, "-o", folder)[0] == 0
    assert sitewright("infer", folder, "--write")[0] == 0
    return folder


@pytest.fixture(scope="module")
def interrupted(imported: Path) -> Iterator[Path]:
    """Return the project after one component was built and the next plan was held."""
    folder = imported.with_name("interrupted")
    shutil.copytree(imported, folder)
    code, _, said = sitewright("run", folder, answers="a\n")
    assert code == 7, said
    yield folder
    cell = run_folders(folder / "runs")[-1].path / "cell"
    connect(cell, open_project(folder).cell, ()).shutdown()


@pytest.fixture
def project(imported: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(imported, tmp_path / "project"))


@pytest.fixture
def held(interrupted: Path, tmp_path: Path) -> Path:
    return Path(
        shutil.copytree(interrupted, tmp_path / "held", ignore=shutil.ignore_patterns("*.sock"))
    )


def name_of(folder: Path, identity: str) -> str:
    return read_building(folder / "building.json").component_by_id[identity].name  # type: ignore[index]


def events_of(folder: Path) -> tuple[Any, ...]:
    return chain_events(chain_of(run_folders(folder / "runs")[-1]))[0]


def installed_in(folder: Path) -> str:
    """Return the name of the one component that stands."""
    (done,) = [e for e in events_of(folder) if isinstance(e, ComponentInstalled)]
    return name_of(folder, done.target)


def test_the_same_file_changes_nothing(project: Path) -> None:
    before = (project / "building.json").read_bytes()
    found = document("import", project.with_name("x") / "y", "-o", project)
    assert found["code"] == 3  # there is no such file
    same = drawn(project.with_name("same.ifc"), {})
    found = document("import", same, "-o", project, "--write")
    assert (found["code"], found["changes"], found["is_written"]) == (0, [], False)
    assert (project / "building.json").read_bytes() == before


def test_a_changed_file_is_shown_and_only_written_if_asked(project: Path) -> None:
    before = (project / "building.json").read_bytes()
    file = drawn(project.with_name("v2.ifc"), {"stud 3": (0, -100, 0)}, gone="stud 1")
    code, out, _ = sitewright("import", file, "-o", project)
    assert code == 0
    lines = out.splitlines()
    assert any(
        line.startswith("~") and "(stud 3)" in line and "(0, -100, 0) mm" in line for line in lines
    )
    assert any(line.startswith("-") and "(stud 1)" in line for line in lines)
    assert (project / "building.json").read_bytes() == before
    assert document("import", file, "-o", project, "--write")["is_written"]
    assert (project / "building.json.bak").read_bytes() == before
    names = {c.name for c in read_building(project / "building.json").component_by_id.values()}
    assert "stud 1" not in names
    assert "stud 3" in names
    assert document("import", file, "-o", project)["changes"] == []


def test_own_edits_stay_and_inferred_facts_follow_the_file(project: Path) -> None:
    file = project / "building.json"
    content = json.loads(file.read_text(encoding="utf-8"))
    stud = next(c for c in content["components"] if c["name"] == "stud 2")
    stud["ext"] = {**stud.get("ext", {}), "colour": "red"}
    stud["group"] = "mine"
    content["materials"] = {"C24": {"density_kg_m3": 420.0}}
    file.write_text(json.dumps(content), encoding="utf-8")
    moved = drawn(project.with_name("v2.ifc"), {"stud 2": (0, 0, 500)})
    found = document("import", moved, "-o", project, "--write")
    assert (found["code"], found.get("conflicts")) == (0, []), found
    after = next(c for c in read_building(file).component_by_id.values() if c.name == "stud 2")
    assert (after.ext["colour"], after.group) == ("red", "mine")
    assert after.world_T_component.position_m[2] == pytest.approx(0.66)
    assert after.construction_parents == ()  # inferred before; now it touches nothing
    assert read_building(file).materials == {"C24": {"density_kg_m3": 420.0}}


def test_what_both_changed_is_told_and_the_user_wins_unless_he_says_otherwise(
    project: Path,
) -> None:
    file = project / "building.json"
    content = json.loads(file.read_text(encoding="utf-8"))
    stud = next(c for c in content["components"] if c["name"] == "stud 2")
    stud["world_T_component"]["p_m"][1] = 0.1
    file.write_text(json.dumps(content), encoding="utf-8")
    moved = drawn(project.with_name("v2.ifc"), {"stud 2": (0, 50, 0)})
    mine = document("import", moved, "-o", project)
    assert [(c["key"], c["taken"]) for c in mine["conflicts"]] == [("world_T_component", "mine")]
    assert mine["changes"] == []
    theirs = document("import", moved, "-o", project, "--prefer", "file", "--write")
    assert theirs["conflicts"][0]["taken"] == "file"
    after = read_building(file).component_by_id[stud["id"]]
    assert after.world_T_component.position_m[1] == pytest.approx(0.05)


def test_another_kind_of_file_and_a_project_without_record_are_refused(project: Path) -> None:
    obj = project.with_name("x.obj")
    obj.write_text("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    found = document("import", obj, "-o", project, "--unit", "m")
    assert found["code"] == 3
    assert "another kind of file" in found["message"]
    shutil.rmtree(project / "imports")
    file = drawn(project.with_name("v2.ifc"), {"stud 3": (0, -100, 0)})
    found = document("import", file, "-o", project)
    assert found["code"] == 3
    assert "--base" in found["message"]
    old = drawn(project.with_name("v1.ifc"), {})
    found = document("import", file, "-o", project, "--base", old)
    assert [c["key"] for c in found["changes"]] == ["world_T_component"]


def test_the_held_plan_dies_and_the_frame_is_built_as_changed(held: Path) -> None:
    (old,) = [e for e in events_of(held) if isinstance(e, ProposalMade)][-1:]
    next_one = name_of(held, old.target)
    standing = installed_in(held)
    assert next_one != standing
    file = drawn(held.with_name("v2.ifc"), {next_one: (6, 0, 0), "stud 3": (0, -60, 0)})
    written = document("import", file, "-o", held, "--write")
    assert (written["code"], written["superseded"]) == (0, old.fingerprint), written
    dead, change = events_of(held)[-2:]
    assert isinstance(dead, ProposalSuperseded)
    assert dead.fingerprint == old.fingerprint
    assert isinstance(change, DesignChanged)
    result = document("run", held, "--approve", "auto")
    assert (result["code"], result["targets_installed"]) == (0, 5), result["said"]
    assert result["unallowed_contacts"] == 0
    events = events_of(held)
    new = events[events.index(change) :]
    made = [e for e in new if isinstance(e, ProposalMade)]
    assert made[0].target == old.target
    assert old.fingerprint not in {m.fingerprint for m in made}
    placed = next(e for e in new if isinstance(e, ComponentPositioned) and e.target == old.target)
    before = read_building(held / "building.json.bak").component_by_id[old.target]
    after = read_building(held / "building.json").component_by_id[old.target]
    by_m = after.world_T_component.position_m[0] - before.world_T_component.position_m[0]
    assert by_m == pytest.approx(0.006)
    at = placed.world_T_wanted.position_m[0]
    assert at == pytest.approx(after.world_T_component.position_m[0], abs=2e-3)
    done = [e for e in events if isinstance(e, ComponentInstalled)]
    assert [name_of(held, e.target) for e in done].count(standing) == 1  # built once


@pytest.mark.parametrize("is_gone", [False, True])
def test_what_stands_is_protected_and_the_rest_can_be_taken(held: Path, is_gone: bool) -> None:  # noqa: FBT001
    standing = installed_in(held)
    moves = {"stud 3": (0.0, -60.0, 0.0)} | ({} if is_gone else {standing: (0.0, 5.0, 0.0)})
    file = drawn(held.with_name("v2.ifc"), moves, gone=standing if is_gone else "")
    before = (held / "building.json").read_bytes()
    found = document("import", file, "-o", held, "--write")
    assert (found["code"], found["is_written"]) == (3, False)
    (wrong,) = [p for p in found["problems"] if p["code"] == "I1"]
    assert name_of(held, wrong["where"]) == standing
    assert wrong["source_id"] == wrong["where"]
    assert ("not in the new design" if is_gone else "pose (by 5.0 mm") in wrong["message"]
    assert "--keep-installed" in wrong["fix"]
    assert (held / "building.json").read_bytes() == before
    kept = document("import", file, "-o", held, "--write", "--keep-installed")
    assert (kept["code"], kept["is_written"]) == (0, True), kept
    old = json.loads(before)
    new = json.loads((held / "building.json").read_bytes())
    same = [next(c for c in d["components"] if c["id"] == wrong["where"]) for d in (old, new)]
    assert same[0] == same[1]
    assert not is_gone or document("run", held, "--approve", "auto")["targets_installed"] == 5


def test_a_design_changed_by_hand_may_not_move_what_stands_either(held: Path) -> None:
    standing = installed_in(held)
    file = held / "building.json"
    content = json.loads(file.read_text(encoding="utf-8"))
    support = next(c for c in content["components"] if c["name"] == standing)
    support["world_T_component"]["p_m"][0] += 0.05
    file.write_text(json.dumps(content), encoding="utf-8")
    found = document("run", held, "--approve", "auto")
    assert found["code"] == 3
    assert [p["code"] for p in found["problems"]] == ["I1"]


def test_nothing_is_taken_while_a_controller_runs(held: Path) -> None:
    file = drawn(held.with_name("v2.ifc"), {"stud 3": (0, -60, 0)})
    with locked(held / "runs" / "lock", "The project"):
        assert document("import", file, "-o", held, "--write")["code"] == 9
        assert reimport_file(file, held, ImportOptions()).changes  # looking is allowed


def test_the_report_of_an_older_run_shows_the_design_that_it_built(held: Path) -> None:
    assert document("run", held, "--approve", "auto")["targets_installed"] == 5
    first = run_folders(held / "runs")[-1].run
    more = drawn(held.with_name("v2.ifc"), {})
    grown = ifc.lying_frame()
    grown.member("stud 4", (-900, 400, 160), (1, 0, 0), 1800, sides=(40, 90), PredefinedType="STUD")
    thin: dict[str, Any] = {"sides": (40, 90), "PredefinedType": "STUD"}
    piece = grown.member("spare", (-2500, -1550, 140), (1, 0, 0), 1800, **thin)
    pile = {"Layer": "Material", "Stack": "pallet-thin", "StackIndex": 3}
    grown.properties(piece, "Sitewright", pile)
    grown.material("C24", [piece, grown.file.by_type("IfcMember")[-2]])
    grown.write(more)
    assert document("import", more, "-o", held, "--write")["is_written"]
    told = document("report", held, "--run", first)
    assert (told["code"], told.get("targets_total")) == (0, 5), told
