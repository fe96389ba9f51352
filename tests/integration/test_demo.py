"""The demonstration as a new user runs it: one command, no terminal, and what one does next."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

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
