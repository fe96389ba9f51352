"""What moves with an arm in the reach check: links, end effector and piece, part by part."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.backends.arm_model import ArmModel
from sitewright.planning_twin.backends.convex_part import CompiledPart, compiled
from sitewright.planning_twin.backends.kinematic_chain import BASE, Array, matrix_of
from sitewright.planning_twin.backends.layout import laid_out
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.jobsite import end_effector_bodies
from sitewright.planning_twin.scene import (
    Attachment,
    Body,
    Pair,
    RobotInScene,
    SceneSnapshot,
    link_name,
    pair_of,
)
from sitewright.robot_team.cell import EndEffector, Robot


@dataclass(frozen=True, slots=True, eq=False)
class Moving:
    """Convex parts that move, and which of them are looked at.

    Attributes:
        names: Link or body of each part.
        outer: Parts that are held against what stands still.
        own_a, own_b: Pairs of parts that can come near each other.
        own_names: Pair of bodies of each of them.
        piece_T_part: Of the parts of a carried piece, which are the last ones: their poses are
            given, not computed.
    """

    parts: tuple[CompiledPart, ...]
    names: tuple[str, ...]
    half_m: Array
    radius_m: Array
    outer: Indices
    own_a: Indices
    own_b: Indices
    own_names: tuple[Pair, ...]
    piece_T_part: Array

    def with_piece(self, frames: Array, world_T_piece: Array | None) -> Array:
        """Return placed parts, m x p x 4 x 4, with those of the piece put where it is."""
        count = len(self.piece_T_part)
        if count and world_T_piece is not None:
            frames[:, -count:] = world_T_piece[:, None] @ self.piece_T_part
        return frames


@dataclass(frozen=True, slots=True, eq=False)
class Rigid:
    """What moves as one body: the hand (last link and end effector), or a carried piece.

    Attributes:
        frame_T_part: Of each part, in the frame of the tip, or of the piece.
    """

    moving: Moving
    frame_T_part: Array

    def placed(self, world_T_frames: Array) -> Array:
        """Return world_T_part, m x p x 4 x 4."""
        return np.asarray(world_T_frames[:, None] @ self.frame_T_part)


@dataclass(frozen=True, slots=True, eq=False)
class Load:
    """An arm with what it carries; only the links before the last are outer parts.

    Attributes:
        joint: Joint that moves each part; the base moves none.
    """

    arm: ArmModel
    world_T_base: Array
    moving: Moving
    joint: Indices
    joint_T_part: Array

    def placed(self, q: Array, world_T_piece: Array | None = None) -> Array:
        """Return world_T_part in postures, m x p x 4 x 4, with a piece where it is said to be."""
        frames = self.world_T_base @ self.arm.chain.frames(q)
        placed = np.asarray(frames[:, self.joint] @ self.joint_T_part)
        return self.moving.with_piece(placed, world_T_piece)

    def hand(self) -> Rigid:
        """Return what is rigid to the tip, a carried piece aside."""
        tip, joint_T_tip = self.arm.chain.carrier_by_link[self.arm.chain.tip]
        carried = len(self.moving.parts) - len(self.moving.piece_T_part)
        mine = np.flatnonzero((self.joint == tip) & (np.arange(len(self.joint)) < carried))
        tip_T_part = np.linalg.inv(joint_T_tip) @ self.joint_T_part[mine]
        return Rigid(_only(self.moving, mine), tip_T_part)

    def piece(self) -> Rigid | None:
        """Return the carried piece, if there is one."""
        count = len(self.moving.piece_T_part)
        if not count:
            return None
        last = np.arange(len(self.moving.parts) - count, len(self.moving.parts))
        return Rigid(_only(self.moving, last), self.moving.piece_T_part)


def _only(moving: Moving, rows: Indices) -> Moving:
    """Return some of the parts, which are rigid to each other."""
    none = np.zeros(0, dtype=np.intp)
    return Moving(
        parts=tuple(moving.parts[k] for k in rows),
        names=tuple(moving.names[k] for k in rows),
        half_m=moving.half_m[rows],
        radius_m=moving.radius_m[rows],
        outer=np.arange(len(rows)),
        own_a=none,
        own_b=none,
        own_names=(),
        piece_T_part=np.zeros((0, 4, 4)),
    )


def load_of(robot: Robot, arm: ArmModel, tool: EndEffector, aperture_m: float) -> Load:
    """Return an arm with an end effector."""
    bodies = end_effector_bodies(tool, Attachment(robot.id, Pose()), aperture_m)
    alone = RobotInScene(
        description=robot.description, world_T_base=robot.world_T_base, q_rad=robot.home_q_rad
    )
    scene = SceneSnapshot(robots={robot.id: alone}, bodies={b.id: b for b in bodies})
    layout = laid_out(scene, {robot.id: arm})
    table, joint = layout.pairs_of[robot.id], layout.joints_of[robot.id]
    tip, _ = arm.chain.carrier_by_link[arm.chain.tip]
    moving = Moving(
        parts=layout.parts,
        names=_part_names(robot.id, arm, bodies),
        half_m=layout.half_m,
        radius_m=layout.radius_m,
        outer=np.flatnonzero((joint != BASE) & (joint != tip)),
        own_a=table.a,
        own_b=table.b,
        own_names=tuple(table.names[n] for n in table.name.tolist()),
        piece_T_part=np.zeros((0, 4, 4)),
    )
    return Load(
        arm=arm,
        world_T_base=matrix_of(robot.world_T_base),
        moving=moving,
        joint=joint,
        joint_T_part=layout.joint_T_part_of[robot.id],
    )


def with_piece(load: Load, shape: Shape, name: str) -> Load:
    """Return an arm that carries a piece too; its links but the last may come near it."""
    before = load.moving
    added = [compiled(part) for part in shape]
    tip, _ = load.arm.chain.carrier_by_link[load.arm.chain.tip]
    near = np.flatnonzero(load.joint != tip)
    new = np.arange(len(before.parts), len(before.parts) + len(added))
    piece_T_part = np.array([part.body_T_part for part in added])
    moving = replace(
        before,
        parts=(*before.parts, *added),
        names=(*before.names, *(name for _ in added)),
        half_m=np.concatenate((before.half_m, [part.half_m for part in added])),
        radius_m=np.append(before.radius_m, [part.radius_m for part in added]),
        own_a=np.append(before.own_a, np.repeat(new, len(near))),
        own_b=np.append(before.own_b, np.tile(near, len(added))),
        own_names=(
            *before.own_names,
            *(pair_of(name, before.names[k]) for _ in added for k in near.tolist()),
        ),
        piece_T_part=piece_T_part,
    )
    return replace(
        load,
        moving=moving,
        joint=np.append(load.joint, np.full(len(added), tip)),
        joint_T_part=np.concatenate((load.joint_T_part, piece_T_part)),
    )


def _part_names(robot: RobotId, arm: ArmModel, bodies: list[Body]) -> tuple[str, ...]:
    """Return whose each part is, in the order in which a layout has them."""
    links = [link_name(robot, link) for link, parts in arm.parts_by_link.items() for _ in parts]
    return (*links, *(b.id for b in bodies for _ in b.shape))
