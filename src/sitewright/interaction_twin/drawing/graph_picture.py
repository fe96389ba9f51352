"""The construction relationship graph as a picture: the jobsite below, what rests on it above."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sitewright.building_model.component import Layer
from sitewright.construction_graph.graph import JOBSITE, ConstructionGraph, Node
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.drawing.graph_layout import GraphLayout, graph_layout
from sitewright.interaction_twin.drawing.palette import INK
from sitewright.interaction_twin.drawing.svg import element, picture, shortened, text, tooltip
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook

_MARGIN, _BETWEEN, _LEGEND = 14.0, 12.0, 18.0
_CHAR, _END = 0.55, 4
_EDGE, _ROOT = "#9aa8b0", "#33485a"
_FILL: Mapping[Layer, str] = {
    Layer.TARGET: "#ffffff",
    Layer.MATERIAL: "#f5ecd9",
    Layer.AS_BUILT: "#ead6b4",
    Layer.AS_DESIGNED: "#eef1f3",
    Layer.VIRTUAL_COLLISION: "#f7dcd6",
}
_STROKE: Mapping[Layer, str] = {
    Layer.TARGET: "#4f8cc6",
    Layer.MATERIAL: "#c6a06c",
    Layer.AS_BUILT: "#93682f",
    Layer.AS_DESIGNED: "#98a3ab",
    Layer.VIRTUAL_COLLISION: "#c9543f",
}
_BUILDING = (Layer.TARGET, Layer.AS_BUILT)


@dataclass(frozen=True, slots=True, kw_only=True)
class GraphStyle:
    """What a graph looks like where it is shown.

    Attributes:
        box_px: Width of a node.
        height_px: Height of a node.
        row_px: From one row to the next.
    """

    box_px: float = 118.0
    height_px: float = 26.0
    row_px: float = 60.0
    font_px: float = 10.5
    book: Phrasebook = ENGLISH


REPORT = GraphStyle()


def for_fingers(book: Phrasebook) -> GraphStyle:
    """Return the style of a page: nodes that a finger finds."""
    return GraphStyle(box_px=150.0, height_px=48.0, row_px=80.0, font_px=13.0, book=book)


def building_of(graph: ConstructionGraph) -> ConstructionGraph:
    """Return what is built or to be built, without stock and keep-out volumes."""
    kept = {i: n for i, n in graph.node_by_id.items() if n.layer in _BUILDING}
    return ConstructionGraph(node_by_id=kept)


def graph_picture(graph: ConstructionGraph, style: GraphStyle = REPORT) -> str:
    """Return the graph as an SVG document: an edge goes from a node to what it rests on.

    Nodes are groups with ``data-component``, from the jobsite up and from left to right.
    """
    layout = graph_layout(graph)
    rows = max(layout.row.values(), default=0) + 1
    columns = max(layout.column.values(), default=0.0) + 1.0
    width = max(2 * _MARGIN + columns * (style.box_px + _BETWEEN), 460.0)
    height = 2 * _MARGIN + rows * style.row_px + _LEGEND
    centres = _centres(layout, rows, style)
    nodes = sorted(graph.node_by_id.values(), key=lambda n: (layout.row[n.id], layout.column[n.id]))
    parts = [line for node in nodes for line in _edges(node, centres, style)]
    parts += [_jobsite(centres[JOBSITE], style)]
    parts += [_node(node, centres[node.id], style) for node in nodes]
    parts += _legend(nodes, height, style)
    return picture(width, height, style.book.page["graph"], parts)


Point = tuple[float, float]


def _centres(layout: GraphLayout, rows: int, style: GraphStyle) -> dict[ComponentId, Point]:
    """Return the centre of every box in pixels."""
    return {
        component: (
            _MARGIN + (column + 0.5) * (style.box_px + _BETWEEN),
            _MARGIN + (rows - layout.row[component] - 0.5) * style.row_px,
        )
        for component, column in layout.column.items()
    }


def _edges(node: Node, centres: Mapping[ComponentId, Point], style: GraphStyle) -> Iterator[str]:
    x, y = centres[node.id]
    for parent in node.construction_parents:
        if parent in centres:
            px, py = centres[parent]
            top, bottom = y + style.height_px / 2.0, py - style.height_px / 2.0
            half = (top + bottom) / 2.0
            curve = (
                f"M{x:.1f} {top:.1f} C{x:.1f} {half:.1f} {px:.1f} {half:.1f} {px:.1f} {bottom:.1f}"
            )
            yield element("path", d=curve, fill="none", stroke=_EDGE, stroke_width=1.2)


def _node(node: Node, centre: Point, style: GraphStyle) -> str:
    used = f", {node.material_used}" if node.material_used else ""
    layer = style.book.page[f"layer-{node.layer}"]
    words = f"{node.label} ({node.id}), {layer}, {node.type}{used}"
    fill, stroke = _FILL[node.layer], _STROKE[node.layer]
    box = _box(centre, style, rx=5, fill=fill, stroke=stroke, stroke_width=1.4)
    label = _label(_fitted(node.label, style), centre, style, INK)
    return element("g", tooltip(words) + box + label, class_="node", data_component=node.id)


def _fitted(name: str, style: GraphStyle) -> str:
    """Return a name that fits into a box; its end stays, since numbers stand there."""
    room, char_px = style.box_px - 8.0, style.font_px * _CHAR
    if len(name) * char_px <= room:
        return name
    end = name[-_END:]
    return shortened(name[:-_END] + " " * _END, room - _END * char_px, char_px=char_px) + end


def _jobsite(centre: Point, style: GraphStyle) -> str:
    name = style.book.page["jobsite"]
    box = _box(centre, style, rx=style.height_px / 2.0, fill=_ROOT)
    return element("g", tooltip(name) + box + _label(name, centre, style, "#ffffff"))


def _box(centre: Point, style: GraphStyle, **look: str | float) -> str:
    x, y = centre[0] - style.box_px / 2.0, centre[1] - style.height_px / 2.0
    return element("rect", x=x, y=y, width=style.box_px, height=style.height_px, **look)


def _label(name: str, centre: Point, style: GraphStyle, colour: str) -> str:
    x, y = centre
    size = style.font_px
    return text(name, x, y + size / 3.0, font_size=size, text_anchor="middle", fill=colour)


def _legend(nodes: Sequence[Node], height: float, style: GraphStyle) -> Iterator[str]:
    x, y = _MARGIN, height - 18.0
    for layer in [layer for layer in Layer if any(n.layer is layer for n in nodes)]:
        words = style.book.page[f"layer-{layer}"]
        fill, stroke = _FILL[layer], _STROKE[layer]
        yield element("rect", x=x, y=y, width=12, height=10, rx=2, fill=fill, stroke=stroke)
        yield text(words, x + 17.0, y + 9.0, font_size=11)
        x += 36.0 + 6.4 * len(words)
