"""Runs one function on a foreign file in a child process under limits: parsers crash on bad files.

The child is `import_child`. It dies with us, in whatever way we end, and nothing of it is left
when `run_child` returns or raises.
"""

from __future__ import annotations

import json
import os
import selectors
import signal
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from sitewright.building_model.formats.detect import refused
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.canonical import Json

_INHERITED = ("HOME", "LANG", "LC_ALL", "PATH", "TMPDIR", "LD_LIBRARY_PATH")
_BOOT = (
    "import sys; sys.path[:] = sys.argv.pop(1).split('\\n'); "
    "from sitewright.building_model.formats.import_child import main; main(*sys.argv[1:])"
)
_SHOWN_CHARS = 400
_OUT_OF_MEMORY = ("MemoryError", "bad_alloc", "annot allocate memory")
_CHUNK_BYTES = 1 << 20
_LAST_WORDS_BYTES = 1 << 16
_POLL_S = 0.002
_LIGHTER = "Export only what is to be built."
_FIX = "Check the file, or save or export it again."


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """What a child may use.

    Attributes:
        memory_bytes: Address space, libraries included.
        written_bytes: Largest file that it may write; nothing by default.
        answer_bytes: Longest answer that is listened to.
        how_to_raise: How a user gives it more, as a sentence; empty where nobody can.
    """

    memory_bytes: int = 4 * 1024**3
    cpu_s: int = 60
    wall_s: float = 60.0
    written_bytes: int = 0
    open_files: int = 256
    answer_bytes: int = 512 * 1024**2
    how_to_raise: str = ""


@dataclass(frozen=True, slots=True)
class ChildFailed:
    """The child gave no answer.

    Attributes:
        reason: What ended it, as a phrase: ``took longer than 60 s``.
        is_limit: It would have used more than it may.
    """

    reason: str
    is_limit: bool = False


def answer_about(
    path: Path, function: str, *arguments: str, limits: Limits | None = None
) -> Mapping[str, Json]:
    """Return what a function says in a child process.

    Args:
        path: The user's file, for messages.
        function: ``module:name`` of a function of texts that returns a JSON object.
        arguments: Its arguments.
        limits: What it may use.

    Raises:
        ModelRejectedError: The function refused the file, or its process failed (E2).
    """
    limits = limits or Limits()
    answer = run_child(function, *arguments, limits=limits)
    if isinstance(answer, ChildFailed):
        fix = f"{_LIGHTER} {limits.how_to_raise}".rstrip() if answer.is_limit else _FIX
        raise refused(path, "E2", f"the reader {answer.reason}.", fix)
    return _unwrapped(path, answer)


def run_child(function: str, *arguments: str, limits: Limits) -> Json | ChildFailed:
    """Run a function under limits in a process of its own and return what that prints.

    That is ``{"answer": ..}`` or ``{"problems": [..]}``, see `import_child`.
    """
    spec = (os.getpid(), limits.memory_bytes, limits.cpu_s, limits.written_bytes, limits.open_files)
    paths = "\n".join(str(Path(p).absolute()) for p in sys.path if p)
    numbers = ",".join(str(v) for v in spec)
    command = [sys.executable, "-I", "-S", "-B", "-c", _BOOT, paths, numbers, function, *arguments]
    process = subprocess.Popen(  # noqa: S603 - our own interpreter and our own module
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=_environment(),
        cwd=os.sep,
        start_new_session=True,  # an interrupt at the terminal is ours to handle
    )
    try:
        return _result(process, limits)
    finally:
        _end(process)


def _result(process: subprocess.Popen[bytes], limits: Limits) -> Json | ChildFailed:
    deadline = time.monotonic() + limits.wall_s
    heard = _listen(process, limits, deadline)
    if isinstance(heard, ChildFailed):
        return heard
    answer, last_words = heard
    if not _has_ended(process, deadline):
        return _too_slow(limits)
    _end(process)
    if process.returncode != 0:
        return _ended_by(process.returncode, last_words, limits)
    try:
        document: Json = json.loads(answer)
    except (ValueError, RecursionError):
        return ChildFailed("gave no complete answer")
    return document


def _listen(
    process: subprocess.Popen[bytes], limits: Limits, deadline: float
) -> tuple[bytes, bytes] | ChildFailed:
    """Return all of its answer and the last of what it complained about."""
    assert process.stdout is not None and process.stderr is not None  # noqa: S101, PT018
    answer, complaints = bytearray(), bytearray()
    with selectors.DefaultSelector() as selector:
        selector.register(process.stdout, selectors.EVENT_READ, answer)
        selector.register(process.stderr, selectors.EVENT_READ, complaints)
        while selector.get_map():
            ready = selector.select(max(0.0, deadline - time.monotonic()))
            if not ready:
                return _too_slow(limits)
            for key, _ in ready:
                if not _take(key.fileobj, key.data):  # type: ignore[arg-type]
                    selector.unregister(key.fileobj)
            if len(answer) > limits.answer_bytes:
                said = f"answered with more than {limits.answer_bytes} bytes"
                return ChildFailed(said, is_limit=True)
            del complaints[:-_LAST_WORDS_BYTES]
    return bytes(answer), bytes(complaints)


def _take(pipe: IO[bytes], into: bytearray) -> bool:
    """Append what is there; False at its end."""
    chunk = os.read(pipe.fileno(), _CHUNK_BYTES)
    into += chunk
    return bool(chunk)


def _has_ended(process: subprocess.Popen[bytes], deadline: float) -> bool:
    """Wait for its end without burying it: its number must stay taken until the group is dead."""
    how = os.WEXITED | os.WNOWAIT | os.WNOHANG
    while os.waitid(os.P_PID, process.pid, how) is None:
        if time.monotonic() > deadline:
            return False
        time.sleep(_POLL_S)
    return True


def _end(process: subprocess.Popen[bytes]) -> None:
    """Leave nothing of the child, nor of what it may have started."""
    if process.returncode is None:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    for pipe in (process.stdout, process.stderr):
        if pipe is not None:
            pipe.close()


def _unwrapped(path: Path, document: Json) -> Mapping[str, Json]:
    """Return the answer; problems are raised as the refusal of the file."""
    if isinstance(document, Mapping):
        answer, problems = document.get("answer"), document.get("problems")
        if isinstance(answer, Mapping):
            return answer
        if isinstance(problems, list) and problems:
            raise ModelRejectedError(str(path), [_problem(p) for p in problems])
    raise refused(path, "E2", "the reader gave no records.", _FIX)


def _problem(record: Json) -> Problem:
    texts = [str(v) for v in record] if isinstance(record, list) else []
    code, severity, where, message, fix, source_id = (*texts, *[""] * 6)[:6]
    return Problem(
        code=code, severity=severity, where=where, message=message, fix=fix, source_id=source_id
    )


def _too_slow(limits: Limits) -> ChildFailed:
    return ChildFailed(f"took longer than {limits.wall_s:g} s", is_limit=True)


def _environment() -> dict[str, str]:
    kept = {name: os.environ[name] for name in _INHERITED if name in os.environ}
    threads = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")  # each would reserve address space
    return {**kept, **dict.fromkeys(threads, "1")}


def _ended_by(returncode: int, stderr: bytes, limits: Limits) -> ChildFailed:
    """Say what ended it; the limits that the kernel keeps are told by their marks."""
    if returncode == -signal.SIGXCPU:
        words = f"used more than {limits.cpu_s} s of processor time"
        return ChildFailed(words, is_limit=True)
    last = [line for line in stderr.decode(errors="replace").splitlines() if line.strip()][-1:]
    if any(mark in line for line in last for mark in _OUT_OF_MEMORY):
        words = f"needs more than {limits.memory_bytes / 1024**3:g} GB of memory"
        return ChildFailed(words, is_limit=True)
    if returncode < 0:
        return ChildFailed(f"was ended by {signal.Signals(-returncode).name}")
    said = last[0][:_SHOWN_CHARS] if last else str(returncode)
    return ChildFailed(f"stopped with: {said}" if last else f"stopped with {said}")
