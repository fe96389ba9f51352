"""The page as a user starts it: server, run and simulated cell, each in its own process."""

from __future__ import annotations

import contextlib
import json
import signal
import struct
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

import httpx
import psutil
import pytest
from websockets.sync.client import connect

from builders_serving import approval, wait_for, waiting
from sitewright.app.project import new_project
from sitewright.app.serving.history import history_of
from sitewright.central_controller.events import AnyEvent, RunHeld, SkillIntent

PROGRAM = Path(sys.executable).with_name("sitewright")
PATIENCE_S = 60.0
OPTIONS = ("--port", "0", "--no-browser", "--json")


@dataclass
class Started:
    """A server that was started as a user starts it."""

    project: Path
    speed: float
    process: subprocess.Popen[str] = field(init=False)
    page: httpx.Client = field(init=False)

    def __enter__(self) -> Self:
        self.process = subprocess.Popen(
            [PROGRAM, "serve", self.project, *OPTIONS, "--speed", str(self.speed)],
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        assert self.process.stdout is not None
        text = ""
        while not text.endswith("}\n"):
            text += self.process.stdout.readline()
        told = json.loads(text)
        origin, token = told["url"].split("/#token=")
        self.page = httpx.Client(base_url=origin, headers={"origin": origin}, timeout=PATIENCE_S)
        assert self.page.post("/api/session", json={"token": token}).status_code == 200
        return self

    def __exit__(self, *_: object) -> None:
        self.page.close()
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        self.process.wait(PATIENCE_S)
        assert self.process.stdout is not None
        self.process.stdout.close()

    def interrupt_twice(self) -> bool:
        """Press Ctrl-C twice, as people do, while a page is connected."""
        for _ in range(2):
            self.process.send_signal(signal.SIGINT)
        return True

    def hear(self, after: object, is_enough: Callable[[list[Any]], bool]) -> list[Any]:
        """Listen until it is enough: texts as documents, frames as they come."""
        found: list[Any] = []
        url = str(self.page.base_url).replace("http", "ws", 1).rstrip("/")
        with connect(
            f"{url}/ws",
            additional_headers={"origin": url.replace("ws", "http", 1)},
            open_timeout=PATIENCE_S,
        ) as link:
            ticket = self.page.post("/api/ws-ticket", json={}).json()["ticket"]
            link.send(json.dumps({"ticket": ticket, "after": after}))
            while not is_enough(found):
                message = link.recv(PATIENCE_S)
                found.append(json.loads(message) if isinstance(message, str) else message)
        return found


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    folder = new_project(tmp_path / "frame")
    yield folder
    for process in psutil.process_iter(["cmdline"]):
        if any(str(folder) in word for word in process.info["cmdline"] or ()):
            with contextlib.suppress(psutil.NoSuchProcess):
                process.terminate()  # the simulated cell outlives its controller


def kinds(messages: list[Any]) -> list[str]:
    return [m["kind"] for m in messages if isinstance(m, dict) and m["type"] == "event"]


def events(messages: list[Any]) -> list[tuple[str, int]]:
    found = [m for m in messages if isinstance(m, dict) and m["type"] == "event"]
    return [(m["run"], m["n"]) for m in found]


def written(project: Path) -> list[AnyEvent]:
    return [r.stamped.event for r in history_of(project / "runs")]


def run_processes(project: Path) -> list[psutil.Process]:
    found = []
    for process in psutil.process_iter(["cmdline"]):
        words = process.info["cmdline"] or ()
        if "sitewright.app.serving.process" in words and str(project) in words:
            found.append(process)
    return found


@pytest.mark.slow
def test_a_killed_server_holds_the_robots_and_the_next_one_goes_on(
    project: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    with Started(project, speed=1.0) as server:
        proposal = waiting(server.page)
        scene = server.page.get("/api/scene").json()
        answer = server.page.post("/api/decisions", json=approval(proposal))
        assert answer.status_code == 200
        heard = server.hear({"run": "", "n": 0}, _moves)
        frames = [m for m in heard if isinstance(m, bytes) and m[0] == 1]
        assert len(frames[-1]) == 16 + 4 * len(scene["joints"])
        server.process.kill()
        server.process.wait(PATIENCE_S)
        assert psutil.wait_procs(run_processes(project), PATIENCE_S)[1] == []
    ran = [e for e in written(project) if isinstance(e, SkillIntent)]
    previewed = {m["trajectory_sha256"] for s in proposal["steps"] for m in s["motions"]}
    assert {t for e in ran for t in e.trajectories} < previewed
    last = written(project)[-1]
    assert isinstance(last, RunHeld)
    assert last.who == "the page's server"

    with Started(project, speed=0.0) as server:
        assert server.page.get("/api/state").json()["phase"] == "held"  # nothing moves by itself
        run, number = events(heard)[-1]
        missed = server.hear({"run": run, "n": number}, lambda m: _is_caught_up(m[-1:]))
        numbers = [(r.run, r.stamped.number) for r in history_of(project / "runs")]
        assert events(heard) + events(missed) == numbers
        assert kinds(missed)[-1] == "run_held"
        _resume_and_build(server.page, proposal["fingerprint"])
        _kill_the_run_and_resume(server.page)
        server.hear(None, lambda m: _is_caught_up(m[:1]) and server.interrupt_twice())
        assert server.process.wait(PATIENCE_S) == 0
    said = capfd.readouterr().err.strip()
    assert said == "The server has ended and nothing moves; `sitewright serve` goes on."


def _resume_and_build(page: httpx.Client, old: str) -> None:
    go = {"verb": "resume", "key": "resume-after-kill"}
    assert page.post("/api/decisions", json=go).status_code == 200
    new = waiting(page, other_than=old)
    assert page.post("/api/decisions", json=approval(new)).status_code == 200
    waiting(page, other_than=new["fingerprint"])
    assert page.get("/api/state").json()["progress"]["installed"] == 1
    why = page.get(f"/api/proposals/{new['fingerprint']}/steps/1/why").json()
    assert why["lines"][0].startswith("Step 1 of")
    assert page.get("/api/schedule").json()["actual"]


def _kill_the_run_and_resume(page: httpx.Client) -> None:
    health = page.get("/api/health").json()
    assert health["journal"]["is_whole"]
    psutil.Process(health["run"]["pid"]).kill()
    state = wait_for(page, lambda s: s["phase"] == "broken")
    assert state["words"] == "The process of the run is not there."
    lost = page.post("/api/decisions", json=approval({**state["open"], "steps": []}))
    assert (lost.status_code, lost.json()["error"]) == (503, "run")
    go = {"verb": "resume", "key": "resume-after-loss"}
    assert page.post("/api/decisions", json=go).status_code == 200
    waiting(page)


def _is_caught_up(messages: list[Any]) -> bool:
    return bool(messages) and isinstance(messages[0], dict) and messages[0]["type"] == "caught-up"


def _moves(messages: list[Any]) -> bool:
    """Tell whether two joint frames differ: a robot is on its way."""
    frames = [m[16:] for m in messages if isinstance(m, bytes) and m[0] == 1]
    joints = [struct.unpack(f"<{len(f) // 4}f", f) for f in frames]
    return len(joints) > 1 and any(
        abs(a - b) > 0.01 for a, b in zip(joints[0], joints[-1], strict=True)
    )
