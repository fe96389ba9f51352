"""The construction relationship graph as indented text."""

from __future__ import annotations

from sitewright.building_model.component import Layer
from sitewright.construction_graph.graph import JOBSITE, ConstructionGraph, Node
from sitewright.foundation.ids import ComponentId

_MARK = {Layer.TARGET: "[ ]", Layer.AS_BUILT: "[x]", Layer.MATERIAL: " = "}


def text_graph(graph: ConstructionGraph) -> tuple[str, ...]:
    """Return the graph as lines: what rests on something stands below it, further in.

    A node with two construction parents is written out under the first one of them in order of
    id, and named with the others.
    """
    above: dict[ComponentId, list[Node]] = {}
    for node in sorted(graph.node_by_id.values(), key=lambda n: n.id):
        first = min(node.construction_parents, default=JOBSITE)
        above.setdefault(first, []).append(node)
    lines = ["jobsite"]

    def write(parent: ComponentId, depth: int) -> None:
        for node in above.get(parent, ()):
            lines.append(f"{'  ' * depth}{_MARK.get(node.layer, '   ')} {_words(node)}")
            write(node.id, depth + 1)

    write(JOBSITE, 1)
    return tuple(lines)


def _words(node: Node) -> str:
    others = sorted(node.construction_parents)[1:]
    also = f", also on {', '.join(others)}" if others else ""
    used = f", made of {node.material_used}" if node.material_used else ""
    return f"{node.id} ({node.type}{also}{used})"
