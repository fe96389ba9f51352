"""Grasp candidates of a piece: where the gripper's tcp may sit, the cheapest first."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import product

from sitewright.foundation.pose import Pose, Vector, cross, dot, rotation, scale
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.description import Description
from sitewright.robot_team.gripper import finger_parts, mount_T_tcp

_FLOOR_GAP_M = 0.002
"""Fingertips end this far above what the piece lies on (motion note, section 4)."""
_MIN_PAD_M = 0.005
"""The tcp stays at least this deep under the face that the gripper comes from."""
_PITCHES_DEG = (0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0)
_OFFSET_STEP_M = 0.1
_END_MARGIN_M = 0.05
_MAX_OFFSET_M = 0.6
_OPENING_MARGIN_M = 0.020
_DOWNWARDS = -0.5

_X: Vector = (1.0, 0.0, 0.0)
_APPROACHES: tuple[tuple[Vector, int, int], ...] = (
    ((0.0, 0.0, -1.0), 2, 1),
    ((0.0, 0.0, 1.0), 2, 1),
    ((0.0, -1.0, 0.0), 1, 2),
    ((0.0, 1.0, 0.0), 1, 2),
)
"""Approach direction in the component frame, its axis, and the axis the fingers close along."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Grasp:
    """One way to hold a piece.

    Attributes:
        piece_T_tcp: The tcp's z is the approach direction, its y the closing axis.
        width_m: Aperture when closed on the piece.
        open_m: Aperture while coming and going.
        cost: Order of preference: pitch and offset from the middle.
    """

    piece_T_tcp: Pose
    width_m: float
    open_m: float
    cost: float

    def tip_T_piece(self, tool: EndEffector) -> Pose:
        """Return the pose of the held piece in the robot's tip frame."""
        return mount_T_tcp(tool.description) @ self.piece_T_tcp.inverse()


def grasps_of(piece: PieceShape, tool: EndEffector, world_T_piece: Pose) -> list[Grasp]:
    """Return all candidates that come from above where the piece lies, cheapest first.

    Args:
        piece: Box and shape of the piece.
        tool: A gripper with a grip range.
        world_T_piece: Where it lies now; sides that look down are left out.
    """
    found = [
        grasp
        for approach, axis, closing in _APPROACHES
        if world_T_piece.turn(approach)[2] < _DOWNWARDS
        for grasp in _from_side(piece, tool, approach, axis, closing)
    ]
    return sorted(found, key=lambda g: g.cost)


def grasp_in_use(tool: EndEffector, tip_T_held: Pose, width_m: float) -> Grasp:
    """Return the grasp by which a robot holds a piece already."""
    return Grasp(
        piece_T_tcp=tip_T_held.inverse() @ mount_T_tcp(tool.description),
        width_m=width_m,
        open_m=min(tool.opens_to_m, width_m + 2 * _OPENING_MARGIN_M),
        cost=0.0,
    )


def _from_side(
    piece: PieceShape, tool: EndEffector, approach: Vector, axis: int, closing: int
) -> Iterator[Grasp]:
    width_m = piece.size_m[closing]
    low, high = tool.grips_m or (0.0, 0.0)
    if not low <= width_m <= high:
        return
    open_m = min(tool.opens_to_m, max(width_m + 2 * _OPENING_MARGIN_M, high))
    for pitch_deg, flip in product(_PITCHES_DEG, (1.0, -1.0)):
        piece_R_tcp = _orientation(approach, flip, math.radians(pitch_deg))
        depth_m = _depth(piece.size_m[axis], tool, approach, piece_R_tcp, width_m)
        if depth_m is None:
            continue
        for offset_m in _offsets(piece.size_m[0]):
            position = (offset_m, *scale(approach, depth_m)[1:])
            yield Grasp(
                piece_T_tcp=Pose(position, piece_R_tcp.quaternion_wxyz),
                width_m=width_m,
                open_m=open_m,
                cost=abs(offset_m) + abs(pitch_deg) / 30.0 + (0.001 if flip < 0 else 0.0),
            )


def _orientation(approach: Vector, flip: float, pitch_rad: float) -> Pose:
    x_axis = scale(_X, flip)
    upright = Pose.from_axes((0.0, 0.0, 0.0), x_axis, cross(approach, x_axis))
    return upright @ rotation((0.0, 1.0, 0.0), pitch_rad)


def _depth(
    height_m: float, tool: EndEffector, approach: Vector, piece_R_tcp: Pose, width_m: float
) -> float | None:
    """Return how far past the piece's middle the tcp goes along the approach direction."""
    overhang_m = _overhang_m(tool.description, approach, piece_R_tcp, width_m)
    depth_m = min(0.0, height_m / 2.0 - _FLOOR_GAP_M - overhang_m)
    return depth_m if depth_m > -height_m / 2.0 + _MIN_PAD_M else None


@lru_cache(maxsize=4096)
def _overhang_m(
    description: Description, approach: Vector, piece_R_tcp: Pose, width_m: float
) -> float:
    """Return how far the fingers end past the tcp along the approach direction."""
    tcp_T_mount = mount_T_tcp(description).inverse()
    return max(
        dot(piece_R_tcp.turn(tcp_T_mount.apply(vertex)), approach)
        for shape in finger_parts(description, width_m).values()
        for part in shape
        for vertex in part.vertices_m()
    )


def _offsets(length_m: float) -> list[float]:
    limit = min(length_m / 2.0 - _END_MARGIN_M, _MAX_OFFSET_M)
    steps = max(0, int(limit / _OFFSET_STEP_M + 1e-9))
    return sorted((k * _OFFSET_STEP_M for k in range(-steps, steps + 1)), key=abs)
