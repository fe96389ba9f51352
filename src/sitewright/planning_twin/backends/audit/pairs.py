"""Which pairs of parts a certificate must speak of, and how fast each can come nearer."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.audit.parts import (
    NO_JOINT,
    Array,
    Part,
    frames_of,
    link_parts,
    reaches_m,
)
from sitewright.planning_twin.scene import Pair, RobotInScene, SceneSnapshot, link_name, pair_of
from sitewright.robot_team.description import Description

_POSTURES = 100
_EVIDENCE_SEED = 4
_NOBODY = RobotId("")


@dataclass(frozen=True, slots=True, eq=False)
class PartPair:
    """Two parts that must keep a distance.

    Attributes:
        rates_m: By how much their distance shrinks at most per radian (or metre) of each joint
            of each robot.
        is_neighbour: Parts of one arm with a single joint between them.
    """

    a: Part
    b: Part
    name: Pair
    rates_m: dict[RobotId, Array]
    is_neighbour: bool


def pairs_of(scene: SceneSnapshot, parts: tuple[Part, ...]) -> tuple[PartPair, ...]:
    """Return all pairs that count.

    Left out are: what never moves against each other, links of one arm that share a joint, and
    links of one arm that overlap in every posture of a sample.
    """
    overlapping = {
        pair_of(*(link_name(robot, link) for link in links))
        for robot, arm in scene.robots.items()
        for links in always_overlapping(arm.description)
    }
    reaches = {
        id(p): reaches_m(scene.robots[p.robot].description, p) for p in parts if p.robot is not None
    }
    found = []
    for a, b in combinations(parts, 2):
        name = pair_of(a.name, b.name)
        if _counts(a, b) and name not in overlapping:
            near = a.robot is not None and a.robot == b.robot and abs(a.joint - b.joint) == 1
            rates = dict(_rates(a, b, reaches))
            found.append(PartPair(a, b, name, rates, near))
    return tuple(found)


def _counts(a: Part, b: Part) -> bool:
    if a.joint == NO_JOINT and b.joint == NO_JOINT:
        return False
    if a.robot is None or a.robot != b.robot:
        return True
    if a.joint == b.joint:
        return False
    return not (a.is_link and b.is_link and abs(a.joint - b.joint) <= 1)


def _rates(a: Part, b: Part, reaches: dict[int, Array]) -> Iterator[tuple[RobotId, Array]]:
    """Yield the rates: joints that carry both parts leave their distance alone."""
    if a.robot is not None and a.robot == b.robot:
        outer, inner = (a, b) if a.joint > b.joint else (b, a)
        rates = reaches[id(outer)].copy()
        rates[: inner.joint + 1] = 0.0
        yield a.robot, rates
        return
    for part in (a, b):
        if part.robot is not None and part.joint != NO_JOINT:
            yield part.robot, reaches[id(part)]


@lru_cache(maxsize=16)
def always_overlapping(arm: Description) -> frozenset[tuple[str, str]]:
    """Return the pairs of links that no posture of a sample separates."""
    rng = np.random.default_rng(_EVIDENCE_SEED)
    joints = arm.movable_joints
    parts = link_parts(_NOBODY, arm)
    left = [pair for pair in combinations(parts, 2) if _may_meet(*pair)]
    for _ in range(_POSTURES):
        q = tuple(float(rng.uniform(j.lower_rad, j.upper_rad)) for j in joints)
        frames = frames_of(RobotInScene(description=arm, world_T_base=Pose(), q_rad=q), q)
        meeting = {(a.frame, b.frame) for a, b in left if _overlap(frames, a, b)}
        left = [(a, b) for a, b in left if (a.frame, b.frame) in meeting]
    return frozenset((a.frame, b.frame) for a, b in left)


def _may_meet(a: Part, b: Part) -> bool:
    return a.name != b.name and abs(a.joint - b.joint) > 1


def _overlap(frames: dict[str, Array], a: Part, b: Part) -> bool:
    import coal

    placed = [
        argument
        for part in (a, b)
        for argument in (part.solid, coal.Transform3s(*_turn_and_shift(frames[part.frame])))
    ]
    return bool(coal.collide(*placed, coal.CollisionRequest(), coal.CollisionResult()))


def _turn_and_shift(frame: Array) -> tuple[Array, Array]:
    return frame[:3, :3], frame[:3, 3]
