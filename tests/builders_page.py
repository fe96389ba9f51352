"""A real server of a real project, and a real browser that looks at it."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

import pytest
from playwright.sync_api import Browser, Page, Route, expect, sync_playwright
from playwright.sync_api import TimeoutError as TooLate

from builders_wire import assert_body_fits
from sitewright.app.project import new_project
from sitewright.robot_team.drivers.mujoco.places import PID_NAME

CHROMIUM = shutil.which("chromium")
WAIT_MS = int(os.environ.get("SITEWRIGHT_PAGE_WAIT_MS", "60000"))
expect.set_options(timeout=WAIT_MS)
READY = "() => Boolean(window.__m?.marks.first && window.__m.marks.ui)"
SIZES = {390: 844, 820: 1180, 1280: 800}
_MAIN = "from sitewright.cli.main import main; main()"
_SOFTWARE_GL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
_ROW = 40
_PATIENCE, _SENT_MS = 5, 4_000
_NOISE = "GPU stall due to ReadPixels"


@dataclass
class ServedProject:
    """`sitewright serve` of the wooden frame as a process of its own, in a cell that hurries."""

    folder: Path
    speed: float = 0.0
    users: Path | None = None
    url: str = ""
    _process: subprocess.Popen[str] | None = None
    _drain: threading.Thread = field(default_factory=threading.Thread)

    def __enter__(self) -> Self:
        if not self.folder.exists():
            new_project(self.folder)
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.end(signal.SIGINT)
        for file in self.folder.glob(f"runs/*/cell/{PID_NAME}"):  # it outlives its server
            with contextlib.suppress(OSError, ValueError):
                os.kill(int(json.loads(file.read_text())["pid"]), signal.SIGTERM)

    @property
    def origin(self) -> str:
        return self.url.split("#")[0].rstrip("/")

    def start(self, port: int = 0) -> None:
        """Start the server and read the link that it prints."""
        command = [sys.executable, "-c", _MAIN, "serve", str(self.folder)]
        options = ["--port", str(port), "--no-browser", "--speed", str(self.speed)]
        options += ["--users", str(self.users)] if self.users else []
        state = {"XDG_STATE_HOME": str(self.folder.parent / "state")}
        self._process = subprocess.Popen(
            [*command, *options],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={**os.environ, **state, "PYTHONUNBUFFERED": "1"},
        )
        assert self._process.stdout is not None
        said = []
        for line in self._process.stdout:
            said.append(line)
            if line.startswith("The page: "):
                self.url = line.split()[-1]
                break
        assert self.url, "".join(said)
        self._drain = threading.Thread(target=self._process.stdout.read, daemon=True)
        self._drain.start()

    def end(self, how: signal.Signals) -> None:
        """End the server, gently or not, and wait for it."""
        if self._process is None:
            return
        self._process.send_signal(how)
        self._process.wait(30)
        self._drain.join()
        if self._process.stdout is not None:
            self._process.stdout.close()
        self._process = None

    @property
    def port(self) -> int:
        return int(self.origin.rsplit(":", 1)[1])


@dataclass
class Seen:
    """A page with what went wrong on it.

    Attributes:
        requests: Addresses of all that it asked for.
        complaints: Errors and warnings of its console.
        sent: Bodies of the decisions that it sent.
    """

    page: Page
    served: ServedProject
    requests: list[str] = field(default_factory=list)
    complaints: list[str] = field(default_factory=list)
    sent: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.page.on("request", self._note)
        self.page.on("pageerror", lambda e: self.complaints.append(str(e)))
        self.page.on("console", self._listen)

    def _note(self, request: Any) -> None:
        self.requests.append(request.url)
        if request.url.endswith("/api/decisions"):
            self.sent.append(request.post_data or "")

    def _listen(self, message: Any) -> None:
        if message.type in {"error", "warning"} and _NOISE not in message.text:
            self.complaints.append(message.text)

    def open(self, *, dots: float = 1.0) -> None:
        """Load the page by its link and wait until it is there; fewer dots are drawn sooner."""
        token = self.served.url.partition("#")[2]
        self.page.goto(f"{self.served.origin}/?dpr={dots}#{token}")
        self.page.wait_for_function(READY, timeout=WAIT_MS)
        self.page.wait_for_selector("[data-link=live]", timeout=WAIT_MS)

    def sign_in(self, user: str, token: str, *, dots: float = 0.5) -> None:
        """Load the page as a person with a token of his own."""
        body = {"user": user, "token": token}
        assert self.post("/api/session", body)[0] == 200
        self.page.goto(f"{self.served.origin}/?dpr={dots}")
        self.page.wait_for_function(READY, timeout=WAIT_MS)
        self.page.wait_for_selector("[data-link=live]", timeout=WAIT_MS)

    def json(self, path: str) -> dict[str, Any]:
        """Ask the server as this page would."""
        reply = self.page.request.get(self.served.origin + path)
        answer: dict[str, Any] = reply.json()
        assert_body_fits("GET", path, answer, is_success=reply.ok)
        return answer

    def report(self, run: str) -> bytes:
        """Return the report of a run; it is written soon after the run has ended."""
        for _ in range(WAIT_MS // 50):
            reply = self.page.request.get(f"{self.served.origin}/api/runs/{run}/report")
            if reply.ok:
                return reply.body()
            self.page.wait_for_timeout(50)
        raise AssertionError(reply.text())

    def post(self, path: str, body: Mapping[str, Any]) -> tuple[int, dict[str, Any]]:
        """Send something as this page would."""
        headers = {"origin": self.served.origin, "content-type": "application/json"}
        reply = self.page.request.post(self.served.origin + path, data=body, headers=headers)
        return reply.status, reply.json()

    def waiting(self, *, other_than: str = "") -> dict[str, Any]:
        """Return the proposal that waits for a decision, once the page shows it."""
        self.page.wait_for_function(
            "other => { const b = document.querySelector('.approve.main');"
            " return b !== null && b.dataset.fingerprint !== other }",
            arg=other_than,
            timeout=WAIT_MS,
        )
        return self.json("/api/proposals/open")

    def armed(self) -> None:
        """Wait until Approve may be pressed."""
        self.page.wait_for_selector('.approve.main[aria-disabled="false"]', timeout=WAIT_MS)

    def press(self, selector: str, *, times: int = 1) -> None:
        """Press a button of approval; again if a busy machine had just taken it away."""
        for _ in range(_PATIENCE):
            self.armed()
            try:
                with self.page.expect_request("**/api/decisions", timeout=_SENT_MS):
                    self.page.click(selector, click_count=times)
            except TooLate:
                continue
            return
        raise AssertionError(f"pressing {selector} sends nothing")

    def until(self, is_so: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        """Ask for the state until it is as wanted."""
        for _ in range(WAIT_MS // 50):
            state = self.json("/api/state")
            if is_so(state):
                return state
            self.page.wait_for_timeout(50)
        raise AssertionError(state)


def filled_up(count: int) -> Callable[[Route], None]:
    """Return a route handler that fills the scene up with pieces of its own shapes."""

    def fill(route: Route) -> None:
        scene = route.fetch().json()
        own = [c for c in scene["components"] if c["geometry"] is not None]
        for number in range(len(scene["components"]), count):
            copy = dict(own[number % len(own)])
            place = [(number % _ROW) * 0.2 - 4.0, (number // _ROW) * 0.2 - 3.0, 0.5]
            copy |= {"id": f"copy-{number}", "world_T": {**copy["world_T"], "p_m": place}}
            scene["components"].append(copy)
        scene["hash"] += f"-{count}"
        route.fulfill(body=json.dumps(scene), content_type="application/json")

    return fill


@contextmanager
def browser() -> Iterator[Browser]:
    """Start a real Chromium, or skip by name."""
    if CHROMIUM is None:
        pytest.skip("needs Chromium: apt-get install chromium fonts-dejavu-core")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=CHROMIUM, args=list(_SOFTWARE_GL))
        yield chromium
        chromium.close()


def look(
    chromium: Browser, served: ServedProject, *, width: int = 1280, has_touch: bool = False
) -> Seen:
    """Return a page in a context of its own: another person at another screen."""
    context = chromium.new_context(
        viewport={"width": width, "height": SIZES[width]},
        reduced_motion="reduce",
        locale="en-GB",
        has_touch=has_touch,
    )
    context.set_default_timeout(WAIT_MS)
    return Seen(context.new_page(), served)
