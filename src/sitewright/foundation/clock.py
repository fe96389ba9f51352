"""The clock port: time is an argument, never a global."""

from __future__ import annotations

from typing import Protocol


class Clock(Protocol):
    """Tells the time; tests inject their own."""

    def utc_ns(self) -> int:
        """Wall clock, nanoseconds since 1970-01-01 UTC."""
        ...

    def monotonic_ns(self) -> int:
        """Clock that never goes back, nanoseconds since an arbitrary start."""
        ...
