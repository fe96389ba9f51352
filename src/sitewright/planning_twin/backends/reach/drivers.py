"""Which robots may take pieces, and which may do an operation, with which end effector."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.planning_twin.backends.reach.bench import ArmBench, Bench
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.jobsite import drives
from sitewright.robot_team.cell import Capability, EndEffectorKind


def grippers(bench: Bench) -> Iterator[ArmBench]:
    """Yield each robot that may take pieces, with each of its grippers."""
    for robot in bench.cell.robot_by_id.values():
        for tool_id in robot.end_effectors:
            tool = bench.cell.end_effector_by_id[tool_id]
            if tool.kind is EndEffectorKind.GRIPPER and Capability.GRASPING in robot.can:
                yield bench.arm(robot, tool)


def drivers(bench: Bench, spot: Spot) -> Iterator[ArmBench]:
    """Yield each robot that may do an operation, with each of its tools that does."""
    for robot in bench.cell.robot_by_id.values():
        for tool_id in robot.end_effectors:
            tool = bench.cell.end_effector_by_id[tool_id]
            if spot.process in tool.processes and drives(tool, spot):
                yield bench.arm(robot, tool)
