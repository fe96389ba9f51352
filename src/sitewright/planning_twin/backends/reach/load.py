"""What moves with an arm in the reach check: links, end effector and piece, part by part."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.backends.arm_model import ArmModel
from sitewright.planning_twin.backends.convex_part import CompiledPart, compiled
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
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
class Load:
    """An arm with what it carries.

    Attributes:
        names: Link or body of each part.
        joint: Joint that moves each part; the base moves none.
        piece_T_part: Of the piece's parts, which are the last ones; their poses are given, not
            computed.
        own_a, own_b: Pairs of parts that can come near each other.
        own_names: Pair of bodies of each of them.
    """

    arm: ArmModel
    world_T_base: Array
    parts: tuple[CompiledPart, ...]
    names: tuple[str, ...]
    joint: Indices
    joint_T_part: Array
    half_m: Array
    radius_m: Array
    piece_T_part: Array
    own_a: Indices
    own_b: Indices
    own_names: tuple[Pair, ...]

    def placed(self, q: Array, world_T_piece: Array | None = None) -> Array:
        """Return world_T_part in postures, m x p x 4 x 4.

        Args:
            q: m x n.
            world_T_piece: m x 4 x 4, where the piece is; None if none is carried.
        """
        frames = self.world_T_base @ self.arm.chain.frames(q)
        out = frames[:, self.joint] @ self.joint_T_part
        if world_T_piece is not None:
            out[:, -len(self.piece_T_part) :] = world_T_piece[:, None] @ self.piece_T_part
        return np.asarray(out)


def load_of(robot: Robot, arm: ArmModel, tool: EndEffector, aperture_m: float) -> Load:
    """Return an arm with an end effector."""
    bodies = end_effector_bodies(tool, Attachment(robot.id, Pose()), aperture_m)
    alone = RobotInScene(
        description=robot.description, world_T_base=robot.world_T_base, q_rad=robot.home_q_rad
    )
    scene = SceneSnapshot(robots={robot.id: alone}, bodies={b.id: b for b in bodies})
    layout = laid_out(scene, {robot.id: arm})
    table = layout.pairs_of[robot.id]
    return Load(
        arm=arm,
        world_T_base=matrix_of(robot.world_T_base),
        parts=layout.parts,
        names=_part_names(robot.id, arm, bodies),
        joint=layout.joints_of[robot.id],
        joint_T_part=layout.joint_T_part_of[robot.id],
        half_m=layout.half_m,
        radius_m=layout.radius_m,
        piece_T_part=np.zeros((0, 4, 4)),
        own_a=table.a,
        own_b=table.b,
        own_names=tuple(table.names[n] for n in table.name.tolist()),
    )


def with_piece(load: Load, shape: Shape, name: str) -> Load:
    """Return an arm that carries a piece too; all links but the last ones may come near it."""
    added = [compiled(part) for part in shape]
    tip, joint_T_tip = load.arm.chain.carrier_by_link[load.arm.chain.tip]
    count = len(load.parts)
    near = np.flatnonzero(load.joint != tip)
    frames = np.array([joint_T_tip @ part.body_T_part for part in added])
    return replace(
        load,
        parts=(*load.parts, *added),
        names=(*load.names, *(name for _ in added)),
        joint=np.append(load.joint, np.full(len(added), tip)),
        joint_T_part=np.concatenate((load.joint_T_part, frames)),
        half_m=np.concatenate((load.half_m, [part.half_m for part in added])),
        radius_m=np.append(load.radius_m, [part.radius_m for part in added]),
        piece_T_part=np.array([part.body_T_part for part in added]),
        own_a=np.append(load.own_a, np.repeat(np.arange(count, count + len(added)), len(near))),
        own_b=np.append(load.own_b, np.tile(near, len(added))),
        own_names=(
            *load.own_names,
            *(pair_of(name, load.names[k]) for _ in added for k in near.tolist()),
        ),
    )


def _part_names(robot: RobotId, arm: ArmModel, bodies: list[Body]) -> tuple[str, ...]:
    """Return whose each part is, in the order in which a layout has them."""
    links = [link_name(robot, link) for link, parts in arm.parts_by_link.items() for _ in parts]
    return (*links, *(b.id for b in bodies for _ in b.shape))
