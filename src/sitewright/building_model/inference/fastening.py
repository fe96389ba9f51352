"""Nails and screws at contact faces, by the rules of the model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sitewright.building_model.check_fasteners import MIN_PENETRATION_M, penetration_m
from sitewright.building_model.component import Component, Operation, Origin
from sitewright.building_model.findings import warned
from sitewright.building_model.inference.bodies import Body, Points
from sitewright.building_model.inference.carrying import Edge
from sitewright.building_model.inference.interfaces import Interface, Patch
from sitewright.building_model.inference.rules import FastenRule, Rules
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose, Vector

MIN_EDGE_M = 0.015
EDGE_DIAMETERS = 5.0
SPACING_M = 0.020
"""Fasteners are at least so far apart."""
_ROOM_M = 0.005
"""Something this near in front of the entry face covers it."""
_ALONG = 0.9
_CROSSING = 0.5
_INSIDE_M = 1e-4


@dataclass(frozen=True, slots=True, kw_only=True)
class Joint:
    """A contact that a rule fastens."""

    rule: FastenRule
    through: ComponentId
    into: ComponentId
    patch: Patch
    """Its normal points from `through` into `into`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Fastening:
    """What the rules add.

    Attributes:
        operations: By the component that they secure: the later one of the two.
        before: (earlier, later): what is fastened before its entry face is covered.
        joined: (earlier, later): what must be there for the later one to be fastened to it.
    """

    operations: Mapping[ComponentId, tuple[Operation, ...]]
    before: tuple[Edge, ...]
    problems: tuple[Problem, ...]
    joined: tuple[Edge, ...] = ()


def joints_of(
    components: Mapping[ComponentId, Component], interfaces: Sequence[Interface], rules: Rules
) -> list[Joint]:
    """Return the contacts that a rule fits and that no stated operation fastens."""
    stated = {frozenset(o.on[:2]) for c in components.values() for o in c.operations if o.fastener}
    found = []
    for face in interfaces:
        if frozenset((face.a, face.b)) not in stated:
            joint = _joint(components, face, rules)
            if joint is not None:
                found.append(joint)
    return found


def _joint(
    components: Mapping[ComponentId, Component], face: Interface, rules: Rules
) -> Joint | None:
    patch = face.largest
    turned = Patch(_opposite(patch.normal), patch.corners_m, patch.area_m2)
    for rule in rules.fasten:
        for through, into, own in ((face.a, face.b, patch), (face.b, face.a, turned)):
            one, other = components[through], components[into]
            contact = contact_kind(one, other, own.normal)
            if contact and rule.fits(one.type, other.type, contact):
                return Joint(rule=rule, through=through, into=into, patch=own)
    return None


def contact_kind(through: Component, into: Component, normal: Vector) -> str:
    """Return ``end-grain``, ``lap`` or ``side``; nothing if it would go in along `through`."""
    n = np.array(normal)
    one = np.array(through.world_T_component.x_axis)
    other = np.array(into.world_T_component.x_axis)
    if abs(float(n @ one)) > _ALONG:
        return ""
    if abs(float(n @ other)) > _ALONG:
        return "end-grain"
    return "lap" if abs(float(one @ other)) < _CROSSING else "side"


def fasten(
    components: Mapping[ComponentId, Component],
    bodies: Mapping[ComponentId, Body],
    joints: Sequence[Joint],
    place: Mapping[ComponentId, int],
    ground: tuple[Points, float],
) -> Fastening:
    """Return operations for joints, each checked for edges, length, spacing and a free entry.

    Args:
        components: Targets and what stands, by id.
        bodies: Their shapes.
        joints: Contacts to fasten.
        place: Order of building.
        ground: Unit vector up, and the height of the ground along it.
    """
    found: dict[ComponentId, tuple[Operation, ...]] = {}
    before: list[Edge] = []
    joined: list[Edge] = []
    problems: list[Problem] = []
    taken = _stated_entries(components)
    for joint in joints:
        owner = max(joint.through, joint.into, key=lambda i: (place[i], i))
        if place[owner] < 0:
            continue
        spots, problem = _spots(components[owner], joint, bodies, taken)
        covers, covered = _covers(joint, spots, bodies, place, ground)
        problem = problem or covered
        start = len(found.get(owner, ())) + len(components[owner].operations)
        made = [_operation(components[owner], joint, p, start + k) for k, p in enumerate(spots)]
        short = [o for o in made if _held_m(components, joint, owner, o) < MIN_PENETRATION_M - 1e-6]
        if short:
            problem = _too_short(components, joint, owner, short[0])
        if problem is not None:
            problems.append(problem)
        if covered is not None or short:
            continue
        taken += [(joint.through, np.array(p.position_m), np.array(p.z_axis)) for p in spots]
        found[owner] = (*found.get(owner, ()), *made)
        if made:
            joined.append((joint.into if owner == joint.through else joint.through, owner))
        before += [(owner, cover) for cover in covers]
    return Fastening(
        operations=found, before=tuple(before), problems=tuple(problems), joined=tuple(joined)
    )


_Entry = tuple[ComponentId, Points, Points]


def _stated_entries(components: Mapping[ComponentId, Component]) -> list[_Entry]:
    found: list[_Entry] = []
    for component in components.values():
        for operation in component.operations:
            if operation.fastener is not None and operation.on:
                pose = component.world_T_component @ operation.component_T_operation
                entry = (np.array(pose.position_m), np.array(pose.z_axis))
                found.append((operation.on[0], *entry))
    return found


def _spots(
    owner: Component, joint: Joint, bodies: Mapping[ComponentId, Body], taken: list[_Entry]
) -> tuple[list[Pose], Problem | None]:
    """Return where the fasteners enter (model frame), and what could not be kept."""
    corners, normal = np.array(joint.patch.corners_m), np.array(joint.patch.normal)
    along = _long_side(corners)
    across = np.cross(normal, along)
    edge_m = max(joint.rule.edge_m, EDGE_DIAMETERS * joint.rule.fastener.d_m, MIN_EDGE_M)
    u, v = corners @ along, corners @ across
    room_m, count = float(u.max() - u.min()) - 2 * edge_m, joint.rule.count
    fitting = min(count, int(room_m / SPACING_M + 1e-6) + 1) if room_m >= 0.0 else 0
    if float(v.max() - v.min()) < 2 * edge_m - 1e-6:
        fitting = 0
    steps = np.linspace(u.min() + edge_m, u.max() - edge_m, fitting) if fitting > 1 else [u.mean()]
    middle = float(v.max() + v.min()) / 2.0
    height = float(corners[0] @ normal)
    points = [s * along + middle * across + height * normal for s in steps[:fitting]]
    entries = [p - normal * _depth_m(bodies[joint.through], p, -normal) for p in points]
    free = [p for p in entries if not _is_taken(p, normal, joint, taken)]
    poses = [Pose.from_z_axis(_vector(p), _vector(normal), _vector(along)) for p in free]
    if len(poses) == count:
        return poses, None
    message = (
        f"Rule {joint.rule.id!r}: {len(poses)} of {count} fasteners fit between "
        f"{joint.through} and {joint.into} ({edge_m * 1000:.0f} mm to edges, "
        f"{SPACING_M * 1000:.0f} mm apart)."
    )
    return poses, warned("C3", owner, message, "Use thinner or fewer ones, or state operations.")


def _is_taken(entry: Points, normal: Points, joint: Joint, taken: list[_Entry]) -> bool:
    """Whether another fastener of the same member is nearer than the smallest spacing."""
    for member, other, direction in taken:
        if member == joint.through and abs(float(direction @ normal)) > _ALONG:
            apart = other - entry
            apart = apart - normal * float(apart @ normal)
            if float(np.linalg.norm(apart)) < SPACING_M - 1e-6:
                return True
    return False


def _depth_m(body: Body, start: Points, direction: Points) -> float:
    """Return how far a body reaches from a point on its face along a direction."""
    deepest = 0.0
    for part in body.parts:
        heights, rates = part.normals @ start - part.offsets_m, part.normals @ direction
        if heights.max() > _INSIDE_M + 1e-3:
            continue
        ahead = rates > 1e-9  # noqa: PLR2004 - faces that the line runs towards
        deepest = max(deepest, float((-heights[ahead] / rates[ahead]).min()))
    return deepest


def _covers(
    joint: Joint,
    spots: Sequence[Pose],
    bodies: Mapping[ComponentId, Body],
    place: Mapping[ComponentId, int],
    ground: tuple[Points, float],
) -> tuple[list[ComponentId], Problem | None]:
    """Return what covers the entry face later; a problem if something does so already."""
    ready = max(place[joint.through], place[joint.into])
    fronts = [np.array(p.position_m) - np.array(p.z_axis) * _ROOM_M for p in spots]
    covering = sorted(
        i
        for i, body in bodies.items()
        if i not in (joint.through, joint.into) and any(_is_in(body, f) for f in fronts)
    )
    there = [i for i in covering if place[i] < ready]
    up, level_m = ground
    if any(float(f @ up) < level_m - _INSIDE_M for f in fronts):
        there.append(ComponentId("the ground"))
    later = [i for i in covering if place[i] > ready]
    if not there:
        return later, None
    message = (
        f"Rule {joint.rule.id!r}: where fasteners go through {joint.through} into {joint.into}, "
        f"{there[0]} covers the entry face."
    )
    fix = "Give another order, or state operations from another side."
    where = bodies[joint.into].id
    return later, Problem(code="C3", severity="W", where=where, message=message, fix=fix)


def _is_in(body: Body, point: Points) -> bool:
    if np.any(point < body.low_m - _INSIDE_M) or np.any(point > body.high_m + _INSIDE_M):
        return False
    return any(float((p.normals @ point - p.offsets_m).max()) < _INSIDE_M for p in body.parts)


def _operation(owner: Component, joint: Joint, world_T_spot: Pose, number: int) -> Operation:
    word = f".{joint.rule.process.value}-{number + 1}"
    return Operation(
        id=OperationId(f"{owner.id[: 64 - len(word)]}{word}"),
        process=joint.rule.process,
        on=(joint.through, joint.into),
        component_T_operation=owner.world_T_component.inverse() @ world_T_spot,
        fastener=joint.rule.fastener,
        params={"rule": joint.rule.id},
        origin=Origin.RULE,
    )


def _held_m(
    components: Mapping[ComponentId, Component],
    joint: Joint,
    owner: ComponentId,
    operation: Operation,
) -> float:
    return penetration_m(components[owner], operation, components[joint.into])


def _too_short(
    components: Mapping[ComponentId, Component],
    joint: Joint,
    owner: ComponentId,
    operation: Operation,
) -> Problem:
    held_m = _held_m(components, joint, owner, operation)
    message = (
        f"Rule {joint.rule.id!r}: {joint.rule.fastener.l_m * 1000:g} mm through {joint.through} "
        f"leaves {held_m * 1000:.0f} mm in {joint.into} (< {MIN_PENETRATION_M * 1000:.0f})."
    )
    return warned("C1", components[owner], message, "Use a longer fastener in the rule.")


def _long_side(corners: Points) -> Points:
    """Return the direction of a polygon's longest edge, always the same way round."""
    edges = np.roll(corners, -1, axis=0) - corners
    lengths = np.linalg.norm(edges, axis=1)
    best = edges[int(np.argmax(np.round(lengths, 6)))] / lengths.max()
    leading = best[int(np.argmax(np.abs(best) > 1e-6))]  # noqa: PLR2004 - its first coordinate
    return np.asarray(best if leading > 0.0 else -best)


def _opposite(v: Vector) -> Vector:
    return (-v[0], -v[1], -v[2])


def _vector(row: Points) -> Vector:
    return (float(row[0]), float(row[1]), float(row[2]))
