"""grasp, position, set-down, release: every answer is read off the simulated bodies."""

from __future__ import annotations

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.driver import SkillReport
from sitewright.robot_team.drivers.mujoco import params
from sitewright.robot_team.drivers.mujoco.fixings import Grip
from sitewright.robot_team.drivers.mujoco.scene import pad_bodies
from sitewright.robot_team.drivers.mujoco.simulation import Simulation
from sitewright.robot_team.drivers.mujoco.skills.moving import follow_all, lost_piece
from sitewright.robot_team.skill import SkillCommand

_SQUEEZE_M = 0.003
"""Each finger is sent this far into the piece: 600 N at the finger's stiffness."""
_SETTLE_S = 0.3
_TOUCH_M = 0.001
_MOVED_M = 0.010


def grasp(sim: Simulation, command: SkillCommand) -> SkillReport:
    """Close the fingers; the piece is held only if both pads press on it at the right opening."""
    piece = params.text(command, "piece")
    width_m, tolerance_m = params.number(command, "width_m"), params.number(command, "tolerance_m")
    arrived = follow_all(sim, command.robot, command.trajectories)
    tool = sim.gripper_of(command.robot)
    if not arrived.is_done:
        return arrived
    if tool is None or command.robot in sim.fixings.grips:
        why = "no gripper is mounted" if tool is None else "the gripper holds a piece"
        return _failed("grasp-failed", {"detail": why})
    open_m = sim.aperture_m(tool)
    sim.watch.allow(sim.physics, ((pad, piece) for pad in pad_bodies(tool)))
    sim.move_fingers(tool, max(0.0, width_m - 2 * _SQUEEZE_M))
    pads, aperture_m = sim.pads_on(tool, piece), sim.aperture_m(tool)
    evidence: dict[str, Json] = {"pads": pads, "aperture_m": aperture_m}
    if pads < len(pad_bodies(tool)) or abs(aperture_m - width_m) > tolerance_m:
        sim.move_fingers(tool, open_m)
        return _failed("grasp-failed", evidence)
    return _hold(sim, command, tool, ComponentId(piece), evidence)


def _hold(
    sim: Simulation,
    command: SkillCommand,
    tool: EndEffector,
    piece: ComponentId,
    evidence: dict[str, Json],
) -> SkillReport:
    world_T_piece = sim.physics.pose(piece)
    tool_T_piece = sim.physics.pose(tool.id).inverse() @ world_T_piece
    grip = Grip(
        piece=piece,
        tool_T_piece=tool_T_piece,
        since_s=sim.time_s,
        number=sim.fixings.grip_count + 1,
        taken_at_m=world_T_piece.position_m,
    )
    sim.fix(sim.fixings.gripped(command.robot, grip))
    sim.effect(
        "gripped",
        command_id=command.command_id,
        robot=command.robot,
        piece=piece,
        tool_T_piece=params.pose_json(tool_T_piece),
        aperture_m=evidence["aperture_m"],
    )
    sim.advance(_SETTLE_S)
    return SkillReport(is_done=True, evidence=evidence)


def position(sim: Simulation, command: SkillCommand) -> SkillReport:
    """Sense whether the held piece is where it should be and touches what it should rest on."""
    piece = params.text(command, "piece")
    rests_on = params.texts(command, "rests_on")
    wanted = params.pose(command, "world_T_piece")
    sim.watch.allow(sim.physics, ((piece, other) for other in rests_on))
    arrived = follow_all(sim, command.robot, command.trajectories)
    if not arrived.is_done:
        return arrived
    sim.advance(_SETTLE_S)
    if loss := lost_piece(sim, command.robot):
        return _failed("dropped", {"detail": loss})
    in_place, evidence = _compare(sim, command, piece, wanted)
    apart: dict[str, Json] = {
        other: gap
        for other in rests_on
        if sim.physics.has_body(other) and (gap := sim.physics.gap_m(piece, other, 1.0)) > _TOUCH_M
    }
    unknown = [other for other in rests_on if not sim.physics.has_body(other)]
    evidence |= {"apart_m": apart, "unknown": unknown}
    if not in_place or apart or unknown:
        return _failed("position-failed", evidence)
    return SkillReport(is_done=True, evidence=evidence)


def set_down(sim: Simulation, command: SkillCommand) -> SkillReport:
    """Let a piece go and sense whether it lies where it should."""
    wanted = params.pose(command, "world_T_piece")
    released = release(sim, command)
    if not released.is_done:
        return released
    in_place, evidence = _compare(sim, command, params.text(command, "piece"), wanted)
    evidence |= released.evidence
    if not in_place:
        return _failed("position-failed", evidence)
    return SkillReport(is_done=True, evidence=evidence)


def release(sim: Simulation, command: SkillCommand) -> SkillReport:
    """Open the fingers; done when no pad touches the piece and it stays where it was."""
    piece = params.text(command, "piece")
    aperture_m = params.number(command, "aperture_m")
    arrived = follow_all(sim, command.robot, command.trajectories)
    tool = sim.gripper_of(command.robot)
    if not arrived.is_done:
        return arrived
    if tool is None:
        return _failed("dropped", {"detail": "no gripper is mounted"})
    before = sim.physics.pose(piece)
    grip = sim.fixings.grips.get(command.robot)
    if grip is not None:
        sim.fix(sim.fixings.let_go(command.robot))
    sim.move_fingers(tool, aperture_m)
    sim.advance(_SETTLE_S)
    after = sim.physics.pose(piece)
    if grip is not None:
        sim.effect(
            "let-go",
            command_id=command.command_id,
            robot=command.robot,
            piece=grip.piece,
            world_T_piece=params.pose_json(sim.physics.pose(grip.piece)),
        )
    moved_m = before.distance_to_m(after)
    evidence: dict[str, Json] = {
        "aperture_m": sim.aperture_m(tool),
        "moved_m": moved_m,
        "world_T_piece": params.pose_json(after),
    }
    if moved_m > _MOVED_M or sim.pads_on(tool, piece):
        return _failed("dropped", evidence)
    return SkillReport(is_done=True, evidence=evidence)


def _compare(
    sim: Simulation, command: SkillCommand, piece: str, wanted: Pose
) -> tuple[bool, dict[str, Json]]:
    sensed = sim.physics.pose(piece)
    off_m, off_rad = sensed.distance_to_m(wanted), sensed.angle_to_rad(wanted)
    in_place = off_m <= params.number(command, "tolerance_m") and off_rad <= params.number(
        command, "tolerance_rad"
    )
    return in_place, {
        "off_m": off_m,
        "off_rad": off_rad,
        "world_T_piece": params.pose_json(sensed),
    }


def _failed(reason: str, evidence: dict[str, Json]) -> SkillReport:
    return SkillReport(is_done=False, reason=reason, evidence=evidence)
