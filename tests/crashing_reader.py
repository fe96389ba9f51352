"""A reader that misbehaves as it is told; run by the import tests in a child process."""

from __future__ import annotations

import ctypes
import os
import resource
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from sitewright.building_model.formats.detect import refused


def read(manner: str, path: str) -> Any:
    return globals()[f"_{manner}"](Path(path))


def _good(_: Path) -> Any:
    return {"text": 42}


def _crash(_: Path) -> Any:
    os.kill(os.getpid(), signal.SIGSEGV)


def _hang(_: Path) -> Any:
    Path(f"/proc/{os.getpid()}/comm").write_text("hanging-reader")
    time.sleep(600)


def _deaf(_: Path) -> Any:
    os.close(1)
    os.close(2)
    time.sleep(600)


def _breed(_: Path) -> Any:
    subprocess.Popen(["/bin/sleep", "600"])
    return {"text": 42}


def _memory(_: Path) -> Any:
    return {"text": str(len(bytearray(8 * 1024**3)))}


def _cpu(_: Path) -> Any:
    while True:
        pass


def _disk(path: Path) -> Any:
    path.write_bytes(b"x")
    return {"text": 42}


def _files(_: Path) -> Any:
    return {"numbers": [os.open("/dev/null", os.O_RDONLY) for _ in range(1000)]}


def _half(_: Path) -> Any:
    os._exit(0)


def _nan(_: Path) -> Any:
    return {"number": float("inf")}


def _talk(_: Path) -> Any:
    return {"text": "x" * 2_000_000}


def _print(_: Path) -> Any:
    sys.stdout.write("a library says something")
    os.write(1, b"and so does its C part")
    return {"text": 42}


def _refuse(path: Path) -> Any:
    raise refused(path, "E3", "it is another kind.", "Take the right one.")


def _network(_: Path) -> Any:
    return {"interfaces": [name for _, name in socket.if_nameindex()]}


def _escape(path: Path) -> Any:
    """Try to get out of every limit, and tell what worked."""
    tries: dict[str, Callable[[], object]] = {
        "raise memory": lambda: resource.setrlimit(
            resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY)
        ),
        "raise time": lambda: resource.setrlimit(resource.RLIMIT_CPU, (10**6, 10**6)),
        "raise file size": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10**6, 10**6)),
        "raise files": lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (5000, 5000)),
        "write": lambda: path.with_name("escaped").write_text("x"),
        "mount": lambda: ctypes_call("mount", b"none", b"/mnt", b"tmpfs", 0, None),
        "change root": lambda: os.chroot("/"),
        "become another": lambda: os.setuid(12345),
    }
    worked = []
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    for name, attempt in tries.items():
        try:
            attempt()
        except (OSError, ValueError):
            continue
        worked.append(name)
    return {"worked": worked, "isolated": sys.flags.isolated, "limits": _limits()}


def ctypes_call(name: str, *arguments: Any) -> None:
    libc = ctypes.CDLL(None, use_errno=True)
    if getattr(libc, name)(*arguments) != 0:
        raise OSError(ctypes.get_errno(), name)


def _limits() -> dict[str, int]:
    kinds = ("AS", "CPU", "FSIZE", "NOFILE", "CORE")
    return {k: resource.getrlimit(getattr(resource, f"RLIMIT_{k}"))[0] for k in kinds}


def _where(_: Path) -> Any:
    return {"folder": str(Path.cwd()), "path": sys.path}
