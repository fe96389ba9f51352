"""Solids of Rhino geometry, without a mesher: extrusions, flat breps, meshes, saved meshes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from sitewright.building_model.formats.flat_faces import (
    Corners,
    Face,
    NoLoopError,
    area_vector,
    faces_of_loops,
    loops_of,
    outward,
    plane_axes,
)
from sitewright.foundation.pose import Vector, cross, dot, norm, subtract

Map = Callable[[Vector], Vector]
"""Takes points of the geometry to the file's world; affine."""
CHORDS_PER_TURN = 72
_CORNERS = 3
_STRAIGHT = 1e-9
_FINE, _FINEST = 1e-5, 1e-9
_MAX_TRIANGLES = 2_000_000


class NoSolidError(Exception):
    """A geometry gives no solid; carries code, message and fix."""

    def __init__(self, code: str, message: str, fix: str) -> None:
        super().__init__(message)
        self.problem = [code, message, fix]


def solid_of(geometry: Any, place: Map, tolerance: float) -> dict[str, Any]:  # noqa: ANN401
    """Return the record of an extrusion, brep or mesh at its place in the world.

    Args:
        geometry: A rhino3dm Extrusion, Brep or Mesh.
        place: Where blocks put it.
        tolerance: Of the file, in its unit; points nearer than this are one.

    Raises:
        NoSolidError: It has curved faces without a saved mesh, is broken or too large.
    """
    import rhino3dm

    tolerance = _fine(geometry, place, tolerance)
    if isinstance(geometry, rhino3dm.Extrusion):
        return _extrusion(geometry, place, tolerance)
    corners = Corners(tolerance)
    if isinstance(geometry, rhino3dm.Mesh):
        return _faces(corners, _mesh_faces([geometry], place, corners))
    return _brep(geometry, place, corners)


def is_round(geometry: Any) -> bool:  # noqa: ANN401
    """Return whether chords stand for curves in the record of a geometry."""
    import rhino3dm

    if not isinstance(geometry, rhino3dm.Extrusion):
        return False
    profiles = (geometry.Profile3d(i, 0.0) for i in range(geometry.ProfileCount))
    return any(p.TryGetPolyline() is None for p in profiles)


def _fine(geometry: Any, place: Map, tolerance: float) -> float:  # noqa: ANN401
    """Return a tolerance that leaves thin pieces their thickness: some templates have 10 mm."""
    box = geometry.GetBoundingBox()
    across = norm(subtract(place(_vector(box.Max)), place(_vector(box.Min))))
    return min(tolerance, max(_FINE * across, _FINEST))


def _extrusion(extrusion: Any, place: Map, tolerance: float) -> dict[str, Any]:  # noqa: ANN401
    count = range(extrusion.ProfileCount)
    bottoms = [[place(p) for p in _outline(extrusion.Profile3d(i, 0.0))] for i in count]
    tops = [[place(p) for p in _outline(extrusion.Profile3d(i, 1.0))] for i in count]
    if any(len(b) != len(t) or len(b) < _CORNERS for b, t in zip(bottoms, tops, strict=True)):
        message = "the profile of its extrusion has less than three corners."
        raise NoSolidError("G6", message, "Draw it again as a closed solid.")
    way = subtract(tops[0][0], bottoms[0][0])
    normal = area_vector(bottoms[0])
    if norm(way) <= tolerance or norm(normal) <= tolerance**2:
        raise NoSolidError("G6", "its extrusion has no volume.", "Draw it again.")
    if extrusion.IsSolid and _is_straight(bottoms, tops, way, normal):
        return _straight(bottoms, way)
    return _prism(bottoms, tops, tolerance, is_capped=extrusion.IsSolid)


def _is_straight(
    bottoms: list[list[Vector]], tops: list[list[Vector]], way: Vector, normal: Vector
) -> bool:
    """Return whether the path is the same everywhere and square to the profile."""
    if norm(cross(way, normal)) > _STRAIGHT * norm(way) * norm(normal):
        return False
    pairs = (p for b, t in zip(bottoms, tops, strict=True) for p in zip(b, t, strict=True))
    return all(norm(subtract(subtract(t, b), way)) <= _STRAIGHT * norm(way) for b, t in pairs)


def _straight(bottoms: list[list[Vector]], way: Vector) -> dict[str, Any]:
    origin = bottoms[0][0]
    edges = [subtract(b, a) for a, b in zip(bottoms[0], bottoms[0][1:], strict=False)]
    x, y = plane_axes(way, max(edges, key=norm))

    def flat(points: list[Vector], *, is_hole: bool) -> list[list[float]]:
        offsets = [subtract(p, origin) for p in points]
        outline = [[dot(o, x), dot(o, y)] for o in offsets]
        runs_forward = dot(area_vector(points), way) > 0.0
        return outline if runs_forward is not is_hole else outline[::-1]

    return {
        "kind": "extrusion",
        "p": list(origin),
        "x": list(x),
        "y": list(y),
        "profile": flat(bottoms[0], is_hole=False),
        "depth": norm(way),
        "holes": [flat(b, is_hole=True) for b in bottoms[1:]],
    }


def _prism(
    bottoms: list[list[Vector]], tops: list[list[Vector]], tolerance: float, *, is_capped: bool
) -> dict[str, Any]:
    """Return faces of an oblique, mitred or open extrusion; without caps it stays open."""
    corners = Corners(tolerance)
    below = [[corners.index_of(p) for p in b] for b in bottoms]
    above = [[corners.index_of(p) for p in t] for t in tops]
    faces: list[Face] = []
    normal = area_vector(bottoms[0])
    is_up = dot(subtract(tops[0][0], bottoms[0][0]), normal) > 0.0
    for number, (b, t) in enumerate(zip(below, above, strict=True)):
        is_forward = dot(area_vector(bottoms[number]), normal) > 0.0
        is_outer = number == 0
        sides = zip(b, (*b[1:], b[0]), (*t[1:], t[0]), t, strict=True)
        faces += [s if is_forward is (is_outer is is_up) else s[::-1] for s in sides]
    if is_capped:
        faces += [f if not is_up else f[::-1] for f in _cap(corners, below)]
        faces += [f if is_up else f[::-1] for f in _cap(corners, above)]
    return _faces(corners, faces)


def _cap(corners: Corners, loops: list[list[int]]) -> list[Face]:
    normal = area_vector([corners.points[i] for i in loops[0]])
    try:
        return faces_of_loops(corners.points, loops, normal)
    except NoLoopError as error:
        raise NoSolidError("G6", f"{error}.", "Draw it again.") from None


def _outline(curve: Any) -> list[Vector]:  # noqa: ANN401 - untyped library
    """Return the corners of a profile; curves become chords."""
    line = curve.TryGetPolyline()
    points = [_vector(p) for p in line] if line is not None else _chords(curve)
    is_repeated = norm(subtract(points[0], points[-1])) <= _STRAIGHT * _extent(points)
    return points[:-1] if is_repeated else points


def _chords(curve: Any) -> list[Vector]:  # noqa: ANN401
    if hasattr(curve, "SegmentCount"):
        pieces = [_chords(curve.SegmentCurve(i)) for i in range(curve.SegmentCount)]
        joined = pieces[0]
        for piece in pieces[1:]:
            joined += piece[1:]
        return joined
    if (line := curve.TryGetPolyline()) is not None:
        return [_vector(p) for p in line]
    steps = CHORDS_PER_TURN * max(1, curve.SpanCount // 4)
    start, end = curve.Domain.T0, curve.Domain.T1
    return [_vector(curve.PointAt(start + (end - start) * i / steps)) for i in range(steps + 1)]


def _brep(brep: Any, place: Map, corners: Corners) -> dict[str, Any]:  # noqa: ANN401
    all_faces = [brep.Faces[i] for i in range(len(brep.Faces))]
    pieces = [f.DuplicateFace(False) for f in all_faces]  # noqa: FBT003 - takes no keyword
    edges = [[p.Edges[i] for i in range(len(p.Edges))] for p in pieces]
    flat = [
        f.IsPlanar(1e-6) and all(e.IsLinear(1e-6) for e in es)
        for f, es in zip(all_faces, edges, strict=True)
    ]
    if not all(flat):
        return _saved_meshes(all_faces, place, corners)
    faces: list[Face] = []
    for face, es in zip(all_faces, edges, strict=True):
        faces += _flat_face(face, es, place, corners)
    return _faces(corners, faces)


def _flat_face(face: Any, edges: list[Any], place: Map, corners: Corners) -> list[Face]:  # noqa: ANN401
    ends = [(_vector(e.PointAtStart), _vector(e.PointAtEnd)) for e in edges]
    pairs = [(corners.index_of(place(a)), corners.index_of(place(b))) for a, b in ends]
    try:
        loops = loops_of(pairs)
        if not loops:
            return []
        largest = max(loops, key=lambda lo: norm(area_vector([corners.points[i] for i in lo])))
        normal = area_vector([corners.points[i] for i in largest])
        found = faces_of_loops(corners.points, loops, normal)
    except NoLoopError as error:
        fix = "In Rhino: check the object, repair it."
        raise NoSolidError("G6", f"{error}.", fix) from None
    return found if _looks_along(face, ends, place, normal) else [f[::-1] for f in found]


def _looks_along(
    face: Any,  # noqa: ANN401
    ends: list[tuple[Vector, Vector]],
    place: Map,
    normal: Vector,
) -> bool:
    """Return whether a face's outer side, taken to its place, is on the side of the normal."""
    u, v = face.Domain(0), face.Domain(1)
    told = _vector(face.NormalAt((u.T0 + u.T1) / 2.0, (v.T0 + v.T1) / 2.0))
    outside = (-told[0], -told[1], -told[2]) if face.OrientationIsReversed else told
    at = ends[0][0]
    moved = subtract(place((at[0] + outside[0], at[1] + outside[1], at[2] + outside[2])), place(at))
    return dot(moved, normal) > 0.0


def _saved_meshes(faces: Sequence[Any], place: Map, corners: Corners) -> dict[str, Any]:
    import rhino3dm

    meshes = [f.GetMesh(rhino3dm.MeshType.Any) for f in faces]
    missing = sum(m is None for m in meshes)
    if missing:
        message = f"it is curved, and {missing} of its {len(faces)} faces have no saved mesh."
        raise NoSolidError("G3", message, "In Rhino: show it shaded, then Save (not Save Small).")
    return _faces(corners, _mesh_faces(meshes, place, corners))


def _mesh_faces(meshes: Sequence[Any], place: Map, corners: Corners) -> list[Face]:
    if sum(len(m.Faces) for m in meshes) * 2 > _MAX_TRIANGLES:
        message = f"its mesh has more than {_MAX_TRIANGLES} triangles."
        raise NoSolidError("G6", message, "In Rhino: ReduceMesh.")
    faces: list[Face] = []
    for mesh in meshes:
        at = [corners.index_of(place(_vector(v))) for v in mesh.Vertices]
        for number in range(len(mesh.Faces)):
            a, b, c, d = (at[i] for i in mesh.Faces[number])
            faces += [t for t in ((a, b, c), (a, c, d)) if len(set(t)) == _CORNERS]
    return faces


def _faces(corners: Corners, faces: list[Face]) -> dict[str, Any]:
    if not faces:
        raise NoSolidError("G6", "it has no faces.", "Draw it again.")
    turned = outward(corners.points, faces)
    return {
        "kind": "faces",
        "vertices": [list(p) for p in corners.points],
        "faces": [list(f) for f in turned],
    }


def _extent(points: list[Vector]) -> float:
    return max(norm(subtract(p, points[0])) for p in points)


def _vector(point: Any) -> Vector:  # noqa: ANN401
    x, y, z = float(point.X), float(point.Y), float(point.Z)
    if not (math.isfinite(x) and math.isfinite(y) and math.isfinite(z)):
        raise NoSolidError("G6", "one of its coordinates is no number.", "Draw it again.")
    return (x, y, z)
