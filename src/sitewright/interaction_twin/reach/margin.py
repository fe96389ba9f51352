"""The column beside the views: what the colours mean, who does how much, what nobody reaches."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import wrap

from sitewright.interaction_twin.drawing.svg import element, text
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.reach.drawing import Drawing
from sitewright.interaction_twin.reach.lines import WORDS, robot_lines
from sitewright.interaction_twin.reach.outline import Point
from sitewright.interaction_twin.reach.palette import (
    ALARM,
    INK,
    LOOKS,
    SOFT,
    STOCK,
    STOCK_EDGE,
    ZONE,
    ZONE_EDGE,
    Look,
    look_of,
)
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.planning_twin.reachability.verdict import Standing

_LINE_PX, _SWATCH_PX, _WIDTH = 18.0, 12.0, 54
_STOCK = Look(STOCK, STOCK_EDGE, "stock")
_ZONE = Look(ZONE, ZONE_EDGE, "zone that nobody enters")


def margin_column(
    report: ReachReport, drawing: Drawing, labels: Labels, at: Point, height: float
) -> Iterator[str]:
    """Yield the column's elements, as many lines as fit into its height."""
    x, y = at
    used = {look_of(v) for v in report.verdicts}
    for look in (*(w for w in LOOKS if w in used), _STOCK, *([_ZONE] if drawing.zones else [])):
        yield from _swatch(look, (x, y))
        y += _LINE_PX
    for robot in drawing.robots:
        yield element(
            "circle",
            cx=x + 6.0,
            cy=y + 6.0,
            r=6.0,
            fill="none",
            stroke=robot.colour,
            stroke_dasharray="2 3",
        )
        words = f"{robot.id}, at home; where its wrist can be at most"
        yield text(words, x + 22.0, y + 10.0, font_size=11)
        y += _LINE_PX
    y += _LINE_PX
    for words, style in _rows(report, labels):
        if y > height - 3 * _LINE_PX:
            yield text("... see the document for the rest", x, y, font_size=11, fill=SOFT)
            return
        yield text(words, x, y, font_size=11, **style)
        y += 15.0


def _swatch(look: Look, at: Point) -> Iterator[str]:
    yield element(
        "rect",
        x=at[0],
        y=at[1],
        width=_SWATCH_PX,
        height=_SWATCH_PX,
        fill=look.fill,
        stroke=look.edge,
        rx=2,
    )
    yield text(look.words, at[0] + 22.0, at[1] + 10.0, font_size=11)


def _rows(report: ReachReport, labels: Labels) -> Iterator[tuple[str, dict[str, str]]]:
    """Yield lines with their style: who does how much, then each target that cannot be built."""
    bold = {"font_weight": "bold", "fill": INK}
    yield "Who does how much", bold
    for line in robot_lines(report):
        yield line, {"fill": INK}
    for note in report.notes:
        yield from ((piece, {"fill": ALARM}) for piece in wrap(note, _WIDTH)[:3])
    out = [v for v in report.verdicts if v.standing is not Standing.BUILDABLE]
    if out:
        yield "", {}
        yield "What cannot be built", bold
    for verdict in out:
        yield f"{labels.name(verdict.target)}: {WORDS[verdict.standing]}", {"fill": INK}
        for reason in verdict.reasons[:2]:
            for piece in wrap(reason, _WIDTH)[:3]:
                yield f"   {piece}", {"fill": SOFT}
