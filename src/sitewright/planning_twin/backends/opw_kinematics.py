"""Kinematics of any serial arm: all postures for a tip pose, in closed form where there is one."""

from __future__ import annotations

import numpy as np
from typing_extensions import override

from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.identity_cache import IdentityCache
from sitewright.planning_twin.backends.judged_arm import judged
from sitewright.planning_twin.backends.kinematic_chain import matrix_of, pose_of
from sitewright.planning_twin.backends.opw_solver import OpwSolver
from sitewright.planning_twin.backends.solver import Solver, nearest
from sitewright.planning_twin.motion import ArmVerdict, Kinematics
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Description, Joints

_ARMS_REMEMBERED = 32


class OpwKinematics(Kinematics):
    """Kinematics of any arm: closed form if it proves right for the arm, else iterations."""

    def __init__(self) -> None:
        self._judged = IdentityCache(judged, size=_ARMS_REMEMBERED)

    @override
    def verdict(self, description: Description) -> ArmVerdict:
        return self._judged(description)[1]

    @override
    def tip(self, description: Description, q_rad: Joints) -> Pose:
        return pose_of(self._solver(description).tip(q_rad))

    @override
    def solve(
        self, description: Description, base_T_tip: Pose, near_rad: Joints
    ) -> tuple[Joints, ...] | NoIk:
        near = np.array(near_rad, dtype=np.float64)
        found = self._solver(description).postures(matrix_of(base_T_tip), near)
        if isinstance(found, NoIk):
            return found
        return tuple(tuple(row) for row in nearest(found, near).tolist())

    @override
    def has_all(self, description: Description, base_T_tip: Pose) -> bool:
        solver = self._solver(description)
        if not isinstance(solver, OpwSolver):
            return False
        (found,) = solver.branches(matrix_of(base_T_tip)[None])
        return not found.is_singular

    @override
    def follow(self, description: Description, base_T_tip: Pose, near_rad: Joints) -> Joints | NoIk:
        near = np.array(near_rad, dtype=np.float64)
        found = self._solver(description).next(matrix_of(base_T_tip), near)
        return found if isinstance(found, NoIk) else tuple(found.tolist())

    def _solver(self, description: Description) -> Solver:
        return self._judged(description)[0]


def solver_of(description: Description) -> Solver:
    """Return the closed form if it equals the arm's own kinematics, else the iterating solver."""
    return judged(description)[0]
