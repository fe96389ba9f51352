"""`sitewright check`: what shapes tell, folded for people; and its safe repairs."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest

from sitewright.app.checking import check
from sitewright.app.clock import SystemClock
from sitewright.app.event_log import EventLog
from sitewright.app.ids import UuidSource
from sitewright.app.importing import ImportOptions, import_file
from sitewright.app.model_writing import BACKUP
from sitewright.app.project import new_project
from sitewright.app.repairing import repair_project
from sitewright.app.run_folder import next_run_folder
from sitewright.building_model.formats.native import read_building
from sitewright.central_controller.events import RunStarted
from sitewright.cli.main import exit_code
from sitewright.errors import Problem
from sitewright.foundation.ids import RunId
from sitewright.journal.sqlite import SqliteJournal

DATA = os.environ.get("SITEWRIGHT_DATA")
needs_data = pytest.mark.skipif(DATA is None, reason="needs SITEWRIGHT_DATA")


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return new_project(tmp_path / "frame")


def run(*arguments: str | Path) -> int:
    return exit_code([str(a) for a in arguments])


def edited(project: Path) -> dict[str, Any]:
    document: dict[str, Any] = json.loads((project / "building.json").read_text(encoding="utf-8"))
    return document


def save(project: Path, document: dict[str, Any]) -> None:
    (project / "building.json").write_text(json.dumps(document), encoding="utf-8")


def target(document: dict[str, Any], identity: str) -> dict[str, Any]:
    found: dict[str, Any] = next(c for c in document["components"] if c["id"] == identity)
    return found


def of(code: str, problems: list[Problem] | tuple[Problem, ...]) -> list[Problem]:
    return [p for p in problems if p.code == code]


def shift(document: dict[str, Any], identity: str, by_m: float, axis: int = 2) -> None:
    target(document, identity)["world_T_component"]["p_m"][axis] += by_m


def imported(tmp_path: Path, name: str, unit: str) -> Path:
    assert DATA is not None
    return import_file(Path(DATA) / name, tmp_path / "p", ImportOptions(unit=unit)).folder


def test_the_example_has_nothing_to_mend(project: Path) -> None:
    assert [p for p in check(project) if p.severity == "E" or p.is_fixable] == []


def test_an_overlap_is_told_by_check(project: Path) -> None:
    document = edited(project)
    shift(document, "stud-1", -0.03)
    save(project, document)
    assert of("G1", check(project))


def test_a_near_miss_is_told_with_its_gap(project: Path) -> None:
    document = edited(project)
    shift(document, "stud-1", 0.0025)
    save(project, document)
    missed = of("G5", check(project))
    assert missed
    assert "2.6 mm" in missed[0].message


@needs_data
def test_a_mason_reads_why_the_cell_cannot_lay_the_blocks(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project = imported(tmp_path, "masonry/wall_assembly.json", "m")
    assert run("check", project) == 3
    said = capsys.readouterr().out
    assert "Q2 52 times: No gripper holds its section of 400 x 200 mm" in said
    assert "gripper-a takes 30-140 mm" in said
    assert "as concrete" in said
    assert "120 kg of kr120-a" in said
    assert len(said.splitlines()) < 20
    assert run("check", project, "--all") == 3
    assert len(capsys.readouterr().out.splitlines()) > 190


@needs_data
def test_blocks_that_only_lack_a_statement_are_no_floating_ones(tmp_path: Path) -> None:
    found = check(imported(tmp_path, "masonry/wall_assembly.json", "m"))
    assert of("F2", found) == []
    assert len(of("F4", found)) == 42
    assert all(p.is_fixable for p in of("F4", found))


@needs_data
def test_the_voussoirs_of_an_arch_need_falsework(tmp_path: Path) -> None:
    found = check(imported(tmp_path, "masonry/arch_assembly.json", "m"))
    assert len(of("F2", found)) == 20
    assert not any(p.is_fixable for p in of("F2", found))


@needs_data
def test_bars_are_too_thin_for_the_grippers(tmp_path: Path) -> None:
    found = of("Q2", check(imported(tmp_path, "bars/four_frame.json", "mm")))
    assert len(found) == 4
    assert "2.6587 mm" in found[0].fix


@needs_data
def test_what_is_fixable_is_mended(tmp_path: Path) -> None:
    project = imported(tmp_path, "masonry/wall_assembly.json", "m")
    fixable = {(p.code, p.where) for p in check(project) if p.is_fixable}
    assert repair_project(project, write=True).is_written
    left = {(p.code, p.where) for p in check(project)}
    assert fixable
    assert not fixable & left


def test_a_unique_name_becomes_an_id_and_the_old_file_is_kept(project: Path) -> None:
    document = edited(project)
    stud = target(document, "stud-1")
    parent = stud["construction_parents"][0]
    target(document, parent)["name"] = "below"
    stud["construction_parents"][0] = "below"
    save(project, document)
    before = (project / "building.json").read_bytes()
    named = of("N1", check(project))
    assert [p.is_fixable for p in named] == [True]
    assert not repair_project(project).is_written
    assert (project / "building.json").read_bytes() == before
    found = repair_project(project, write=True)
    assert of("N1", found.mended)
    assert (project / BACKUP).read_bytes() == before
    stands = read_building(project / "building.json").component_by_id
    assert parent in next(c for i, c in stands.items() if i == "stud-1").construction_parents


def test_a_name_of_two_is_left_to_the_author(project: Path) -> None:
    document = edited(project)
    names = [c["id"] for c in document["components"] if c["id"] != "stud-1"][:2]
    for identity in names:
        target(document, identity)["name"] = "twin"
    target(document, "stud-1")["construction_parents"] = ["twin"]
    save(project, document)
    assert [p.is_fixable for p in of("N1", check(project))] == [False]
    assert repair_project(project, write=True).changes == ()


def test_a_component_removed_after_inference_leaves_no_trace(project: Path) -> None:
    document = edited(project)
    del document["stacks"]
    document["components"] = [c for c in document["components"] if c.get("layer") != "material"]
    for component in document["components"]:
        component.pop("operations", None)
        component.pop("construction_parents", None)
    save(project, document)
    assert run("infer", project, "--write") == 0
    document = edited(project)
    gone = next(c["id"] for c in document["components"] if c["id"].startswith("stud"))
    document["components"] = [c for c in document["components"] if c["id"] != gone]
    save(project, document)
    broken = of("P1", check(project))
    assert broken
    assert all(p.is_fixable for p in broken)
    assert repair_project(project, write=True).is_written
    assert of("P1", check(project)) == []


def test_inferred_facts_of_a_moved_component_are_stale_and_inferred_anew(project: Path) -> None:
    assert run("infer", project, "--write") == 0
    assert of("I3", check(project)) == []
    document = edited(project)
    shift(document, "stud-1", 0.5)
    save(project, document)
    stale = of("I3", check(project))
    assert stale
    assert all(p.is_fixable for p in stale)
    repair_project(project, write=True)
    assert of("I3", check(project)) == []


def test_a_relation_that_stands_twice_stands_once_after_repair(project: Path) -> None:
    document = edited(project)
    relation = {"kind": "before", "a": "support-1", "b": "stud-1"}
    document["relations"] = [*document.get("relations", []), relation, relation]
    save(project, document)
    assert len(of("D2", check(project))) == 1
    assert repair_project(project, write=True).is_written
    assert edited(project)["relations"].count(relation) == 1


def test_no_repair_while_a_run_is_open(project: Path) -> None:
    document = edited(project)
    relation = {"kind": "before", "a": "support-1", "b": "stud-1"}
    document["relations"] = [relation, relation]
    save(project, document)
    folder = next_run_folder(project / "runs")
    folder.create()
    clock = SystemClock()
    with SqliteJournal(folder.journal) as journal:
        started = RunStarted(run=RunId(folder.run), project="frame", hashes={})
        EventLog(folder, journal, clock=clock, ids=UuidSource(clock)).append(started)
    before = (project / "building.json").read_bytes()
    assert run("check", project, "--fix", "--write") == 9
    assert (project / "building.json").read_bytes() == before


def test_write_alone_is_wrong_usage(project: Path) -> None:
    assert run("check", project, "--write") == 2


def test_json_marks_what_is_fixable(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    document = edited(project)
    relation = {"kind": "before", "a": "support-1", "b": "stud-1"}
    document["relations"] = [relation, relation]
    save(project, document)
    assert run("check", project, "--fix", "--json") in {0, 3}
    answer = json.loads(capsys.readouterr().out)
    assert answer["schema"] == "sitewright.check/1"
    assert [p["code"] for p in answer["mended"]] == ["D2"]
    assert answer["is_written"] is False
