"""The driver of the simulated cell: starts its process, or finds the one that runs."""

from __future__ import annotations

import fcntl
import json
import os
import socket
import subprocess
import sys
import time
from collections.abc import Iterable
from pathlib import Path
from threading import Lock

from sitewright import errors
from sitewright.errors import BackendError, OutcomeUnknownError, SitewrightError
from sitewright.foundation.ids import CommandId
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.driver import (
    CommandState,
    CommandStatus,
    Observation,
    SkillReport,
)
from sitewright.robot_team.drivers.mujoco.cell_log import LOG_NAME
from sitewright.robot_team.drivers.mujoco.codec import (
    Plain,
    Setup,
    command_to_json,
    observation_from_json,
    report_from_json,
    setup_to_json,
)
from sitewright.robot_team.drivers.mujoco.places import (
    ALREADY_RUNNING,
    LOCK_NAME,
    OUTPUT_NAME,
    SETUP_NAME,
    socket_path,
)
from sitewright.robot_team.drivers.mujoco.service import setup_hash
from sitewright.robot_team.piece import Piece
from sitewright.robot_team.skill import SkillCommand

_START_TIMEOUT_S = 60.0
_ANSWER_TIMEOUT_S = 60.0
_POLL_S = 0.02


class MujocoCell:
    """A connection to the simulated cell of one state folder; see `connect`."""

    def __init__(self, folder: Path, *, skill_timeout_s: float) -> None:
        self._folder, self._path = folder, socket_path(folder)
        self._skill_timeout_s = skill_timeout_s
        self._lock = Lock()
        self._socket = _open(self._path, skill_timeout_s)
        self._lines = self._socket.makefile("rb")

    def new_epoch(self) -> int:
        """Raise the epoch, so that late commands of an older controller are refused."""
        return int(self._ask("new_epoch"))

    def observe(self) -> Observation:
        """Return what is sensed now."""
        return observation_from_json(self._ask("observe"))

    def status(self, command_id: CommandId) -> CommandStatus:
        """Ask the ledger about a command."""
        answer = self._ask("status", command_id)
        report = answer["report"]
        return CommandStatus(
            state=CommandState(answer["state"]),
            report=None if report is None else report_from_json(report),
        )

    def execute(self, command: SkillCommand) -> SkillReport:
        """Run a command to its end; a known id returns its outcome and moves nothing."""
        try:
            return report_from_json(self._ask("execute", command_to_json(command)))
        except _ConnectionGoneError as error:
            raise OutcomeUnknownError(
                f"The simulated cell went away during {command.skill} ({command.command_id})."
            ) from error

    def hold(self) -> None:
        """Stop all motion on the path, over a connection of its own."""
        _ask_once(self._path, "hold")

    def extra(self) -> Plain:
        """Return ``contacts`` (nothing allowed them), ``physical_log`` (path), ``sim_time_s``."""
        return self._ask("extra")

    def shutdown(self) -> None:
        """End the cell's process; what it remembers stays on disk."""
        self._ask("shutdown")
        self.close()
        _wait_until_gone(self._folder)

    def close(self) -> None:
        """Let the connection go; the cell lives on."""
        self._lines.close()
        self._socket.close()

    def _ask(self, operation: str, data: Plain = None) -> Plain:
        with self._lock:
            return _exchange(self._socket, self._lines, operation, data)


class _ConnectionGoneError(BackendError):
    """The process on the other side is gone or does not answer."""


def connect(  # noqa: PLR0913 - options of the process
    state_dir: Path,
    cell: Cell,
    pieces: Iterable[Piece],
    *,
    real_time_factor: float = 0.0,
    is_fresh: bool = False,
    idle_s: float = 600.0,
    skill_timeout_s: float = 600.0,
) -> MujocoCell:
    """Return a driver for the simulated cell of a project.

    A process that runs already is found again. One that was started with another cell or other
    pieces is restarted with the present ones; it remembers all that is still there.

    Args:
        state_dir: Folder of the cell's files; created if need be.
        cell: The cell.
        pieces: All pieces of material, also those that are installed by now.
        real_time_factor: 0 = as fast as it can; 1 = for watching.
        is_fresh: Forget everything and begin with all pieces at their first place; the old log is
            kept under another name.
        idle_s: The process ends by itself after so long without a client.
        skill_timeout_s: A command without an answer for so long has an unknown outcome.
    """
    folder = Path(state_dir).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    setup = Setup(cell=cell, pieces=tuple(pieces), real_time_factor=real_time_factor)
    path = socket_path(folder)
    running = _hello(path)
    if running is not None and (is_fresh or running != setup_hash(setup)):
        _ask_once(path, "shutdown")
        _wait_until_gone(folder)
        running = None
    if is_fresh:
        _put_away(folder / LOG_NAME)
    if running is None:
        _write_whole(folder / SETUP_NAME, json.dumps(setup_to_json(setup)).encode())
        _start(folder, idle_s)
    return MujocoCell(folder, skill_timeout_s=skill_timeout_s)


def _hello(path: Path) -> str | None:
    """Return the set-up of the process that listens there, None if there is none."""
    try:
        return str(_ask_once(path, "hello")["setup"])
    except _ConnectionGoneError:
        return None


def _start(folder: Path, idle_s: float) -> None:
    module = "sitewright.robot_team.drivers.mujoco.process"
    command = [
        sys.executable,
        "-m",
        module,
        "--project-state",
        str(folder),
        "--idle-s",
        str(idle_s),
    ]
    found_at = (str(Path(errors.__file__).parents[1]), os.environ.get("PYTHONPATH", ""))
    with (folder / OUTPUT_NAME).open("ab") as output:
        process = subprocess.Popen(  # noqa: S603 - our own module
            command,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=output,
            start_new_session=True,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, found_at))},
        )
    deadline_s = time.monotonic() + _START_TIMEOUT_S
    while _hello(socket_path(folder)) is None:
        if process.poll() not in (None, ALREADY_RUNNING):
            said = (folder / OUTPUT_NAME).read_text(errors="replace")[-800:]
            raise BackendError(f"The simulated cell ended with {process.returncode}: {said}")
        if time.monotonic() > deadline_s:
            process.kill()
            raise BackendError(f"The simulated cell did not start in {_START_TIMEOUT_S:g} s.")
        time.sleep(_POLL_S)
    _leave_alone(process)


def _leave_alone(process: subprocess.Popen[bytes]) -> None:
    """The process outlives us on purpose; no warning that it was not waited for."""
    process.returncode = 0


def _wait_until_gone(folder: Path) -> None:
    """Wait until the lock that a process keeps to its very end is free."""
    deadline_s = time.monotonic() + _ANSWER_TIMEOUT_S
    with (folder / LOCK_NAME).open("a") as lock:
        while True:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                if time.monotonic() > deadline_s:
                    raise BackendError("The simulated cell does not end.") from None
                time.sleep(_POLL_S)
            else:
                return


def _put_away(log: Path) -> None:
    if log.exists():
        number = sum(1 for _ in log.parent.glob(f"{log.stem}-*{log.suffix}")) + 1
        log.rename(log.with_name(f"{log.stem}-{number}{log.suffix}"))


def _write_whole(path: Path, data: bytes) -> None:
    draft = path.with_suffix(".new")
    with draft.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    draft.rename(path)


def _open(path: Path, timeout_s: float) -> socket.socket:
    link = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    link.settimeout(timeout_s)
    try:
        link.connect(str(path))
    except OSError as error:
        link.close()
        raise _ConnectionGoneError(f"No simulated cell answers at {path}.") from error
    return link


def _ask_once(path: Path, operation: str) -> Plain:
    with _open(path, _ANSWER_TIMEOUT_S) as link, link.makefile("rb") as lines:
        return _exchange(link, lines, operation, None)


def _exchange(link: socket.socket, lines: Iterable[bytes], operation: str, data: Plain) -> Plain:
    try:
        link.sendall(json.dumps({"op": operation, "data": data}, allow_nan=False).encode() + b"\n")
        line = next(iter(lines), b"")
    except (OSError, ValueError) as error:
        raise _ConnectionGoneError(f"The simulated cell does not answer: {error}") from error
    if not line.endswith(b"\n"):
        raise _ConnectionGoneError("The simulated cell went away.")
    answer = json.loads(line)
    if "error" in answer:
        raise _error(answer["error"], answer["message"])
    return answer["value"]


def _error(name: str, message: str) -> SitewrightError:
    kind = getattr(errors, name, BackendError)
    simple = {errors.CommandRefusedError, OutcomeUnknownError, BackendError}
    return kind(message) if kind in simple else BackendError(message)
