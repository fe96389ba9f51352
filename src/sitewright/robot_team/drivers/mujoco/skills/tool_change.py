"""change-end-effector: dock one, take another; the flange must really be at the dock."""

from __future__ import annotations

import math

from sitewright.errors import CommandRefusedError
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import EndEffectorId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.driver import SkillReport
from sitewright.robot_team.drivers.mujoco import params
from sitewright.robot_team.drivers.mujoco.scene import link_body, tool_bodies
from sitewright.robot_team.drivers.mujoco.simulation import Simulation
from sitewright.robot_team.drivers.mujoco.skills.moving import follow_all
from sitewright.robot_team.skill import SkillCommand
from sitewright.robot_team.trajectory import Trajectory

_TOLERANCE_M = 0.005
_TOLERANCE_RAD = math.radians(2.0)
_LOCK_S = 0.3
_RACK_M = 0.005


def change_end_effector(sim: Simulation, command: SkillCommand) -> SkillReport:
    """Leave the old end effector in its dock and lock on the new one, each if it fits."""
    old, new = old_and_new(command)
    ways = list(command.trajectories)
    if sim.fixings.mounted.get(command.robot) != old or (
        new is not None and EndEffectorId(new) not in sim.fixings.world_T_docked
    ):
        return _failed({"detail": f"{old} is not mounted or {new} is not docked"})
    evidence: dict[str, Json] = {}
    for act, name in ((_dock, old), (_take, new)):
        if name is None:
            continue
        tool = sim.cell.end_effector_by_id[EndEffectorId(name)]
        _allow(sim, command, tool)
        failed = _go(sim, command, ways.pop(0)) or act(sim, command, tool, evidence)
        if failed is not None:
            return failed
    return _go(sim, command, ways[0]) or SkillReport(is_done=True, evidence=evidence)


def old_and_new(command: SkillCommand) -> tuple[str | None, str | None]:
    """Return what is left and what is taken; a wrong number of trajectories is refused."""
    old, new = params.text_or_none(command, "old"), params.text_or_none(command, "new")
    count = len(command.trajectories)
    if count != (old is not None) + (new is not None) + 1:
        raise CommandRefusedError(
            f"change-end-effector from {old} to {new} with {count} trajectories"
        )
    return old, new


def _dock(
    sim: Simulation, command: SkillCommand, tool: EndEffector, evidence: dict[str, Json]
) -> SkillReport | None:
    if tool.station is None or command.robot in sim.fixings.grips:
        return _failed({"detail": f"{tool.id} has no dock, or holds a piece"})
    sensed = sim.physics.pose(tool.id)
    if off := _apart(sensed, dock_pose(sim, tool), evidence, f"dock {tool.id}"):
        return _failed({**evidence, "detail": off})
    sim.fix(sim.fixings.docked(command.robot, sensed))
    sim.effect(
        "tool-docked",
        command_id=command.command_id,
        robot=command.robot,
        end_effector=tool.id,
        world_T_mount=params.pose_json(sensed),
    )
    sim.advance(_LOCK_S)
    return None


def _take(
    sim: Simulation, command: SkillCommand, tool: EndEffector, evidence: dict[str, Json]
) -> SkillReport | None:
    """Lock the changer: its cone seats the tool exactly on the flange from within tolerance."""
    sensed = sim.physics.pose(tool.id)
    if off := _apart(sim.tip(command.robot), sensed, evidence, f"take {tool.id}"):
        return _failed({**evidence, "detail": off})
    sim.fix(sim.fixings.taken(command.robot, tool.id))
    _allow(sim, command, tool)
    sim.effect(
        "tool-taken", command_id=command.command_id, robot=command.robot, end_effector=tool.id
    )
    sim.advance(_LOCK_S)
    return None


def dock_pose(sim: Simulation, tool: EndEffector) -> Pose:
    """Return where a tool's mount stands when it is docked."""
    if tool.station is None:
        raise CommandRefusedError(f"end effector {tool.id} has no tool station")
    return sim.cell.station_by_id[tool.station].world_T_station @ tool.station_T_mount


def _apart(sensed: Pose, wanted: Pose, evidence: dict[str, Json], key: str) -> str:
    off_m, off_rad = sensed.distance_to_m(wanted), sensed.angle_to_rad(wanted)
    evidence[key] = {"off_m": off_m, "off_rad": off_rad}
    if off_m <= _TOLERANCE_M and off_rad <= _TOLERANCE_RAD:
        return ""
    return f"{key}: {off_m * 1000:.1f} mm and {math.degrees(off_rad):.2f} deg off"


def _allow(sim: Simulation, command: SkillCommand, tool: EndEffector) -> None:
    """The plates of the changer touch each other, and the tool touches its rack."""
    description = sim.cell.robot_by_id[command.robot].description
    wrist = description.movable_joints[-1].child
    links = [wrist, *(j.child for j in description.joints if j.parent == wrist), description.tip]
    bodies = tool_bodies(tool)
    pairs = {(link_body(command.robot, link), body) for link in links for body in bodies}
    racks = [
        f for f in sim.cell.fixture_by_id for b in bodies if sim.physics.gap_m(b, f, 1.0) <= _RACK_M
    ]
    sim.watch.allow(sim.physics, pairs | {(b, rack) for b in bodies for rack in racks})


def _go(sim: Simulation, command: SkillCommand, way: Trajectory) -> SkillReport | None:
    report = follow_all(sim, command.robot, (way,))
    return None if report.is_done else report


def _failed(evidence: dict[str, Json]) -> SkillReport:
    return SkillReport(is_done=False, reason="dock-failed", evidence=evidence)
