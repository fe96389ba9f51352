"""The construction relationship graph as a picture: the jobsite below, what rests on it above."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sitewright.building_model.component import Layer
from sitewright.construction_graph.graph import JOBSITE, ConstructionGraph, Node
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.report.svg import element, picture, shortened, text, tooltip

_BOX, _HEIGHT, _COLUMN, _ROW, _MARGIN = 104.0, 26.0, 116.0, 60.0, 14.0
_FILL: Mapping[Layer, str] = {
    Layer.TARGET: "#ffffff",
    Layer.MATERIAL: "#e9dcc3",
    Layer.AS_BUILT: "#bcdcc4",
    Layer.AS_DESIGNED: "#eef1f5",
    Layer.VIRTUAL_COLLISION: "#f3d5d2",
}
_STROKE: Mapping[Layer, str] = {
    Layer.TARGET: "#2f6fab",
    Layer.MATERIAL: "#9a7b45",
    Layer.AS_BUILT: "#3f8f5f",
    Layer.AS_DESIGNED: "#8b98a8",
    Layer.VIRTUAL_COLLISION: "#c0392b",
}
_WORDS: Mapping[Layer, str] = {
    Layer.TARGET: "target",
    Layer.MATERIAL: "material",
    Layer.AS_BUILT: "as built",
    Layer.AS_DESIGNED: "as designed",
    Layer.VIRTUAL_COLLISION: "virtual collision",
}


@dataclass(frozen=True, slots=True)
class _Layout:
    """Column and row (0 is the jobsite) of every node."""

    column: Mapping[ComponentId, float]
    row: Mapping[ComponentId, int]


def graph_picture(graph: ConstructionGraph) -> str:
    """Return the graph as an SVG document: an edge goes from a node to what it rests on."""
    layout = _layout(graph)
    rows = max(layout.row.values(), default=0) + 1
    columns = max(layout.column.values(), default=0.0) + 1.0
    width = max(2 * _MARGIN + columns * _COLUMN, 460.0)
    height = 2 * _MARGIN + rows * _ROW + 18.0
    centres = _centres(layout, rows)
    nodes = sorted(graph.node_by_id.values(), key=lambda n: n.id)
    parts = [line for node in nodes for line in _edges(node, centres)]
    parts += [_node(node, centres[node.id]) for node in nodes]
    parts += [_jobsite(centres[JOBSITE]), *_legend(nodes, height)]
    return picture(width, height, "Construction relationship graph", parts)


Point = tuple[float, float]


def _centres(layout: _Layout, rows: int) -> dict[ComponentId, Point]:
    """Return the centre of every box in pixels."""
    return {
        component: (
            _MARGIN + (column + 0.5) * _COLUMN,
            _MARGIN + (rows - layout.row[component] - 0.5) * _ROW,
        )
        for component, column in layout.column.items()
    }


def _layout(graph: ConstructionGraph) -> _Layout:
    row = _rows(graph)
    members: dict[int, list[ComponentId]] = {}
    for component in sorted(row):
        members.setdefault(row[component], []).append(component)
    widest = max((len(m) for m in members.values()), default=1)
    column: dict[ComponentId, float] = {}
    for number in sorted(members):
        ordered = sorted(members[number], key=lambda c: (_wished(graph, c, column), c))
        column |= _spread(graph, ordered, column, widest)
    return _Layout(column, row)


def _rows(graph: ConstructionGraph) -> dict[ComponentId, int]:
    """Return the longest way to the jobsite; the graph is acyclic."""
    row: dict[ComponentId, int] = {JOBSITE: 0}

    def height(component: ComponentId) -> int:
        if component not in row:
            node = graph.node_by_id.get(component)
            parents = node.construction_parents if node is not None else ()
            row[component] = 1 + max((height(p) for p in parents), default=0)
        return row[component]

    for component in sorted(graph.node_by_id):
        height(component)
    return {c: r for c, r in row.items() if c == JOBSITE or c in graph.node_by_id}


def _wished(
    graph: ConstructionGraph, component: ComponentId, column: Mapping[ComponentId, float]
) -> float:
    """Return the mean column of what a node rests on; targets stand left of the stock."""
    node = graph.node_by_id.get(component)
    if node is None:
        return 0.0
    below = [column[p] for p in node.construction_parents if p in column and p != JOBSITE]
    if below:
        return sum(below) / len(below)
    return 1e6 if node.layer is Layer.MATERIAL else -1.0


def _spread(
    graph: ConstructionGraph,
    ordered: Sequence[ComponentId],
    column: Mapping[ComponentId, float],
    widest: int,
) -> dict[ComponentId, float]:
    """Give each node of a row a column near its wish, none closer than one to the next."""
    if list(ordered) == [JOBSITE]:
        return {JOBSITE: (widest - 1) / 2.0}
    found: dict[ComponentId, float] = {}
    last = -1.0
    for component in ordered:
        wish = _wished(graph, component, column)
        free = last + 1.0
        last = max(free, wish) if 0.0 <= wish < 1e6 else free  # noqa: PLR2004 -- no wish
        found[component] = last
    overhang = last - (widest - 1)
    return {c: max(x - max(overhang, 0.0), float(i)) for i, (c, x) in enumerate(found.items())}


def _edges(node: Node, centres: Mapping[ComponentId, Point]) -> Iterator[str]:
    x, y = centres[node.id]
    for parent in node.construction_parents:
        if parent in centres:
            px, py = centres[parent]
            top, bottom = y + _HEIGHT / 2.0, py - _HEIGHT / 2.0
            half = (top + bottom) / 2.0
            curve = (
                f"M{x:.1f} {top:.1f} C{x:.1f} {half:.1f} {px:.1f} {half:.1f} {px:.1f} {bottom:.1f}"
            )
            yield element("path", d=curve, fill="none", stroke="#9aa8b8", stroke_width=1.2)


def _node(node: Node, centre: Point) -> str:
    x, y = centre
    used = f", made of {node.material_used}" if node.material_used else ""
    words = f"{node.label} ({node.id}), {_WORDS[node.layer]}, {node.type}{used}"
    box = element(
        "rect",
        x=x - _BOX / 2.0,
        y=y - _HEIGHT / 2.0,
        width=_BOX,
        height=_HEIGHT,
        rx=5,
        fill=_FILL[node.layer],
        stroke=_STROKE[node.layer],
        stroke_width=1.4,
    )
    room, char_px = _BOX - 8.0, 5.7
    fits = len(node.label) * char_px <= room
    name = node.label if fits else shortened(node.id, room, char_px=char_px)
    label = text(name, x, y + 4.0, font_size=10.5, text_anchor="middle")
    return element("g", tooltip(words) + box + label)


def _jobsite(centre: Point) -> str:
    x, y = centre
    box = element(
        "rect",
        x=x - _BOX / 2.0,
        y=y - _HEIGHT / 2.0,
        width=_BOX,
        height=_HEIGHT,
        rx=13,
        fill="#34495e",
    )
    name = text("Jobsite", x, y + 4.0, font_size=11, text_anchor="middle", fill="#ffffff")
    return element("g", tooltip("The jobsite, root of the graph") + box + name)


def _legend(nodes: Sequence[Node], height: float) -> Iterator[str]:
    x = _MARGIN
    for layer in [layer for layer in Layer if any(n.layer is layer for n in nodes)]:
        words = _WORDS[layer]
        yield element(
            "rect",
            x=x,
            y=height - 18.0,
            width=12,
            height=10,
            rx=2,
            fill=_FILL[layer],
            stroke=_STROKE[layer],
        )
        yield text(words, x + 17.0, height - 9.0, font_size=11)
        x += 36.0 + 6.4 * len(words)
