"""Reach checks of whole models: seconds for the question and the answer, and what is buildable.

Run: ``python benchmarks/bench_reach.py [PROJECT ...]``. Without projects: the examples and
generated walls.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from builders_reach import checked
from builders_walls import frame_wall, lattice
from sitewright.app.project import EXAMPLES, Project, example_folder, read_project


def main() -> None:
    """Print a line for each project."""
    for name, project in _projects(sys.argv[1:]):
        before_s = time.perf_counter()
        report = checked(project)
        took_s = time.perf_counter() - before_s
        total = len(report.verdicts)
        print(
            f"{name:24} {total:4} targets  {len(report.answer.operatings):5} operations x robots  "
            f"buildable {100.0 * report.share:5.1f} %  {took_s:6.2f} s  "
            f"{1000.0 * took_s / max(1, total):6.1f} ms each"
        )


def _projects(folders: list[str]) -> Iterator[tuple[str, Project]]:
    if folders:
        yield from ((Path(f).name, read_project(f)) for f in folders)
        return
    yield from ((e, read_project(example_folder(e))) for e in EXAMPLES)
    for studs in (5, 20, 80):
        yield f"wall of {studs} studs", frame_wall(studs)
    yield "panel of 430 laths", lattice(43, 10)
    yield "panel of 425, too tight", lattice(17, 25)


if __name__ == "__main__":
    main()
