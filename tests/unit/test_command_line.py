"""The command line: one document, exit codes, and words that say what to do next."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner

from sitewright.cli.main import commands, exit_code
from sitewright.errors import (
    ApprovalError,
    BackendError,
    BuildingModelError,
    ExecutionError,
    JournalError,
    SitewrightError,
)

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "wooden_frame"
COMMANDS = {
    "demo",
    "new",
    "import",
    "check",
    "infer",
    "explain",
    "graph",
    "layout",
    "plan",
    "show",
    "run",
    "serve",
    "user",
    "resolve",
    "report",
    "audit",
    "export",
    "doctor",
    "version",
    "approve",
    "reject",
    "hold",
    "resume",
}
HEAVY = {
    "numpy",
    "pydantic",
    "mujoco",
    "coal",
    "rich",
    "apsw",
    "pinocchio",
    "subprocess",
    "asyncio",
    "starlette",
    "uvicorn",
}


def called(*arguments: str | Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    code = exit_code([str(a) for a in arguments])
    out, err = capsys.readouterr()
    return code, out, err


def document(out: str) -> dict[str, Any]:
    found = json.loads(out)
    assert isinstance(found, dict)
    assert found["schema"].startswith("sitewright.")
    return found


@pytest.fixture
def project(tmp_path: Path) -> Path:
    folder = tmp_path / "frame"
    assert exit_code(["new", str(folder)]) == 0
    return folder


def test_the_commands_are_these() -> None:
    assert set(commands.commands) == COMMANDS


def help_pages(command: str, own: str) -> list[str]:
    """Return the help of a command, or of each command in a group of them."""
    group = commands.commands[command]
    if not isinstance(group, click.Group):
        return [own]
    return [CliRunner().invoke(commands, [command, c, "--help"]).output for c in group.commands]


@pytest.mark.parametrize("command", sorted(COMMANDS))
def test_every_command_answers_in_json_and_explains_itself(command: str) -> None:
    result = CliRunner().invoke(commands, [command, "--help"])
    assert result.exit_code == 0
    assert all("--json" in page for page in help_pages(command, result.output))
    text = commands.commands[command].help
    assert text
    assert text.strip()[0].isupper()


@pytest.mark.parametrize("command", sorted(COMMANDS))
def test_every_command_is_documented(command: str) -> None:
    assert f"`{command}" in (ROOT / "docs" / "cli.md").read_text(encoding="utf-8")


def test_help_loads_nothing_heavy() -> None:
    script = (
        "import json, sys\n"
        "from sitewright.cli.main import exit_code\n"
        "code = exit_code(['--help'])\n"
        "print(json.dumps(sorted(sys.modules)), file=sys.stderr)\n"
        "sys.exit(code)"
    )
    run = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0
    assert "Usage: sitewright" in run.stdout
    assert HEAVY & set(json.loads(run.stderr)) == set()


def test_a_new_project_is_sound_and_a_second_one_does_not_overwrite_it(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = (project / "building.json").read_bytes()
    code, out, _ = called("check", project, "--json", capsys=capsys)
    assert (code, document(out)["errors"]) == (0, 0)
    code, out, err = called("new", project, "--json", capsys=capsys)
    assert code == 3
    assert document(out)["exit_code"] == 3
    assert "not empty" in err
    assert (project / "building.json").read_bytes() == before


def test_problems_are_listed_all_at_once_and_end_with_three(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    building = project / "building.json"
    text = building.read_text(encoding="utf-8").replace('"support-2"]', '"suport-2"]')
    building.write_text(text, encoding="utf-8")
    code, out, _ = called("check", project, "--json", capsys=capsys)
    found = document(out)
    assert code == 3
    assert found["errors"] >= 3, "three studs rest on what does not exist"
    for problem in found["problems"]:
        assert problem["where"]
        assert problem["fix"]
    code, out, err = called("plan", project, "--json", capsys=capsys)
    assert code == 3
    assert document(out)["schema"] == "sitewright.error/1"
    assert len(document(out)["problems"]) >= 3
    assert err.count("suport-2") == 2, "once for three parents, once for six operations"
    assert " 3 times: " in err
    assert " 6 times: " in err


def test_wrong_usage_is_two_and_still_one_document(capsys: pytest.CaptureFixture[str]) -> None:
    for arguments in (
        ["nonsense", "--json"],
        ["import", "x.json", "--json"],
        ["run", "--json", "-x"],
    ):
        code, out, err = called(*arguments, capsys=capsys)
        assert code == 2
        assert document(out)["exit_code"] == 2
        assert "Usage:" in err


def test_without_json_a_failure_leaves_stdout_empty(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = called("check", "/nowhere", capsys=capsys)
    assert (code, out) == (3, "")
    assert "sitewright new" in err, "it says what to do next"


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (BuildingModelError("x"), 3),
        (ApprovalError("x"), 7),
        (ExecutionError("x"), 8),
        (JournalError("x"), 8),
        (BackendError("x"), 10),
        (SitewrightError("x"), 1),
        (KeyboardInterrupt(), 130),
        (ZeroDivisionError("x"), 1),
    ],
)
def test_errors_have_their_exit_codes(
    error: BaseException,
    code: int,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def fails() -> None:
        raise error

    monkeypatch.setattr("sitewright.app.doctor.diagnose", fails)
    got, out, err = called("doctor", "--json", capsys=capsys)
    assert got == code
    assert document(out)["exit_code"] == code
    assert "Traceback" not in err


def test_debug_shows_where_a_bug_is(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails() -> None:
        raise ZeroDivisionError("planted")

    monkeypatch.setattr("sitewright.app.doctor.diagnose", fails)
    _, _, err = called("doctor", "--debug", capsys=capsys)
    assert "Traceback" in err
    assert "planted" in err


def test_the_graph_has_a_queue_a_text_and_a_picture(
    project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, _ = called("graph", project, "--json", capsys=capsys)
    found = document(out)
    assert code == 0
    assert found["queue"] == ["support-1", "support-2", "stud-1", "stud-2", "stud-3"]
    layers = {n["id"]: n["layer"] for n in found["nodes"]}
    assert layers["stud-1"] == "target"
    assert layers["thin.5"] == "material"
    picture = tmp_path / "graph.svg"
    code, out, _ = called("graph", project, "--svg", picture, capsys=capsys)
    assert "[ ] stud-1 (transverse-stud, also on support-2)" in out
    assert picture.read_text(encoding="utf-8").startswith("<svg")


def test_without_a_run_there_is_nothing_to_show_report_or_resolve(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert called("show", project, capsys=capsys)[0] == 7
    assert called("report", project, capsys=capsys)[0] == 8
    code, _, err = called("resolve", "0001-x", "3", "done", "--project", project, capsys=capsys)
    assert code == 8
    assert "0001-x" in err


def test_an_unknown_target_is_named_with_what_is_like_it(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _, err = called("plan", project, "--target", "stud-l", capsys=capsys)
    assert code == 3
    assert "Did you mean" in err
    assert "stud-1" in err


def test_doctor_finds_this_machine_fit(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = called("doctor", "--json", capsys=capsys)
    found = document(out)
    failed = [c for c in found["checks"] if c["is_needed"] and not c["is_ok"]]
    assert (code, failed) == (0, [])
    names = {c["name"] for c in found["checks"]}
    assert {"Fast Downward finds a plan", "MuJoCo simulates", "free disk space"} <= names


def test_doctor_says_what_is_missing_and_how_to_get_it(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from importlib.metadata import PackageNotFoundError, version

    def without_apsw(name: str) -> str:
        if name == "apsw":
            raise PackageNotFoundError(name)
        return version(name)

    monkeypatch.setattr("sitewright.app.doctor.version", without_apsw)
    code, out, _ = called("doctor", capsys=capsys)
    assert code == 10
    assert "NO  apsw: not installed" in out
    assert "pip install 'apsw" in out


def test_a_reader_that_goes_away_is_no_trouble() -> None:
    program = Path(sys.executable).with_name("sitewright")
    run = subprocess.Popen(
        [program, "version", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert run.stdout is not None
    run.stdout.close()
    _, err = run.communicate(timeout=30)
    assert "Traceback" not in err
    assert "Exception" not in err
