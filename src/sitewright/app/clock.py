"""The machine's clock."""

from __future__ import annotations

import time
from pathlib import Path


class SystemClock:
    """Wall clock and monotonic clock of this machine."""

    def utc_ns(self) -> int:
        """Wall clock, nanoseconds since 1970-01-01 UTC."""
        return time.time_ns()

    def monotonic_ns(self) -> int:
        """Nanoseconds since this machine's boot, without sleep."""
        return time.monotonic_ns()


def boot_id() -> str:
    """Return the id of this boot, so that monotonic times of two boots are not compared."""
    try:
        return Path("/proc/sys/kernel/random/boot_id").read_text(encoding="ascii").strip()
    except OSError:
        return "unknown"
