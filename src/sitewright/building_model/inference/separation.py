"""How far two convex solids are apart, also after one of them has been shifted."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

from sitewright.building_model.inference.solid import Solid
from sitewright.foundation.pose import Vector, cross, dot, norm, scale, subtract, unit

_PARALLEL = 1e-6


@dataclass(frozen=True, slots=True)
class Separation:
    """Gaps between two solids along every axis that can separate them.

    Attributes:
        gaps: Unit axis and the gap along it, from the first solid to the second; negative
            if their shadows overlap.
    """

    gaps: tuple[tuple[Vector, float], ...]

    def gap_m(self, shift_m: Vector = (0.0, 0.0, 0.0)) -> float:
        """Return how far they are at least apart once the first is shifted; negative: overlap."""
        return max(gap - dot(axis, shift_m) for axis, gap in self.gaps)

    def reversed(self) -> Separation:
        """Return the same gaps, seen from the second solid."""
        return Separation(tuple((scale(axis, -1.0), gap) for axis, gap in self.gaps))


def separation_of(one: Solid, other: Solid) -> Separation:
    """Return the gaps along all face normals and all crossings of edges."""
    return Separation(
        tuple(
            (axis, other.lowest_m(axis) - one.highest_m(axis))
            for line in _axes(one, other)
            for axis in (line, scale(line, -1.0))
        )
    )


def _axes(one: Solid, other: Solid) -> list[Vector]:
    lines = [f.plane.normal for s in (one, other) for f in s.faces]
    lines += [
        unit(crossing)
        for a, b in product(_edges(one), _edges(other))
        if norm(crossing := cross(a, b)) > _PARALLEL
    ]
    return _distinct(lines)


def _edges(solid: Solid) -> list[Vector]:
    corners = [(f.corners_m, f.corners_m[1:] + f.corners_m[:1]) for f in solid.faces]
    return _distinct(
        [
            unit(subtract(end, start))
            for starts, ends in corners
            for start, end in zip(starts, ends, strict=True)
        ]
    )


def _distinct(lines: list[Vector]) -> list[Vector]:
    """Return each direction once, whichever way it points."""
    kept: list[Vector] = []
    for line in lines:
        if not any(norm(cross(line, k)) < _PARALLEL for k in kept):
            kept.append(line)
    return kept
