"""`sitewright infer` and `explain`: a diff, a careful write, and reasons."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from sitewright.app.clock import SystemClock
from sitewright.app.event_log import EventLog
from sitewright.app.ids import UuidSource
from sitewright.app.importing import ImportOptions, read_design
from sitewright.app.inferring import infer_project
from sitewright.app.locks import locked
from sitewright.app.model_writing import BACKUP
from sitewright.app.project import new_project
from sitewright.app.run_folder import next_run_folder
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.inference.bodies import bodies_of
from sitewright.building_model.inference.interfaces import interfaces_of
from sitewright.central_controller.events import RunStarted
from sitewright.cli.main import exit_code
from sitewright.foundation.ids import ComponentId, RunId
from sitewright.journal.sqlite import SqliteJournal

TOML = """
[[rules]]
id = "cross"
kind = "fasten"
through = "transverse-stud"
into = "supporting-stud"
contact = "lap"
fastener = { type = "nail", d_m = 0.0031, l_m = 0.09 }
count = 2
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return new_project(tmp_path / "frame")


def strip(project: Path) -> dict[str, object]:
    """Take everything out of the example that can be inferred, and return the document."""
    file = project / "building.json"
    document = json.loads(file.read_text(encoding="utf-8"))
    for component in document["components"]:
        for key in ("order", "construction_parents", "ground", "operations"):
            component.pop(key, None)
        component.pop("hold_until_fasteners", None)
    del document["stacks"]
    file.write_text(json.dumps(document), encoding="utf-8")
    return dict(document)


def run(*arguments: str | Path) -> int:
    return exit_code([str(a) for a in arguments])


def test_infer_shows_a_diff_and_writes_nothing(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = (project / "building.json").read_bytes()
    assert run("infer", project) == 0
    shown = capsys.readouterr().out
    assert "+ support-1 supports stud-1" in shown
    assert "nothing is written without --write" in shown
    assert (project / "building.json").read_bytes() == before
    assert not (project / BACKUP).exists()


def test_write_keeps_the_old_file_and_every_stated_value(project: Path) -> None:
    before = (project / "building.json").read_bytes()
    assert run("infer", project, "--write") == 0
    assert (project / BACKUP).read_bytes() == before
    old = json.loads(before)
    new = json.loads((project / "building.json").read_bytes())
    for stated, now in zip(old["components"], new["components"], strict=True):
        assert {k: now[k] for k in stated} == stated
    assert new["stacks"] == old["stacks"]
    assert {r["origin"] for r in new["relations"]} == {"inferred"}


def test_inferring_again_finds_nothing_and_writes_nothing(project: Path) -> None:
    infer_project(project, write=True)
    written = (project / "building.json").read_bytes()
    again = infer_project(project, write=True)
    assert again.changes == ()
    assert not again.is_written
    assert (project / "building.json").read_bytes() == written


def test_a_bare_frame_gets_back_what_the_paper_assumes_given(project: Path) -> None:
    strip(project)
    rules = project / "rules.toml"
    rules.write_text(TOML, encoding="utf-8")
    found = infer_project(project, rules=rules, write=True)
    model = read_building(project / "building.json")
    studs = [c for c in model.component_by_id.values() if c.type == "transverse-stud"]
    targets = {c.id: c for c in model.component_by_id.values() if c.layer == "target"}
    assert found.is_written
    assert sum(c.ground for c in targets.values()) == 2
    assert [targets[ComponentId(f"stud-{k}")].construction_parents for k in (1, 2, 3)] == [
        ("support-1", "support-2")
    ] * 3
    assert {c.order for c in targets.values()} == {1, 2}
    assert sum(len(c.operations) for c in targets.values()) == 12
    assert len([r for r in model.relations if r.kind == "contact"]) == 6
    assert len([r for r in model.relations if r.kind == "supports"]) == 6
    assert len(model.stacks) == 2
    assert len(studs) == 6
    assert [str(r["id"]) for r in model.rules] == ["cross"]
    assert run("check", project) == 0


def test_an_override_by_hand_stays(project: Path) -> None:
    strip(project)
    infer_project(project, write=True)
    file = project / "building.json"
    document = json.loads(file.read_text(encoding="utf-8"))
    stud = next(c for c in document["components"] if c["id"] == "stud-1")
    stud["order"] = 7
    del stud["origins"]["order"]
    file.write_text(json.dumps(document), encoding="utf-8")
    found = infer_project(project, write=True)
    assert found.after.component_by_id[stud["id"]].order == 7
    assert read_building(file).component_by_id[stud["id"]].order == 7


def test_nothing_is_written_while_another_process_runs_the_project(project: Path) -> None:
    before = (project / "building.json").read_bytes()
    with locked(project / "runs" / "lock", "The project"):
        assert run("infer", project, "--write") == 9
    assert (project / "building.json").read_bytes() == before


def test_nothing_is_written_while_a_run_is_open(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = (project / "building.json").read_bytes()
    begin_run(project)
    assert run("infer", project) == 0
    assert run("infer", project, "--write") == 9
    assert "is open" in capsys.readouterr().err
    assert (project / "building.json").read_bytes() == before
    assert not (project / BACKUP).exists()


def begin_run(project: Path) -> None:
    """Leave a run that has begun and not ended."""
    folder = next_run_folder(project / "runs")
    folder.create()
    started = RunStarted(run=RunId(folder.run), project="frame", hashes={})
    clock = SystemClock()
    with SqliteJournal(folder.journal) as journal:
        EventLog(folder, journal, clock=clock, ids=UuidSource(clock)).append(started)


def test_rules_that_cannot_be_read_or_clash_are_one_clear_error(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rules = project / "rules.toml"
    rules.write_text("[[rules]\n", encoding="utf-8")
    assert run("infer", project, "--rules", rules) == 3
    rules.write_text(TOML, encoding="utf-8")
    assert run("infer", project, "--rules", rules, "--write") == 0
    rules.write_text(TOML.replace("count = 2", "count = 3"), encoding="utf-8")
    assert run("infer", project, "--rules", rules) == 3
    assert "says something else" in capsys.readouterr().err


def test_rules_that_come_with_it_are_named_builtin(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run("infer", project, "--rules", "builtin:timber-panel", "--write") == 0
    rules = read_building(project / "building.json").rules
    assert [r["id"] for r in rules] == ["butt-joints", "double-plates"]
    assert run("infer", project, "--rules", "builtin:timber-panels") == 3
    assert "there are builtin:timber-panel. Did you mean timber-panel?" in capsys.readouterr().err


def test_explain_says_where_facts_come_from_and_what_comes_first(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    strip(project)
    assert run("explain", "component", "stud-2", project) == 0
    said = capsys.readouterr().out
    assert "rests on support-1, 81 cm2 (inferred)" in said
    assert "construction_parents: support-1, support-2 (inferred: touching from below" in said
    assert run("explain", "order", "support-1", project, "--json") == 0
    document = json.loads(capsys.readouterr().out)
    assert "  before stud-2: it is its construction parent" in document["lines"]
    assert run("explain", "order", "stud-9", project) == 3
    assert "Did you mean stud-" in capsys.readouterr().err


def test_an_imported_frame_house_has_nothing_left_to_infer(
    shared_data: Path, tmp_path: Path
) -> None:
    pytest.importorskip("compas_timber", reason="needs the extra [timber]")
    file, house = shared_data / "timber" / "frame_house.json", tmp_path / "house"
    assert run("import", file, "--unit", "mm", "-o", house) == 0
    assert infer_project(tmp_path / "house").changes == ()


def test_contacts_of_the_frame_house_are_54_of_its_63_joints_and_none_on_blanks(
    shared_data: Path,
) -> None:
    pytest.importorskip("compas_timber", reason="needs the extra [timber]")
    file = shared_data / "timber" / "frame_house.json"
    _, model, _ = read_design(file, ImportOptions(unit="mm"))
    joined = {frozenset((r.a, r.b)) for r in model.relations}
    blanks = {i: replace(c, cuts=()) for i, c in model.component_by_id.items()}
    found = [frozenset((i.a, i.b)) for i in interfaces_of(bodies_of(model)[0])]
    assert (len(joined), len(found)) == (63, 54)
    assert set(found) <= joined
    assert interfaces_of(bodies_of(replace(model, component_by_id=blanks))[0]) == []
