"""A stored wall of 52 blocks: what two arms with clamps reach of it, before and after a layout.

Run: ``python benchmarks/bench_masonry.py WALL.json [BUDGET [PICTURE.svg]]``, with the file
``masonry/wall_assembly.json`` of the stored data.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from builders_masonry import block_wall
from sitewright.app.clock import SystemClock
from sitewright.app.layout import LayoutOptions, propose_layout
from sitewright.app.planning import plan_project
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.reach.moves import layout_lines, layout_picture
from sitewright.planning_twin.reachability.report import ReachReport


def main() -> None:
    """Print both reach checks, and what the layout moves."""
    project = block_wall(Path(sys.argv[1]))
    budget = int(sys.argv[2]) if len(sys.argv) > 2 else 40  # noqa: PLR2004 - the second argument
    before_s = time.process_time()
    found = propose_layout(project, LayoutOptions(budget=budget), SystemClock())
    took_s = time.process_time() - before_s
    print(f"before: {_words(found.before)}")
    print(f"after:  {_words(found.after)}")
    for line in layout_lines(found.yard, found.arrangement, found.before, found.after):
        print(f"  {line}")
    print(f"{budget} reach checks: {took_s:.0f} s of one processor")
    planned = plan_project(found.project)
    print(f"planned, all motions certified: {planned.targets_planned} of {planned.targets_total}")
    for verdict in found.after.verdicts:
        if verdict.reasons:
            print(f"  {verdict.target}: {verdict.standing.value}: {verdict.reasons[0]}")
    if len(sys.argv) > 3:  # noqa: PLR2004 - the third argument
        labels, reports = labels_of(project.model, project.cell), (found.before, found.after)
        drawn = layout_picture(found.yard, found.arrangement, reports, labels, "Wall of blocks")
        Path(sys.argv[3]).write_text(drawn + "\n", encoding="utf-8")


def _words(report: ReachReport) -> str:
    standing = Counter(v.standing.value for v in report.verdicts)
    parts = ", ".join(f"{count} {name}" for name, count in sorted(standing.items()))
    return f"buildable {100.0 * report.share:.0f} % ({parts})"


if __name__ == "__main__":
    main()
