"""A proposed layout in words and as a picture: what moves where, before and after."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from sitewright.foundation.pose import Vector
from sitewright.interaction_twin.drawing.svg import element, picture
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import counted
from sitewright.interaction_twin.reach.lines import robot_lines
from sitewright.interaction_twin.reach.picture import sized_picture
from sitewright.planning_twin.layout.movables import Arrangement, Movable, Shift, Yard
from sitewright.planning_twin.reachability.report import ReachReport

_BUILDING = "the building"
_CLEARLY = 0.85
_GAP_PX = 40.0


def layout_lines(
    yard: Yard, arrangement: Arrangement, before: ReachReport, after: ReachReport
) -> Iterator[str]:
    """Yield what moves where, and what it changes."""
    moves = list(move_lines(yard, arrangement, before))
    yield from moves or ["Nothing moves: no better places were found."]
    yield (
        f"Buildable {100.0 * before.share:.0f} % -> {100.0 * after.share:.0f} % "
        f"of {counted(len(after.verdicts), 'target')}."
    )
    yield from (f"  {line}" for line in robot_lines(after) if moves)
    yield from (note for note in after.notes if moves)


def move_lines(yard: Yard, arrangement: Arrangement, before: ReachReport) -> Iterator[str]:
    """Yield a sentence for each robot and stock place that is put elsewhere."""
    marks = {m.id: m.world_T_start.position_m for m in yard.movables}
    middles = [t.task.world_T_target.position_m for t in before.question.targets]
    if middles:
        x, y, z = (sum(p[k] for p in middles) / len(middles) for k in range(3))
        marks = {_BUILDING: (x, y, z), **marks}
    for movable in yard.movables:
        shift = arrangement.get(movable.id, Shift())
        if shift != Shift():
            others = {i: at for i, at in marks.items() if i != movable.id}
            yield _sentence(movable, shift, others)


def _sentence(movable: Movable, shift: Shift, marks: Mapping[str, Vector]) -> str:
    turn_deg = round(math.degrees(shift.yaw_rad))
    x, y, _ = shift.moves(movable).apply(movable.world_T_start.position_m)
    parts = []
    if shift.length_m > 0.0:
        way = _way(movable.world_T_start.position_m, shift, marks)
        parts.append(f"Move {movable.id} {shift.length_m:.2f} m {way}, to x {x:.2f}, y {y:.2f}")
    if turn_deg:
        it = "turn it" if parts else f"Turn {movable.id}"
        parts.append(f"{it} by {turn_deg} deg")
    return f"{' and '.join(parts)}."


def _way(at: Vector, shift: Shift, marks: Mapping[str, Vector]) -> str:
    """Return a direction by what lies in it, the building first; else along the axes."""
    for mark, there in marks.items():
        to = (there[0] - at[0], there[1] - at[1])
        along = shift.x_m * to[0] + shift.y_m * to[1]
        cosine = along / max(shift.length_m * math.hypot(*to), 1e-9)
        if abs(cosine) >= _CLEARLY:
            return f"{'towards' if cosine > 0.0 else 'away from'} {mark}"
    signs = [
        f"{'-' if v < 0.0 else '+'}{axis}" for v, axis in ((shift.x_m, "x"), (shift.y_m, "y")) if v
    ]
    return f"towards {' '.join(signs)}"


def layout_picture(
    yard: Yard,
    arrangement: Arrangement,
    reports: tuple[ReachReport, ReachReport],
    labels: Labels,
    title: str,
) -> str:
    """Return the reach pictures before and after side by side, with arrows where things go."""
    before, after = reports
    moved = [m for m in yard.movables if arrangement.get(m.id, Shift()).length_m > 0.0]
    ways = tuple(
        (m.world_T_start.position_m, arrangement[m.id].moves(m).apply(m.world_T_start.position_m))
        for m in moved
    )
    left, left_px = sized_picture(before, labels, f"{title}: before", key="before", arrows=ways)
    right, right_px = sized_picture(after, labels, f"{title}: after", key="after")
    wide = left_px[0] + _GAP_PX + right_px[0]
    tall = max(left_px[1], right_px[1])
    parts = [
        element("g", left),
        element("g", right, transform=f"translate({left_px[0] + _GAP_PX:.1f} 0)"),
    ]
    return picture(wide, tall, f"Layout of {title}: before and after", parts)
