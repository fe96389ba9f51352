"""The stored queries of the hard set, and apart from them the witnesses."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from benchmarks.motion.query import MotionQuery, from_plain

from sitewright.robot_team.description import Joints

HERE = Path(__file__).parent
QUERIES, WITNESSES = HERE / "queries", HERE / "witnesses"


def stored_queries(*families: str) -> list[MotionQuery]:
    """Return all queries, or those of some families."""
    files = sorted(f for f in QUERIES.glob("*.json") if not families or f.stem in families)
    return [from_plain(plain) for file in files for plain in _read(file)]


def stored_witness(query: MotionQuery) -> tuple[Joints, ...]:
    """Return the certified path that a query was made around. Not for planners."""
    ways = dict(_read(WITNESSES / f"{query.family}.json"))
    return tuple(tuple(q) for q in ways[query.name])


def write(file: Path, values: object) -> None:
    """Write plain values as one line."""
    file.parent.mkdir(exist_ok=True)
    file.write_text(json.dumps(values, allow_nan=False, separators=(",", ":")) + "\n", "utf-8")


def _read(file: Path) -> Any:  # noqa: ANN401 - plain JSON
    return json.loads(file.read_text("utf-8"))
