"""Which parts a scene has, who carries them, and which pairs of them count."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.arm_model import ArmModel, carried, swing_radii
from sitewright.planning_twin.backends.convex_part import CompiledPart, compiled
from sitewright.planning_twin.backends.kinematic_chain import BASE, Array, matrix_of
from sitewright.planning_twin.backends.pair_table import Indices, PairTable
from sitewright.planning_twin.backends.pair_writer import PairWriter, Thing
from sitewright.planning_twin.scene import Attachment, Body, SceneSnapshot, link_name


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """What does not change when only poses and postures do.

    Attributes:
        parts: All parts; `half_m` and `radius_m` are theirs, row by row.
        rows_of: Rows of the parts that each robot carries, its base link included.
        pairs_of: Pairs that each robot's joints change.
        standing_of: Pairs that count and that its joints do not change.
        movable: How many things with a shape can move: links and what is carried.
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
    movable: int
    teams: dict[tuple[RobotId, ...], tuple[PairTable, PairTable]] = field(default_factory=dict)


def laid_out(scene: SceneSnapshot, arms: Mapping[RobotId, ArmModel]) -> Layout:
    """Return the layout of a snapshot: parts of still bodies first, then robot by robot."""
    things = [*_still_things(scene), *(t for r in arms for t in _carried_things(scene, r, arms[r]))]
    parts = [part for thing in things for part in thing.parts]
    owner = [thing.robot for thing in things for _ in thing.parts]
    rows_of = {r: np.flatnonzero([o == r for o in owner]) for r in arms}
    joint_of_part = np.array([p.joint for p in parts], dtype=np.intp)
    frames = np.array([p.joint_T_part for p in parts]).reshape(-1, 4, 4)
    writer = PairWriter(things, arms)
    tables = {r: writer.tables(r) for r in arms}
    return Layout(
        arms=arms,
        parts=tuple(p.part for p in parts),
        half_m=np.array([p.part.half_m for p in parts]).reshape(-1, 3),
        radius_m=np.array([p.part.radius_m for p in parts]),
        rows_of=rows_of,
        joints_of={r: joint_of_part[k] for r, k in rows_of.items()},
        joint_T_part_of={r: frames[k] for r, k in rows_of.items()},
        pairs_of={r: t[0] for r, t in tables.items()},
        standing_of={r: t[1] for r, t in tables.items()},
        movable=sum(1 for thing in things if thing.joint != BASE),
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
            radii=(None,) * len(body.shape),
        )
        for body in scene.bodies.values()
        if attachment(body) is None
    ]


def _carried_things(scene: SceneSnapshot, robot: RobotId, arm: ArmModel) -> list[Thing]:
    things = [
        Thing(
            name=link_name(robot, link),
            robot=robot,
            link=link,
            parts=parts,
            radii=arm.radii_by_link[link],
        )
        for link, parts in arm.parts_by_link.items()
    ]
    joint, joint_T_tip = arm.chain.carrier_by_link[arm.chain.tip]
    for body in scene.bodies.values():
        held = attachment(body)
        if held is not None and held.robot == robot:
            joint_T_body = joint_T_tip @ matrix_of(held.tip_T_body)
            parts = tuple(carried(joint, joint_T_body, p) for p in map(compiled, body.shape))
            radii = tuple(swing_radii(arm.chain, p) for p in parts)
            things.append(Thing(name=body.id, robot=robot, link=None, parts=parts, radii=radii))
    return things
