"""What stays the same about an arm in every scene: its parts, and which of them never collide."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from sitewright.planning_twin.backends.convex_part import CompiledPart, compiled
from sitewright.planning_twin.backends.kinematic_chain import Array, KinematicChain, chain_of
from sitewright.robot_team.description import Description

_EVIDENCE_POSTURES = 256


@dataclass(frozen=True, slots=True, eq=False)
class CarriedPart:
    """A compiled part in the frame of the joint that carries it (`BASE`: none)."""

    part: CompiledPart
    joint: int
    joint_T_part: Array


@dataclass(frozen=True, slots=True, eq=False)
class ArmModel:
    """An arm compiled for the proof scene.

    Attributes:
        parts_by_link: Parts of every link that has a shape.
        radii_by_link: `swing_radii` of each of them.
        neighbours: Pairs of links that are never looked at: those that share a joint, and those
            that overlap in every posture, so that no motion could ever avoid it.
    """

    chain: KinematicChain
    parts_by_link: dict[str, tuple[CarriedPart, ...]]
    radii_by_link: dict[str, tuple[Array, ...]]
    neighbours: frozenset[frozenset[str]]


def arm_model(description: Description) -> ArmModel:
    """Compile an arm."""
    chain = chain_of(description)
    parts_by_link: dict[str, tuple[CarriedPart, ...]] = {}
    for link in description.links:
        joint, joint_T_link = chain.carrier_by_link[link.name]
        if link.shape:
            parts_by_link[link.name] = tuple(
                carried(joint, joint_T_link, p) for p in map(compiled, link.shape)
            )
    return ArmModel(
        chain=chain,
        parts_by_link=parts_by_link,
        radii_by_link={
            link: tuple(swing_radii(chain, p) for p in parts)
            for link, parts in parts_by_link.items()
        },
        neighbours=_adjacent(chain, parts_by_link) | _always_overlapping(chain, parts_by_link),
    )


def carried(joint: int, joint_T_body: Array, part: CompiledPart) -> CarriedPart:
    """Return a body's part as it is carried by a joint."""
    return CarriedPart(part=part, joint=joint, joint_T_part=joint_T_body @ part.body_T_part)


def swing_radii(chain: KinematicChain, carried_part: CarriedPart) -> Array:
    """Return, per joint, how far at most a point of the part moves per radian (or metre).

    The bound holds for all postures: joints between the turning one and the part are taken as
    stretched out. Joints behind the part do not move it: 0.
    """
    radii = np.zeros(chain.joints)
    joint = carried_part.joint
    if joint < 0:
        return radii
    frame = carried_part.joint_T_part
    points = carried_part.part.vertices_m @ frame[:3, :3].T + frame[:3, 3]
    radii[joint] = _off_axis(points, chain.spins[joint]).max()
    length = float(np.linalg.norm(points, axis=1).max())
    slide = np.where(chain.is_prismatic, np.maximum(np.abs(chain.lower), np.abs(chain.upper)), 0.0)
    for i in range(joint - 1, -1, -1):
        offset = chain.carrier_T_joint[i + 1][:3, 3]
        length += float(slide[i + 1])
        radii[i] = float(_off_axis(offset[None], chain.spins[i])[0]) + length
        length += float(np.linalg.norm(offset))
    radii[: joint + 1][chain.is_prismatic[: joint + 1]] = 1.0
    return radii


def _off_axis(points: Array, spin: Array) -> Array:
    """Return how far points are from an axis through the origin, given as its vector product."""
    return np.asarray(np.linalg.norm(points @ spin.T, axis=1))


def _adjacent(
    chain: KinematicChain, parts_by_link: dict[str, tuple[CarriedPart, ...]]
) -> frozenset[frozenset[str]]:
    joint_by_link = {link: chain.carrier_by_link[link][0] for link in parts_by_link}
    return frozenset(
        frozenset((a, b))
        for a, b in combinations(parts_by_link, 2)
        if abs(joint_by_link[a] - joint_by_link[b]) <= 1
    )


def _always_overlapping(
    chain: KinematicChain, parts_by_link: dict[str, tuple[CarriedPart, ...]]
) -> frozenset[frozenset[str]]:
    rng = np.random.default_rng(0)
    q = rng.uniform(chain.lower, chain.upper, (_EVIDENCE_POSTURES, chain.joints))
    frames = chain.frames(q)
    return frozenset(
        frozenset((a, b))
        for a, b in combinations(parts_by_link, 2)
        if all(_overlap(f, parts_by_link[a], parts_by_link[b]) for f in frames)
    )


def _overlap(frames: Array, a: tuple[CarriedPart, ...], b: tuple[CarriedPart, ...]) -> bool:
    import coal

    request = coal.CollisionRequest()
    for x in a:
        for y in b:
            world_T_x = frames[x.joint] @ x.joint_T_part
            world_T_y = frames[y.joint] @ y.joint_T_part
            if coal.collide(
                x.part.geometry,
                coal.Transform3s(world_T_x[:3, :3], world_T_x[:3, 3]),
                y.part.geometry,
                coal.Transform3s(world_T_y[:3, :3], world_T_y[:3, 3]),
                request,
                coal.CollisionResult(),
            ):
                return True
    return False
