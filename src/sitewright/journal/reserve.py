"""A file that is given up when the disk is full, so that the last outcomes still fit."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

RESERVE_BYTES = 8 * 1024 * 1024


def make_reserve(journal: Path) -> None:
    """Set the reserve aside if there is room; a disk without room has no reserve."""
    reserve = _reserve_of(journal)
    if reserve.exists():
        return
    try:
        with reserve.open("wb") as file:
            os.posix_fallocate(file.fileno(), 0, RESERVE_BYTES)
    except OSError:
        reserve.unlink(missing_ok=True)


def free_reserve(journal: Path) -> bool:
    """Give the reserve up; return whether there was one."""
    with contextlib.suppress(OSError):
        _reserve_of(journal).unlink()
        return True
    return False


def _reserve_of(journal: Path) -> Path:
    return journal.with_name("reserve.bin")
