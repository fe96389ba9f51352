"""A page server in this process: the real one, with a run of the small planner behind a pipe."""

from __future__ import annotations

import asyncio
import os
import secrets
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Self

import httpx
import pytest

from builders_run import Site
from builders_wire import assert_answer_fits
from sitewright.app.project import new_project, read_project
from sitewright.app.run import RunResult, run_project
from sitewright.app.serving.channel import Channel
from sitewright.app.serving.history import history_of
from sitewright.app.serving.memory import Memory
from sitewright.app.serving.policy_file import policy_of
from sitewright.app.serving.project_run import begins_itself, begun, state_after, types_of
from sitewright.app.serving.run_process import Hear, PipeLink
from sitewright.app.serving.server import Address, PageServer, ServeOptions
from sitewright.app.serving.worker import Hooks, Worker
from sitewright.central_controller.site_state import site_of
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.decisions import Reply

WAIT_S = 60.0


class ThreadLink:
    """The worker of a small site in a thread, behind real pipes."""

    def __init__(self, site: Site) -> None:
        self.site = site
        self._link = PipeLink()
        self._thread: threading.Thread | None = None
        self._reading: asyncio.ReadTransport | None = None

    @property
    def process_id(self) -> int | None:
        alive = self._thread is not None and self._thread.is_alive()
        return os.getpid() if alive else None

    async def start(self, hear: Hear, *, waits: bool = False) -> None:
        assert not waits  # a thread cannot die by itself
        to_worker, to_server = os.pipe(), os.pipe()
        channel = Channel(os.fdopen(to_worker[0], "rb"), os.fdopen(to_server[1], "wb"))
        self._thread = threading.Thread(target=self._work, args=(channel,), daemon=True)
        self._thread.start()
        loop = asyncio.get_running_loop()
        reader = asyncio.StreamReader(limit=4_000_000)
        self._reading, _ = await loop.connect_read_pipe(
            lambda: asyncio.StreamReaderProtocol(reader), os.fdopen(to_server[0], "rb")
        )
        transport, protocol = await loop.connect_write_pipe(
            lambda: asyncio.StreamReaderProtocol(asyncio.StreamReader()),
            os.fdopen(to_worker[1], "wb"),
        )
        writer = asyncio.StreamWriter(transport, protocol, reader, loop)
        await self._link.listen_to(reader, writer, hear)

    async def ask(self, what: str, content: Mapping[str, Json]) -> Reply:
        return await self._link.ask(what, content)

    async def stop(self) -> None:
        await self._link.hang_up()
        if self._thread is not None:
            await asyncio.to_thread(self._thread.join, WAIT_S)
        if self._reading is not None:
            self._reading.close()
            await asyncio.sleep(0)  # the loop lets go of the pipe in its next round

    def _work(self, channel: Channel) -> None:
        runs, memory = self.site.folder / "runs", Memory()
        project = read_project(self.site.folder)
        history = history_of(runs)
        for record in history:
            memory.note(record.run, record.stamped)
        Worker(
            channel=channel,
            memory=memory,
            run_once=self._run_once,
            begins_itself=begins_itself(history, self.site.site),
            policy=policy_of(project.settings),
            types=types_of(project.model),
            at_rest=lambda: state_after(history_of(runs), self.site.site),
        ).serve()
        channel.close()

    def _run_once(self, hooks: Hooks) -> RunResult:
        ports = replace(
            self.site.ports(),
            approver=hooks.desk,
            on_record=hooks.on_record,
            hold_asked=hooks.desk.hold_asked,
        )
        options = replace(self.site.options(), **begun(hooks.begun_by))
        return run_project(ports, options)


@dataclass
class Served:
    """A server that runs in a thread, and those who talk to it."""

    folder: Path
    users: Path | None = None
    site: Site = field(init=False)
    address: Address = field(init=False)
    _server: PageServer = field(init=False)
    _thread: threading.Thread = field(init=False)
    _clients: ExitStack = field(default_factory=ExitStack)

    def __post_init__(self) -> None:
        if not (self.folder / "building.json").exists():
            new_project(self.folder)
        design = site_of(read_project(self.folder).model)
        self.site = Site(self.folder, site=design)

    def __enter__(self) -> Self:
        options = ServeOptions(folder=self.folder, port=0, users=self.users)
        self._server = PageServer(options, ThreadLink(self.site))
        ready = threading.Event()

        def on_ready(address: Address) -> None:
            self.address = address
            ready.set()

        self._thread = threading.Thread(
            target=lambda: asyncio.run(self._server.run(on_ready)), daemon=True
        )
        self._thread.start()
        assert ready.wait(WAIT_S)
        return self

    def __exit__(self, *_: object) -> None:
        self._clients.close()
        self._server.stop()
        self._thread.join(WAIT_S)
        assert not self._thread.is_alive()

    @property
    def origin(self) -> str:
        return f"http://127.0.0.1:{self.address.port}"

    @property
    def token(self) -> str:
        return self.address.url.split("#token=")[1]

    def guest(self, **headers: str) -> httpx.Client:
        """Return a client that nobody knows; it has the page's Origin unless told otherwise.

        Every answer that it gets is held against the types of the wire.
        """
        own = {"origin": self.origin, **headers}
        headers = {k: v for k, v in own.items() if v}
        return self._clients.enter_context(
            httpx.Client(
                base_url=self.origin,
                headers=headers,
                timeout=WAIT_S,
                event_hooks={"response": [assert_answer_fits]},
            )
        )

    def local(self) -> httpx.Client:
        """Return the local user's client; works once per server."""
        client = self.guest()
        assert client.post("/api/session", json={"token": self.token}).status_code == 200
        return client

    def user(self, name: str, token: str) -> httpx.Client:
        client = self.guest()
        answer = client.post("/api/session", json={"user": name, "token": token})
        assert answer.status_code == 200
        return client


@contextmanager
def served_in(folder: Path, *, users: Path | None = None) -> Iterator[Served]:
    """Serve a new project of a folder, with a home of its own for what the installation keeps."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(folder / "state"))
        with Served(folder / "project", users=users) as running:
            yield running


def wait_for(client: httpx.Client, is_so: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """Ask for the state until it is as wanted."""
    for _ in range(int(WAIT_S / 0.02)):
        state: dict[str, Any] = client.get("/api/state").json()
        if is_so(state):
            return state
        threading.Event().wait(0.02)
    raise AssertionError(state)


def waiting(client: httpx.Client, *, other_than: str = "") -> dict[str, Any]:
    """Return the proposal that waits for a decision."""
    wait_for(
        client,
        lambda s: s["phase"] == "waiting" and s["open"]["fingerprint"] != other_than,
    )
    found: dict[str, Any] = client.get("/api/proposals/open").json()
    return found


def approval(proposal: Mapping[str, Any], **changes: Any) -> dict[str, Any]:
    """Return the body by which a page approves what it shows."""
    return {
        "verb": "approve",
        "fingerprint": proposal["fingerprint"],
        "next_step": proposal["next_step"],
        "scope": {"kind": "plan"},
        "key": secrets.token_hex(16),
        "shown": [s["words"] for s in proposal["steps"]],
        **changes,
    }
