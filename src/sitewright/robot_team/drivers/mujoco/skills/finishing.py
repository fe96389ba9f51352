"""apply-finish: paint sticks where the spray cone really swept over the piece."""

from __future__ import annotations

import itertools

import numpy as np

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import OperationId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import EndEffectorKind
from sitewright.robot_team.driver import SkillReport
from sitewright.robot_team.drivers.mujoco import params
from sitewright.robot_team.drivers.mujoco.physics import Array
from sitewright.robot_team.drivers.mujoco.scene import tool_body
from sitewright.robot_team.drivers.mujoco.simulation import Simulation
from sitewright.robot_team.drivers.mujoco.skills.moving import follow_all
from sitewright.robot_team.skill import SkillCommand

_EVERY_STEPS = 5
_GRID_M = 0.015
_SURFACE_M = 0.005
_REACH = (0.3, 1.5)
"""Paint sticks between these shares of the stand-off; nearer it runs, farther it is mist."""
_FACING = 0.5
"""Smallest cosine between spray and face."""


def apply_finish(sim: Simulation, command: SkillCommand) -> SkillReport:
    """Spray along the trajectory and measure the covered share of the patch."""
    operation = OperationId(params.text(command, "operation"))
    piece, patch = params.text(command, "piece"), params.pose(command, "world_T_patch")
    size_m, needed = params.size(command, "size_m"), params.number(command, "coverage")
    cone = params.number(command, "width_m"), params.number(command, "standoff_m")
    tool = sim.tool_of(command.robot)
    if tool is None or tool.kind is not EndEffectorKind.TOOL or "paint" not in tool.processes:
        detail = f"no paint head on {command.robot}"
        return SkillReport(is_done=False, reason="coverage-short", evidence={"detail": detail})
    tip = tool_body(tool, tool.description.tip)
    points, total = _points_on(sim, piece, patch, size_m)
    followed, swept = _sprayed(sim, command, tip)
    covered = _covered(points, np.array(patch.z_axis), swept, cone)
    share = float(covered.sum()) / total
    sim.fixings = sim.fixings.painted(operation, share)
    sim.effect(
        "paint",
        command_id=command.command_id,
        robot=command.robot,
        operation=operation,
        piece=piece,
        coverage=share,
    )
    evidence: dict[str, Json] = {**followed.evidence, "coverage": share}
    if not followed.is_done:
        return SkillReport(is_done=False, reason=followed.reason, evidence=evidence)
    if share < needed:
        return SkillReport(is_done=False, reason="coverage-short", evidence=evidence)
    return SkillReport(is_done=True, evidence=evidence)


def _sprayed(sim: Simulation, command: SkillCommand, tip: str) -> tuple[SkillReport, list[Pose]]:
    """Follow the strokes and return where the tip was all along."""
    swept: list[Pose] = []
    outer, count = sim.on_step, itertools.count()

    def spray(running: Simulation) -> None:
        if outer is not None:
            outer(running)
        if next(count) % _EVERY_STEPS == 0:
            swept.append(running.physics.pose(tip))

    sim.on_step = spray
    try:
        return follow_all(sim, command.robot, command.trajectories), swept
    finally:
        sim.on_step = outer


def _points_on(
    sim: Simulation, piece: str, patch: Pose, size_m: tuple[float, float]
) -> tuple[Array, int]:
    """Return the sample points of a patch that lie on the piece's face, and how many there are."""
    counts = [max(2, round(s / _GRID_M)) for s in size_m]
    xs, ys = (
        [(k + 0.5) / n * s - s / 2 for k in range(n)] for n, s in zip(counts, size_m, strict=True)
    )
    found = []
    for x in xs:
        for y in ys:
            point = patch.apply((x, y, 0.0))
            inside = sim.physics.stretch_m(piece, patch.z_axis, point)
            if inside and abs(inside[0][0]) <= _SURFACE_M:
                found.append(point)
    return np.array(found).reshape(-1, 3), len(xs) * len(ys)


def _covered(
    points: Array, inward: Array, swept: list[Pose], cone: tuple[float, float]
) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    width_m, standoff_m = cone
    covered = np.zeros(len(points), dtype=np.bool_)
    for world_T_tip in swept:
        axis = np.array(world_T_tip.z_axis)
        if axis @ inward < _FACING:
            continue
        away = points - np.array(world_T_tip.position_m)
        depth = away @ axis
        radial = np.linalg.norm(away - depth[:, None] * axis, axis=1)
        in_reach = (depth >= _REACH[0] * standoff_m) & (depth <= _REACH[1] * standoff_m)
        covered |= in_reach & (radial <= width_m / 2.0 * depth / standoff_m)
    return covered
