"""What the reach check compiles once for a cell and uses for all targets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sitewright.foundation.ids import EndEffectorId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.arm_model import ArmModel, arm_model
from sitewright.planning_twin.backends.identity_cache import IdentityCache
from sitewright.planning_twin.backends.judged_arm import judged
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.reach.arm_poses import ArmPoses, Postures, shoulder_ball
from sitewright.planning_twin.backends.reach.clearance import Clearance
from sitewright.planning_twin.backends.reach.grasp_set import GraspGroup, grasp_groups
from sitewright.planning_twin.backends.reach.load import Load, load_of, with_piece
from sitewright.planning_twin.backends.reach.surroundings import Surroundings
from sitewright.planning_twin.backends.solver import Solver
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.reachability.answer import ReachSphere
from sitewright.robot_team.cell import Cell, EndEffector, Robot
from sitewright.robot_team.description import Description

_ARMS_REMEMBERED = 32


class Engines:
    """What depends on no cell: arms, their inverse kinematics, grasps, distances."""

    def __init__(self) -> None:
        self.clearance = Clearance()
        self._solver_of = IdentityCache(_solver, size=_ARMS_REMEMBERED)
        self._arm_of = IdentityCache(arm_model, size=_ARMS_REMEMBERED)
        self._groups: dict[tuple[object, ...], tuple[EndEffector, tuple[GraspGroup, ...]]] = {}

    def poses(self, description: Description) -> ArmPoses:
        """Return the inverse kinematics of an arm."""
        return ArmPoses(self._solver_of(description))

    def solver(self, description: Description) -> Solver:
        """Return how an arm's inverse kinematics are solved."""
        return self._solver_of(description)

    def arm(self, description: Description) -> ArmModel:
        """Return the compiled arm."""
        return self._arm_of(description)

    def sphere(self, robot: Robot) -> ReachSphere:
        """Return where the wrist of a robot can be at most."""
        centres, radius_m = shoulder_ball(self._solver_of(robot.description))
        world = (robot.world_T_base.apply((x, y, z)) for x, y, z in centres.tolist())
        return ReachSphere(robot=robot.id, centres_m=tuple(world), radius_m=radius_m)

    def groups(
        self, piece: PieceShape, tool: EndEffector, world_T_piece: Pose | None
    ) -> tuple[GraspGroup, ...]:
        """Return the grasps of a piece as it lies, or of any side of it."""
        lies = None if world_T_piece is None else _lean(world_T_piece)
        key = (piece.size_m, id(tool), lies)
        if key not in self._groups:
            self._groups[key] = tool, grasp_groups(piece, tool, world_T_piece)
        return self._groups[key][1]


class ArmBench:
    """One robot with one end effector in its cell."""

    def __init__(self, engines: Engines, robot: Robot, tool: EndEffector) -> None:
        self.engines, self.robot, self.tool = engines, robot, tool
        self._poses = engines.poses(robot.description)
        self._base_T_world = np.linalg.inv(matrix_of(robot.world_T_base))
        self._home = np.array(robot.home_q_rad)
        self._loads: dict[float, Load] = {}
        self._out_of_reach: dict[tuple[tuple[int, ...], Pose], float | None] = {}

    def postures(self, world_T_tips: Array) -> Postures:
        """Return all postures for tip poses, m x 4 x 4."""
        return self._poses.postures(self._base_T_world @ world_T_tips, self._home)

    def following(self, world_T_tips: Array, near: Postures) -> tuple[Array, Flags]:
        """Return the postures a short way on from some, and which of them exist."""
        return self._poses.following(self._base_T_world @ world_T_tips, near)

    def out_of_reach_m(self, groups: Sequence[GraspGroup], world_T_piece: Pose) -> float | None:
        """Return how far a piece is proven to be out of reach of every grasp; None if it is not."""
        key = (tuple(map(id, groups)), world_T_piece)
        if key not in self._out_of_reach:
            tips = (matrix_of(world_T_piece) @ g.piece_T_tip for g in groups)
            self._out_of_reach[key] = _nearest_m([self.postures(t) for t in tips])
        return self._out_of_reach[key]

    def load(self, aperture_m: float, piece: PieceShape | None = None, name: str = "") -> Load:
        """Return the arm with its end effector, and with a piece of that name if it has one."""
        if aperture_m not in self._loads:
            arm = self.engines.arm(self.robot.description)
            self._loads[aperture_m] = load_of(self.robot, arm, self.tool, aperture_m)
        load = self._loads[aperture_m]
        return load if piece is None else with_piece(load, piece.shape, name)


class Bench:
    """A cell with everything that stands still in it."""

    def __init__(self, engines: Engines, cell: Cell, still: Surroundings) -> None:
        self.engines, self.cell, self.still = engines, cell, still
        self._arms: dict[tuple[RobotId, EndEffectorId], ArmBench] = {}
        self._lying: dict[tuple[RobotId, EndEffectorId], Flags] = {}

    def arm(self, robot: Robot, tool: EndEffector) -> ArmBench:
        """Return a robot with an end effector."""
        key = (robot.id, tool.id)
        if key not in self._arms:
            self._arms[key] = ArmBench(self.engines, robot, tool)
        return self._arms[key]

    def there(self, number: int, arm: ArmBench) -> Flags:
        """Return which parts stand still while an arm places a target.

        End effectors lie in their docks, unless this arm uses them or another one has them.
        """
        key = (arm.robot.id, arm.tool.id)
        if key not in self._lying:
            others = {r.mounted for r in self.cell.robot_by_id.values() if r.id != arm.robot.id}
            docked = {i for i, t in self.cell.end_effector_by_id.items() if t.station is not None}
            self._lying[key] = self.still.lying(docked - others - {arm.tool.id})
        return np.asarray(self.still.at(number) & self._lying[key])


def _nearest_m(solved: Sequence[Postures]) -> float | None:
    if not all(rows.is_never.all() for rows in solved):
        return None
    return min((float(rows.beyond_m.min()) for rows in solved), default=0.0)


def _solver(description: Description) -> Solver:
    return judged(description)[0]


def _lean(world_T_piece: Pose) -> tuple[float, float]:
    """Return what decides which sides of a piece look up."""
    return round(world_T_piece.y_axis[2], 4), round(world_T_piece.z_axis[2], 4)
