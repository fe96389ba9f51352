"""The schedule as a picture: two lanes per robot, planned above (outline) and actual (solid)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import in_seconds
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.report.content import Bar
from sitewright.interaction_twin.report.svg import element, picture, shortened, text, tooltip
from sitewright.robot_team.skill import Skill

_WIDTH, _LEFT, _TOP, _LANE, _GAP = 1120.0, 96.0, 46.0, 22.0, 22.0
_TICKS = 8
_STEPS_S = (1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600)

_MOVING, _HANDLING, _FASTENING, _FINISHING, _CHANGING = (
    "#9fb3c8",
    "#2f6fab",
    "#d9822b",
    "#3f8f5f",
    "#7d5ba6",
)
_FAILED, _OTHER = "#c0392b", "#5c6b7a"
_COLOUR: Mapping[str, str] = {
    Skill.REACH: _MOVING,
    Skill.RETRACT: _MOVING,
    Skill.GRASP: _HANDLING,
    Skill.POSITION: _HANDLING,
    Skill.SET_DOWN: _HANDLING,
    Skill.RELEASE: _HANDLING,
    Skill.FASTEN: _FASTENING,
    Skill.APPLY_FINISH: _FINISHING,
    Skill.CHANGE_END_EFFECTOR: _CHANGING,
}
_LEGEND = (
    ("moves", _MOVING),
    ("handles", _HANDLING),
    ("fastens", _FASTENING),
    ("paints", _FINISHING),
    ("changes its tool", _CHANGING),
    ("failed", _FAILED),
)


@dataclass(frozen=True, slots=True)
class _Axis:
    """Seconds to pixels."""

    end_s: float

    def x(self, time_s: float) -> float:
        return _LEFT + (_WIDTH - _LEFT - 12.0) * time_s / max(self.end_s, 1e-9)


def gantt(planned: Sequence[Bar], actual: Sequence[Bar], labels: Labels) -> str:
    """Return the schedule by robot as an SVG document."""
    bars = (*planned, *actual)
    robots = sorted({b.robot for b in bars})
    axis = _Axis(max((b.starts_s + b.duration_s for b in bars), default=1.0))
    height = _TOP + len(robots) * (2 * _LANE + _GAP) + 44.0
    parts = [*_targets(actual or planned, axis, labels, height), *_ticks(axis, height)]
    for row, robot in enumerate(robots):
        top = _TOP + row * (2 * _LANE + _GAP)
        parts.append(text(labels.name(robot), 8.0, top + _LANE + 4.0, font_weight="bold"))
        parts += [_outline(b, axis, top, labels) for b in planned if b.robot == robot]
        parts += [_solid(b, axis, top + _LANE, labels) for b in actual if b.robot == robot]
    parts += _legend(height)
    return picture(_WIDTH, height, "Schedule by robot: planned (outline) and actual (solid)", parts)


def _outline(bar: Bar, axis: _Axis, top: float, labels: Labels) -> str:
    return _box(bar, axis, top, labels, fill="none", stroke=_COLOUR.get(bar.call.skill, _OTHER))


def _solid(bar: Bar, axis: _Axis, top: float, labels: Labels) -> str:
    colour = _COLOUR.get(bar.call.skill, _OTHER) if bar.is_done else _FAILED
    return _box(bar, axis, top, labels, fill=colour, stroke="#ffffff")


def _box(bar: Bar, axis: _Axis, top: float, labels: Labels, *, fill: str, stroke: str) -> str:
    left, right = axis.x(bar.starts_s), axis.x(bar.starts_s + bar.duration_s)
    state = "" if bar.is_done else " (failed)"
    words = f"{narrate(bar.call, labels)}: {in_seconds(bar.duration_s)}{state}"
    return element(
        "rect",
        tooltip(words),
        x=left,
        y=top + 1.0,
        width=max(right - left, 1.0),
        height=_LANE - 3.0,
        rx=2,
        fill=fill,
        stroke=stroke,
        stroke_width=0.8,
    )


def _targets(bars: Sequence[Bar], axis: _Axis, labels: Labels, height: float) -> Iterator[str]:
    """Shade the time of every other target and write its name on top."""
    spans: list[tuple[str, float, float]] = []
    for bar in sorted(bars, key=lambda b: b.starts_s):
        end_s = bar.starts_s + bar.duration_s
        if spans and spans[-1][0] == bar.target:
            spans[-1] = (bar.target, spans[-1][1], max(spans[-1][2], end_s))
        else:
            spans.append((bar.target, bar.starts_s, end_s))
    for number, (target, start_s, end_s) in enumerate(spans):
        left, right = axis.x(start_s), axis.x(end_s)
        if number % 2 == 0:
            yield element(
                "rect", x=left, y=22, width=right - left, height=height - 62.0, fill="#f1f4f8"
            )
        name = shortened(labels.name(target), right - left - 4.0)
        if name:
            yield text(name, left + 3.0, 36.0, font_size=11, fill="#44566c")


def _ticks(axis: _Axis, height: float) -> Iterator[str]:
    step_s = next((s for s in _STEPS_S if axis.end_s / s <= _TICKS), _STEPS_S[-1])
    bottom = height - 40.0
    for number in range(int(axis.end_s // step_s) + 1):
        x = axis.x(float(number * step_s))
        yield element("line", x1=x, y1=_TOP - 4.0, x2=x, y2=bottom, stroke="#d5dde6")
        label = f"{number * step_s} s"
        yield text(label, x, bottom + 12.0, font_size=10, text_anchor="middle", fill="#5c6b7a")


def _legend(height: float) -> Iterator[str]:
    x = _LEFT
    for words, colour in _LEGEND:
        yield element("rect", x=x, y=height - 18.0, width=12, height=10, rx=2, fill=colour)
        yield text(words, x + 17.0, height - 9.0, font_size=11)
        x += 36.0 + 6.4 * len(words)
    note = "above: planned, below: actual"
    yield text(note, _WIDTH - 12.0, height - 9.0, font_size=11, text_anchor="end", fill="#5c6b7a")
