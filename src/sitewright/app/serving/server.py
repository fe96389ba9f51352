"""`sitewright serve`: one port on this machine, the twin behind it, and the link to open it."""

from __future__ import annotations

import asyncio
import contextlib
import signal
import socket
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import FrameType

import uvicorn
from starlette.types import ASGIApp
from typing_extensions import override

from sitewright.app.clock import SystemClock
from sitewright.app.execution import state_home
from sitewright.app.run_folder import installation_key
from sitewright.app.serving.door import Door, opened
from sitewright.app.serving.project_twin import ProjectTwin
from sitewright.app.serving.reached import Tls, listening, place_of
from sitewright.app.serving.run_process import RunLink, RunProcess
from sitewright.app.serving.users import read_users
from sitewright.interaction_twin.web.hub import Hub
from sitewright.interaction_twin.web.pins import Pins
from sitewright.interaction_twin.web.sessions import Sessions
from sitewright.interaction_twin.web.site import application

RUNS = "runs"
_MOST_FRAME_BYTES = 256_000
_MOST_CONNECTIONS = 256
_PAGES_LEAVE_S = 10


@dataclass(frozen=True, slots=True, kw_only=True)
class ServeOptions:
    """What is served, and how.

    Attributes:
        port: 0 takes a free one.
        speed: Of the simulated cell; 1 is real time, 0 as fast as it can.
        from_design: Begin on an empty site.
        users: File with the users who have tokens of their own; None is the one local user.
        host: Address under which other machines reach it; None is this machine alone.
        tls: Certificate and key; None serves without TLS.
    """

    folder: Path
    cell: Path | None = None
    port: int = 8765
    speed: float = 1.0
    from_design: bool = False
    users: Path | None = None
    host: str | None = None
    tls: Tls | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Address:
    """Where the page is.

    Attributes:
        url: Of the page; with a token that signs in one time unless users have their own.
    """

    port: int
    url: str


def serve(options: ServeOptions, *, on_ready: Callable[[Address], None]) -> None:
    """Serve a project until interrupted.

    Args:
        options: What and how.
        on_ready: Called once the server listens.

    Raises:
        BackendError: The port is taken.
        SitewrightError: The project or the users file cannot be read.
    """
    arguments = ["--project", str(options.folder), "--speed", str(options.speed)]
    arguments += ["--cell", str(options.cell)] if options.cell is not None else []
    arguments += ["--from-design"] if options.from_design else []
    asyncio.run(PageServer(options, RunProcess(arguments)).run(on_ready))


class PageServer:
    """One server with its twin; runs on the event loop that it is started on."""

    def __init__(self, options: ServeOptions, link: RunLink) -> None:
        """Prepare it.

        Args:
            options: What is served, and how.
            link: The way to the run; a process, or something else in tests.
        """
        self._options, self._link = options, link
        self._server: uvicorn.Server | None = None

    async def run(self, on_ready: Callable[[Address], None]) -> None:
        """Serve until interrupted or stopped."""
        options, clock, hub = self._options, SystemClock(), Hub()
        users = {} if options.users is None else read_users(options.users)
        twin = ProjectTwin(
            options.folder, self._link, hub, clock, cell=options.cell, has_users=bool(users)
        )
        sessions = Sessions(key=installation_key(state_home()), clock=clock, users=users)
        with listening(options.host, options.port) as listener:
            port = int(listener.getsockname()[1])
            place = place_of(options.host, port, is_secure=options.tls is not None)
            pins = Pins(users, clock) if twin.asks_pin else None
            app = application(twin, sessions, hub, place=place, pins=pins)
            key = "" if users else f"#token={sessions.invite()}"
            address = Address(port=port, url=f"{place.origin}/{key}")
            config = _config(app, options.tls)
            self._server = EndingServer(config, lambda: on_ready(address))
            door = Door(
                origin=place.origin,
                token="" if users else sessions.program_token(),
                certificate="" if options.tls is None else str(options.tls.certificate.resolve()),
            )
            with opened(options.folder / RUNS, door):
                await self._serve(twin, listener)

    async def _serve(self, twin: ProjectTwin, listener: socket.socket) -> None:
        assert self._server is not None  # noqa: S101 -- made before
        await twin.start()
        feeding = asyncio.create_task(twin.feed.run())
        try:
            await self._server.serve(sockets=[listener])
        finally:
            feeding.cancel()
            await twin.stop()

    def stop(self) -> None:
        """End the server soon; safe from any thread."""
        if self._server is not None:
            self._server.should_exit = True


def _config(app: ASGIApp, tls: Tls | None) -> uvicorn.Config:
    return uvicorn.Config(
        app,
        ssl_certfile=None if tls is None else tls.certificate,
        ssl_keyfile=None if tls is None else str(tls.key),
        lifespan="off",
        limit_concurrency=_MOST_CONNECTIONS,
        log_level="warning",
        ws="websockets-sansio",
        ws_max_size=_MOST_FRAME_BYTES,
        server_header=False,
        date_header=False,
        timeout_graceful_shutdown=_PAGES_LEAVE_S,
    )


class EndingServer(uvicorn.Server):
    """Tells when it listens; an interrupt ends it in order, and is no error."""

    def __init__(self, config: uvicorn.Config, on_started: Callable[[], None]) -> None:
        super().__init__(config)
        self._on_started = on_started

    @override
    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """Wish to end; who asks twice gets the same orderly end."""
        del sig, frame
        self.should_exit = True

    @override
    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Take signals as the wish to end, and do not raise them again afterwards."""
        if threading.current_thread() is not threading.main_thread():
            yield
            return
        before = {s: signal.signal(s, self.handle_exit) for s in (signal.SIGINT, signal.SIGTERM)}
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    @override
    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Start, then tell."""
        await super().startup(sockets)
        if self.started:
            self._on_started()
