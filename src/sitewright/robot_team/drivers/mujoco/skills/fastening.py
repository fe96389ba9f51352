"""fasten: a nail or screw runs from the measured tip and holds only what it really enters."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose, rotation
from sitewright.robot_team.cell import EndEffector, EndEffectorKind
from sitewright.robot_team.driver import FastenerObservation, SkillReport
from sitewright.robot_team.drivers.mujoco import params
from sitewright.robot_team.drivers.mujoco.scene import tool_bodies, tool_body
from sitewright.robot_team.drivers.mujoco.simulation import Simulation
from sitewright.robot_team.drivers.mujoco.skills.moving import follow_all
from sitewright.robot_team.skill import SkillCommand

_AIM_S = 0.2
_SETTLE_S = 0.2
_STAND_OFF_M = 0.005
"""The nose may stand this far off the wood; further away the safety contact does not trip."""
_PRESSED_IN_M = 0.002
_JOINT_GAP_M = 0.003
_ROUNDING_M = 1e-4
_MISS_ANGLE_DEG = 60.0
_SAME_LENGTH_M = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class Hit:
    """Where a fastener went.

    Attributes:
        failure: Empty if it holds, else what is wrong.
        penetration_m: Length inside the receiver.
    """

    failure: str = ""
    stand_off_m: float | None = None
    penetration_m: float = 0.0


def fasten(sim: Simulation, command: SkillCommand) -> SkillReport:
    """Shoot one fastener and join the two bodies only if it passes through one into the other."""
    operation = OperationId(params.text(command, "operation"))
    through, into = ComponentId(params.text(command, "through")), params.text(command, "into")
    kind, length_m = params.fastener(command)
    needed_m = params.number(command, "penetration_m")
    arrived = follow_all(sim, command.robot, command.trajectories)
    if not arrived.is_done:
        return arrived
    tool = sim.tool_of(command.robot)
    if tool is None or not _has(tool, kind, length_m):
        detail = f"no tool on {command.robot} drives a {kind} of {length_m * 1000:.0f} mm"
        return SkillReport(is_done=False, reason="missed", evidence={"detail": detail})
    sim.watch.allow(sim.physics, ((body, through) for body in tool_bodies(tool)))
    sim.advance(_AIM_S)
    world_T_tip = _aimed(sim, sim.physics.pose(tool_body(tool, tool.description.tip)))
    hit = _trace(sim, world_T_tip, (through, into), length_m, needed_m)
    world_T_through, world_T_into = sim.physics.pose(through), sim.physics.pose(into)
    shot = replace(sim.fixings, shots=sim.fixings.shots + 1)
    if not hit.failure:
        seen = FastenerObservation(
            operation=operation, through=through, into=into, penetration_m=hit.penetration_m
        )
        shot = shot.fastened(seen, world_T_through.inverse() @ world_T_into)
    sim.fix(shot)
    sim.effect(
        "fastener",
        command_id=command.command_id,
        robot=command.robot,
        operation=operation,
        type=kind,
        is_driven=not hit.failure,
        through=through,
        into=into,
        penetration_m=hit.penetration_m,
        world_T_tip=params.pose_json(world_T_tip),
        world_T_through=params.pose_json(world_T_through),
        world_T_into=params.pose_json(world_T_into),
    )
    sim.advance(_SETTLE_S)
    evidence: dict[str, Json] = {
        "penetration_m": hit.penetration_m,
        "stand_off_m": hit.stand_off_m,
        "world_T_tip": params.pose_json(world_T_tip),
    }
    if hit.failure:
        return SkillReport(
            is_done=False, reason="missed", evidence={**evidence, "detail": hit.failure}
        )
    return SkillReport(is_done=True, evidence=evidence)


def _has(tool: EndEffector, kind: str, length_m: float) -> bool:
    return tool.kind is EndEffectorKind.TOOL and any(
        f.type == kind and f.l_min_m - _SAME_LENGTH_M <= length_m <= f.l_max_m + _SAME_LENGTH_M
        for f in tool.fasteners
    )


def _aimed(sim: Simulation, world_T_tip: Pose) -> Pose:
    """Return the line of the shot: the tip's, unless a fault on demand deflects this shot."""
    settings = sim.cell.simulation
    if settings.get("miss_shot_number", 0) != sim.fixings.shots + 1:
        return world_T_tip
    angle_deg = settings.get("miss_angle_deg", _MISS_ANGLE_DEG)
    return world_T_tip @ rotation((1.0, 0.0, 0.0), math.radians(angle_deg))


def _trace(
    sim: Simulation, world_T_tip: Pose, bodies: tuple[str, str], length_m: float, needed_m: float
) -> Hit:
    through, into = bodies
    tip, direction = world_T_tip.position_m, world_T_tip.z_axis
    entered = [s for s in sim.physics.stretch_m(through, direction, tip) if s[1] > 0.0]
    if not entered:
        return Hit(failure=f"the fastener does not meet {through}")
    start_m, end_m = entered[0]
    if not -_PRESSED_IN_M <= start_m <= _STAND_OFF_M:
        return Hit(
            failure=f"the tip is {start_m * 1000:.1f} mm from {through}", stand_off_m=start_m
        )
    inside = [
        (max(a, end_m), min(b, length_m))
        for a, b in sim.physics.stretch_m(into, direction, tip)
        if min(b, length_m) > max(a, end_m)
    ]
    penetration_m = sum(b - a for a, b in inside)
    if not inside or inside[0][0] - end_m > _JOINT_GAP_M:
        failure = f"the fastener does not go from {through} into {into}"
    elif penetration_m < needed_m - _ROUNDING_M:
        failure = f"only {penetration_m * 1000:.1f} mm of it are in {into}"
    else:
        failure = ""
    return Hit(failure=failure, stand_off_m=start_m, penetration_m=penetration_m)
