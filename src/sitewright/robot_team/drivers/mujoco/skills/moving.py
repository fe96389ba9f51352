"""reach and retract: follow one trajectory, with the fingers opened before if so asked."""

from __future__ import annotations

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import RobotId
from sitewright.robot_team.driver import SkillReport
from sitewright.robot_team.drivers.mujoco import params
from sitewright.robot_team.drivers.mujoco.motions import follow
from sitewright.robot_team.drivers.mujoco.simulation import Simulation
from sitewright.robot_team.skill import SkillCommand
from sitewright.robot_team.trajectory import Trajectory

_SLIP_M = 0.005


def move(sim: Simulation, command: SkillCommand) -> SkillReport:
    """Follow the command's trajectories; a piece that is lost on the way is ``dropped``."""
    tool = sim.gripper_of(command.robot)
    if (
        tool is not None
        and "aperture_m" in command.params
        and command.robot not in sim.fixings.grips
    ):
        sim.move_fingers(tool, params.number(command, "aperture_m"))
    return follow_all(sim, command.robot, command.trajectories)


def follow_all(
    sim: Simulation, robot: RobotId, trajectories: tuple[Trajectory, ...]
) -> SkillReport:
    """Follow trajectories one after the other, up to the first that fails."""
    worst_rad = 0.0
    for trajectory in trajectories:
        followed = follow(sim, trajectory)
        worst_rad = max(worst_rad, followed.worst_rad)
        evidence: dict[str, Json] = {"tracking_rad": worst_rad}
        if followed.failure:
            return SkillReport(
                is_done=False,
                reason=followed.failure,
                evidence={**evidence, "detail": followed.detail},
            )
        if loss := lost_piece(sim, robot):
            return SkillReport(
                is_done=False, reason="dropped", evidence={**evidence, "detail": loss}
            )
    return SkillReport(is_done=True, evidence={"tracking_rad": worst_rad})


def lost_piece(sim: Simulation, robot: RobotId) -> str:
    """Return why a robot does not hold what it should hold; empty if it does."""
    if robot in sim.lost:
        return "the piece fell out of the gripper"
    grip = sim.fixings.grips.get(robot)
    if grip is None:
        return ""
    world_T_tool = sim.physics.pose(sim.fixings.mounted[robot])
    tool_T_piece = world_T_tool.inverse() @ sim.physics.pose(grip.piece)
    slip_m = tool_T_piece.distance_to_m(grip.tool_T_piece)
    return f"{grip.piece} slipped {slip_m * 1000:.1f} mm in the grip" if slip_m > _SLIP_M else ""
