"""Locks that a dying process always lets go of."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from sitewright.errors import SitewrightError


class LockedError(SitewrightError):
    """Another process runs this project, or robots of this cell."""

    exit_code = 9

    def __init__(self, what: str, path: Path, holder: str) -> None:
        who = f" by process {holder}" if holder else ""
        super().__init__(f"{what} is in use{who} ({path}). Wait for it, or stop it, and try again.")


@contextmanager
def locked(path: Path, what: str) -> Iterator[None]:
    """Hold an exclusive lock on a file; somebody else's lock is a `LockedError` at once."""
    path.parent.mkdir(parents=True, exist_ok=True)
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            holder = os.read(descriptor, 32).decode("ascii", "replace").strip()
            raise LockedError(what, path, holder) from error
        os.ftruncate(descriptor, 0)
        os.pwrite(descriptor, str(os.getpid()).encode(), 0)
        yield
    finally:
        os.close(descriptor)
