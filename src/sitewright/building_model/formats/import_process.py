"""Runs a reader of foreign files in a child process under limits: parsers crash on bad files."""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from sitewright.foundation.canonical import Json

_INHERITED = ("HOME", "LANG", "LC_ALL", "PATH", "TMPDIR", "LD_LIBRARY_PATH", "VIRTUAL_ENV")
_SHOWN_CHARS = 400


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """What a child may use.

    Attributes:
        memory_bytes: Address space, libraries included.
        written_bytes: Largest file that it may write.
    """

    memory_bytes: int = 4 * 1024**3
    cpu_s: int = 60
    wall_s: float = 60.0
    written_bytes: int = 1024**2
    open_files: int = 256


@dataclass(frozen=True, slots=True)
class ChildFailed:
    """The child gave no answer.

    Attributes:
        reason: What ended it, as a phrase: ``took longer than 60 s``.
    """

    reason: str


def run_reader(module: str, path: Path, limits: Limits) -> Json | ChildFailed:
    """Run ``python -m module path`` under limits and return the JSON document on its stdout.

    Args:
        module: A module that calls `limit_own_resources` first and prints one JSON document.
        path: File to be read, its last argument.
        limits: What it may use.
    """
    spec = (limits.memory_bytes, limits.cpu_s, limits.written_bytes, limits.open_files)
    command = [sys.executable, "-P", "-m", module, ",".join(str(v) for v in spec), str(path)]
    try:
        run = subprocess.run(  # noqa: S603 - our own interpreter and our own module
            command, capture_output=True, timeout=limits.wall_s, env=_environment(), check=False
        )
    except subprocess.TimeoutExpired:
        return ChildFailed(f"took longer than {limits.wall_s:g} s")
    if run.returncode != 0:
        return ChildFailed(_ended_by(run.returncode, run.stderr))
    try:
        answer: Json = json.loads(run.stdout)
    except ValueError:
        return ChildFailed("gave no complete answer")
    return answer


def limit_own_resources(spec: str) -> None:
    """Apply the limits that `run_reader` passed; called by the child before heavy imports."""
    memory, cpu, written, files = (int(v) for v in spec.split(","))
    for kind, value in (
        (resource.RLIMIT_AS, memory),
        (resource.RLIMIT_CPU, cpu),
        (resource.RLIMIT_FSIZE, written),
        (resource.RLIMIT_NOFILE, files),
        (resource.RLIMIT_CORE, 0),
    ):
        _, hard = resource.getrlimit(kind)
        allowed = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(kind, (allowed, allowed))


def _environment() -> dict[str, str]:
    kept = {name: os.environ[name] for name in _INHERITED if name in os.environ}
    return {
        **kept,
        "PYTHONPATH": os.pathsep.join(p for p in sys.path if p),
        "PYTHONDONTWRITEBYTECODE": "1",
        "OPENBLAS_NUM_THREADS": "1",  # each thread would reserve address space
        "OMP_NUM_THREADS": "1",
    }


def _ended_by(returncode: int, stderr: bytes) -> str:
    if returncode < 0:
        return f"was ended by {signal.Signals(-returncode).name}"
    lines = [line for line in stderr.decode(errors="replace").splitlines() if line.strip()]
    return f"stopped with: {lines[-1][:_SHOWN_CHARS]}" if lines else f"stopped with {returncode}"
