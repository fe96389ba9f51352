"""Cost of planning one target as walls grow: seconds of each target, from 5 to 200 targets.

Run: ``python benchmarks/bench_scaling.py [TARGETS ...]``. A wall of 5 targets has a bay of two
supports and three studs with four nails each; longer ones have more bays, on longer tracks.
"""

from __future__ import annotations

import statistics
import sys
import time
from functools import partial
from itertools import pairwise
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from builders_long_walls import STUDS_PER_BAY, long_wall
from sitewright.app.planning import plan_project

_TARGETS = (5, 10, 20, 50, 100, 200)
_PER_BAY = STUDS_PER_BAY + 2


def main() -> None:
    """Print a line for each length."""
    wanted = [int(a) for a in sys.argv[1:]] or _TARGETS
    print("| targets | planned | whole s | s per target: median | p95 | worst | of it symbolic |")
    print("|--:|--:|--:|--:|--:|--:|--:|")
    for targets in wanted:
        project = long_wall(STUDS_PER_BAY * (targets // _PER_BAY))
        moments = [time.perf_counter()]
        report = plan_project(project, on_progress=partial(_note, moments))
        each = sorted(b - a for a, b in pairwise(moments))
        symbolic_s = report.timing_s["symbolic"] / report.targets_total
        print(
            f"| {report.targets_total} | {report.targets_planned} | {sum(each):.1f} "
            f"| {statistics.median(each):.2f} | {each[int(0.95 * (len(each) - 1))]:.2f} "
            f"| {each[-1]:.2f} | {symbolic_s:.3f} |",
            flush=True,
        )


def _note(moments: list[float], *_words: object) -> None:
    moments.append(time.perf_counter())


if __name__ == "__main__":
    main()
