"""Position control of all arms at once, with feed-forward for speed, inertia and load."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitewright.foundation.ids import RobotId
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.drivers.mujoco.fixings import Fixings
from sitewright.robot_team.drivers.mujoco.physics import Array, Physics
from sitewright.robot_team.drivers.mujoco.scene import joint_name

_GRAVITY = np.array((0.0, 0.0, -9.81))


@dataclass(slots=True)
class Load:
    """A held piece, whose weight and inertia the controller knows and carries."""

    tool_body: int
    piece_body: int
    mass_kg: float
    inertia_kg_m2: Array


class ArmControl:
    """Drives every arm joint of the cell after a reference.

    Attributes:
        q: Reference positions of all arm joints, robot after robot.
        dq: Reference speeds.
        ddq: Reference accelerations.
        span: Which of them are a robot's.
    """

    def __init__(self, cell: Cell) -> None:
        self._names: list[str] = []
        self.span: dict[RobotId, slice] = {}
        for robot in cell.robot_by_id.values():
            start = len(self._names)
            self._names += [joint_name(robot.id, j.name) for j in robot.description.movable_joints]
            self.span[robot.id] = slice(start, len(self._names))
        self.q = np.zeros(len(self._names))
        self.dq = np.zeros(len(self._names))
        self.ddq = np.zeros(len(self._names))

    def bind(self, physics: Physics, fixings: Fixings) -> None:
        """Look up addresses in a newly compiled model."""
        m = physics.m
        self.positions, self.speeds = physics.joint_numbers(self._names)
        self._drives: NDArray[np.int64] = np.array(
            [physics.drives[n] for n in self._names], dtype=np.int64
        )
        self._stiffness: Array = m.actuator_gainprm[self._drives, 0].copy()
        self._damping: Array = -m.actuator_biasprm[self._drives, 2] + m.dof_damping[
            self.speeds
        ].reshape(-1)
        self._wanted = np.zeros(m.nv)
        self._force = np.zeros(m.nv)
        self._turn = np.zeros((3, m.nv))
        self._shift = np.zeros((3, m.nv))
        self._loads = [
            Load(
                physics.body(fixings.mounted[robot]),
                piece := physics.body(grip.piece),
                float(m.body_mass[piece]),
                m.body_inertia[piece].copy(),
            )
            for robot, grip in fixings.grips.items()
        ]

    def stand(self, physics: Physics, targets: Mapping[str, float] | None = None) -> None:
        """Make the present posture the reference (or the given joint targets)."""
        self.q[:] = physics.d.qpos[self.positions]
        if targets is not None:
            self.q[:] = [targets.get(n, q) for n, q in zip(self._names, self.q, strict=True)]
        self.dq[:] = 0.0
        self.ddq[:] = 0.0

    def reference(self) -> dict[str, float]:
        """Return the reference positions by joint name."""
        return dict(zip(self._names, self.q.tolist(), strict=True))

    def error_rad(self, physics: Physics, robot: RobotId) -> float:
        """Return how far the worst joint of a robot is from its reference."""
        span = self.span[robot]
        return float(np.abs(physics.d.qpos[self.positions[span]] - self.q[span]).max())

    def drive(self, physics: Physics) -> None:
        """Set the drive targets for the present instant; positions must be up to date."""
        m, d = physics.m, physics.d
        self._wanted[self.speeds] = self.ddq
        mujoco.mj_mulM(m, d, self._force, self._wanted)
        self._force += d.qfrc_bias
        self._force -= d.qfrc_gravcomp
        for load in self._loads:
            self._carry(physics, load)
        push = self._damping * self.dq + self._force[self.speeds]
        d.ctrl[self._drives] = self.q + push / self._stiffness

    def _carry(self, physics: Physics, load: Load) -> None:
        """Add the joint forces that hold up and accelerate a piece rigid to the tool."""
        m, d = physics.m, physics.d
        mujoco.mj_jac(m, d, self._shift, self._turn, d.xipos[load.piece_body], load.tool_body)
        axes = d.ximat[load.piece_body].reshape(3, 3)
        inertia = axes @ (load.inertia_kg_m2[:, None] * axes.T)
        force = load.mass_kg * (self._shift @ self._wanted - _GRAVITY)
        self._force += self._shift.T @ force
        self._force += self._turn.T @ (inertia @ (self._turn @ self._wanted))
