"""Follows a trajectory with one robot while all others hold still."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sitewright.robot_team.description import JointKind
from sitewright.robot_team.drivers.mujoco.sampling import broken_limit, samples
from sitewright.robot_team.drivers.mujoco.simulation import Simulation
from sitewright.robot_team.trajectory import Trajectory

_START = 0.01
_LOST = 0.05
"""Radians, or metres of a rail."""
_STOP_S = 0.25
_SETTLE_S = 0.1


@dataclass(frozen=True, slots=True, kw_only=True)
class Followed:
    """How a motion went.

    Attributes:
        failure: Empty, ``tracking`` or ``held``.
        detail: Why, for people.
        worst_rad: Largest difference between the reference and the joints (metres on a rail).
    """

    failure: str = ""
    detail: str = ""
    worst_rad: float = 0.0


def follow(sim: Simulation, trajectory: Trajectory) -> Followed:
    """Move along a trajectory; nothing moves if it starts elsewhere or breaks a limit."""
    robot = sim.cell.robot_by_id[trajectory.robot]
    rows = samples(trajectory, sim.step_s)
    if broken := broken_limit(rows, robot.description.movable_joints):
        return Followed(failure="tracking", detail=f"refused, {broken}")
    span = sim.arms.span[robot.id]
    apart = np.abs(rows[0][0] - sim.physics.d.qpos[sim.arms.positions[span]])
    if apart.max() > _START:
        joint = robot.description.movable_joints[int(apart.argmax())]
        unit = "m" if joint.kind is JointKind.PRISMATIC else "rad"
        detail = f"starts {apart.max():.3f} {unit} from the robot ({joint.name})"
        return Followed(failure="tracking", detail=detail, worst_rad=float(apart.max()))
    positions, speeds, accelerations = rows
    worst_rad = 0.0
    for k in range(len(positions) - 1):
        if sim.hold.is_set():
            _stop_on_path(sim, trajectory, k * sim.step_s)
            return Followed(failure="held", detail="hold was asked for", worst_rad=worst_rad)
        sim.arms.q[span] = positions[k]
        sim.arms.dq[span] = speeds[k]
        sim.arms.ddq[span] = accelerations[k]
        sim.step()
        sim.arms.q[span] = positions[k + 1]
        worst_rad = max(worst_rad, sim.arms.error_rad(sim.physics, robot.id))
        if worst_rad > _LOST:
            sim.arms.stand(sim.physics)
            sim.advance(_STOP_S)
            return Followed(failure="tracking", detail="pushed off its path", worst_rad=worst_rad)
    sim.advance(_SETTLE_S)
    return Followed(worst_rad=worst_rad)


def _stop_on_path(sim: Simulation, trajectory: Trajectory, time_s: float) -> None:
    """Let the clock of the motion run out, so that the arm stays on the certified path."""
    span = sim.arms.span[trajectory.robot]
    steps = round(_STOP_S / sim.step_s)
    for k in range(steps):
        pace = 1.0 - k / steps
        q, v, a = (np.array(x) for x in trajectory.at(time_s))
        sim.arms.q[span] = q
        sim.arms.dq[span] = v * pace
        sim.arms.ddq[span] = a * pace * pace - v / _STOP_S
        sim.step()
        time_s += pace * sim.step_s
    sim.arms.q[span] = trajectory.at(time_s)[0]
    sim.advance(_SETTLE_S)
