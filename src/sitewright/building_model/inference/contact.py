"""Face contacts between convex solids: where, how large, and in which direction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

from sitewright.building_model.inference.nearness import near_pairs
from sitewright.building_model.inference.solid import Face, Solid
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector, add, cross, dot, norm, scale, subtract

GAP_M = 0.001
"""Faces nearer than this touch."""
MIN_AREA_M2 = 1e-4
_ANTIPARALLEL = -0.99985
"""cos of 179 degrees."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """Two components touch face to face.

    Attributes:
        normal: Unit vector in the model frame, from `a` into `b`.
    """

    a: ComponentId
    b: ComponentId
    normal: Vector
    area_m2: float


def contacts_of(solid_by_id: Mapping[ComponentId, Solid]) -> list[Contact]:
    """Return the largest contact of every touching pair, in order of id."""
    found = []
    for a, b in near_pairs(solid_by_id, GAP_M):
        contact = contact_between(a, solid_by_id[a], b, solid_by_id[b])
        if contact is not None:
            found.append(contact)
    return found


def contact_between(a: ComponentId, one: Solid, b: ComponentId, other: Solid) -> Contact | None:
    """Return the largest face contact of two solids, if they have one."""
    if not one.may_be_near(other, GAP_M):
        return None
    best: Contact | None = None
    for face in one.faces:
        for facing in other.faces:
            area_m2 = _shared_area_m2(face, facing)
            if area_m2 > (best.area_m2 if best else MIN_AREA_M2):
                best = Contact(a=a, b=b, normal=face.plane.normal, area_m2=area_m2)
    return best


def _shared_area_m2(face: Face, facing: Face) -> float:
    normal = face.plane.normal
    if dot(normal, facing.plane.normal) > _ANTIPARALLEL:
        return 0.0
    gap_m = dot(normal, facing.corners_m[0]) - face.plane.offset_m
    if abs(gap_m) > GAP_M:
        return 0.0
    polygon = list(facing.corners_m)
    for start, end in zip(face.corners_m, face.corners_m[1:] + face.corners_m[:1], strict=True):
        inward = cross(normal, subtract(end, start))
        polygon = _clipped(polygon, inward, dot(inward, start))
    return _area_m2(polygon, normal)


def _clipped(polygon: list[Vector], inward: Vector, offset: float) -> list[Vector]:
    """Return the part of a convex polygon where ``inward . x >= offset``."""
    kept: list[Vector] = []
    for start, end in zip(polygon, polygon[1:] + polygon[:1], strict=True):
        inside, ends_inside = dot(inward, start) - offset, dot(inward, end) - offset
        if inside >= 0.0:
            kept.append(start)
        if (inside < 0.0) != (ends_inside < 0.0):
            share = inside / (inside - ends_inside)
            kept.append(add(start, scale(subtract(end, start), share)))
    return kept


def _area_m2(polygon: list[Vector], normal: Vector) -> float:
    if len(polygon) < 3:  # noqa: PLR2004 - a polygon
        return 0.0
    total: Vector = (0.0, 0.0, 0.0)
    for start, end in pairwise(polygon[1:]):
        total = add(total, cross(subtract(start, polygon[0]), subtract(end, polygon[0])))
    return abs(dot(total, normal)) / (2.0 * norm(normal))
