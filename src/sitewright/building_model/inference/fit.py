"""Do neighbours fit: pieces that overlap, and faces that just miss each other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from sitewright.building_model.component import Component
from sitewright.building_model.convex import Plane, clipped, volume_m3
from sitewright.building_model.findings import refused, warned
from sitewright.building_model.inference.bodies import Body, Part, volume_of
from sitewright.building_model.inference.interfaces import (
    GAP_M,
    Interface,
    interface_between,
    near_pairs,
)
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector

MISSES_M = 0.005
"""Faces between the contact gap and this apart were probably meant to touch."""
MUCH = 0.20
"""An overlap of more than this share of the smaller piece is an error."""
_DEPTH_M = 0.001
_SMALLEST_M3 = 1e-7
_CORNERS = 4


def fit_problems(
    components: Mapping[ComponentId, Component],
    bodies: Mapping[ComponentId, Body],
    interfaces: Sequence[Interface],
) -> Iterator[Problem]:
    """Yield overlaps (G1, deeper than 1 mm) and gaps of 1 to 5 mm between facing faces (G5)."""
    touching = {(i.a, i.b) for i in interfaces}
    names = sorted(bodies)
    for k, n in near_pairs([bodies[i] for i in names], MISSES_M):
        a, b = names[k], names[n]
        one, other = bodies[a], bodies[b]
        shared_m3 = overlap_m3(one, other)
        if shared_m3 > _SMALLEST_M3:
            yield _overlap(components, a, b, shared_m3, min(volume_of(one), volume_of(other)))
        elif (a, b) not in touching and interface_between(one, other, MISSES_M) is not None:
            gap_m = _gap_m(one, other)
            message = f"It misses {b} by {gap_m * 1000:.1f} mm."
            fix = "Move one of them if they should touch."
            yield warned("G5", components[a], message, fix)


def overlap_m3(one: Body, other: Body) -> float:
    """Return the volume that two bodies share, or 0 if they overlap by less than 1 mm."""
    return sum(_shared_m3(p, q) for p in one.parts for q in other.parts)


def _shared_m3(one: Part, other: Part) -> float:
    low = np.maximum(one.corners_m.min(axis=0), other.corners_m.min(axis=0))
    high = np.minimum(one.corners_m.max(axis=0), other.corners_m.max(axis=0))
    if float((high - low).min()) < _DEPTH_M or _is_apart(one, other) or _is_apart(other, one):
        return 0.0
    points: tuple[Vector, ...] = tuple(_vector(c) for c in one.corners_m)
    for normal, offset in zip(other.normals, other.offsets_m, strict=True):
        points = clipped(points, Plane(_vector(normal), float(offset)))
        if len(points) < _CORNERS:
            return 0.0
    spread = np.array(points) @ other.normals.T
    if float((spread.max(axis=0) - spread.min(axis=0)).min()) < _DEPTH_M:
        return 0.0
    return volume_m3(points)


def _is_apart(one: Part, other: Part) -> bool:
    """Whether a face of the first keeps the second out, but for 1 mm."""
    heights = other.corners_m @ one.normals.T - one.offsets_m
    return bool((heights.min(axis=0) > -_DEPTH_M).any())


def _overlap(
    components: Mapping[ComponentId, Component],
    a: ComponentId,
    b: ComponentId,
    shared_m3: float,
    smaller_m3: float,
) -> Problem:
    share = shared_m3 / smaller_m3
    message = f"It overlaps {b}: {shared_m3 * 1e6:.0f} cm3 ({share * 100:.0f} % of the smaller)."
    report = refused if share > MUCH else warned
    return report("G1", components[a], message, "Cut or move one of them.")


def _gap_m(one: Body, other: Body) -> float:
    """Return the smallest gap for which they would touch, to 0.1 mm."""
    steps = np.arange(GAP_M, MISSES_M + 1e-9, 1e-4)
    return next(
        (float(g) for g in steps if interface_between(one, other, float(g)) is not None), MISSES_M
    )


def _vector(row: object) -> Vector:
    x, y, z = np.asarray(row, dtype=np.float64).tolist()
    return (x, y, z)
