"""Both ends of a handling: what the gripper carries there, what is near, which ways lead away."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector
from sitewright.planning_twin.approach import PRE_M
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.reach.bench import ArmBench, Bench
from sitewright.planning_twin.backends.reach.clearance import Around, Thresholds
from sitewright.planning_twin.backends.reach.end_record import EndRecord
from sitewright.planning_twin.backends.reach.ends import End
from sitewright.planning_twin.backends.reach.grasp_end import GraspEnd
from sitewright.planning_twin.backends.reach.grasp_set import GraspGroup
from sitewright.planning_twin.backends.reach.stage import Stage, Way
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

_PIECE = ComponentId("the piece")
"""Name of a carried piece at the target, where it does not matter which one it is."""


@dataclass(frozen=True, slots=True, eq=False)
class GraspCase:
    """One arm, one target, and grasps for which the gripper opens and closes alike."""

    bench: Bench
    arm: ArmBench
    target: ReachTarget
    group: GraspGroup

    def pick_end(self, piece: ComponentId, record: EndRecord) -> GraspEnd:
        """Return the end at which a piece is taken and lifted."""
        task, lying = self.target.task, self.target.world_T_piece[piece]
        touch = pick_touch(task, self.arm.tool, piece, lying, self.group.grasps[0])
        opened = self._opened(touch.near_m, self._there(), record)
        near_m = lift_thresholds(task, self.arm.tool, piece)
        carried = self._carried(piece, lying, near_m, self._there(without=piece), record)
        stages = (
            Stage(opened, (Way(0, self._back_m(lying)),)),
            Stage(carried, (Way(0, self._along_m(UP, PRE_M)),)),
        )
        return GraspEnd(self.arm, self.group, lying, stages, record)

    def place_end(self, record: EndRecord) -> GraspEnd:
        """Return the end at which a piece is placed and let go, alike for all pieces that fit."""
        task, tool, at = self.target.task, self.arm.tool, self.target.task.world_T_target
        touch = place_touch(task, tool, _PIECE, self.group.grasps[0], task.insertions[0])
        there = self._there(without=next(iter(task.candidates), None))
        carried = self._carried(_PIECE, at, touch.near_m, there, record)
        ways = tuple(
            Way(number, self._along_m(i.come_from, PRE_M + i.slide_m))
            for number, i in enumerate(task.insertions)
        )
        leave = leave_touch(task, tool, self.target.id, touch.world_T_tip)
        standing = there.copy()
        standing[self.bench.still.rows(self.target.id)] = True
        opened = self._opened(leave.near_m, standing, record)
        stages = (Stage(carried, ways), Stage(opened, (Way(0, self._back_m(at)),)))
        return GraspEnd(self.arm, self.group, at, stages, record)

    def _back_m(self, world_T_piece: Pose) -> Array:
        """Return the ways back out of all grasps, along the gripper."""
        turn = matrix_of(world_T_piece)[:3, :3]
        return np.asarray(-PRE_M * self.group.approach @ turn.T)

    def _along_m(self, direction: Vector, length_m: float) -> Array:
        return np.tile(length_m * np.array(direction), (len(self.group.grasps), 1))

    def _there(self, without: ComponentId | None = None) -> Flags:
        there = self.bench.there(self.target.number, self.arm).copy()
        if without is not None:
            there[self.bench.still.rows(without)] = False
        return there

    def _opened(self, near_m: Mapping[Pair, float], there: Flags, record: EndRecord) -> End:
        return End(
            arm=self.arm,
            load=self.arm.load(self.group.open_m),
            around=(Around(self.bench.still, there),),
            contact=self._thresholds(near_m),
            free=self._thresholds({}),
            blame=record.blame,
        )

    def _carried(
        self,
        name: ComponentId,
        at: Pose,
        near_m: Mapping[Pair, float],
        there: Flags,
        record: EndRecord,
    ) -> End:
        return End(
            arm=self.arm,
            load=self.arm.load(self.group.width_m, self.target.shape, name),
            around=(Around(self.bench.still, there),),
            contact=self._thresholds(near_m),
            free=self._thresholds({}),
            world_T_piece=matrix_of(at),
            blame=record.blame,
        )

    def _thresholds(self, declared_m: Mapping[Pair, float]) -> Thresholds:
        return Thresholds(clearance_m=self.bench.cell.clearance_m, declared_m=declared_m)
