"""Convex collision shapes: the only shapes that planning, proof and simulation use."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import product

from sitewright.foundation.pose import Pose, Vector


@dataclass(frozen=True, slots=True)
class Box:
    """A box centred on its own pose.

    Attributes:
        size_m: Full edge lengths along x, y, z; all positive.
        body_T_box: Pose of its centre in the frame of the body that it belongs to.
    """

    size_m: Vector
    body_T_box: Pose = field(default_factory=Pose)

    def vertices_m(self) -> tuple[Vector, ...]:
        """Return the eight corners in the body frame."""
        half = tuple(s / 2.0 for s in self.size_m)
        corners = product(*((-h, h) for h in half))
        return tuple(self.body_T_box.apply((x, y, z)) for x, y, z in corners)


@dataclass(frozen=True, slots=True)
class Hull:
    """The convex hull of some points.

    Attributes:
        points_m: At least four points, not in one plane, in the body frame.
    """

    points_m: tuple[Vector, ...]

    def vertices_m(self) -> tuple[Vector, ...]:
        """Return the points as given."""
        return self.points_m


ConvexPart = Box | Hull
"""One convex piece of a body, in the body frame."""
Shape = tuple[ConvexPart, ...]
"""A body's shape: the union of its convex pieces."""


def moved(shape: Shape, frame_T_body: Pose) -> Shape:
    """Return the shape expressed in another frame."""
    return tuple(_moved_part(part, frame_T_body) for part in shape)


def _moved_part(part: ConvexPart, frame_T_body: Pose) -> ConvexPart:
    match part:
        case Box(size_m=size, body_T_box=pose):
            return Box(size, frame_T_body @ pose)
        case Hull(points_m=points):
            return Hull(tuple(frame_T_body.apply(p) for p in points))
