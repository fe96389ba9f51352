"""All postures for a tip pose, in closed form where the arm allows it."""

from __future__ import annotations

import itertools
import math
from typing import Protocol

import numpy as np
from typing_extensions import override

from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.extensions import extension
from sitewright.planning_twin.backends.identity_cache import IdentityCache
from sitewright.planning_twin.backends.kinematic_chain import (
    Array,
    KinematicChain,
    chain_of,
    distinct,
    matrix_of,
    pose_of,
)
from sitewright.planning_twin.backends.numeric_kinematics import NumericSolver
from sitewright.planning_twin.backends.opw_geometry import OpwGeometry, opw_geometry
from sitewright.planning_twin.motion import Kinematics
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Description, Joints

_CHECKED_POSTURES = 500
_CHECK_TOLERANCE = 1e-9
_NUDGE_RAD = 1e-7
"""Turn about the tool's y axis that brings back the branches lost at a straight wrist."""
_LIMIT_SLACK_RAD = 1e-9
_TURN = 2.0 * math.pi
_ARMS_REMEMBERED = 8


class _OpwRobot(Protocol):
    """What is used of the compiled solver; its own wrapper converts poses at a cost."""

    def batch_forward(self, joints: Array) -> Array: ...

    def forward(self, joints: Joints) -> list[list[float]]: ...

    def reach(self, poses: Array) -> tuple[Array, Array, Array, Array, Array]: ...


class Solver(Protocol):
    """Inverse kinematics of one arm."""

    @property
    def chain(self) -> KinematicChain:
        """The arm that it solves."""
        ...

    def tip(self, q_rad: Joints) -> Array:
        """Return base_T_tip of a posture."""
        ...

    def branches(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return postures, one per row, regardless of limits, or why there are none."""
        ...


class OpwSolver:
    """Closed form for arms with an ortho-parallel basis and a spherical wrist."""

    def __init__(self, chain: KinematicChain, geometry: OpwGeometry) -> None:
        self.chain = chain
        self._robot = _robot(geometry)
        self._base_T_opw = geometry.base_T_opw
        zero = np.zeros((1, chain.joints))
        self._opw_T_base = np.linalg.inv(geometry.base_T_opw)
        self._tip_T_opw_tip = np.linalg.inv(chain.tips(zero)[0]) @ self._opw_tips(zero)[0]
        self._opw_tip_T_tip = np.linalg.inv(self._tip_T_opw_tip)

    def error(self, q: Array) -> float:
        """Return the largest difference between the closed form and the arm's own frames."""
        return float(np.abs(self._opw_tips(q) - self.chain.tips(q) @ self._tip_T_opw_tip).max())

    def tip(self, q_rad: Joints) -> Array:
        """Return base_T_tip; the closed form takes a tenth of the time of the frames."""
        opw = np.array(self._robot.forward(q_rad))
        return np.asarray(self._base_T_opw @ opw @ self._opw_tip_T_tip)

    def branches(self, base_T_tip: Array, near: Array) -> Array | NoIk:  # noqa: ARG002 - a port
        """Return up to eight branches; an empty answer is a proof."""
        target = self._opw_T_base @ base_T_tip @ self._tip_T_opw_tip
        targets = np.stack((target, target @ _NUDGE))
        joints, _, extension, _, _ = self._robot.reach(targets.reshape(2, 16))
        slots = np.where(np.isfinite(joints[0]), joints[0], joints[1])
        found = distinct(slots[np.isfinite(slots).all(axis=1)])
        if len(found):
            return found
        return NoIk(
            is_proven=bool(extension[0] < 0.0),
            extension_m=max(0.0, -float(extension[0])),
            reason="the tip pose is out of reach",
        )

    def _opw_tips(self, q: Array) -> Array:
        poses = np.asarray(self._robot.batch_forward(np.ascontiguousarray(q))).reshape(-1, 4, 4)
        return np.asarray(self._base_T_opw @ poses)


class OpwKinematics(Kinematics):
    """Kinematics of any arm: closed form if it proves right for the arm, else iterations."""

    def __init__(self) -> None:
        self._solver_of = IdentityCache(solver_of, size=_ARMS_REMEMBERED)

    @override
    def tip(self, description: Description, q_rad: Joints) -> Pose:
        return pose_of(self._solver_of(description).tip(q_rad))

    @override
    def solve(
        self, description: Description, base_T_tip: Pose, near_rad: Joints
    ) -> tuple[Joints, ...] | NoIk:
        solver = self._solver_of(description)
        near = np.array(near_rad, dtype=np.float64)
        found = solver.branches(matrix_of(base_T_tip), near)
        if isinstance(found, NoIk):
            return found
        allowed = wrapped(found, solver.chain.lower, solver.chain.upper)
        if not len(allowed):
            return NoIk(
                is_proven=isinstance(solver, OpwSolver),
                tried=len(found),
                reason="every posture for the tip pose is outside the joint limits",
            )
        order = np.argsort(np.linalg.norm(allowed - near, axis=1), kind="stable")
        return tuple(tuple(row) for row in allowed[order].tolist())


def solver_of(description: Description) -> Solver:
    """Return the closed form if it equals the arm's own kinematics, else the iterating solver."""
    chain = chain_of(description)
    geometry = opw_geometry(chain)
    if geometry is not None:
        solver = OpwSolver(chain, geometry)
        q = np.random.default_rng(0).uniform(
            chain.lower, chain.upper, (_CHECKED_POSTURES, chain.joints)
        )
        if solver.error(q) <= _CHECK_TOLERANCE:
            return solver
    return NumericSolver(chain)


def wrapped(postures: Array, lower: Array, upper: Array) -> Array:
    """Return all postures inside the limits that differ from the given ones by whole turns."""
    counts = np.floor((upper - lower) / _TURN).astype(int) + 1
    turns = _TURN * np.array(list(itertools.product(*(range(n) for n in counts))))
    lowest = postures + _TURN * np.ceil((lower - _LIMIT_SLACK_RAD - postures) / _TURN)
    rows = (lowest[:, None] + turns).reshape(-1, postures.shape[1])
    inside = rows[(rows <= upper + _LIMIT_SLACK_RAD).all(axis=1)]
    return np.asarray(np.clip(inside, lower, upper))


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
