"""Which parts a scene has, who carries them, and which pairs of them count."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

import numpy as np
import numpy.typing as npt

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.arm_model import (
    ArmModel,
    CarriedPart,
    carried,
    swing_radii,
)
from sitewright.planning_twin.backends.convex_part import CompiledPart, compiled
from sitewright.planning_twin.backends.kinematic_chain import BASE, Array, matrix_of
from sitewright.planning_twin.scene import Attachment, Body, Pair, SceneSnapshot, link_name, pair_of

Indices = npt.NDArray[np.intp]


@dataclass(frozen=True, slots=True, eq=False)
class PairTable:
    """Pairs of parts that one robot's motion changes (or that no motion changes).

    Attributes:
        a, b: Numbers of the two parts.
        name: Number of the pair of bodies in `names`.
        is_neighbour: Whether a row is of two parts of one arm with one joint between them (a tool
            and the link before the last one); their distance hardly depends on the motion.
        weights: pairs x joints; how far the parts come nearer at most per radian of each joint.
        queries: Compiled distance queries by row, made when first asked for.
    """

    a: Indices
    b: Indices
    name: Indices
    names: tuple[Pair, ...]
    is_neighbour: npt.NDArray[np.bool_]
    weights: Array
    queries: dict[int, Any] = field(default_factory=dict)

    def thresholds(self, clearance_m: float, declared_m: Mapping[Pair, float]) -> Array:
        """Return the distance that each row must keep."""
        by_name = np.array([declared_m.get(n, clearance_m) for n in self.names])
        return np.asarray(by_name[self.name], dtype=np.float64)

    def is_declared(self, declared_m: Mapping[Pair, float]) -> npt.NDArray[np.bool_]:
        """Return which rows are declared."""
        by_name = np.array([n in declared_m for n in self.names], dtype=np.bool_)
        return np.asarray(by_name[self.name], dtype=np.bool_)


@dataclass(frozen=True, slots=True, eq=False)
class Thing:
    """A link or a body: what pairs are named after."""

    name: str
    robot: RobotId | None
    link: str | None
    parts: tuple[CarriedPart, ...]

    @property
    def joint(self) -> int:
        """Number of the joint that carries it."""
        return self.parts[0].joint if self.robot is not None else BASE

    @property
    def is_still(self) -> bool:
        """Whether no joint of any robot moves it."""
        return self.joint == BASE


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """What does not change when only poses and postures do.

    Attributes:
        parts: All parts; `half_m` and `radius_m` are theirs, row by row.
        rows_of: Rows of the parts that each robot carries, its base link included.
        pairs_of: Pairs that each robot's joints change.
        standing_of: Pairs that count and that its joints do not change.
        teams: Both tables for robots that move in step, made when first asked for.
    """

    arms: Mapping[RobotId, ArmModel]
    parts: tuple[CompiledPart, ...]
    half_m: Array
    radius_m: Array
    rows_of: Mapping[RobotId, Indices]
    joints_of: Mapping[RobotId, Indices]
    joint_T_part_of: Mapping[RobotId, Array]
    pairs_of: Mapping[RobotId, PairTable]
    standing_of: Mapping[RobotId, PairTable]
    teams: dict[tuple[RobotId, ...], tuple[PairTable, PairTable]] = field(default_factory=dict)


def laid_out(scene: SceneSnapshot, arms: Mapping[RobotId, ArmModel]) -> Layout:
    """Return the layout of a snapshot: parts of still bodies first, then robot by robot."""
    things = [*_still_things(scene), *(t for r in arms for t in _carried_things(scene, r, arms[r]))]
    rows: dict[str, range] = {}
    parts: list[CarriedPart] = []
    for thing in things:
        rows[thing.name] = range(len(parts), len(parts) + len(thing.parts))
        parts.extend(thing.parts)
    rows_of = {
        robot: [k for t in things if t.robot == robot for k in rows[t.name]] for robot in arms
    }
    radii_of = [
        swing_radii(arms[t.robot].chain, p) if t.robot else None for t in things for p in t.parts
    ]
    counted = [pair for pair in combinations(things, 2) if _counts(*pair, arms)]
    tables = {r: _tables(r, counted, rows, radii_of, arms) for r in arms}
    return Layout(
        arms=arms,
        parts=tuple(p.part for p in parts),
        half_m=np.array([p.part.half_m for p in parts]).reshape(-1, 3),
        radius_m=np.array([p.part.radius_m for p in parts]),
        rows_of={r: np.array(k, dtype=np.intp) for r, k in rows_of.items()},
        joints_of={
            r: np.array([parts[i].joint for i in k], dtype=np.intp) for r, k in rows_of.items()
        },
        joint_T_part_of={
            r: np.array([parts[i].joint_T_part for i in k]).reshape(-1, 4, 4)
            for r, k in rows_of.items()
        },
        pairs_of={r: t[0] for r, t in tables.items()},
        standing_of={r: t[1] for r, t in tables.items()},
    )


def attachment(body: Body) -> Attachment | None:
    """Return how a body is carried, or None if it stands."""
    return body.placement if isinstance(body.placement, Attachment) else None


def _still_things(scene: SceneSnapshot) -> list[Thing]:
    return [
        Thing(
            name=body.id,
            robot=None,
            link=None,
            parts=tuple(carried(BASE, np.eye(4), p) for p in map(compiled, body.shape)),
        )
        for body in scene.bodies.values()
        if attachment(body) is None
    ]


def _carried_things(scene: SceneSnapshot, robot: RobotId, arm: ArmModel) -> list[Thing]:
    things = [
        Thing(name=link_name(robot, link), robot=robot, link=link, parts=parts)
        for link, parts in arm.parts_by_link.items()
    ]
    joint, joint_T_tip = arm.chain.carrier_by_link[arm.chain.tip]
    for body in scene.bodies.values():
        held = attachment(body)
        if held is not None and held.robot == robot:
            joint_T_body = joint_T_tip @ matrix_of(held.tip_T_body)
            parts = tuple(carried(joint, joint_T_body, p) for p in map(compiled, body.shape))
            things.append(Thing(name=body.id, robot=robot, link=None, parts=parts))
    return things


def _counts(a: Thing, b: Thing, arms: Mapping[RobotId, ArmModel]) -> bool:
    """Tell whether a pair can ever collide by a motion, neighbours aside."""
    if not a.parts or not b.parts or (a.is_still and b.is_still):
        return False
    if a.robot is None or a.robot != b.robot:
        return True
    if a.joint == b.joint:
        return False
    is_own = a.link is not None and b.link is not None
    return not (is_own and frozenset((a.link, b.link)) in arms[a.robot].neighbours)


def _tables(
    robot: RobotId,
    counted: Iterable[tuple[Thing, Thing]],
    rows: Mapping[str, range],
    radii_of: list[Array | None],
    arms: Mapping[RobotId, ArmModel],
) -> tuple[PairTable, PairTable]:
    """Return the pairs that a robot's joints change, and those that they leave alone."""
    moving: list[tuple[Thing, Thing]] = []
    standing: list[tuple[Thing, Thing]] = []
    for a, b in counted:
        changes = any(t.robot == robot and not t.is_still for t in (a, b))
        (moving if changes else standing).append((a, b))
    joints = arms[robot].chain.joints
    return _table(robot, moving, rows, radii_of, joints), _table(
        robot, standing, rows, radii_of, joints
    )


def _table(
    robot: RobotId,
    pairs: list[tuple[Thing, Thing]],
    rows: Mapping[str, range],
    radii_of: list[Array | None],
    joints: int,
) -> PairTable:
    found: list[tuple[int, int, int]] = []
    weights: list[Array] = []
    for number, (a, b) in enumerate(pairs):
        outer, inner = (a, b) if a.robot == robot and a.joint >= _joint_in(b, robot) else (b, a)
        shared = _joint_in(inner, robot) + 1
        for i in rows[outer.name]:
            weight = np.zeros(joints)
            radii = radii_of[i]
            if outer.robot == robot and radii is not None:
                weight[shared:] = radii[shared:]
            for j in rows[inner.name]:
                found.append((i, j, number))
                weights.append(weight)
    table = np.array(found, dtype=np.intp).reshape(-1, 3)
    return PairTable(
        a=table[:, 0],
        b=table[:, 1],
        name=table[:, 2],
        names=tuple(pair_of(a.name, b.name) for a, b in pairs),
        is_neighbour=np.array(
            [
                a.robot is not None and a.robot == b.robot and abs(a.joint - b.joint) == 1
                for a, b in pairs
            ],
            dtype=np.bool_,
        )[table[:, 2]],
        weights=np.array(weights).reshape(-1, joints),
    )


def _joint_in(thing: Thing, robot: RobotId) -> int:
    """Return the joint of `robot` that carries a thing, `BASE` if none of its joints does."""
    return thing.joint if thing.robot == robot else BASE
