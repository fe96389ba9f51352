"""Tessellates what the analytic IFC reader leaves: the geometry kernel, on one thread.

The hybrid kernel is exact for planar solids and falls back for curved ones; two threads are
slower than one, and another kernel gave wrong half-space clips.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

_KERNEL = "hybrid-cgal-simple-opencascade"
MAX_TRIANGLES = 2_000_000


def tessellate(
    file: Any,  # noqa: ANN401 - untyped library
    elements: Sequence[Any],
    metres_per_unit: float,
) -> dict[str, list[dict[str, Any]]]:
    """Return bodies of triangles by GlobalId, in world coordinates and the file's unit.

    Elements that the kernel gives nothing for are absent.
    """
    from ifcopenshell import geom

    if not elements:
        return {}
    iterator = geom.iterator(
        geom.settings(), file, 1, include=list(elements), geometry_library=_KERNEL
    )
    found: dict[str, list[dict[str, Any]]] = {}
    if not iterator.initialize():
        return found
    while True:
        shape = iterator.get()
        found[shape.guid] = _bodies(shape, metres_per_unit)
        if not iterator.next():
            return {i: bodies for i, bodies in found.items() if bodies}


def _bodies(shape: Any, metres_per_unit: float) -> list[dict[str, Any]]:  # noqa: ANN401
    import numpy as np

    mesh = shape.geometry
    world_T_object = np.array(shape.transformation.matrix).reshape(4, 4, order="F")
    local = np.array(mesh.verts).reshape(-1, 3)
    points = (local @ world_T_object[:3, :3].T + world_T_object[:3, 3]) / metres_per_unit
    triangles = np.array(mesh.faces).reshape(-1, 3)
    items = np.array(mesh.item_ids)
    if len(items) != len(triangles):
        items = np.zeros(len(triangles), dtype=int)
    return [_body(points, triangles[items == i]) for i in dict.fromkeys(items.tolist())]


def _body(points: Any, triangles: Any) -> dict[str, Any]:  # noqa: ANN401
    import numpy as np

    used, numbers = np.unique(triangles, return_inverse=True)
    return {
        "kind": "faces",
        "vertices": points[used].tolist(),
        "faces": numbers.reshape(-1, 3).tolist(),
    }
