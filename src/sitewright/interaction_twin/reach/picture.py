"""The reach check as a picture: plan, elevation, legend, and what nobody reaches."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.reach.drawing import Drawing, drawing_of
from sitewright.interaction_twin.reach.layers import layers
from sitewright.interaction_twin.reach.lines import headline
from sitewright.interaction_twin.reach.margin import margin_column
from sitewright.interaction_twin.reach.outline import Outline
from sitewright.interaction_twin.reach.palette import INK, SOFT
from sitewright.interaction_twin.reach.view import Frame, Side, extent
from sitewright.interaction_twin.report.svg import element, picture, text
from sitewright.planning_twin.reachability.report import ReachReport

_LEFT, _TOP, _GAP, _COLUMN = 40.0, 84.0, 46.0, 330.0
_WIDEST, _HIGHEST = 900.0, 1100.0


def reach_picture(report: ReachReport, labels: Labels, title: str) -> str:
    """Return the picture as an SVG document.

    Args:
        report: The check.
        labels: Names that people know.
        title: What it is a picture of, e.g. the project's name.
    """
    drawing = drawing_of(report, labels, title)
    plan, elevation = _frames(drawing)
    right = plan.left_px + plan.width_px + 36.0
    height = elevation.top_px + elevation.height_px + 44.0
    parts = [
        text(f"Reach: {title}", _LEFT, 38.0, font_size=22, font_weight="bold", fill=INK),
        text(headline(report), _LEFT, 60.0, font_size=13, fill=SOFT),
        *_view(drawing, plan, Side.PLAN, "Plan (x to the right, y up)"),
        *_view(drawing, elevation, Side.ELEVATION, "Elevation (x to the right, z up)"),
        *margin_column(report, drawing, labels, (right, _TOP), height),
    ]
    return picture(right + _COLUMN, height, f"Reach of {title}", parts)


def _frames(drawing: Drawing) -> tuple[Frame, Frame]:
    """Return where plan and elevation are, to one scale."""
    low, high = extent(_shown(drawing))
    wide, deep, tall = (b - a for a, b in zip(low, high, strict=True))
    scale = min(_WIDEST / wide, _HIGHEST / (deep + tall))
    plan = Frame(_LEFT, _TOP + 18.0, (low[0], low[1]), (high[0], high[1]), scale)
    top = plan.top_px + plan.height_px + _GAP
    return plan, Frame(_LEFT, top, (low[0], low[2]), (high[0], high[2]), scale)


def _shown(drawing: Drawing) -> Iterator[Outline]:
    """Yield what must fit into the views; a wide floor need not."""
    bodies = (*drawing.targets, *drawing.stock, *drawing.zones)
    yield from (d.outline for d in bodies)
    for robot in drawing.robots:
        yield from robot.links
    yield from (d.outline for d in drawing.fixtures if not d.is_floor)


def _view(drawing: Drawing, frame: Frame, side: Side, caption: str) -> Iterator[str]:
    clip = f"clip-{side.value}"
    x, y = frame.left_px, frame.top_px
    box = element("rect", x=x, y=y, width=frame.width_px, height=frame.height_px)
    yield element("clipPath", box, id=clip)
    yield text(caption, x, y - 8.0, font_size=12, fill=SOFT)
    yield element("g", "".join(layers(drawing, frame, side)), clip_path=f"url(#{clip})")
    yield element(
        "rect",
        x=x,
        y=y,
        width=frame.width_px,
        height=frame.height_px,
        fill="none",
        stroke="#aeb9c5",
    )
