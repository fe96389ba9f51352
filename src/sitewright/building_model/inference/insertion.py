"""The way out: in which direction a component leaves what stands around it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

from sitewright.building_model.inference.separation import Separation
from sitewright.foundation.pose import Vector, dot, norm, scale, unit

PARTED_M = 0.011
"""A neighbour is left behind once it is this far off: the usual clearance and a little."""
NEAR_M = 0.030
"""Neighbours should be left behind within this much travel."""
AROUND_M = 0.20
"""Only what is nearer than this is looked at."""
_TRAVEL_M = (0.005, NEAR_M, 0.06, 0.12)
_SLIDES_M = tuple(0.01 * k for k in range(1, 101))
_OVERLAP_M = -1e-4
_TINY = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class WayOut:
    """A straight way out of an assembly; the way in is its reverse.

    Attributes:
        direction: Unit vector in the model frame.
        slide_m: How far it still is within 11 mm of some neighbour, where that is more than
            30 mm; else 0.
    """

    direction: Vector
    slide_m: float


def way_out(around: Sequence[Separation], up: Vector, above_ground_m: float) -> WayOut | None:
    """Return the best straight way out, or None if neighbours block every tried direction.

    The first 120 mm are looked at; what comes after is for the motion planner to find.

    Args:
        around: Separations from the component to what stands around it.
        up: Unit vector against gravity.
        above_ground_m: Height of its lowest point above the ground.
    """
    ranked = ((_rank(d, around, up, above_ground_m), d) for d in _directions(around))
    (is_free, _, _), best = max(ranked)
    if not is_free:
        return None
    return WayOut(direction=best, slide_m=_slide_m(best, around))


def _rank(
    direction: Vector, around: Sequence[Separation], up: Vector, above_ground_m: float
) -> tuple[bool, float, float]:
    """Free at all first, then parting from all neighbours early, then upwards."""
    rises = dot(direction, up)
    gaps = [_gap_m(direction, t, around) for t in _TRAVEL_M]
    is_free = min(gaps) > _OVERLAP_M and above_ground_m + rises * _TRAVEL_M[-1] > _OVERLAP_M
    parted = round(min(gaps[1:], default=PARTED_M), 6)
    return (is_free, min(parted, PARTED_M), round(rises, 6))


def _gap_m(direction: Vector, travel_m: float, around: Sequence[Separation]) -> float:
    shift_m = scale(direction, travel_m)
    return min((s.gap_m(shift_m) for s in around), default=PARTED_M)


def _slide_m(direction: Vector, around: Sequence[Separation]) -> float:
    if _gap_m(direction, NEAR_M, around) >= PARTED_M - _TINY:
        return 0.0
    parted = (t for t in _SLIDES_M if _gap_m(direction, t, around) >= PARTED_M)
    return next(parted, _SLIDES_M[-1])


def _directions(around: Sequence[Separation]) -> list[Vector]:
    """Return the 26 directions of a lattice, and away from each touching face."""
    steps = (-1.0, 0.0, 1.0)
    lattice = [unit(v) for v in product(steps, steps, steps) if norm(v) > 0.0]
    away = [scale(axis, -1.0) for s in around for axis, gap in s.gaps if gap >= s.gap_m() - _TINY]
    total = (sum(a[0] for a in away), sum(a[1] for a in away), sum(a[2] for a in away))
    combined = [unit(total)] if norm(total) > _TINY else []
    return [*lattice, *away, *combined]
