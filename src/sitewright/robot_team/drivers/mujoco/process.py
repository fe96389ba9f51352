"""The cell's own process: one socket, one line of JSON per question and answer.

    python -m sitewright.robot_team.drivers.mujoco.process --project-state DIR

It outlives the controller and ends on ``shutdown``, or when no client was there for a while.
Killed at any moment, the next one goes on from the last line of the log: the physics stands as it
stood when that line was written (for a motion under way: at its start), and a command that was
accepted and has no end stays so.
"""

from __future__ import annotations

import argparse
import fcntl
import json
import os
import socketserver
import sys
import time
from pathlib import Path
from threading import Event, Thread

from typing_extensions import override

from sitewright.errors import SitewrightError
from sitewright.robot_team.drivers.mujoco.codec import Plain, setup_from_json
from sitewright.robot_team.drivers.mujoco.places import (
    ALREADY_RUNNING,
    LOCK_NAME,
    PID_NAME,
    SETUP_NAME,
    make_private,
    socket_path,
)
from sitewright.robot_team.drivers.mujoco.service import CellService

_POLL_S = 0.05


class _Server(socketserver.ThreadingUnixStreamServer):
    """Listens on the socket; each client has a thread, the physics has a lock."""

    daemon_threads = True

    def __init__(self, path: Path, service: CellService) -> None:
        self.service = service
        self.clients = 0
        self.last_client_s = time.monotonic()
        self.stop = Event()
        super().__init__(str(path), _Client)


class _Client(socketserver.StreamRequestHandler):
    """One connection: questions come in, answers go out, in order."""

    server: _Server

    @override
    def handle(self) -> None:
        self.server.clients += 1
        try:
            for line in self.rfile:
                answer = self._answer(line)
                self.wfile.write(json.dumps(answer, allow_nan=False).encode() + b"\n")
                self.wfile.flush()
                if self.server.service.is_broken:
                    self.server.stop.set()
        except (BrokenPipeError, ConnectionResetError):
            pass  # the client is gone; what it asked for is in the ledger
        finally:
            self.server.clients -= 1
            self.server.last_client_s = time.monotonic()

    def _answer(self, line: bytes) -> Plain:
        try:
            question = json.loads(line)
            operation = str(question["op"])
            if operation == "shutdown":
                self.server.stop.set()
                return {"value": None}
            return {"value": self.server.service.answer(operation, question.get("data"))}
        except SitewrightError as error:
            return {"error": type(error).__name__, "message": str(error)}
        except (ValueError, KeyError, TypeError) as error:
            return {"error": "BackendError", "message": f"not a question: {error!r}"}


def serve(folder: Path, *, idle_s: float) -> int:
    """Run the cell of a state folder until it is shut down or left alone for `idle_s`."""
    with (folder / LOCK_NAME).open("a") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return ALREADY_RUNNING
        setup = setup_from_json(json.loads((folder / SETUP_NAME).read_bytes()))
        service = CellService(folder, setup)
        path = socket_path(folder)
        make_private(path.parent)
        path.unlink(missing_ok=True)
        pid = {"pid": os.getpid(), "socket": str(path)}
        (folder / PID_NAME).write_text(json.dumps(pid))
        try:
            _listen(path, service, idle_s)
        finally:
            path.unlink(missing_ok=True)
            (folder / PID_NAME).unlink(missing_ok=True)
    return 0


def _listen(path: Path, service: CellService, idle_s: float) -> None:
    old_mask = os.umask(0o177)
    try:
        server = _Server(path, service)
    finally:
        os.umask(old_mask)
    with server:
        Thread(target=server.serve_forever, kwargs={"poll_interval": _POLL_S}, daemon=True).start()
        while not server.stop.wait(_POLL_S):
            alone_s = time.monotonic() - server.last_client_s
            if server.clients == 0 and alone_s > idle_s:
                break
        server.shutdown()


def main(arguments: list[str]) -> int:
    """Read the arguments and serve."""
    parser = argparse.ArgumentParser(description="The simulated cell of a project.")
    parser.add_argument("--project-state", type=Path, required=True, metavar="DIR")
    parser.add_argument("--idle-s", type=float, default=600.0)
    options = parser.parse_args(arguments)
    try:
        return serve(options.project_state, idle_s=options.idle_s)
    except SitewrightError as error:
        print(f"error: {error}", file=sys.stderr)  # noqa: T201 - goes to cell.out
        return error.exit_code


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
