"""Decisions by the command line go through the page's server, and say what they decided."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from builders_serving import Served, wait_for, waiting
from sitewright.app.serving.door import NAME, Door
from sitewright.app.serving.history import history_of
from sitewright.central_controller.events import ApprovalGiven, ApprovalRejected
from sitewright.cli.main import exit_code


@pytest.fixture
def served(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Served]:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    with Served(tmp_path / "project") as running:
        yield running


class Terminal:
    """The command line in the folder of nobody in particular."""

    def __init__(self, served: Served, capsys: pytest.CaptureFixture[str]) -> None:
        self.project, self.capsys = str(served.folder), capsys

    def __call__(self, *words: str) -> tuple[int, str, str]:
        """Give a command; return its exit code and what it said."""
        self.capsys.readouterr()
        code = exit_code([*words, "--project", self.project])
        said = self.capsys.readouterr()
        return code, said.out, said.err

    def json(self, *words: str) -> tuple[int, dict[str, Any]]:
        code, out, _ = self(*words, "--json")
        return code, json.loads(out)


def events(served: Served, kind: type[Any]) -> list[Any]:
    found = [r.stamped.event for r in history_of(served.folder / "runs")]
    return [e for e in found if isinstance(e, kind)]


def test_a_plan_is_approved_by_its_code_bound_to_its_fingerprint(
    served: Served, capsys: pytest.CaptureFixture[str]
) -> None:
    page, terminal = served.local(), Terminal(served, capsys)
    plan = waiting(page)
    code, out, _ = terminal("approve", plan["code"].lower(), "--step")
    assert code == 0
    assert out.splitlines()[0] == f"Approved by local: {plan['code']}"
    first = plan["steps"][0]
    assert f"  1. {first['robot_name']} {first['words']}" in out
    assert "  2. " not in out
    assert plan["fingerprint"] in out
    wait_for(page, lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == 2)
    code, told = terminal.json("approve", plan["code"], "--until", "3")
    assert (code, told["schema"], told["verb"]) == (0, "sitewright.decision/1", "approve")
    assert told["scope"] == {"kind": "until", "step": 3}
    wait_for(page, lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == 4)
    assert terminal("approve", plan["code"])[0] == 0
    given = events(served, ApprovalGiven)
    wait_for(page, lambda s: s["progress"]["installed"] == 1)
    assert {g.approval.fingerprint for g in given} == {plan["fingerprint"]}
    assert given[1].decision.shown == tuple(told["lines"])
    assert given[0].decision.session == "command-line"


def test_what_is_not_the_open_plan_is_not_approved(
    served: Served, capsys: pytest.CaptureFixture[str]
) -> None:
    page, terminal = served.local(), Terminal(served, capsys)
    plan = waiting(page)
    code, told = terminal.json("approve", "0000-0000")
    assert (code, told["error"]) == (7, "ApprovalError")
    assert f"The plan that is open is {plan['code']}, not 0000-0000" in told["message"]
    assert terminal("approve", plan["code"], "--step", "--until", "2")[0] == 2
    code, _, said = terminal("approve", plan["code"], "--until", "99")
    assert (code, "there is no step 99" in said) == (7, True)
    why = ("--reason", "later", "--detail", "the crane is here")
    assert terminal("reject", plan["code"], *why)[0] == 0
    waiting(page, other_than=plan["fingerprint"])
    code, _, said = terminal("approve", plan["code"])
    assert (code, "Look at it first" in said) == (7, True)
    assert events(served, ApprovalGiven) == []
    (rejected,) = events(served, ApprovalRejected)
    assert rejected.rejection.fingerprint == plan["fingerprint"]


def test_a_run_is_held_and_goes_on(served: Served, capsys: pytest.CaptureFixture[str]) -> None:
    page, terminal = served.local(), Terminal(served, capsys)
    plan = waiting(page)
    code, out, _ = terminal("hold", "--reason", "somebody is inside")
    assert (code, "the stop is on the cell" in out) == (0, True)
    held = wait_for(page, lambda s: s["phase"] == "held")
    assert held["held"]["reason"] == "local holds the run: somebody is inside"
    code, told = terminal.json("hold")
    assert (code, told["message"]) == (7, "The run stands already.")
    assert terminal("approve", plan["code"])[0] == 7
    assert terminal("resume")[0] == 0
    waiting(page)
    assert terminal("resume")[0] == 7  # it is under way already


def test_without_a_server_nothing_is_decided(
    served: Served, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    terminal = Terminal(served, capsys)
    terminal.project = str(tmp_path / "elsewhere")
    code, told = terminal.json("approve", "0000-0000")
    assert (code, told["error"]) == (10, "BackendError")
    assert "No server serves" in told["message"]
    (tmp_path / "elsewhere" / "runs").mkdir(parents=True)
    left = Door(origin="http://127.0.0.1:9", token="nobody listens there")  # noqa: S106
    file = tmp_path / "elsewhere" / "runs" / NAME
    file.write_text(json.dumps({"origin": left.origin, "token": left.token, "certificate": ""}))
    assert terminal("resume")[0] == 10  # a killed server leaves its door behind
    file.write_text("{")
    assert "cannot be read" in terminal("resume")[2]
