"""The few tip poses by which a sketch guesses: grasps of each target, leans at each operation."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sitewright.foundation.ids import ComponentId, EndEffectorId
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.reach.bench import Engines
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.jobsite import drives
from sitewright.planning_twin.reachability.question import ReachTarget
from sitewright.planning_twin.skill_motions.finish import first_touches
from sitewright.robot_team.cell import Capability, EndEffector, EndEffectorKind, Robot

_GRASPS, _LEANS = 12, 5
Tools = Mapping[EndEffectorId, EndEffector]


@dataclass(frozen=True, slots=True, eq=False)
class Tips:
    """Tip poses where things are now, k for each of n things.

    Attributes:
        world_T_tip: n x k x 4 x 4.
        place: Stock place that each thing lies at; empty for what stays.
    """

    world_T_tip: Array
    place: tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class WorkTips:
    """What one robot would do with one end effector.

    Attributes:
        thing: Number of the target, or operation, that each row is about.
        goal: At the targets or operations.
        stock: At the pieces, the same grasps in the same order; None for operations.
    """

    robot: Robot
    thing: Indices
    goal: Tips
    stock: Tips | None = None


def handling_tips(
    engines: Engines, robot: Robot, tools: Tools, targets: Sequence[ReachTarget]
) -> Iterator[WorkTips]:
    """Yield the tip poses of a robot's grippers, at the targets and at their first pieces."""
    for tool in (tools[i] for i in robot.end_effectors):
        if tool.kind is not EndEffectorKind.GRIPPER or Capability.GRASPING not in robot.can:
            continue
        rows = [(n, t, piece) for n, t in enumerate(targets) for piece in t.task.candidates[:1]]
        grasps = [_grasps(engines, tool, t, piece) for _, t, piece in rows]
        kept = [k for k, g in enumerate(grasps) if len(g)]
        if not kept:
            continue
        goal = [matrix_of(rows[k][1].task.world_T_target) @ grasps[k] for k in kept]
        stock = [matrix_of(rows[k][1].world_T_piece[rows[k][2]]) @ grasps[k] for k in kept]
        yield WorkTips(
            robot=robot,
            thing=np.array([rows[k][0] for k in kept], dtype=np.intp),
            goal=Tips(np.array(goal), ("",) * len(kept)),
            stock=Tips(np.array(stock), tuple(rows[k][1].place for k in kept)),
        )


def operating_tips(
    robot: Robot, tools: Tools, spots: Sequence[tuple[ComponentId, Spot]]
) -> Iterator[WorkTips]:
    """Yield the tip poses of a robot's tools at operations."""
    for tool in (tools[i] for i in robot.end_effectors):
        mine = [
            (n, _leans(tool, target, spot))
            for n, (target, spot) in enumerate(spots)
            if spot.process in tool.processes and drives(tool, spot)
        ]
        if mine:
            things = np.array([n for n, _ in mine], dtype=np.intp)
            tips = Tips(np.array([leans for _, leans in mine]), ("",) * len(mine))
            yield WorkTips(robot=robot, thing=things, goal=tips)


def _grasps(engines: Engines, tool: EndEffector, target: ReachTarget, piece: ComponentId) -> Array:
    """Return piece_T_tip of some grasps, the cheapest among them; none if no side fits."""
    groups = engines.groups(target.shape, tool, target.world_T_piece[piece])
    if not groups:
        return np.zeros((0, 4, 4))
    costs = np.array([g.cost for group in groups for g in group.grasps])
    order = np.argsort(costs, kind="stable")
    every = np.concatenate([group.piece_T_tip for group in groups])[order]
    return every[_some(len(every), _GRASPS)]


def _leans(tool: EndEffector, target: ComponentId, spot: Spot) -> Array:
    if spot.patch is not None:
        tips = [matrix_of(t.world_T_tip) for t in first_touches(spot, tool, target)]
    else:
        tips = [matrix_of(p.world_T_tip) for p in tool_poses(spot, tool, has_yaw=False)]
    return np.array(tips)[_some(len(tips), _LEANS)]


def _some(count: int, wanted: int) -> Indices:
    """Return numbers from the first to the last, always as many; some twice if there are few."""
    return np.linspace(0, count - 1, wanted).round().astype(np.intp)
