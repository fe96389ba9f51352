"""How quickly an approval is acknowledged, and what 20 pages at 30 frames a second cost.

    python benchmarks/bench_serving.py [--clients 20] [--seconds 10]

The real server, run process and simulated cell build the wooden frame. First each step is approved
by itself, and the time from the press to the answer is taken: the answer comes when the approval
is on the disk. Then moving robots are held, and the time until the cell was told is taken. At last
pages listen while robots move in real time, and the share of a core that the server takes is
measured.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import json
import secrets
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from statistics import median, quantiles
from typing import Any

import httpx
import psutil
from websockets.asyncio.client import connect

from sitewright.app.project import new_project

PROGRAM = Path(sys.executable).with_name("sitewright")
MOST_STEPS = 40
HOLDS = 10
AT_REST_S = 0.06


@contextlib.contextmanager
def served(project: Path, speed: float) -> Iterator[tuple[httpx.Client, int]]:
    """Serve a project as a user does; yield a signed-in client and the server's process id."""
    options = ["--port", "0", "--no-browser", "--json", "--speed", str(speed)]
    process = subprocess.Popen(
        [PROGRAM, "serve", project, *options], stdout=subprocess.PIPE, text=True
    )
    told = process.stdout
    text = ""
    while told is not None and not text.endswith("}\n"):
        text += told.readline()
    origin, token = json.loads(text)["url"].split("/#token=")
    try:
        with httpx.Client(base_url=origin, headers={"origin": origin}, timeout=60.0) as page:
            page.post("/api/session", json={"token": token}).raise_for_status()
            yield page, process.pid
    finally:
        process.terminate()
        process.wait()


def waiting(page: httpx.Client) -> dict[str, Any] | None:
    """Return the open proposal once one waits; None when the run is over."""
    while True:
        state = page.get("/api/state").json()
        if state["phase"] == "waiting":
            return dict(state["open"])
        if state["phase"] in {"finished", "broken", "needs-help", "held"}:
            return None
        time.sleep(0.01)


def press(page: httpx.Client, made: dict[str, Any], scope: dict[str, Any]) -> float:
    """Approve and return how long the answer took in milliseconds."""
    body = {
        "verb": "approve",
        "fingerprint": made["fingerprint"],
        "next_step": made["next_step"],
        "scope": scope,
        "key": secrets.token_hex(8),
    }
    started = time.perf_counter()
    page.post("/api/decisions", json=body).raise_for_status()
    return (time.perf_counter() - started) * 1000.0


def acknowledgements(project: Path) -> list[float]:
    """Return the time of each approval, step by step."""
    found: list[float] = []
    with served(project, speed=0.0) as (page, _):
        while len(found) < MOST_STEPS and (made := waiting(page)) is not None:
            found.append(press(page, made, {"kind": "step", "step": made["next_step"]}))
    return found


def holds(project: Path, count: int) -> list[float]:
    """Return how long it took, in milliseconds, until the moving cell was told to hold."""
    found: list[float] = []
    with served(project, speed=1.0) as (page, _):
        while len(found) < count and (made := waiting(page)) is not None:
            press(page, made, {"kind": "plan"})
            time.sleep(0.7)
            started = time.perf_counter()
            answer = page.post("/api/hold", json={"key": secrets.token_hex(8)})
            took_ms = (time.perf_counter() - started) * 1000.0
            if answer.is_success and answer.json()["told_cell"]:
                found.append(took_ms)
            while page.get("/api/state").json()["phase"] != "held":
                time.sleep(0.02)
            page.post("/api/decisions", json={"verb": "resume", "key": secrets.token_hex(8)})
            while page.get("/api/state").json()["phase"] == "held":
                time.sleep(0.02)
    return found


@dataclass
class Heard:
    """What one page got: the moments of its frames of joints, and the bytes of all frames."""

    at_s: list[float] = field(default_factory=list)
    size: int = 0

    def moving_per_s(self) -> float:
        """Return the frames a second while joints move: at rest four a second are enough."""
        gaps_s = [b - a for a, b in pairwise(self.at_s) if b - a < AT_REST_S]
        return len(gaps_s) / sum(gaps_s)


async def listen(origin: str, ticket: str, seconds: float) -> Heard:
    """Listen as a page does."""
    heard = Heard()
    url = f"{origin.replace('http', 'ws', 1)}/ws"
    async with connect(url, additional_headers={"origin": origin}) as link:
        await link.send(json.dumps({"ticket": ticket, "after": None}))
        deadline = time.monotonic() + seconds
        while (left := deadline - time.monotonic()) > 0:
            with contextlib.suppress(TimeoutError):
                message = await asyncio.wait_for(link.recv(), left)
                if isinstance(message, bytes):
                    heard.at_s += [time.monotonic()] if message[0] == 1 else []
                    heard.size += len(message)
    return heard


async def crowd(origin: str, tickets: list[str], seconds: float) -> list[Heard]:
    """Let many pages listen at once."""
    return list(await asyncio.gather(*(listen(origin, t, seconds) for t in tickets)))


def frames(project: Path, clients: int, seconds: float) -> dict[str, float]:
    """Return what listening pages got, and the share of a core that the server took for it."""
    with served(project, speed=1.0) as (page, pid):
        made = waiting(page) or {}
        page.get("/api/scene").raise_for_status()
        tickets = [page.post("/api/ws-ticket", json={}).json()["ticket"] for _ in range(clients)]
        press(page, made, {"kind": "plan"})
        server = psutil.Process(pid)
        before, started = server.cpu_times(), time.perf_counter()
        got = asyncio.run(crowd(str(page.base_url).rstrip("/"), tickets, seconds))
        after, took = server.cpu_times(), time.perf_counter() - started
    used = after.user + after.system - before.user - before.system
    return {
        "frames_per_s": sum(len(h.at_s) for h in got) / len(got) / seconds,
        "moving_frames_per_s": sum(h.moving_per_s() for h in got) / len(got),
        "least_moving_frames_per_s": min(h.moving_per_s() for h in got),
        "kB_per_s_and_page": sum(h.size for h in got) / len(got) / seconds / 1000.0,
        "share_of_a_core": used / took,
    }


def end_cells(folder: str) -> None:
    """End the simulated cells of a folder; they outlive their servers."""
    for process in psutil.process_iter(["cmdline"]):
        if any(folder in word for word in process.info["cmdline"] or ()):
            process.terminate()


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--clients", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=10.0)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        times = acknowledgements(new_project(Path(folder) / "steps"))
        cuts = quantiles(times, n=100, method="inclusive")
        print(
            f"approvals: {len(times)}, p50 {cuts[49]:.1f} ms, p99 {cuts[98]:.1f} ms, "
            f"worst {max(times):.1f} ms"
        )
        stops = holds(new_project(Path(folder) / "holds"), HOLDS)
        print(f"holds: {len(stops)}, median {median(stops):.1f} ms, worst {max(stops):.1f} ms")
        for clients in (0, options.clients):
            told = frames(
                new_project(Path(folder) / f"of{clients}"), max(clients, 1), options.seconds
            )
            print(f"{max(clients, 1)} pages: " + ", ".join(f"{k} {v:.3f}" for k, v in told.items()))
        end_cells(folder)


if __name__ == "__main__":
    main()
