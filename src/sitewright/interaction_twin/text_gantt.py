"""A schedule as text: one row per robot, for terminals and golden files."""

from __future__ import annotations

from collections.abc import Sequence

from sitewright.interaction_twin.measures import in_seconds
from sitewright.interaction_twin.proposal_view import StepView

_IDLE = "."


def text_gantt(steps: Sequence[StepView], *, width: int = 60) -> tuple[str, ...]:
    """Return the plan on a time axis; each step shows the last digit of its number.

    Args:
        steps: One after the other.
        width: Characters of the axis.
    """
    end_s = max((s.starts_s + s.duration_s for s in steps), default=0.0)
    if end_s <= 0.0:
        return ()
    robots = sorted({s.robot for s in steps})
    margin = max(len(r) for r in robots)
    lines = []
    for robot in robots:
        row = [_IDLE] * width
        for step in (s for s in steps if s.robot == robot):
            first = int(width * step.starts_s / end_s)
            last = max(first + 1, int(width * (step.starts_s + step.duration_s) / end_s))
            row[first:last] = str(step.number % 10) * (min(last, width) - first)
        lines.append(f"  {robot.ljust(margin)}  {''.join(row)}")
    end = in_seconds(end_s)
    return (*lines, f"  {' ' * margin}  0{end.rjust(width - 1)}")
