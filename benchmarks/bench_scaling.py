"""Cost of planning one target as walls grow: processor seconds, from 5 to 200 targets.

Run: ``python benchmarks/bench_scaling.py [TARGETS ...]``; ``200:10`` plans the first 10 of 200.
A wall of 5 targets has a bay of two supports and three studs with four nails each; longer ones
have more bays, on longer tracks.
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

_TARGETS = ("5", "10", "20", "50", "100", "200")
_PER_BAY = STUDS_PER_BAY + 2


def main() -> None:
    """Print a line for each length."""
    wanted = sys.argv[1:] or _TARGETS
    print("| targets | planned | all, s | each, s: median | p95 | worst | symbolic, mean |")
    print("|--:|--:|--:|--:|--:|--:|--:|")
    for length in wanted:
        targets, _, first = length.partition(":")
        project = long_wall(STUDS_PER_BAY * (int(targets) // _PER_BAY))
        last = _last_of(int(first or targets))
        moments = [time.process_time()]
        report = plan_project(project, last, on_progress=partial(_note, moments))
        each = sorted(b - a for a, b in pairwise(moments))
        symbolic_s = report.timing_s["symbolic"] / len(each)
        print(
            f"| {report.targets_total} | {report.targets_planned} | {sum(each):.1f} "
            f"| {statistics.median(each):.2f} | {each[int(0.95 * (len(each) - 1))]:.2f} "
            f"| {each[-1]:.2f} | {symbolic_s:.3f} |",
            flush=True,
        )


def _last_of(count: int) -> str:
    """Return the last of so many targets, bay by bay."""
    return f"bay-{count // _PER_BAY - 1:03d}.stud-{STUDS_PER_BAY - 1}"


def _note(moments: list[float], *_words: object) -> None:
    moments.append(time.process_time())


if __name__ == "__main__":
    main()
