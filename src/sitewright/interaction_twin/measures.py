"""Numbers as people read them."""

from __future__ import annotations

_MINUTE_S = 60.0


def in_seconds(duration_s: float) -> str:
    """Return a time such as ``8.2 s`` or ``1 min 32 s``."""
    if round(duration_s, 1) < _MINUTE_S:
        return f"{duration_s:.1f} s"
    minutes, seconds = divmod(round(duration_s), 60)
    return f"{minutes} min {seconds:02d} s"


def in_millimetres(distance_m: float | None) -> str:
    """Return a distance such as ``38 mm``, rounded down; a dash if there is none."""
    if distance_m is None:
        return "-"
    return f"{int(distance_m * 1000.0 + 1e-6)} mm" if distance_m >= 0 else "touching"


def counted(count: int, noun: str) -> str:
    """Return ``1 step`` or ``4 steps``."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
