"""All grasps of a piece as arrays, grouped by how wide the gripper opens and by kind."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sitewright.foundation.pose import Pose, rotation
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.grasps import Grasp, grasps_of
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.reachability.answer import GraspWay
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.gripper import mount_T_tcp

_AXES = "xyz"


@dataclass(frozen=True, slots=True, eq=False)
class GraspGroup:
    """Grasps for which the gripper opens and closes alike, the cheapest first.

    Attributes:
        piece_T_tip: g x 4 x 4, the robot's tip in the frame of the piece.
        approach: g x 3, unit vectors in the frame of the piece: the way in.
        kind: g, equal for grasps that differ only in their offset along the piece.
    """

    grasps: tuple[Grasp, ...]
    piece_T_tip: Array
    approach: Array
    kind: Indices
    open_m: float
    width_m: float

    def rounds(self) -> Iterator[Indices]:
        """Yield, for each offset, the grasps that have it as their next best, one per kind."""
        turn = np.zeros(len(self.kind), dtype=np.intp)
        for kind in np.unique(self.kind):
            mine = np.flatnonzero(self.kind == kind)
            turn[mine] = np.arange(len(mine))
        for k in range(int(turn.max(initial=-1)) + 1):
            yield np.flatnonzero(turn == k)


def grasp_groups(
    piece: PieceShape, tool: EndEffector, world_T_piece: Pose | None
) -> tuple[GraspGroup, ...]:
    """Return the grasps of a piece as it lies; as it may lie on any of its sides if None."""
    found = grasps_of(piece, tool, world_T_piece) if world_T_piece else _any(piece, tool)
    widths = sorted({(g.open_m, g.width_m) for g in found})
    return tuple(_group([g for g in found if (g.open_m, g.width_m) == w], tool) for w in widths)


def way_of(grasp: Grasp, insertion: int) -> GraspWay:
    """Return the freedoms of a grasp by name."""
    approach, closing = grasp.piece_T_tcp.z_axis, grasp.piece_T_tcp.y_axis
    pitch_rad = math.asin(max(-1.0, min(1.0, approach[0])))
    axis = 2 if abs(closing[1]) > abs(closing[2]) else 1
    x_axis = grasp.piece_T_tcp.x_axis
    is_turned = x_axis[0] < 0.0
    sign = "-" if approach[axis] > 0.0 else "+"
    return GraspWay(
        face=f"{sign}{_AXES[axis]}",
        pitch_deg=round(math.degrees(pitch_rad), 1) + 0.0,
        is_turned=is_turned,
        offset_m=grasp.piece_T_tcp.position_m[0],
        insertion=insertion,
    )


def _any(piece: PieceShape, tool: EndEffector) -> list[Grasp]:
    quarters = (rotation((1.0, 0.0, 0.0), k * math.pi / 2.0) for k in range(4))
    return [g for quarter in quarters for g in grasps_of(piece, tool, quarter)]


def _group(grasps: Sequence[Grasp], tool: EndEffector) -> GraspGroup:
    frames = np.array([matrix_of(g.piece_T_tcp) for g in grasps])
    turns = frames[:, :3, :3].reshape(len(frames), -1).round(6)
    _, kind = np.unique(turns, axis=0, return_inverse=True)
    return GraspGroup(
        grasps=tuple(grasps),
        piece_T_tip=frames @ np.linalg.inv(matrix_of(mount_T_tcp(tool.description))),
        approach=frames[:, :3, 2],
        kind=np.asarray(kind).reshape(-1),
        open_m=grasps[0].open_m,
        width_m=grasps[0].width_m,
    )
