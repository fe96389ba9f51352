"""Closed-form inverse kinematics of arms with ortho-parallel basis and spherical wrist."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.backends.extensions import extension
from sitewright.planning_twin.backends.kinematic_chain import Array, KinematicChain
from sitewright.planning_twin.backends.opw_geometry import OpwGeometry
from sitewright.planning_twin.backends.solver import OUTSIDE_LIMITS, nearest
from sitewright.planning_twin.backends.whole_turns import Flags, distinct, wrapped
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Joints

_NUDGE_RAD = 1e-7
"""Turn about the tool's y axis that brings back the branches lost at a straight wrist."""
_BRANCHES = 8
_SINGULAR = 1e-6
"""Smallest singular value of the Jacobian under which a branch stands for many postures."""


class _OpwRobot(Protocol):
    """What is used of the compiled solver; its own wrapper converts poses at a cost."""

    def batch_forward(self, joints: Array) -> Array: ...

    def forward(self, joints: Joints) -> list[list[float]]: ...

    def reach(self, poses: Array) -> tuple[Array, Array, Array, Array, Array]: ...


@dataclass(frozen=True, slots=True, eq=False)
class Branches:
    """What the closed form says about one pose.

    Attributes:
        postures: Up to eight, one per row, regardless of limits.
        extension_m: How far the pose is within reach; negative is out of reach.
        is_singular: In one of them joints can share a turn freely, so that there are more.
    """

    postures: Array
    extension_m: float
    is_singular: bool


class OpwSolver:
    """All branches of an arm; that there are none is a proof.

    Attributes:
        shoulder_m: Point on the first axis, at the height of the second, in the base.
        reach_m: The centre of the wrist is never further from it.
    """

    def __init__(self, chain: KinematicChain, geometry: OpwGeometry) -> None:
        self.chain = chain
        self._robot = _robot(geometry)
        self._base_T_opw = geometry.base_T_opw
        zero = np.zeros((1, chain.joints))
        self._opw_T_base = np.linalg.inv(geometry.base_T_opw)
        self._tip_T_opw_tip = np.linalg.inv(chain.tips(zero)[0]) @ self._opw_tips(zero)[0]
        self._opw_tip_T_tip = np.linalg.inv(self._tip_T_opw_tip)
        self._nudge = self._tip_T_opw_tip @ _NUDGE @ self._opw_tip_T_tip
        a1, a2, b, c1, c2, c3, self._hand_m = geometry.lengths_m
        self.shoulder_m: Array = (geometry.base_T_opw @ (0.0, 0.0, c1, 1.0))[:3]
        self.reach_m = math.hypot(abs(a1) + abs(c2) + math.hypot(a2, c3), b)
        self._shoulder_m, self._aside_m = (abs(a1), c1), b
        self._outstretched_m = abs(c2) + math.hypot(a2, c3)

    def error(self, q: Array) -> float:
        """Return the largest difference between the closed form and the arm's own frames."""
        return float(np.abs(self._opw_tips(q) - self.chain.tips(q) @ self._tip_T_opw_tip).max())

    def tip(self, q: Joints) -> Array:
        """Return base_T_tip; the closed form takes a tenth of the time of the frames."""
        opw = np.array(self._robot.forward(q))
        return np.asarray(self._base_T_opw @ opw @ self._opw_tip_T_tip)

    def branches(self, base_T_tips: Array) -> list[Branches]:
        """Return the branches of each pose, m x 4 x 4."""
        filled, extension_m, is_singular = self.slots(base_T_tips)
        is_whole = np.asarray(np.isfinite(filled).all(axis=2))
        return [
            Branches(distinct(rows[whole]), float(extension), bool(singular))
            for rows, whole, extension, singular in zip(
                filled, is_whole, extension_m, is_singular, strict=True
            )
        ]

    def slots(self, base_T_tips: Array) -> tuple[Array, Array, Flags]:
        """Return, for poses m x 4 x 4, eight places for branches, the reach, and singularity.

        Returns:
            m x 8 x n joints, NaN where there is no branch; how far each pose is within reach,
            negative is out of reach; whether joints can share a turn freely in some branch.
        """
        both = np.stack((base_T_tips, base_T_tips @ self._nudge), axis=1).reshape(-1, 4, 4)
        joints, extension_m, is_singular = self.plain_slots(both)
        found = joints.reshape(len(base_T_tips), 2, _BRANCHES, self.chain.joints)
        filled = np.where(np.isfinite(found[:, 0]), found[:, 0], found[:, 1])
        return filled, extension_m[::2], np.asarray(is_singular.reshape(-1, 2).any(axis=1))

    def plain_slots(self, base_T_tips: Array) -> tuple[Array, Array, Flags]:
        """Return the same in half the time, without the branches lost at a straight wrist."""
        targets = self._opw_T_base @ base_T_tips @ self._tip_T_opw_tip
        joints, _, extension_m, sigma_min, _ = self._robot.reach(targets.reshape(-1, 16))
        found = joints.reshape(len(targets), _BRANCHES, self.chain.joints)
        sigma = np.asarray(sigma_min).reshape(len(targets), _BRANCHES)
        return found, np.asarray(extension_m), np.asarray((sigma < _SINGULAR).any(axis=1))

    def wrist_m(self, base_T_tip: Array) -> Array:
        """Return the centre of the wrist at a tip pose, or at each of many, in their frame."""
        hand = base_T_tip @ self._tip_T_opw_tip
        return np.asarray(hand[..., :3, 3] - self._hand_m * hand[..., :3, 2])

    def too_far_m(self, base_T_tips: Array) -> Array:
        """Return how far poses, m x 4 x 4, are further than the outstretched arm; 0 if not."""
        wrist_m = self.wrist_m(self._opw_T_base @ base_T_tips)
        across2 = (wrist_m[:, :2] ** 2).sum(axis=1) - self._aside_m**2
        out_m = np.sqrt(np.maximum(across2, 0.0)) - self._shoulder_m[0]
        away_m = np.hypot(out_m, wrist_m[:, 2] - self._shoulder_m[1])
        return np.asarray(np.maximum(0.0, away_m - self._outstretched_m))

    def postures(self, base_T_tip: Array, near: Array) -> Array | NoIk:  # noqa: ARG002 - a port
        """Return all branches inside the limits; an empty answer is a proof."""
        (found,) = self.branches(base_T_tip[None])
        if not len(found.postures):
            return NoIk(
                is_proven=found.extension_m < 0.0,
                extension_m=max(0.0, -found.extension_m),
                reason=Sentence("the tip pose is out of reach"),
            )
        allowed = wrapped(found.postures, self.chain.lower, self.chain.upper)
        if len(allowed):
            return allowed
        return NoIk(
            is_proven=not found.is_singular, tried=len(found.postures), reason=OUTSIDE_LIMITS
        )

    def next(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return the posture nearest to another one."""
        found = self.postures(base_T_tip, near)
        return found if isinstance(found, NoIk) else nearest(found, near)[0]

    def _opw_tips(self, q: Array) -> Array:
        poses = np.asarray(self._robot.batch_forward(np.ascontiguousarray(q))).reshape(-1, 4, 4)
        return np.asarray(self._base_T_opw @ poses)


def _robot(geometry: OpwGeometry) -> _OpwRobot:
    opw = extension("py_opw_kinematics", "_internal", role="inverse kinematics")
    model = opw.KinematicModel(
        *geometry.lengths_m, offsets=geometry.offsets_rad, flip_axes=geometry.is_flipped
    )
    robot: _OpwRobot = opw.Robot(model, degrees=False)
    return robot


def _nudge() -> Array:
    turn = np.eye(4)
    c, s = math.cos(_NUDGE_RAD), math.sin(_NUDGE_RAD)
    turn[0, 0], turn[0, 2], turn[2, 0], turn[2, 2] = c, s, -s, c
    return turn


_NUDGE = _nudge()
