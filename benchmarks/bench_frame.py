"""Whole frame from files to certified motions, replans after a change, memory: medians.

.venv/bin/python benchmarks/bench_frame.py [PROJECT] [RUNS]
"""

from __future__ import annotations

import resource
import statistics
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TypeVar

from sitewright.app.engines import proposals_of
from sitewright.app.planning import plan_project, start_of
from sitewright.app.project import example_folder, open_project
from sitewright.central_controller.ports import Planned, SiteContext
from sitewright.central_controller.rehearsal import rehearsed
from sitewright.foundation.pose import translation

T = TypeVar("T")
_AIM_S, _AIM_REPLAN_S = 3.0, 0.5
_SHIFT = translation(0.02, 0.01, 0.0)


def main() -> None:
    """Print the figures."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else example_folder("wooden_frame")
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 5  # noqa: PLR2004 - the second argument
    whole, kinds = [], []
    for _ in range(runs):
        seconds, report = timed(lambda: plan_project(open_project(folder)))
        whole.append(seconds)
        kinds.append(report.timing_s)
        print(f"  {report.targets_planned}/{report.targets_total} planned in {seconds:.2f} s")
    median = statistics.median(whole)
    print(f"files to certified motions: median {median:.2f} s (aim {_AIM_S:g} s)")
    for kind in ("symbolic", "motion", "certificate"):
        print(f"  {kind}: median {statistics.median(k[kind] for k in kinds):.2f} s")
    replans = [seconds for _ in range(runs) for seconds in replans_after_a_moved_stack(folder)]
    worst, middle = max(replans), statistics.median(replans)
    p95 = statistics.quantiles(replans, n=20)[-1]
    print(
        f"replan of one target ({len(replans)}): median {middle:.2f}, p95 {p95:.2f}, "
        f"worst {worst:.2f} s (aim {_AIM_REPLAN_S:g} s at p95)"
    )
    peak_kb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(f"peak memory of this process: {peak_kb / 1024:.0f} MiB (aim 2048)")


def timed(work: Callable[[], T]) -> tuple[float, T]:
    """Return the wall seconds of some work, and its result."""
    start_s = time.perf_counter()
    result = work()
    return time.perf_counter() - start_s, result


def replans_after_a_moved_stack(folder: Path) -> list[float]:
    """Return the seconds of planning each target anew after its stock was pushed by 2 cm."""
    project = open_project(folder)
    proposals = proposals_of(project)
    context = start_of(project)
    seconds: list[float] = []
    while True:
        outcome = proposals.propose(context)
        if not isinstance(outcome, Planned):
            return seconds
        moved = _pushed(context)
        took_s, again = timed(partial(proposals.propose, moved))
        if isinstance(again, Planned):
            seconds.append(took_s)
        context = rehearsed(context, outcome.proposal)


def _pushed(context: SiteContext) -> SiteContext:
    placed = {p.piece for p in context.site.placed.values()}
    poses = {
        piece: pose if piece in placed else _SHIFT @ pose
        for piece, pose in context.observation.world_T_piece.items()
    }
    return replace(context, observation=replace(context.observation, world_T_piece=poses))


if __name__ == "__main__":
    main()
