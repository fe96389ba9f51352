"""What ``check --reach`` prints and draws."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sitewright.cli.output import Output

PICTURE = "reach.svg"
_DONE, _NO_MOTION = 0, 6


def show_reach(
    out: Output, project: Path, cell: Path | None, *, svg: Path | None, is_all: bool
) -> int:
    """Check the reach of a project and tell it; exit code 6 if something cannot be built.

    Args:
        out: Where the words go.
        project: Its folder.
        cell: Another cell file than its own.
        svg: Where the picture goes; ``reach.svg`` in the project by default.
        is_all: Also tell the ways of what can be built.
    """
    from sitewright.app.clock import SystemClock
    from sitewright.app.project import read_project
    from sitewright.app.reach import reach_of
    from sitewright.interaction_twin.labels import labels_of
    from sitewright.interaction_twin.reach.document import SCHEMA, reach_document
    from sitewright.interaction_twin.reach.lines import reach_lines
    from sitewright.interaction_twin.reach.picture import reach_picture

    opened = read_project(project, cell=cell)
    report, labels = reach_of(opened, SystemClock()), labels_of(opened.model, opened.cell)
    for line in reach_lines(report, labels, is_all=is_all):
        out.line(line)
    file = svg or project / PICTURE
    title = opened.model.name or project.resolve().name
    file.write_text(reach_picture(report, labels, title) + "\n", encoding="utf-8")
    out.line(f"Picture: {file}")
    out.document(SCHEMA, {**reach_document(report, labels), "svg": str(file)})
    return _DONE if report.share == 1.0 else _NO_MOTION
