"""Which executor runs which skill, and what surrounds every one of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from sitewright.errors import CommandRefusedError, did_you_mean
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import RobotId
from sitewright.robot_team.cell import EndEffectorKind
from sitewright.robot_team.driver import SkillReport
from sitewright.robot_team.drivers.mujoco import params
from sitewright.robot_team.drivers.mujoco.contacts import ContactWatch
from sitewright.robot_team.drivers.mujoco.scene import pad_bodies, tool_bodies
from sitewright.robot_team.drivers.mujoco.simulation import Simulation
from sitewright.robot_team.drivers.mujoco.skills.fastening import fasten
from sitewright.robot_team.drivers.mujoco.skills.finishing import apply_finish
from sitewright.robot_team.drivers.mujoco.skills.gripping import grasp, position, release, set_down
from sitewright.robot_team.drivers.mujoco.skills.moving import move
from sitewright.robot_team.drivers.mujoco.skills.tool_change import change_end_effector, old_and_new
from sitewright.robot_team.skill import Skill, SkillCommand

Executor = Callable[[Simulation, SkillCommand], SkillReport]
Reader = Callable[[SkillCommand], object]


def _name(key: str) -> Reader:
    return lambda command: params.text(command, key)


def _names(key: str) -> Reader:
    return lambda command: params.texts(command, key)


def _number(key: str) -> Reader:
    return lambda command: params.number(command, key)


_PLACE: tuple[Reader, ...] = (
    _name("piece"),
    lambda command: params.pose(command, "world_T_piece"),
    _number("tolerance_m"),
    _number("tolerance_rad"),
)
EXECUTORS: Mapping[str, Executor] = {
    Skill.REACH: move,
    Skill.RETRACT: move,
    Skill.GRASP: grasp,
    Skill.POSITION: position,
    Skill.SET_DOWN: set_down,
    Skill.RELEASE: release,
    Skill.FASTEN: fasten,
    Skill.APPLY_FINISH: apply_finish,
    Skill.CHANGE_END_EFFECTOR: change_end_effector,
}
_READERS: Mapping[str, tuple[Reader, ...]] = {
    Skill.GRASP: (_name("piece"), _number("width_m"), _number("tolerance_m")),
    Skill.POSITION: (*_PLACE, _names("rests_on")),
    Skill.SET_DOWN: (*_PLACE, _number("aperture_m")),
    Skill.RELEASE: (_name("piece"), _number("aperture_m")),
    Skill.FASTEN: (
        *map(_name, ("operation", "through", "into")),
        params.fastener,
        _number("penetration_m"),
    ),
    Skill.APPLY_FINISH: (
        *map(_name, ("operation", "piece")),
        lambda c: params.pose(c, "world_T_patch"),
        lambda c: params.size(c, "size_m"),
        *map(_number, ("standoff_m", "width_m", "coverage")),
    ),
    Skill.CHANGE_END_EFFECTOR: (old_and_new,),
}
"""What each skill reads, tried before a command is accepted."""
_RESTING_M = 0.002
_ARRIVED_M = 0.001


def check(sim: Simulation, command: SkillCommand, executors: Mapping[str, Executor]) -> None:
    """Refuse a command that cannot even start: unknown skill, robot, piece or tool."""
    if command.skill not in executors:
        known = ", ".join(sorted(executors))
        hint = did_you_mean(command.skill, executors)
        raise CommandRefusedError(f"No executor for skill {command.skill!r}; known: {known}.{hint}")
    strangers = {command.robot, *(t.robot for t in command.trajectories)} - set(
        sim.cell.robot_by_id
    )
    if strangers or any(t.robot != command.robot for t in command.trajectories):
        raise CommandRefusedError(f"{command.skill}: the cell has no robot {sorted(strangers)}")
    for key in ("piece", "through", "into"):
        name = command.params.get(key)
        if isinstance(name, str) and not sim.physics.has_body(name):
            raise CommandRefusedError(f"{command.skill}: nothing here is called {name!r}")
    for key in ("old", "new"):
        tool = command.params.get(key)
        if tool is not None and tool not in sim.cell.end_effector_by_id:
            raise CommandRefusedError(f"{command.skill}: there is no end effector {tool!r}")
    for read in (params.declared_contacts, *_READERS.get(command.skill, ())):
        read(command)


def execute(
    sim: Simulation, command: SkillCommand, executors: Mapping[str, Executor] = EXECUTORS
) -> tuple[SkillReport, list[dict[str, Json]]]:
    """Run one command; return its report and the contacts that nothing allowed."""
    started_s = sim.time_s
    sim.lost.clear()
    sim.watch = ContactWatch()
    sim.watch.allow(sim.physics, _resting(sim, command.robot))
    declared = params.declared_contacts(command)
    sim.watch.allow(sim.physics, declared or ())
    report = executors[command.skill](sim, command)
    if declared is None:
        sim.watch.forgive(_arrived(sim, command.robot))
    report = replace(report, duration_s=sim.time_s - started_s)
    return report, sim.watch.records(command.skill, command.command_id)


def _resting(sim: Simulation, robot: RobotId) -> set[tuple[str, str]]:
    """Return what touches already: pieces on what they lie on, pads on what they hold, a tip."""
    tool = sim.tool_of(robot)
    tips = tool_bodies(tool) if tool is not None and tool.kind is EndEffectorKind.TOOL else ()
    pairs = sim.near_pairs(_RESTING_M, tips)
    for holder, grip in sim.fixings.grips.items():
        gripper = sim.gripper_of(holder)
        if gripper is not None:
            pairs |= {(pad, grip.piece) for pad in pad_bodies(gripper)}
    return pairs


def _arrived(sim: Simulation, robot: RobotId) -> set[tuple[str, str]]:
    """Return what a motion without declared contacts was evidently to end at.

    A held piece that lies against something when the motion is over was to be put there, and a
    tool tip that touches a piece was to work on it. What was hit on the way is not among them.
    """
    tool, grip = sim.tool_of(robot), sim.fixings.grips.get(robot)
    tips = tool_bodies(tool) if tool is not None and tool.kind is EndEffectorKind.TOOL else ()
    held = () if grip is None else (grip.piece,)
    others = [*sim.contents.pieces, *sim.cell.fixture_by_id]
    return {
        (a, b)
        for a in (*held, *tips)
        for b in others
        if a != b and sim.physics.gap_m(a, b, 2 * _ARRIVED_M) <= _ARRIVED_M
    }
