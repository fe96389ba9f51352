"""The flat pictures of a page, drawn by the writer that draws those of the report."""

from __future__ import annotations

from collections.abc import Sequence

from sitewright.interaction_twin.drawing.bars import Bar, on_the_axis_of
from sitewright.interaction_twin.drawing.gantt import GanttStyle, gantt
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.report.timeline import timeline

History = Sequence[Stamped]


def plan_schedule(plan: Sequence[Bar], records: History, labels: Labels, style: GanttStyle) -> str:
    """Return a plan, and what ran of it in its run's records, on the plan's own axis."""
    ran = timeline(s.event for s in records).actual
    return gantt(plan, on_the_axis_of(plan, ran), labels, style)


def run_schedule(records: History, labels: Labels, style: GanttStyle) -> str:
    """Return everything that was planned and ran in a run, from its first skill on."""
    found = timeline(s.event for s in records)
    return gantt(found.planned, found.actual, labels, style)
