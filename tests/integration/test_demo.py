"""The demonstration as a new user runs it: one command, no terminal, and what one does next."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from sitewright.app.explaining_steps import explain_step
from sitewright.app.project import open_project
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.step_words import explanation
from sitewright.robot_team.skill import Skill

PROGRAM = Path(sys.executable).with_name("sitewright")


def sitewright(*arguments: str | Path, cwd: Path, typed: str = "") -> tuple[int, str, str]:
    run = subprocess.run(
        [PROGRAM, *map(str, arguments)],
        input=typed,
        capture_output=True,
        text=True,
        cwd=cwd,
        timeout=110,
        check=False,
    )
    return run.returncode, run.stdout, run.stderr


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    made = tmp_path_factory.mktemp("demo")
    yield made
    for process in psutil.process_iter(["cmdline"]):
        if any(str(made) in word for word in process.info["cmdline"] or ()):
            process.terminate()  # the simulated cell outlives its controller


@pytest.fixture(scope="module")
def demo(folder: Path) -> dict[str, Any]:
    code, out, err = sitewright("demo", "--approve", "auto", "--json", cwd=folder)
    assert code == 0, err[-2000:]
    found: dict[str, Any] = json.loads(out)
    return found


@pytest.mark.slow
def test_the_demo_builds_the_whole_frame_and_proves_it(demo: dict[str, Any]) -> None:
    assert (demo["targets_installed"], demo["targets_total"]) == (5, 5)
    assert (demo["fasteners_driven"], demo["fasteners_total"]) == (12, 12)
    assert demo["unallowed_contacts"] == 0
    total = demo["trajectories_total"]
    assert demo["trajectories_certified"] == demo["trajectories_confirmed"] == total > 0
    assert demo["closest_distance_m"] >= 0.010
    assert demo["worst_pose_error_m"] < 0.005
    assert demo["worst_pose_error_rad"] < 0.010
    assert demo["skills_failed"] == demo["questions_asked"] == 0
    assert demo["exit_code"] == 0


@pytest.mark.slow
def test_every_certificate_of_the_demo_is_proven_again(folder: Path, demo: dict[str, Any]) -> None:
    project = (folder / demo["folder"]).parents[1]
    code, out, err = sitewright("audit", "certificates", project, "--json", cwd=folder)
    audit = json.loads(out)
    assert code == 0, err[-2000:]
    assert audit["is_proven"]
    assert audit["is_scene_compared"]
    assert len(audit["motions"]) == demo["trajectories_total"]
    assert 0.0 < audit["longest_contact_m"] <= 0.035


@pytest.mark.slow
def test_the_run_folder_has_what_the_demo_says(folder: Path, demo: dict[str, Any]) -> None:
    run = folder / demo["folder"]
    report = json.loads((run / "report.json").read_text(encoding="utf-8"))
    same = set(report) - {"schema"}
    assert {k: report[k] for k in same} == {k: demo[k] for k in same}
    as_built = json.loads((run / "as_built.json").read_text(encoding="utf-8"))
    built = [c["id"] for c in as_built["components"] if c["layer"] == "as_built"]
    assert sorted(built) == ["stud-1", "stud-2", "stud-3", "support-1", "support-2"]
    sitewright("export", run.parents[1], "--json-model", "-o", folder / "out.json", cwd=folder)
    assert json.loads((folder / "out.json").read_text(encoding="utf-8")) == as_built
    design = json.loads((run.parents[1] / "building.json").read_text(encoding="utf-8"))
    assert not [c for c in design["components"] if c["layer"] == "as_built"]
    for target in built:
        suffixes = {p.suffix for p in (run / "pddl").glob(f"{target}-*")}
        assert {".domain", ".problem", ".plan"} <= suffixes
    page = (run / "report.html").read_text(encoding="utf-8")
    assert page.count("<svg") == 3
    assert "5/5" in page


@pytest.mark.slow
def test_what_was_built_can_be_looked_at(folder: Path, demo: dict[str, Any]) -> None:
    project = folder / "sitewright-demo"
    _, out, _ = sitewright("graph", project, cwd=folder)
    assert "[x] stud-3 (transverse-stud, also on support-2, made of thin." in out
    code = demo["plans"][-1]["code"]
    _, out, _ = sitewright("show", project, code, "--json", cwd=folder)
    shown = json.loads(out)
    assert (shown["code"], shown["target"]) == (code, demo["plans"][-1]["target"])
    assert len(shown["steps"]) == demo["plans"][-1]["steps"]
    status, out, _ = sitewright("run", project, "--approve", "auto", "--json", cwd=folder)
    again = json.loads(out)
    assert (status, again["run"]) == (0, demo["run"])
    assert "nothing to do" in again["message"]
    before = (folder / demo["folder"] / "report.json").read_bytes()
    sitewright("report", project, cwd=folder)
    assert (folder / demo["folder"] / "report.json").read_bytes() == before


@pytest.mark.slow
def test_every_step_of_a_plan_says_why_it_is_there(folder: Path, demo: dict[str, Any]) -> None:
    project = open_project(folder / "sitewright-demo")
    labels = labels_of(project.model, project.cell)
    for plan in (p for p in demo["plans"] if p["target"] in {"support-2", "stud-1"}):
        for number in range(1, plan["steps"] + 1):
            reasons = explain_step(project, number, code=plan["code"])
            assert reasons.status == "done"
            assert reasons.needed_by or reasons.lasting
            assert {x.fact for x in reasons.made_possible_by} == set(reasons.step.relies_on)
            text = "\n".join(explanation(reasons, labels))
            assert "{" not in text
            if reasons.act.skill == Skill.FASTEN:
                assert reasons.stance is not None
                assert 0.0 <= (reasons.stance.lean_rad or 0.0) <= math.radians(10.01)
            if reasons.step.call.skill == Skill.GRASP:
                nearest = next(p for p in reasons.pieces if not p.under)
                assert nearest.piece == reasons.piece
                assert reasons.stance is not None
                assert reasons.stance.from_above_rad == pytest.approx(0.0, abs=math.radians(46))


@pytest.mark.slow
def test_a_step_explains_itself_at_the_command_line(folder: Path, demo: dict[str, Any]) -> None:
    words = ("explain", "step", "3", "sitewright-demo", "--target", "stud-1")
    code, out, _ = sitewright(*words, cwd=folder)
    assert code == 0
    assert "Why thin 5\n  the only one that could be taken" in out
    assert "under others: thin 4, thin 3" in out or "under others: thin 1" in out
    _, out, _ = sitewright(*words, "--json", cwd=folder)
    told = json.loads(out)
    assert (told["schema"], told["topic"]) == ("sitewright.explain/1", "step")
    assert told["target"] == "stud-1"
    assert told["code"] in {p["code"] for p in demo["plans"]}
    code, _, err = sitewright("explain", "step", "77", "sitewright-demo", cwd=folder)
    assert (code, "there is no step 77" in err) == (7, True)
    code, _, err = sitewright(*words[:-1], "stud-9", cwd=folder)
    assert (code, "no proposal for 'stud-9'" in err) == (7, True)


@pytest.mark.slow
def test_step_mode_runs_what_was_typed_and_then_holds(folder: Path) -> None:
    sitewright("new", "stepwise", cwd=folder)
    status, out, err = sitewright(
        "run", "stepwise", "--approve", "step", "--json", cwd=folder, typed="a\na\nr\n5\nlunch\n"
    )
    found = json.loads(out)
    assert status == 7, err[-2000:]
    assert found["skills_executed"] == 2
    assert [d["what"] for d in found["decisions"]] == ["approved", "approved", "rejected"]
    assert found["decisions"][-1]["detail"] == "later: lunch"
    assert "[o]ther action" in err
