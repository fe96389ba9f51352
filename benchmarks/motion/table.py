"""The outcomes of the hard set as a table: one line per solver and family."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

import numpy as np

HEAD = (
    "| solver | family | runs | solved | p50 ms | p95 ms | length rad | motion s |\n"
    "|---|---|--:|--:|--:|--:|--:|--:|"
)


class Row(Protocol):
    """What the table needs of an outcome."""

    @property
    def solver(self) -> str: ...  # noqa: D102 - see the outcome
    @property
    def family(self) -> str: ...  # noqa: D102
    @property
    def is_solved(self) -> bool: ...  # noqa: D102
    @property
    def spent_s(self) -> float: ...  # noqa: D102
    @property
    def length_rad(self) -> float | None: ...  # noqa: D102
    @property
    def motion_s(self) -> float | None: ...  # noqa: D102


def printed(rows: Iterable[Row]) -> str:
    """Return a table of some outcomes; times of all runs, lengths of the solved ones (medians)."""
    rows = list(rows)
    lines = [HEAD]
    for solver in dict.fromkeys(r.solver for r in rows):
        mine = [r for r in rows if r.solver == solver]
        families = dict.fromkeys(r.family for r in mine)
        lines += [_line(solver, f, [r for r in mine if r.family == f]) for f in families]
        lines.append(_line(solver, "all", mine))
    return "\n".join(lines)


def _line(solver: str, family: str, rows: list[Row]) -> str:
    solved = [r for r in rows if r.is_solved]
    p50, p95 = np.percentile([1e3 * r.spent_s for r in rows], (50, 95))
    length = _median(r.length_rad for r in solved)
    motion = _median(r.motion_s for r in solved)
    share = f"{100.0 * len(solved) / len(rows):.1f} %"
    cells = (solver, family, len(rows), share, f"{p50:.0f}", f"{p95:.0f}", length, motion)
    return "| " + " | ".join(map(str, cells)) + " |"


def _median(values: Iterable[float | None]) -> str:
    known = [v for v in values if v is not None]
    return f"{np.median(known):.2f}" if known else "-"
