"""The way out: in which direction a component leaves its touching neighbours."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

from sitewright.building_model.inference.solid import Solid
from sitewright.foundation.pose import Vector, add, dot, norm, scale, unit

PARTING = 0.34
"""A neighbour is left behind if the way out leaves its face at 20 degrees or more: 30 mm on,
there are 10 mm of air."""
_FREE = -1e-6
_STEEP = 0.5
_NO_DIRECTION = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class WayOut:
    """A straight way out of an assembly; the way in is its reverse.

    Attributes:
        direction: Unit vector in the model frame.
        slide_m: How far the component slides along some neighbour; 0 if it parts from all.
    """

    direction: Vector
    slide_m: float


def way_out(
    solid: Solid, neighbours: Sequence[tuple[Vector, Solid | None]], up: Vector
) -> WayOut | None:
    """Return the best straight way out, or None if neighbours block every tried direction.

    Only the first instant is looked at: whether something farther off is in the way is for the
    motion planner to find.

    Args:
        solid: The component.
        neighbours: Contact normal out of the component, and the neighbour (None: the ground).
        up: Unit vector against gravity.
    """
    normals = [n for n, _ in neighbours]
    best = max(_directions(normals), key=lambda d: _rank(d, normals, up))
    if _margin(best, normals) < _FREE:
        return None
    slides = [
        other.highest_m(best) - solid.lowest_m(best)
        for normal, other in neighbours
        if other is not None and -dot(normal, best) < PARTING
    ]
    return WayOut(direction=best, slide_m=max(slides, default=0.0))


def _rank(direction: Vector, normals: Sequence[Vector], up: Vector) -> tuple[float, float, Vector]:
    """Away from every neighbour first, then upwards; the vector itself breaks ties."""
    away = min(_margin(direction, normals), _STEEP)
    return (round(away, 6), round(dot(direction, up), 6), direction)


def _margin(direction: Vector, normals: Sequence[Vector]) -> float:
    return min((-dot(n, direction) for n in normals), default=1.0)


def _directions(normals: Sequence[Vector]) -> list[Vector]:
    steps = (-1.0, 0.0, 1.0)
    lattice = [unit(v) for v in product(steps, steps, steps) if norm(v) > 0.0]
    away = [scale(n, -1.0) for n in normals]
    total: Vector = (0.0, 0.0, 0.0)
    for direction in away:
        total = add(total, direction)
    return [*lattice, *away, *([unit(total)] if norm(total) > _NO_DIRECTION else [])]
