"""How far two convex solids are apart, also after one of them has been shifted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sitewright.building_model.inference.solid import Solid
from sitewright.foundation.pose import Vector

Points = npt.NDArray[np.float64]

_PARALLEL = 1e-6
_TIED_M = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Separation:
    """Gaps between two solids along every axis that can separate them.

    Attributes:
        axes: Unit vectors, one per row.
        gaps_m: The gap along each, from the first solid to the second; negative if their
            shadows overlap.
    """

    axes: Points
    gaps_m: Points

    def gap_m(self, shift_m: Vector = (0.0, 0.0, 0.0)) -> float:
        """Return how far they are at least apart once the first is shifted; negative: overlap."""
        return float((self.gaps_m - self.axes @ np.array(shift_m)).max())

    def widest(self) -> Points:
        """Return the axes (rows) along which they are furthest apart."""
        return np.asarray(self.axes[self.gaps_m >= self.gaps_m.max() - _TIED_M])

    def reversed(self) -> Separation:
        """Return the same gaps, seen from the second solid."""
        return Separation(-self.axes, self.gaps_m)


@dataclass(frozen=True, slots=True, eq=False)
class Edged:
    """A solid ready to be compared with many others.

    Attributes:
        corners_m: One per row.
        normals: Of its faces.
        edges: Directions of its edges, each once.
    """

    corners_m: Points
    normals: Points
    edges: Points


def edged(solid: Solid) -> Edged:
    """Return a solid with the directions of its faces and edges."""
    faces = [np.array(f.corners_m) for f in solid.faces]
    along = np.vstack([np.roll(f, -1, axis=0) - f for f in faces])
    return Edged(
        corners_m=np.array(solid.corners_m),
        normals=np.array([f.plane.normal for f in solid.faces]),
        edges=_distinct(along / np.linalg.norm(along, axis=1, keepdims=True)),
    )


def separation_of(one: Edged, other: Edged) -> Separation:
    """Return the gaps along all face normals and all crossings of edges."""
    lines = _lines(one, other)
    a, b = one.corners_m @ lines.T, other.corners_m @ lines.T
    return Separation(
        axes=np.vstack((lines, -lines)),
        gaps_m=np.concatenate((b.min(axis=0) - a.max(axis=0), a.min(axis=0) - b.max(axis=0))),
    )


def _lines(one: Edged, other: Edged) -> Points:
    crossings = np.cross(one.edges[:, None, :], other.edges[None, :, :]).reshape(-1, 3)
    length = np.linalg.norm(crossings, axis=1)
    real = length > _PARALLEL
    crossings = crossings[real] / length[real, None]
    return _distinct(np.vstack((one.normals, other.normals, crossings)))


def _distinct(lines: Points) -> Points:
    """Return each direction once, whichever way it points."""
    turned = np.linalg.norm(np.cross(lines[:, None, :], lines[None, :, :]), axis=2)
    is_same = turned < _PARALLEL
    kept: list[int] = []
    for index in range(len(lines)):
        if not is_same[index, kept].any():
            kept.append(index)
    return np.asarray(lines[kept])
