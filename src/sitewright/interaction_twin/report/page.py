"""The report page: one self-contained file without scripts, made for the screen and for paper."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from datetime import UTC, datetime
from html import escape

from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.interaction_twin.drawing.gantt import gantt
from sitewright.interaction_twin.drawing.graph_picture import graph_picture
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import counted, in_millimetres, in_seconds
from sitewright.interaction_twin.report.cards import (
    figure_cards,
    milliradians,
    tenths_of_millimetres,
)
from sitewright.interaction_twin.report.content import Figures, RunSummary
from sitewright.interaction_twin.report.style import STYLE

_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
_LAST_TWO = frozenset({1, 2})
_ENDED: Mapping[str, str] = {
    "complete": "Complete",
    "finished": "Finished, not complete",
    "held": "Held",
    "open": "Open",
}


def report_page(
    summary: RunSummary, before: ConstructionGraph, after: ConstructionGraph, labels: Labels
) -> str:
    """Return the report as one HTML document that asks for nothing from outside.

    Args:
        summary: The run.
        before: Graph when the run began.
        after: Graph at its end.
        labels: Names that people see.
    """
    body = "".join(
        (
            _head(summary),
            figure_cards(summary.figures),
            _section("Schedule", _schedule(summary, labels)),
            _section("Where the time went", _times(summary, labels)),
            _section("Construction graph", _graphs(before, after)),
            _section("As built", _as_built(summary, labels)),
            _section("Plans", _plans(summary, labels)),
            _section("Planning times", _planning(summary.figures)),
            _section("Approvals and decisions", _decisions(summary)),
            _section("Refusals and deviations", _refusals(summary, labels)),
            _section("Contacts that were not allowed", _contacts(summary)),
            _foot(summary),
        )
    )
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{_e(summary.project)}: run {_e(summary.run)}</title><style>{STYLE}</style></head>"
        f"<body><main>{body}</main></body></html>\n"
    )


def _e(words: object) -> str:
    return escape(str(words))


def _section(title: str, content: str) -> str:
    return f"<section><h2>{_e(title)}</h2>{content}</section>"


def _head(summary: RunSummary) -> str:
    chain = f" It continues run {_e(summary.continues)}." if summary.continues else ""
    resumed = f" It was resumed {counted(summary.resumed, 'time')}." if summary.resumed else ""
    return (
        f"<h1>{_e(summary.project)}</h1>"
        f'<p class="lead">Run {_e(summary.run)}, begun {_utc(summary.started_utc_ns)}, last event '
        f"{_utc(summary.ended_utc_ns)}.{chain}{resumed}</p>"
        f'<p><span class="state {_e(summary.ended)}">{_ENDED[summary.ended]}</span> '
        f"{_e(summary.ending_note)}</p>"
    )


def _utc(time_ns: int) -> str:
    moment = datetime.fromtimestamp(time_ns / 1e9, tz=UTC)
    return moment.strftime("%Y-%m-%d %H:%M:%S UTC")


def _schedule(summary: RunSummary, labels: Labels) -> str:
    if not summary.actual and not summary.planned:
        return "<p>No skill was started.</p>"
    return f'<div class="picture schedule">{gantt(summary.planned, summary.actual, labels)}</div>'


def _times(summary: RunSummary, labels: Labels) -> str:
    whole_s = sum(summary.spent_s.values()) or 1.0
    causes = (
        (cause, in_seconds(spent_s), f"{spent_s / whole_s:.0%}")
        for cause, spent_s in sorted(summary.spent_s.items(), key=lambda c: -c[1])
    )
    by_cause = _table(("On the clock on the wall", "Time", "Share"), causes, numbers=_LAST_TWO)
    rows = (
        (labels.name(t.robot), *map(in_seconds, (t.works_s, t.holds_s, t.waits_s, t.still_s)))
        for t in summary.robot_times
    )
    heads = ("On the cell's clock", "at work", "holds a piece", "waits for another", "all stand")
    by_robot = _table(heads, rows, numbers=frozenset({1, 2, 3, 4}))
    return f'<div class="two"><div>{by_cause}</div><div>{by_robot}</div></div>'


def _graphs(before: ConstructionGraph, after: ConstructionGraph) -> str:
    return (
        '<div class="two">'
        f'<div class="picture"><p>Before</p>{graph_picture(before)}</div>'
        f'<div class="picture"><p>After</p>{graph_picture(after)}</div></div>'
    )


def _table(heads: Sequence[str], rows: Iterable[Sequence[str]], *, numbers: frozenset[int]) -> str:
    """Return a table; columns in `numbers` stand to the right."""
    lines = [tuple(row) for row in rows]
    if not lines:
        return "<p>None.</p>"
    mark = {c: ' class="n"' if c in numbers else "" for c in range(len(heads))}
    head = "".join(f"<th{mark[c]}>{_e(h)}</th>" for c, h in enumerate(heads))
    body = "".join(
        f"<tr>{''.join(f'<td{mark[c]}>{_e(cell)}</td>' for c, cell in enumerate(row))}</tr>"
        for row in lines
    )
    table = f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
    return f'<div class="wide">{table}</div>'


def _as_built(summary: RunSummary, labels: Labels) -> str:
    heads = ("Component", "State", "Piece", "Robot", "Operations", "Position", "Angle", "Note")
    rows = (
        (
            labels.name(b.target),
            b.status,
            labels.name(b.piece) if b.piece else "",
            labels.name(b.robot) if b.robot else "",
            f"{b.operations_done}/{b.operations_total}",
            tenths_of_millimetres(b.position_error_m),
            milliradians(b.angle_error_rad),
            labels.told(b.note),
        )
        for b in summary.built
    )
    return _table(heads, rows, numbers=frozenset({4, 5, 6}))


def _plans(summary: RunSummary, labels: Labels) -> str:
    heads = ("For", "Plan", "Steps", "Duration", "Closest distance", "Planned in")
    rows = (
        (
            labels.name(p.target),
            p.code,
            str(p.steps),
            in_seconds(p.duration_s),
            in_millimetres(p.closest_distance_m),
            in_seconds(p.planning_s),
        )
        for p in summary.plans
    )
    return _table(heads, rows, numbers=frozenset({2, 3, 4, 5}))


def _planning(figures: Figures) -> str:
    rows = ((name, f"{spent_s:.2f} s") for name, spent_s in figures.planning_s.items())
    return _table(("Part", "Time"), rows, numbers=frozenset({1}))


def _decisions(summary: RunSummary) -> str:
    rows = ((_utc(d.at_utc_ns), d.what, d.who, d.code, d.detail) for d in summary.decisions)
    return _table(("When", "What", "Who", "Plan", "Detail"), rows, numbers=frozenset())


def _refusals(summary: RunSummary, labels: Labels) -> str:
    rows = [
        (labels.name(r.target), r.kind, *map(labels.told, (r.reason, r.verdict, r.then)))
        for r in summary.refusals
    ]
    rows += [
        (d.partition(": ")[0], "deviation", d.partition(": ")[2], "", "")
        for d in summary.deviations
    ]
    heads = ("About", "Kind", "Reason", "How sure", "Instead")
    return _table(heads, rows, numbers=frozenset())


def _contacts(summary: RunSummary) -> str:
    if summary.figures.unallowed_contacts is None:
        return "<p>The cell has not told yet.</p>"
    return _table(("Body", "Body", "During"), summary.contacts, numbers=frozenset())


def _foot(summary: RunSummary) -> str:
    hashes = ", ".join(f"{name} {value[:12]}" for name, value in sorted(summary.hashes.items()))
    return (
        f"<footer>{_e(hashes)}<br>Times of the schedule are those of the cell's clock. "
        "Distances are proven lower bounds of certified motions, declared contacts left out. "
        "This report is no safety document.</footer>"
    )
