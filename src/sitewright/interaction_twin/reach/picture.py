"""The reach check as a picture: plan, elevation, legend, and what nobody reaches."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sitewright.foundation.pose import Vector
from sitewright.interaction_twin.drawing.svg import element, picture, text
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.reach.drawing import Drawing, drawing_of
from sitewright.interaction_twin.reach.layers import layers
from sitewright.interaction_twin.reach.lines import headline
from sitewright.interaction_twin.reach.margin import margin_column
from sitewright.interaction_twin.reach.outline import Outline
from sitewright.interaction_twin.reach.palette import INK, SOFT
from sitewright.interaction_twin.reach.view import Frame, Side, extent
from sitewright.planning_twin.reachability.report import ReachReport

_LEFT, _TOP, _GAP, _COLUMN = 40.0, 84.0, 46.0, 330.0
_WIDEST, _HIGHEST = 900.0, 1100.0
_CAPTIONS = {
    Side.PLAN: "Plan (x to the right, y up)",
    Side.ELEVATION: "Elevation (x to the right, z up)",
}
Arrow = tuple[Vector, Vector]


def reach_picture(report: ReachReport, labels: Labels, title: str) -> str:
    """Return the picture as an SVG document.

    Args:
        report: The check.
        labels: Names that people know.
        title: What it is a picture of, e.g. the project's name.
    """
    inside, (width, height) = sized_picture(report, labels, f"Reach: {title}", key="reach")
    return picture(width, height, f"Reach of {title}", [inside])


def sized_picture(
    report: ReachReport,
    labels: Labels,
    title: str,
    *,
    key: str,
    arrows: tuple[Arrow, ...] = (),
) -> tuple[str, tuple[float, float]]:
    """Return the inside of the picture, and its width and height.

    Args:
        report: The check.
        labels: Names that people know.
        title: Words above it.
        key: Tells it from other pictures in the same document.
        arrows: From where to where things are to be moved, drawn in the plan.
    """
    drawing = drawing_of(report, labels)
    plan, elevation = _frames(drawing)
    right = plan.left_px + plan.width_px + 36.0
    height = elevation.top_px + elevation.height_px + 44.0
    parts = [
        text(title, _LEFT, 38.0, font_size=22, font_weight="bold", fill=INK),
        text(headline(report), _LEFT, 60.0, font_size=13, fill=SOFT),
        *_view(drawing, plan, Side.PLAN, f"{key}-plan"),
        *_view(drawing, elevation, Side.ELEVATION, f"{key}-elevation"),
        *(_arrow(plan, arrow) for arrow in arrows),
        *margin_column(report, drawing, labels, (right, _TOP), height),
    ]
    return "".join(parts), (right + _COLUMN, height)


def _arrow(frame: Frame, arrow: Arrow) -> str:
    """Return an arrow with a head, in the plan."""
    (x, y), (u, v) = (frame.at(Side.PLAN.point(p)) for p in arrow)
    angle = math.atan2(v - y, u - x)
    wings = [(u - 9.0 * math.cos(angle + w), v - 9.0 * math.sin(angle + w)) for w in (0.45, -0.45)]
    head = f"M{u:.1f} {v:.1f}L" + "L".join(f"{a:.1f} {b:.1f}" for a, b in wings) + "Z"
    line = element("line", x1=x, y1=y, x2=u, y2=v, stroke=INK, stroke_width=2)
    return line + element("path", d=head, fill=INK)


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


def _view(drawing: Drawing, frame: Frame, side: Side, clip: str) -> Iterator[str]:
    x, y = frame.left_px, frame.top_px
    box = element("rect", x=x, y=y, width=frame.width_px, height=frame.height_px)
    yield element("clipPath", box, id=clip)
    yield text(_CAPTIONS[side], x, y - 8.0, font_size=12, fill=SOFT)
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
