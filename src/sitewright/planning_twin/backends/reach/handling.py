"""Grasps of a piece put to the test at both ends: picked up and lifted, placed and let go."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.approach import PRE_M
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.reach.arm_poses import Postures
from sitewright.planning_twin.backends.reach.bench import ArmBench, Bench
from sitewright.planning_twin.backends.reach.clearance import Around, Thresholds
from sitewright.planning_twin.backends.reach.end_record import EndRecord
from sitewright.planning_twin.backends.reach.ends import Blame, End
from sitewright.planning_twin.backends.reach.grasp_set import GraspGroup
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.reachability.question import ReachTarget
from sitewright.planning_twin.scene import Pair
from sitewright.planning_twin.task import UP
from sitewright.planning_twin.touches import (
    leave_touch,
    lift_thresholds,
    pick_touch,
    place_touch,
)


@dataclass(frozen=True, slots=True, eq=False)
class Hold:
    """A way in which a piece is held at its target.

    Attributes:
        grasp: Number in the group.
        q: Posture, n values.
    """

    arm: ArmBench
    group: GraspGroup
    grasp: int
    insertion: int
    q: Array


@dataclass(frozen=True, slots=True, eq=False)
class GraspTrials:
    """One robot, its gripper, and one piece for one target; grasps that open alike.

    Attributes:
        lying: Where the piece lies; None if the stock has none, so that only the target counts.
    """

    bench: Bench
    arm: ArmBench
    target: ReachTarget
    piece: ComponentId
    group: GraspGroup
    lying: Pose | None
    stock: EndRecord = field(default_factory=EndRecord)
    goal: EndRecord = field(default_factory=EndRecord)

    def at_stock(self, grasps: Indices) -> Flags:
        """Return which grasps pick the piece up and lift it."""
        if self.lying is None:
            return np.ones(len(grasps), dtype=np.bool_)
        task, tool = self.target.task, self.arm.tool
        tips, back_m = self._tips(self.lying, grasps)
        rows = self.arm.postures(tips)
        self.stock.note(rows)
        touch = pick_touch(task, tool, self.piece, self.lying, self.group.grasps[0])
        opened = self._opened(self.stock.blame, touch.near_m, self._there())
        rows = rows.only(opened.clear(rows))
        rows = rows.only(opened.leaves(rows, tips, back_m))
        near_m = lift_thresholds(task, tool, self.piece)
        carried = self._carrying(self.stock.blame, near_m, self.lying)
        rows = rows.only(carried.clear(rows))
        up_m = np.tile(PRE_M * np.array(UP), (len(grasps), 1))
        is_served = rows.only(carried.leaves(rows, tips, up_m)).has()
        self.stock.is_served |= bool(is_served.any())
        return is_served

    def at_target(self, grasps: Indices) -> list[Hold]:
        """Return the ways to hold the piece at the target from which it can be let go."""
        task, tool = self.target.task, self.arm.tool
        tips, back_m = self._tips(task.world_T_target, grasps)
        rows = self.arm.postures(tips)
        self.goal.note(rows)
        touch = place_touch(task, tool, self.piece, self.group.grasps[0], task.insertions[0])
        carried = self._carrying(self.goal.blame, touch.near_m, task.world_T_target)
        rows = rows.only(carried.clear(rows))
        leave = leave_touch(task, tool, self.target.id, touch.world_T_tip)
        standing = self._there(without=self.piece)
        standing[self.bench.still.rows(self.target.id)] = True
        opened = self._opened(self.goal.blame, leave.near_m, standing)
        rows = rows.only(opened.clear(rows))
        rows = rows.only(opened.leaves(rows, tips, back_m))
        holds: list[Hold] = []
        for number in range(len(task.insertions)):
            if not len(rows.q):
                break
            holds += self._inserted(carried, rows, tips, grasps, number)
            served = {h.grasp for h in holds}
            is_open = [int(grasps[k]) not in served for k in rows.pose]
            rows = rows.only(np.array(is_open, dtype=np.bool_))
        self.goal.is_served |= bool(holds)
        return holds

    def with_postures(self) -> Flags:
        """Return which of all grasps have a posture at both ends; the noes count as proofs."""
        grasps = np.arange(len(self.group.grasps))
        has = np.ones(len(grasps), dtype=np.bool_)
        ends = ((self.goal, self.target.task.world_T_target), (self.stock, self.lying))
        for record, pose in ends:
            if pose is not None:
                rows = self.arm.postures(self._tips(pose, grasps)[0])
                record.note(rows)
                has &= rows.has()
        return has

    def _tips(self, world_T_piece: Pose, grasps: Indices) -> tuple[Array, Array]:
        """Return the tip poses of grasps, and the ways back out of them."""
        frame = matrix_of(world_T_piece)
        back_m = -PRE_M * self.group.approach[grasps] @ frame[:3, :3].T
        return frame @ self.group.piece_T_tip[grasps], np.asarray(back_m)

    def _inserted(
        self, carried: End, rows: Postures, tips: Array, grasps: Indices, number: int
    ) -> Iterator[Hold]:
        insertion = self.target.task.insertions[number]
        distance_m = PRE_M + insertion.slide_m
        way_m = np.tile(distance_m * np.array(insertion.come_from), (len(grasps), 1))
        for k in np.flatnonzero(carried.leaves(rows, tips, way_m)).tolist():
            yield Hold(self.arm, self.group, int(grasps[rows.pose[k]]), number, rows.q[k])

    def _there(self, without: ComponentId | None = None) -> Flags:
        there = self.bench.there(self.target.number, self.arm).copy()
        if without is not None:
            there[self.bench.still.rows(without)] = False
        return there

    def _opened(self, blame: Blame, near_m: Mapping[Pair, float], there: Flags) -> End:
        return End(
            arm=self.arm,
            load=self.arm.load(self.group.open_m),
            around=(Around(self.bench.still, there),),
            contact=self._thresholds(near_m),
            free=self._thresholds({}),
            blame=blame,
        )

    def _carrying(self, blame: Blame, near_m: Mapping[Pair, float], at: Pose) -> End:
        return End(
            arm=self.arm,
            load=self.arm.load(self.group.width_m, self.target.shape, self.piece),
            around=(Around(self.bench.still, self._there(without=self.piece)),),
            contact=self._thresholds(near_m),
            free=self._thresholds({}),
            world_T_piece=matrix_of(at),
            blame=blame,
        )

    def _thresholds(self, declared_m: Mapping[Pair, float]) -> Thresholds:
        return Thresholds(clearance_m=self.bench.cell.clearance_m, declared_m=declared_m)
