"""Flat faces of solids: corners welded, edges chained to loops, concave loops cut to triangles."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise, product

from sitewright.foundation.pose import Vector, cross, distance, dot, norm, scale, subtract, unit

Face = tuple[int, ...]
_CORNERS = 3
_FLAT = 1e-9
_CELL = 16.0
"""Tolerances per cell of the grid that finds near corners."""


class NoLoopError(ValueError):
    """The edges of a face do not close to loops."""


class Corners:
    """Vertices of a solid; points nearer than the tolerance are one vertex.

    Attributes:
        points: One position for each vertex.
    """

    def __init__(self, tolerance: float) -> None:
        self.points: list[Vector] = []
        self._tolerance = tolerance
        self._cells: dict[tuple[int, ...], list[int]] = {}

    def index_of(self, point: Vector) -> int:
        """Return the vertex at a point; a new one if there is none yet."""
        near, size = self._tolerance, _CELL * self._tolerance
        around = product(*({int((c - near) // size), int((c + near) // size)} for c in point))
        for cell in around:
            for index in self._cells.get(cell, ()):
                if distance(self.points[index], point) <= near:
                    return index
        self.points.append(point)
        x, y, z = (int(c // size) for c in point)
        self._cells.setdefault((x, y, z), []).append(len(self.points) - 1)
        return len(self.points) - 1


def loops_of(edges: Iterable[tuple[int, int]]) -> list[list[int]]:
    """Return the closed loops that a face's edges form.

    Raises:
        NoLoopError: A corner does not have exactly two edges.
    """
    neighbours: dict[int, list[int]] = {}
    for a, b in edges:
        if a != b:
            neighbours.setdefault(a, []).append(b)
            neighbours.setdefault(b, []).append(a)
    if any(len(n) != 2 for n in neighbours.values()):  # noqa: PLR2004 - in and out
        raise NoLoopError("the edges of a face do not close")
    loops = []
    while neighbours:
        start = next(iter(neighbours))
        loop, at, came = [start], start, -1
        while True:
            first, second = neighbours.pop(at)
            came, at = at, (second if first == came else first)
            if at == start:
                break
            loop.append(at)
        loops.append(loop)
    return loops


def area_vector(points: Sequence[Vector]) -> Vector:
    """Return a polygon's normal, as long as twice its area (Newell)."""
    origin = points[0]
    total = (0.0, 0.0, 0.0)
    for a, b in zip(points, (*points[1:], points[0]), strict=True):
        c = cross(subtract(a, origin), subtract(b, origin))
        total = (total[0] + c[0], total[1] + c[1], total[2] + c[2])
    return total


def faces_of_loops(points: Sequence[Vector], loops: list[list[int]], normal: Vector) -> list[Face]:
    """Return faces that together fill the largest loop without the others (its holes).

    Args:
        points: All vertices.
        loops: Vertex numbers; which way they run does not matter.
        normal: The side from which the faces run counter-clockwise.
    """
    sized = sorted(loops, key=lambda loop: -norm(area_vector([points[i] for i in loop])))
    outer, *holes = [_turned(points, loop, normal) for loop in sized if len(loop) >= _CORNERS]
    if not holes and _is_convex(points, outer, normal):
        return [tuple(outer)]
    return _triangles(points, [outer, *holes], normal)


def outward(points: Sequence[Vector], faces: list[Face]) -> list[Face]:
    """Return the faces, all turned over if they enclose a negative volume."""
    if not points:
        return faces
    origin, volume = points[0], 0.0
    for face in faces:
        a = subtract(points[face[0]], origin)
        for i, j in pairwise(face[1:]):
            volume += dot(a, cross(subtract(points[i], origin), subtract(points[j], origin)))
    return [f[::-1] for f in faces] if volume < 0.0 else faces


def plane_axes(normal: Vector, hint: Vector) -> tuple[Vector, Vector]:
    """Return x and y of a plane; x as near to `hint`, which must not be its normal."""
    z = unit(normal)
    x = unit(subtract(hint, scale(z, dot(z, hint))))
    return x, cross(z, x)


def _turned(points: Sequence[Vector], loop: list[int], normal: Vector) -> list[int]:
    return loop if dot(area_vector([points[i] for i in loop]), normal) > 0.0 else loop[::-1]


def _is_convex(points: Sequence[Vector], loop: list[int], normal: Vector) -> bool:
    around = zip(loop, (*loop[1:], loop[0]), (*loop[2:], *loop[:2]), strict=True)
    for a, b, c in around:
        first, second = subtract(points[b], points[a]), subtract(points[c], points[b])
        if dot(cross(first, second), normal) < -_FLAT * norm(first) * norm(second) * norm(normal):
            return False
    return True


def _triangles(points: Sequence[Vector], loops: list[list[int]], normal: Vector) -> list[Face]:
    from shapely import Polygon, constrained_delaunay_triangles

    origin = points[loops[0][0]]
    x, y = plane_axes(normal, subtract(points[loops[0][1]], origin))
    index_at: dict[tuple[float, float], int] = {}
    flat: list[list[tuple[float, float]]] = []
    for loop in loops:
        flat.append([])
        for i in loop:
            offset = subtract(points[i], origin)
            at = (dot(offset, x), dot(offset, y))
            index_at[at] = i
            flat[-1].append(at)
    polygon = Polygon(flat[0], flat[1:])
    if not polygon.is_valid:
        raise NoLoopError("the edges of a face cross")
    found = constrained_delaunay_triangles(polygon).geoms
    corners = ([index_at[c] for c in t.exterior.coords[:_CORNERS]] for t in found)
    return [tuple(_turned(points, c, normal)) for c in corners]
