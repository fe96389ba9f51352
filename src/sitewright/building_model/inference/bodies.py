"""Convex pieces of every component in the model frame, as arrays: corners, faces, edges."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.findings import warned
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import UnsupportedGeometryError, shape_of
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Box, ConvexPart

Points = npt.NDArray[np.float64]

_COPLANAR_M = 1e-4
"""Corners this near to a face's plane belong to the face."""
_SAME_LINE = 1e-5
_FLAT = 1e-9
_STANDS = frozenset({Layer.TARGET, Layer.AS_BUILT})
_BOX_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
_BOX_NORMALS = np.vstack([np.eye(3), -np.eye(3)])
_BOX_POLYGONS = ((4, 6, 7, 5), (2, 3, 7, 6), (1, 5, 7, 3), (0, 1, 3, 2), (0, 4, 5, 1), (0, 2, 6, 4))


@dataclass(frozen=True, eq=False)
class Part:
    """One convex piece.

    Attributes:
        corners_m: One per row.
        normals: Outward unit normal of each face, one per row.
        polygons: Indices of each face's corners, counter-clockwise seen from outside.
    """

    corners_m: Points
    normals: Points
    polygons: tuple[tuple[int, ...], ...]

    @cached_property
    def offsets_m(self) -> Points:
        """Of each face: ``normal . x <= offset`` inside."""
        first = [polygon[0] for polygon in self.polygons]
        return np.asarray(np.einsum("ij,ij->i", self.normals, self.corners_m[first]))

    @cached_property
    def lines(self) -> Points:
        """Directions of the face normals, each once whichever way it points."""
        return _distinct(self.normals)

    @cached_property
    def edges(self) -> Points:
        """Directions of the edges, each once whichever way it points."""
        ends = [(p[k - 1], p[k]) for p in self.polygons for k in range(len(p))]
        along = np.array([self.corners_m[b] - self.corners_m[a] for a, b in ends])
        lengths = np.linalg.norm(along, axis=1)
        keep = lengths > _COPLANAR_M
        return _distinct(along[keep] / lengths[keep, None])


@dataclass(frozen=True, eq=False)
class Body:
    """A component as convex pieces in the model frame."""

    id: ComponentId
    parts: tuple[Part, ...]
    centre_m: Points
    """Centre of mass, all parts of one density."""

    @cached_property
    def corners_m(self) -> Points:
        """All corners."""
        return np.vstack([p.corners_m for p in self.parts])

    @cached_property
    def low_m(self) -> Points:
        """The lower corner of the box around it, along the model's axes."""
        return np.asarray(self.corners_m.min(axis=0))

    @cached_property
    def high_m(self) -> Points:
        """The upper corner of the box around it."""
        return np.asarray(self.corners_m.max(axis=0))

    @property
    def faces_total(self) -> int:
        """Number of faces of all pieces."""
        return sum(len(p.polygons) for p in self.parts)


def bodies_of(model: BuildingModel) -> tuple[dict[ComponentId, Body], list[Problem]]:
    """Return what stands or will stand, in order of id, and what has no usable shape."""
    bodies: dict[ComponentId, Body] = {}
    problems: list[Problem] = []
    for component in model.component_by_id.values():
        if component.layer not in _STANDS:
            continue
        try:
            bodies[component.id] = body_of(component)
        except (UnsupportedGeometryError, ValueError) as error:
            message = f"It is not looked at: {error}"
            fix = "State its construction parents and order."
            problems.append(warned("G7", component, message, fix))
    return {i: bodies[i] for i in sorted(bodies)}, problems


def body_of(component: Component) -> Body:
    """Return a component's body; raises `UnsupportedGeometryError` or ValueError without one."""
    parts = tuple(part_of(p, component.world_T_component) for p in shape_of(component))
    volumes, centres = zip(*(_volume_and_centre(p) for p in parts), strict=True)
    total = sum(volumes)
    if component.com_m is not None:
        centre = np.array(component.world_T_component.apply(component.com_m))
    else:
        centre = np.asarray(sum(v * c for v, c in zip(volumes, centres, strict=True))) / total
    return Body(component.id, parts, centre)


def volume_of(body: Body) -> float:
    """Return the volume of all pieces in m3."""
    return sum(_volume_and_centre(p)[0] for p in body.parts)


def part_of(part: ConvexPart, world_T_body: Pose) -> Part:
    """Return a convex piece in the world frame with its faces."""
    if isinstance(part, Box):
        pose = world_T_body @ part.body_T_box
        turn = np.array([pose.x_axis, pose.y_axis, pose.z_axis])
        corners = _BOX_CORNERS * (np.array(part.size_m) / 2.0) @ turn + np.array(pose.position_m)
        return Part(corners, _BOX_NORMALS @ turn, _BOX_POLYGONS)
    points = np.array([world_T_body.apply(p) for p in part.vertices_m()])
    return _hull(points)


def _hull(points: Points) -> Part:
    """Return the hull of points; triangles in one plane become one face."""
    import coal

    middle = points.mean(axis=0)
    if len(points) < 4 or np.linalg.matrix_rank(points - middle, tol=_COPLANAR_M) < 3:  # noqa: PLR2004
        raise ValueError("its points lie in one plane and enclose nothing")
    rows = coal.StdVec_Vec3s()
    rows.extend(list(points - middle))
    made = coal.ConvexBase.convexHull(rows, True, "Qt")  # noqa: FBT003 - coal's own signature
    corners = np.array(made.points(), dtype=np.float64)
    triangles = [made.polygons(i) for i in range(made.num_polygons)]
    planes = _planes(corners, np.array([[t[0], t[1], t[2]] for t in triangles]))
    polygons = [_around(corners, normal, offset) for normal, offset in planes]
    return Part(corners + middle, np.array([n for n, _ in planes]), tuple(polygons))


def _planes(corners: Points, triangles: npt.NDArray[np.int64]) -> list[tuple[Points, float]]:
    """Return each face's plane once, outward, large triangles first."""
    a, b, c = (corners[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    sizes = np.linalg.norm(normals, axis=1)
    inside = corners.mean(axis=0)
    found: list[tuple[Points, float]] = []
    for k in np.argsort(-sizes, kind="stable"):
        if sizes[k] < _FLAT:
            break
        normal = normals[k] / sizes[k]
        normal = normal if normal @ (a[k] - inside) > 0.0 else -normal
        three = np.array([a[k], b[k], c[k]])
        if not any(
            n @ normal > 0.9 and np.abs(three @ n - d).max() < _COPLANAR_M  # noqa: PLR2004
            for n, d in found
        ):
            found.append((normal, float(normal @ a[k])))
    return found


def _around(corners: Points, normal: Points, offset: float) -> tuple[int, ...]:
    """Return the corners in a plane, counter-clockwise about its normal."""
    on = np.flatnonzero(np.abs(corners @ normal - offset) < _COPLANAR_M)
    middle = corners[on].mean(axis=0)
    u = corners[on[0]] - middle
    v = np.cross(normal, u)
    angles = np.arctan2((corners[on] - middle) @ v, (corners[on] - middle) @ u)
    return tuple(int(i) for i in on[np.argsort(angles, kind="stable")])


def _volume_and_centre(part: Part) -> tuple[float, Points]:
    """Sum pyramids from the middle to the faces' triangles."""
    middle = part.corners_m.mean(axis=0)
    fans = [(p[0], p[k], p[k + 1]) for p in part.polygons for k in range(1, len(p) - 1)]
    a, b, c = (part.corners_m - middle)[np.array(fans).T]
    six = np.einsum("ij,ij->i", a, np.cross(b, c))
    volume = max(float(six.sum()) / 6.0, _FLAT)
    return volume, np.asarray(middle + six @ (a + b + c) / 24.0 / volume)


def _distinct(directions: Points) -> Points:
    kept: list[Points] = []
    for direction in directions:
        if not any(abs(abs(float(direction @ k)) - 1.0) < _SAME_LINE**2 * 50 for k in kept):
            kept.append(direction)
    return np.array(kept)


def stacked(bodies: Iterable[Body]) -> tuple[Points, Points]:
    """Return the lower and upper corners of the boxes around bodies, one per row."""
    these = list(bodies)
    if not these:
        return np.empty((0, 3)), np.empty((0, 3))
    return np.array([b.low_m for b in these]), np.array([b.high_m for b in these])
