"""Fresh ids: UUIDs of version 7, which sort by creation."""

from __future__ import annotations

import secrets
from uuid import UUID

from sitewright.foundation.clock import Clock

_RANDOM_BITS = 74


class UuidSource:
    """Version 7 UUIDs from an injected clock; two of one millisecond keep their order."""

    def __init__(self, clock: Clock) -> None:
        self._clock, self._last = clock, 0

    def new(self) -> str:
        """Return a fresh id."""
        now_ms = self._clock.utc_ns() // 1_000_000
        value = (now_ms << _RANDOM_BITS) | secrets.randbits(_RANDOM_BITS)
        self._last = value if value > self._last else self._last + 1
        head, tail = self._last >> 62, self._last & ((1 << 62) - 1)
        time_ms, a = head >> 12, head & 0xFFF
        return str(UUID(int=(time_ms << 80) | (7 << 76) | (a << 64) | (2 << 62) | tail))
