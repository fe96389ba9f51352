"""Directions in which components can leave an assembly, and what is in the way of each."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
import numpy.typing as npt

from sitewright.building_model.inference.bodies import Body, Points
from sitewright.building_model.inference.carrying import Bearing, lowest_m
from sitewright.building_model.inference.sweeping import overlaps
from sitewright.foundation.ids import ComponentId

SHORT_M = 0.15
"""If nothing can leave in one straight move, this much travel is asked for."""
PARTED_M = 0.011
"""A neighbour is left behind once it is this far off: the usual clearance and a little."""
SOON_M = 0.030
"""Neighbours should be left behind within this much travel."""
_EXTRA = 40
_SAME = 0.9999
_SLIDES = 1e-6
_FACES_MAX = 255
_TINY_M = 1e-6
_DOWN = -1e-6

Flags = npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Ways:
    """What is in the way, for each direction, mover and other component.

    Attributes:
        names: Components, by index.
        directions: Unit vectors, one per row; with each its opposite.
        far: ``far[d, i, j]``: `i` meets `j` somewhere as it leaves along `d`.
        near: The same for the first 150 mm.
        barred: ``barred[d, i]``: the ground leaves no room along `d`.
    """

    names: tuple[ComponentId, ...]
    directions: Points
    far: Flags
    near: Flags
    barred: Flags


def ways_of(bearing: Bearing) -> Ways:
    """Look at straight moves of every component past every other one."""
    names = tuple(sorted(bearing.bodies))
    bodies = [bearing.bodies[i] for i in names]
    directions = directions_of(bearing)
    far = np.zeros((len(directions), len(names), len(names)), dtype=np.bool_)
    near = far.copy()
    travel = _travel_m(bodies, directions, bearing)
    opposite = np.argmin(directions @ directions.T, axis=1)
    index = np.arange(len(directions))
    for found in overlaps(bodies, directions) if len(bodies) > 1 else ():
        meets = found.enters_m < found.leaves_m - _TINY_M
        first, second = found.pairs[:, 0], found.pairs[:, 1]
        for mover, other, ways in ((first, second, index), (second, first, opposite)):
            place = (ways[None], mover[:, None], other[:, None])
            np.logical_or.at(far, place, meets & (found.enters_m < travel[place[:2]]))
            np.logical_or.at(near, place, meets & (found.enters_m < SHORT_M))
    return Ways(names, directions, far, near, travel < SHORT_M)


def directions_of(bearing: Bearing) -> Points:
    """Return 14 directions about the vertical: six axes, eight diagonals; and contact normals.

    The normals of the largest contacts are added with their opposites, 40 at most, where they
    are none of the 14: walls that stand askew, voussoirs, laps.
    """
    up = bearing.up
    helper = np.array([1.0, 0.0, 0.0])
    if abs(float(helper @ up)) > 0.9:  # noqa: PLR2004 - gravity along x
        helper = np.array([0.0, 1.0, 0.0])
    x = helper - up * float(helper @ up)
    x /= np.linalg.norm(x)
    frame = np.array([x, np.cross(up, x), up])
    axes = [np.array(s) @ frame for s in np.vstack([np.eye(3), -np.eye(3)])]
    corners = [np.array(s) @ frame / np.sqrt(3.0) for s in product((-1.0, 1.0), repeat=3)]
    found = [*axes, *corners]
    for normal in _normals(bearing):
        if len(found) >= len(axes) + len(corners) + _EXTRA:
            break
        if not any(float(normal @ d) > _SAME for d in found):
            found += [normal, -normal]
    return np.array(found)


def _normals(bearing: Bearing) -> Iterable[Points]:
    area_by_normal: dict[tuple[float, ...], float] = {}
    for i, around in bearing.touching.items():
        for patch in (p for j, face in around.items() if i < j for p in face.patches):
            key = max(tuple(round(s * x, 4) + 0.0 for x in patch.normal) for s in (1.0, -1.0))
            area_by_normal[key] = area_by_normal.get(key, 0.0) + patch.area_m2
    for key in sorted(area_by_normal, key=lambda k: (-area_by_normal[k], k)):
        yield np.array(key) / np.linalg.norm(key)


def _travel_m(bodies: Sequence[Body], directions: Points, bearing: Bearing) -> Points:
    """Return how far each may go along each direction: out of the model, or to the ground."""
    corners = np.vstack([b.corners_m for b in bodies])
    across_m = float(np.linalg.norm(corners.max(axis=0) - corners.min(axis=0))) + 1.0
    rises = directions @ bearing.up
    above = np.array([lowest_m(b, bearing.up) - bearing.ground_m for b in bodies])
    drop = np.where(rises < _DOWN, -rises, 1.0)[:, None]
    return np.where(rises[:, None] < _DOWN, np.maximum(0.0, above)[None] / drop, across_m)


def contact_slides(bearing: Bearing, ways: Ways) -> npt.NDArray[np.uint8]:
    """Return along how many faces of each neighbour a component slides: ``[d, i, j]``."""
    index = {name: k for k, name in enumerate(ways.names)}
    found = np.zeros((len(ways.directions), len(index), len(index)), dtype=np.uint8)
    for i, around in bearing.touching.items():
        for j, face in around.items():
            normals = np.array([p.normal for p in face.patches])
            along = np.abs(normals @ ways.directions.T) < _SLIDES
            found[:, index[i], index[j]] = np.minimum(along.sum(axis=0), _FACES_MAX)
    return found


def sliding(bearing: Bearing, component: ComponentId, others: Iterable[ComponentId]) -> Points:
    """Return the normals into touching neighbours, one per row."""
    rows = []
    for j in sorted(set(others) & bearing.touching[component].keys()):
        face = bearing.touching[component][j]
        sign = 1.0 if face.a == component else -1.0
        rows += [sign * np.array(p.normal) for p in face.patches]
    return np.array(rows).reshape(-1, 3)


def slide_m(
    bearing: Bearing, component: ComponentId, others: Iterable[ComponentId], direction: Points
) -> float:
    """Return how far a component stays within 11 mm of a neighbour as it leaves; 0 if 30 mm."""
    near = sorted(set(others) & bearing.touching[component].keys())
    last = 0.0
    bodies = [bearing.bodies[i] for i in (component, *near)]
    for found in overlaps(bodies, direction[None], grown_m=PARTED_M, movers=1):
        met = found.enters_m < found.leaves_m - _TINY_M
        last = max(last, float(found.leaves_m[met].max(initial=0.0)))
    return 0.0 if last <= SOON_M else round(min(last, 100.0), 4)


def slides_along(normals: Points, direction: Points) -> int:
    """Return along how many contact faces a move slides."""
    return int((np.abs(normals @ direction) < _SLIDES).sum()) if len(normals) else 0
