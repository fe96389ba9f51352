"""Where a cell process keeps its files, and where it listens."""

from __future__ import annotations

import hashlib
import os
import tempfile
from pathlib import Path

LOCK_NAME = "cell.lock"
PID_NAME = "cell.pid"
SETUP_NAME = "cell.setup.json"
OUTPUT_NAME = "cell.out"
ALREADY_RUNNING = 9
"""Exit code of a process that finds the lock taken."""
_LONGEST_SOCKET_PATH = 100
"""The system allows 107 bytes."""


def socket_path(folder: Path) -> Path:
    """Return the socket of a state folder; a long path gets a short stand-in."""
    direct = folder.resolve() / "cell.sock"
    if len(os.fsencode(direct)) <= _LONGEST_SOCKET_PATH:
        return direct
    short = hashlib.sha256(os.fsencode(direct)).hexdigest()[:24]
    return Path(tempfile.gettempdir()) / f"sitewright-{os.getuid()}" / f"{short}.sock"


def make_private(folder: Path) -> None:
    """Create a folder that only this user can enter; somebody else's is an error."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if folder.stat().st_uid != os.getuid():
        raise PermissionError(f"{folder} belongs to another user")
