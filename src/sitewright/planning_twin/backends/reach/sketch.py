"""A guess at how much of a model an arrangement reaches, by inverse kinematics of a few grasps."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.reach.arm_poses import ArmPoses, shoulder_ball
from sitewright.planning_twin.backends.reach.bench import Engines
from sitewright.planning_twin.backends.reach.sketch_tips import (
    Tips,
    WorkTips,
    handling_tips,
    operating_tips,
)
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.layout.movables import Arrangement, Shift, Yard
from sitewright.planning_twin.reachability.question import ReachQuestion
from sitewright.robot_team.cell import Robot

_MOST_TARGETS, _MOST_OPERATIONS = 80, 160
_PARTLY, _FADES_M = 0.8, 0.5
"""What is out of reach by this much counts so much less than what is nearly reached."""
_TOO_NEAR = 0.25
"""A tip is not brought nearer to the axis of the base than this share of the arm's reach."""
Item = TypeVar("Item")


class ReachSketch:
    """Guesses for one model and cell; what was computed for a place is remembered."""

    def __init__(self, engines: Engines, question: ReachQuestion, yard: Yard) -> None:
        self._engines, self._movables = engines, {m.id: m for m in yard.movables}
        targets = spread(question.targets, _MOST_TARGETS)
        spots = [(n, s) for n, t in enumerate(targets) for s in t.task.spots]
        spots = spread(spots, _MOST_OPERATIONS)
        self._targets = len(targets)
        self._target_of_spot = np.array([n for n, _ in spots], dtype=np.intp)
        robots = question.cell.robot_by_id.values()
        tools = question.cell.end_effector_by_id
        self._handling = [w for r in robots for w in handling_tips(engines, r, tools, targets)]
        self._operating = [
            w
            for r in robots
            for w in operating_tips(r, tools, [(targets[n].id, s) for n, s in spots])
        ]
        self._known: dict[tuple[object, ...], tuple[Flags, Array]] = {}

    def guess(self, arrangement: Arrangement) -> float:
        """Return about how much of the targets is reached, 0..1."""
        placed, done = np.zeros(self._targets), np.zeros(len(self._target_of_spot))
        for work in self._handling:
            np.maximum.at(placed, work.thing, self._both_ends(work, arrangement))
        for work in self._operating:
            has, near = self._reached(work, work.goal, arrangement)
            np.maximum.at(done, work.thing, np.where(has.any(axis=1), 1.0, near))
        count = np.bincount(self._target_of_spot, minlength=self._targets)
        total = np.bincount(self._target_of_spot, weights=done, minlength=self._targets)
        share = np.where(count > 0, total / np.maximum(count, 1), 1.0)
        return float((placed * share).mean()) if self._targets else 1.0

    def _both_ends(self, work: WorkTips, arrangement: Arrangement) -> Array:
        """Return, for each target, 1 if one grasp serves at both ends, else how near it comes."""
        at_goal, goal_near = self._reached(work, work.goal, arrangement)
        if work.stock is None:
            return np.where(at_goal.any(axis=1), 1.0, goal_near)
        at_stock, stock_near = self._reached(work, work.stock, arrangement)
        return np.where((at_goal & at_stock).any(axis=1), 1.0, (goal_near + stock_near) / 2.0)

    def _reached(self, work: WorkTips, tips: Tips, arrangement: Arrangement) -> tuple[Flags, Array]:
        """Return which tip poses have a posture, n x k, and how near each thing is, 0..0.8."""
        shift = arrangement.get(work.robot.id, Shift())
        places = tuple((p, arrangement.get(p, Shift())) for p in sorted(set(tips.place)))
        key = (id(tips), shift, places)
        if key not in self._known:
            self._known[key] = self._solved(work.robot, tips, shift, dict(places))
        return self._known[key]

    def _solved(
        self, robot: Robot, tips: Tips, shift: Shift, places: dict[str, Shift]
    ) -> tuple[Flags, Array]:
        base = matrix_of(robot.world_T_base)
        if robot.id in self._movables:
            base = matrix_of(shift.moves(self._movables[robot.id])) @ base
        world_T_tip = tips.world_T_tip
        motions = {
            p: matrix_of(s.moves(self._movables[p]))
            for p, s in places.items()
            if p in self._movables
        }
        if motions:
            still = np.eye(4)
            moves = np.array([motions.get(p, still) for p in tips.place])
            world_T_tip = moves[:, None] @ world_T_tip
        return self._in_base(robot, np.linalg.inv(base) @ world_T_tip)

    def _in_base(self, robot: Robot, base_T_tip: Array) -> tuple[Flags, Array]:
        count, grasps = base_T_tip.shape[:2]
        solver = self._engines.solver(robot.description)
        poses = ArmPoses(solver).quick(base_T_tip.reshape(-1, 4, 4))
        has = poses.has().reshape(count, grasps)
        beyond_m = poses.beyond_m.reshape(count, grasps).min(axis=1, initial=np.inf)
        centres, reach_m = shoulder_ball(solver)
        if len(centres) == 1:
            away_m = np.hypot(base_T_tip[..., 0, 3], base_T_tip[..., 1, 3])
            has &= away_m > _TOO_NEAR * reach_m
        return has, _PARTLY * np.exp(-beyond_m / _FADES_M)


def spread(items: Sequence[Item], most: int) -> list[Item]:
    """Return at most so many of some things, evenly spread over all of them."""
    step = -(-len(items) // most)
    return list(items[:: max(1, step)])
