"""The schedule as a picture: two lanes per robot, planned above (outline) and actual (solid)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sitewright.foundation.ids import RobotId
from sitewright.interaction_twin.drawing.bars import Bar, robot_numbers
from sitewright.interaction_twin.drawing.palette import (
    FAILED,
    INK,
    LANE,
    LINE,
    SHADE,
    SOFT,
    robot_colour,
)
from sitewright.interaction_twin.drawing.svg import (
    Attribute,
    element,
    picture,
    shortened,
    text,
    tooltip,
)
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import in_seconds
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.robot_team.skill import Skill

_RIGHT, _GAP, _TICK_PX = 14.0, 8.0, 90.0
_STEPS_S = (1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200)
_MOVES = frozenset({Skill.REACH, Skill.RETRACT})
_FAINT, _TINT = 0.45, 0.16


@dataclass(frozen=True, slots=True, kw_only=True)
class GanttStyle:
    """What a schedule looks like where it is shown.

    Attributes:
        width_px: Of the whole picture.
        left_px: Room for the robots' numbers and names.
        lane_px: Height of one row of bars.
        has_notes: Targets are named above and colours are explained below.
    """

    width_px: float = 1120.0
    left_px: float = 118.0
    lane_px: float = 20.0
    has_notes: bool = True
    book: Phrasebook = ENGLISH


REPORT = GanttStyle()


def beside_a_picture(width_px: float, book: Phrasebook) -> GanttStyle:
    """Return the style of the strip below the 3D picture: low, robots by number only."""
    return GanttStyle(width_px=width_px, left_px=32.0, lane_px=15.0, has_notes=False, book=book)


@dataclass(frozen=True, slots=True)
class _Plot:
    """Where things are, in pixels."""

    style: GanttStyle
    end_s: float
    number_by_robot: Mapping[RobotId, int]

    @property
    def right(self) -> float:
        return self.style.width_px - _RIGHT

    @property
    def top(self) -> float:
        return 26.0 if self.style.has_notes else 4.0

    @property
    def bottom(self) -> float:
        return self.lane_top(len(self.number_by_robot) + 1) - _GAP / 2.0

    @property
    def height(self) -> float:
        return self.bottom + (44.0 if self.style.has_notes else 17.0)

    def x(self, time_s: float) -> float:
        left = self.style.left_px
        return left + (self.right - left) * time_s / self.end_s

    def lane_top(self, number: int) -> float:
        return self.top + (number - 1) * (2.0 * self.style.lane_px + _GAP)


def gantt(
    planned: Sequence[Bar], actual: Sequence[Bar], labels: Labels, style: GanttStyle = REPORT
) -> str:
    """Return the schedule by robot as an SVG document.

    Bars are ``class="planned"`` or ``"actual"`` with ``data-step`` and ``data-starts-s``; the
    root says by ``data-left``, ``data-right`` and ``data-end-s`` where which time is, for lines
    that are drawn over it.

    Args:
        planned: What was to be.
        actual: What ran, on the same axis.
        labels: Names that people see; their robots, in order, have the numbers from 1.
        style: Where it is shown.
    """
    bars = (*planned, *actual)
    end_s = max((b.ends_s for b in bars), default=0.0) or 10.0
    plot = _Plot(style, end_s, robot_numbers(labels, bars))
    parts = [
        *_lanes(plot, labels),
        *(_targets(actual or planned, plot, labels) if style.has_notes else ()),
        *_ticks(plot),
        *_robots("planned", planned, plot, labels),
        *_robots("actual", actual, plot, labels),
        *(_legend(plot) if style.has_notes else ()),
    ]
    axis = {"data_left": style.left_px, "data_right": plot.right, "data_end_s": round(end_s, 3)}
    return picture(style.width_px, plot.height, style.book.page["schedule"], parts, **axis)


def _lanes(plot: _Plot, labels: Labels) -> Iterator[str]:
    style = plot.style
    for robot, number in plot.number_by_robot.items():
        top, height = plot.lane_top(number), 2.0 * style.lane_px
        width = plot.right - style.left_px
        yield element("rect", x=style.left_px, y=top, width=width, height=height, rx=3, fill=LANE)
        middle = top + style.lane_px
        yield element("circle", cx=16.0, cy=middle, r=11, fill=robot_colour(number))
        bold: dict[str, Attribute] = {"font_size": 12, "font_weight": "bold"}
        yield text(str(number), 16.0, middle + 4.0, text_anchor="middle", fill="#ffffff", **bold)
        if style.has_notes:
            name = shortened(labels.name(robot), style.left_px - 38.0)
            yield text(name, 33.0, middle + 4.0, **bold)


def _robots(kind: str, bars: Sequence[Bar], plot: _Plot, labels: Labels) -> Iterator[str]:
    """Yield the bars of one kind, each robot's in a group of its colour."""
    for robot, number in plot.number_by_robot.items():
        own = [b for b in bars if b.robot == robot and (b.duration_s > 0.0 or kind == "actual")]
        top = plot.lane_top(number) + (plot.style.lane_px if kind == "actual" else 0.0)
        if own:
            colour = robot_colour(number)
            boxes = "".join(_box(kind, b, top, plot, labels) for b in own)
            yield element("g", boxes, fill=colour, stroke=colour)


def _box(kind: str, bar: Bar, top: float, plot: _Plot, labels: Labels) -> str:
    left, right = plot.x(bar.starts_s), plot.x(bar.ends_s)
    is_move = bar.call.skill in _MOVES
    faint = {"planned": 0.0 if is_move else _TINT, "actual": _FAINT if is_move else 1.0}[kind]
    has_failed = not bar.is_done
    wrong = {"fill": FAILED, "stroke": FAILED} if has_failed else {}
    return element(
        "rect",
        tooltip(_words(bar, plot.style.book, labels)),
        class_=kind,
        data_step=bar.step,
        data_starts_s=f"{bar.starts_s:.3f}",
        x=left + 0.5,
        y=top + 1.5,
        width=max(right - left - 1.0, 1.0),
        height=plot.style.lane_px - 3.0,
        rx=2,
        **({} if has_failed or faint == 1.0 else {"fill_opacity": faint}),
        **wrong,
    )


def _words(bar: Bar, book: Phrasebook, labels: Labels) -> str:
    number = f"{bar.step}. " if bar.step else ""
    failed = "" if bar.is_done else f" ({book.page['failed']})"
    return f"{number}{narrate(bar.call, labels, book)}: {in_seconds(bar.duration_s)}{failed}"


def _targets(bars: Sequence[Bar], plot: _Plot, labels: Labels) -> Iterator[str]:
    """Shade the time of every other target and write its name on top."""
    spans: list[tuple[str, float, float]] = []
    for bar in sorted(bars, key=lambda b: b.starts_s):
        if spans and spans[-1][0] == bar.target:
            spans[-1] = (bar.target, spans[-1][1], max(spans[-1][2], bar.ends_s))
        else:
            spans.append((bar.target, bar.starts_s, bar.ends_s))
    for number, (target, start_s, end_s) in enumerate(spans):
        left, right = plot.x(start_s), plot.x(end_s)
        if number % 2 == 0:
            height = plot.bottom - 4.0
            yield element(
                "rect", x=left, y=4, width=right - left, height=height, fill=SHADE, opacity=0.8
            )
        name = shortened(labels.name(target), right - left - 4.0)
        if name:
            yield text(name, left + 3.0, 18.0, font_size=11, fill=SOFT)


def _ticks(plot: _Plot) -> Iterator[str]:
    most = max((plot.right - plot.style.left_px) / _TICK_PX, 2.0)
    step_s = next((s for s in _STEPS_S if plot.end_s / s <= most), _STEPS_S[-1])
    for number in range(int(plot.end_s // step_s) + 1):
        x = plot.x(float(number * step_s))
        yield element("line", x1=x, y1=plot.top - 2.0, x2=x, y2=plot.bottom, stroke=LINE)
        label = f"{number * step_s} s"
        yield text(label, x, plot.bottom + 12.0, font_size=11, text_anchor="middle", fill=SOFT)


def _legend(plot: _Plot) -> Iterator[str]:
    """Explain outline and solid, faint and full, and what failed."""
    page, y, x = plot.style.book.page, plot.height - 19.0, plot.style.left_px
    looks = (
        ("planned", {"fill": INK, "fill_opacity": _TINT, "stroke": INK}),
        ("actual", {"fill": INK, "stroke": INK}),
        ("moves", {"fill": INK, "fill_opacity": _FAINT, "stroke": INK}),
        ("failed", {"fill": FAILED, "stroke": FAILED}),
    )
    for word, look in looks:
        yield element("rect", x=x, y=y, width=14, height=10, rx=2, **look)
        yield text(page[word], x + 19.0, y + 9.0, font_size=11)
        x += 42.0 + 6.4 * len(page[word])
