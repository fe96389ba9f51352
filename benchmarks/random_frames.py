"""Every target of random frames: built, or refused for a reason that other code confirms.

Run: ``python benchmarks/random_frames.py [FIRST LAST [AWAY_M]]``. Frames 1 to 10 in the case
study's cell by default; AWAY_M moves the nailer away from the table, so that some of it is out of
its reach. Each target is counted once:

| built | all its motions are certified |
| impossible | proven by the planner, and confirmed by a check that shares no code with it |
| blocked | by something that is named and could go away |
| not found | within the budget; then planned again with 20 other seeds |
| waits | for one of the others |
| WRONG | the planner calls it impossible and the check does not, or a seed finds a plan |
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from builders_random_frames import random_frame
from independent_holding import held_check
from independent_reach import unreachable
from sitewright.app.engines import proposals_of
from sitewright.app.planning import PlanReport, plan_project, start_of
from sitewright.app.project import Project
from sitewright.central_controller.ports import Escalation, Planned, SiteContext
from sitewright.central_controller.rehearsal import rehearsed
from sitewright.foundation.ids import ComponentId

_SEEDS = range(1, 21)
_CLASSES = ("built", "impossible", "blocked", "not found", "waits", "WRONG")


def main() -> None:
    """Print a line for each frame, and the sums."""
    numbers = [int(a) for a in sys.argv[1:3]] or [1, 10]
    away_m = float(sys.argv[3]) if len(sys.argv) > 3 else 0.0  # noqa: PLR2004 - the third argument
    print("| frame | targets | " + " | ".join(_CLASSES) + " | processor s |")
    print("|--:|" + "--:|" * (len(_CLASSES) + 2))
    sums: Counter[str] = Counter()
    for seed in range(numbers[0], numbers[1] + 1):
        project = random_frame(seed, nailer_away_m=away_m)
        before_s = time.process_time()
        report = plan_project(project)
        took_s = time.process_time() - before_s
        found = Counter(_class_of(project, report, e) for e in report.escalated)
        found += Counter({"built": report.targets_planned, "waits": len(report.waiting)})
        sums += found
        print(f"| {seed} | {report.targets_total} | {_row(found)} | {took_s:.1f} |", flush=True)
    print(f"| all | {sums.total()} | {_row(sums)} | |")
    sys.exit(1 if sums["WRONG"] else 0)


def _row(found: Counter[str]) -> str:
    return " | ".join(str(found[c]) for c in _CLASSES)


def _class_of(project: Project, report: PlanReport, refused: Escalation) -> str:
    """Return what a refusal is, once other code has looked at it."""
    if refused.is_proven:
        return "impossible" if _is_confirmed(project, refused.target) else "WRONG"
    if refused.blockers:
        return "blocked"
    context = _site_before(project, report)
    set_aside = frozenset(e.target for e in report.escalated) - {refused.target}
    tries = (proposals_of(project, seed=s).propose(context, exclude=set_aside) for s in _SEEDS)
    return "WRONG" if any(isinstance(t, Planned) for t in tries) else "not found"


def _is_confirmed(project: Project, target: ComponentId) -> bool:
    """Tell whether other code finds neither a posture nor a way to fasten the piece while held."""
    return bool(unreachable(project, target)) or held_check(project, target).is_impossible


def _site_before(project: Project, report: PlanReport) -> SiteContext:
    """Return the site with everything built that was planned."""
    context = start_of(project)
    for planned in report.planned:
        context = rehearsed(context, planned.proposal)
    return context


if __name__ == "__main__":
    main()
