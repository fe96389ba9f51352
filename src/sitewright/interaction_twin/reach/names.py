"""The names in one view of the reach picture; where two would overlap, the first one stays."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from sitewright.interaction_twin.drawing.svg import Attribute, element, shortened, text
from sitewright.interaction_twin.reach.drawing import Drawing, Drawn
from sitewright.interaction_twin.reach.outline import Point
from sitewright.interaction_twin.reach.palette import INK, PAPER, STOCK_NAME
from sitewright.interaction_twin.reach.view import Frame, Side

_SMALLEST_PX, _SIZE_PX, _CHAR_PX, _BIG_PX = 26.0, 9.0, 5.2, 11.0


@dataclass(slots=True)
class _Taken:
    """Rectangles that names cover already, as left, top, right, bottom."""

    boxes: list[tuple[float, float, float, float]] = field(default_factory=list)

    def take(self, at: Point, wide: float, tall: float) -> bool:
        """Return whether a rectangle about a point is free, and take it if so."""
        left, top = at[0] - wide / 2.0, at[1] - tall / 2.0
        right, bottom = left + wide, top + tall
        if any(a < right and left < c and b < bottom and top < d for a, b, c, d in self.boxes):
            return False
        self.boxes.append((left, top, right, bottom))
        return True


def names(drawing: Drawing, frame: Frame, side: Side) -> Iterator[str]:
    """Yield the names of robots and stock places, then of the targets in front."""
    taken = _Taken()
    for robot in drawing.robots:
        x, y = frame.at(side.point(robot.world_T_base.position_m))
        if side is Side.PLAN:
            yield element("circle", cx=x, cy=y, r=3.5, fill=robot.colour, stroke=PAPER)
        yield from _big(robot.id, (x, y + 14.0), robot.colour, taken)
    if side is Side.PLAN:
        for place, at_m in sorted(drawing.places.items()):
            yield from _big(place, frame.at(side.point(at_m)), STOCK_NAME, taken)
    for body in sorted(drawing.targets, key=lambda d: -side.depth(d.outline)):
        yield from _small(body, frame, side, taken)


def _big(words: str, at: Point, colour: str, taken: _Taken) -> Iterator[str]:
    if taken.take(at, len(words) * 0.6 * _BIG_PX, _BIG_PX):
        bold: dict[str, Attribute] = {"font_weight": "bold"}
        yield _word(words, at, _BIG_PX, colour, bold)


def _small(body: Drawn, frame: Frame, side: Side, taken: _Taken) -> Iterator[str]:
    """Yield the name on a body, along its longer edge, if it is long enough for some of it."""
    low, high = side.point(body.outline.low_m), side.point(body.outline.high_m)
    wide, tall = ((b - a) * frame.px_per_m for a, b in zip(low, high, strict=True))
    words = shortened(body.label, max(wide, tall) - 8.0, char_px=_CHAR_PX)
    if not words or max(wide, tall) < _SMALLEST_PX:
        return
    at, length = frame.at(side.point(body.outline.middle_m)), len(words) * _CHAR_PX
    is_upright = tall > wide
    turn: dict[str, Attribute] = {}
    if is_upright:
        turn = {"transform": f"rotate(-90 {at[0]:.1f} {at[1]:.1f})"}
    if taken.take(at, *((_SIZE_PX, length) if is_upright else (length, _SIZE_PX))):
        yield _word(words, at, _SIZE_PX, INK, turn)


def _word(words: str, at: Point, size_px: float, colour: str, style: dict[str, Attribute]) -> str:
    """Return words in the middle of a point, with a light edge that keeps them legible."""
    return text(
        words,
        at[0],
        at[1] + 0.35 * size_px,
        font_size=size_px,
        fill=colour,
        text_anchor="middle",
        paint_order="stroke",
        stroke=PAPER,
        stroke_width=2.6,
        stroke_opacity=0.8,
        **style,
    )
