"""Reads the seven lengths of an ortho-parallel arm with spherical wrist off its description."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array, KinematicChain

_ARM_JOINTS = 6
_PARALLEL = 1e-9
_SAME_POINT_M = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class OpwGeometry:
    """An arm whose inverse kinematics are known in closed form.

    The names are those of the ortho-parallel basis with spherical wrist (OPW): the arm stands
    upright along z, its second and third axis lie along y.

    Attributes:
        lengths_m: a1, a2, b, c1, c2, c3, c4.
        offsets_rad: Per joint, so that the OPW angle is ``sign * q - offset``.
        is_flipped: Per joint, whether that sign is negative.
        base_T_opw: Frame in which the OPW arm stands.
    """

    lengths_m: tuple[float, ...]
    offsets_rad: tuple[float, ...]
    is_flipped: tuple[bool, ...]
    base_T_opw: Array


@dataclass(frozen=True, slots=True)
class NotOpw:
    """Why an arm has no closed form, for people."""

    reason: str


def opw_geometry(chain: KinematicChain) -> OpwGeometry | NotOpw:
    """Return the OPW lengths of an arm, or why it is not of that kind.

    Only the directions that decide the kind are looked at; whether the result is right must be
    checked against the arm's own forward kinematics.
    """
    if bool(chain.is_prismatic.any()):
        return NotOpw("a joint slides behind one that turns")
    if chain.joints != _ARM_JOINTS:
        return NotOpw(f"it has {chain.joints} turning joints, not {_ARM_JOINTS}")
    points, axes = _axis_lines(chain)
    if fault := _basis_fault(axes):
        return NotOpw(fault)
    wrist, miss_m = _meeting_point(points[3:], axes[3:])
    if miss_m > _SAME_POINT_M:
        return NotOpw(f"the last three axes miss each other by {miss_m * 1000:.3g} mm")
    return _measured(chain, points, axes, wrist)


def _basis_fault(axes: Array) -> str:
    """Return which of the axes do not stand to each other as they should; empty if all do."""
    right = ((0, 1), (2, 3), (3, 4), (4, 5))
    for a, b in right:
        if abs(axes[a] @ axes[b]) > _PARALLEL:
            angle_deg = math.degrees(math.acos(min(1.0, abs(float(axes[a] @ axes[b])))))
            return f"axes {a + 1} and {b + 1} stand at {angle_deg:.4g} deg, not at 90"
    if float(np.linalg.norm(np.cross(axes[1], axes[2]))) > _PARALLEL:
        return "axes 2 and 3 are not parallel"
    return ""


def _axis_lines(chain: KinematicChain) -> tuple[Array, Array]:
    """Return a point and the direction of every joint axis in the base, all joints at zero."""
    frames = chain.frames(np.zeros((1, chain.joints)))[0, :-1]
    return frames[:, :3, 3], np.einsum("nij,nj->ni", frames[:, :3, :3], chain.axes)


def _meeting_point(points: Array, axes: Array) -> tuple[Array, float]:
    """Return the point nearest to all lines, and by how much it misses the farthest."""
    across = np.eye(3) - axes[:, :, None] * axes[:, None, :]
    point, *_ = np.linalg.lstsq(
        across.reshape(-1, 3), np.einsum("nij,nj->ni", across, points).ravel(), rcond=None
    )
    miss = np.linalg.norm(np.einsum("nij,nj->ni", across, point - points), axis=1).max()
    return point, float(miss)


@dataclass(frozen=True, slots=True, eq=False)
class _Stand:
    """Where the upright arm stands: its frame, and shoulder and elbow in the plane of the arm."""

    x: Array
    y: Array
    z: Array
    foot: Array
    shoulder: Array
    elbow: Array


def _stand(points: Array, axes: Array) -> _Stand:
    foot = points[0] - (points[0] @ axes[0]) * axes[0]
    z = axes[0] if (points[1] - foot) @ axes[0] >= 0.0 else -axes[0]
    y = axes[1]
    shoulder, elbow = (p - ((p - foot) @ y) * y for p in points[1:3])
    if (shoulder - foot) @ np.cross(y, z) < 0.0:
        y = -y
    return _Stand(x=np.cross(y, z), y=y, z=z, foot=foot, shoulder=shoulder, elbow=elbow)


def _measured(chain: KinematicChain, points: Array, axes: Array, wrist: Array) -> OpwGeometry:
    at = _stand(points, axes)
    x, y, z, foot, shoulder, elbow = at.x, at.y, at.z, at.foot, at.shoulder, at.elbow
    upper = elbow - shoulder
    forearm = axes[3] if (wrist - elbow) @ axes[3] >= 0.0 else -axes[3]
    tip = chain.tips(np.zeros((1, chain.joints)))[0, :3, 3]
    hand = axes[5] if (tip - wrist) @ axes[5] >= 0.0 else -axes[5]
    lean_upper = math.atan2(upper @ x, upper @ z)
    lean_forearm = math.atan2(forearm @ x, forearm @ z)
    roll = math.atan2(axes[4] @ np.cross(forearm, y), axes[4] @ y)
    bend = math.atan2(np.cross(forearm, hand) @ axes[4], forearm @ hand)
    lengths_m = (
        (shoulder - foot) @ x,
        (wrist - elbow) @ np.cross(y, forearm),
        (wrist - foot) @ y,
        (shoulder - foot) @ z,
        float(np.linalg.norm(upper)),
        (wrist - elbow) @ forearm,
        (tip - wrist) @ hand,
    )
    base_T_opw = np.eye(4)
    base_T_opw[:3, :3] = np.column_stack((x, y, z))
    base_T_opw[:3, 3] = foot
    turns = (z, y, y, forearm, axes[4], hand)
    signs = [float(axis @ turn) for axis, turn in zip(axes, turns, strict=True)]
    starts = (0.0, lean_upper, lean_forearm - lean_upper, roll, bend, 0.0)
    return OpwGeometry(
        lengths_m=tuple(float(v) for v in lengths_m),
        offsets_rad=tuple(-v for v in starts),
        is_flipped=tuple(bool(s < 0.0) for s in signs),
        base_T_opw=base_T_opw,
    )
