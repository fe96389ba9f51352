"""Symbolic call: problem generation, grounding, search and validation; medians in milliseconds.

Run: ``python benchmarks/bench_symbolic.py [repeats]``. The driver is the reference path.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path
from statistics import median, quantiles

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from builders_symbolic import site, team
from sitewright.symbolic_planning.planner import SkillSequence, SymbolicPlanner
from sitewright.symbolic_planning.planners.builtin import BuiltinPlanner
from sitewright.symbolic_planning.planners.fast_downward import FastDownward, FastDownwardDriver
from sitewright.symbolic_planning.problem import problem_for
from sitewright.symbolic_planning.vocabulary import built_in_domain


def measured(planner: SymbolicPlanner, robots: int, repeats: int) -> str:
    """Return a line of the table for half handlers, half finishers and four nails."""
    domain, view = built_in_domain(), site(team(robots // 2, robots // 2))
    ours_ms, total_ms = [], []
    answer: object = None
    for _ in range(repeats):
        started_s = time.perf_counter()
        problem = problem_for(domain, view)
        ours_ms.append(1e3 * (time.perf_counter() - started_s))
        answer = planner.plan(problem)
        total_ms.append(1e3 * (time.perf_counter() - started_s))
    cost = answer.cost if isinstance(answer, SkillSequence) else "-"
    p95_ms = quantiles(total_ms, n=20)[-1]
    return (
        f"{planner.name:22} R={robots:2}  median {median(total_ms):6.1f}  p95 {p95_ms:6.1f}"
        f"  (problem {median(ours_ms):5.1f})  cost {cost}"
    )


def main() -> None:
    """Print the table."""
    repeats = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    for planner in (FastDownward(), FastDownwardDriver(), BuiltinPlanner()):
        for robots in (2, 4, 10):
            print(measured(planner, robots, repeats))


if __name__ == "__main__":
    main()
