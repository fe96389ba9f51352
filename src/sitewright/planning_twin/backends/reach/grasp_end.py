"""Grasps of a piece put to the test at one end: picked up and lifted, or placed and let go."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.reach.bench import ArmBench
from sitewright.planning_twin.backends.reach.end_record import EndRecord
from sitewright.planning_twin.backends.reach.grasp_set import GraspGroup
from sitewright.planning_twin.backends.reach.stage import Stage
from sitewright.planning_twin.backends.whole_turns import Flags

_PIECE = ComponentId("the piece")
"""Name of the piece where it does not matter which one it is."""


@dataclass(frozen=True, slots=True, eq=False)
class Hold:
    """A posture in which a grasp serves at an end.

    Attributes:
        grasp: Number in the group.
        way: Number of the way in that is clear.
        q: Posture, n values.
    """

    arm: ArmBench
    group: GraspGroup
    grasp: int
    way: int
    q: Array


@dataclass(frozen=True, slots=True, eq=False)
class GraspEnd:
    """One end for one arm and one group of grasps; what was found is remembered.

    Attributes:
        world_T_piece: Where the piece is in contact.
        stages: What is done there, in order; a way is chosen for the first of them.
    """

    arm: ArmBench
    group: GraspGroup
    world_T_piece: Pose
    stages: tuple[Stage, ...]
    record: EndRecord
    _roomy: list[Stage] = field(default_factory=list)
    _has_posture: list[Flags] = field(default_factory=list)
    _held: dict[int, list[Hold]] = field(default_factory=dict)
    _serving_hands: dict[int, bool] = field(default_factory=dict)

    def tips(self, grasps: Indices) -> Array:
        """Return the tip poses of grasps."""
        return np.asarray(matrix_of(self.world_T_piece) @ self.group.piece_T_tip[grasps])

    def with_postures(self) -> Flags:
        """Return which of all grasps have a posture; what is known of the rest is recorded."""
        if not self._has_posture:
            rows = self.arm.postures(self.tips(np.arange(len(self.group.grasps))))
            self.record.note(rows)
            self._has_posture.append(rows.has())
        return self._has_posture[0]

    def with_hands(self, grasps: Indices) -> Flags:
        """Return which grasps are clear whatever the arm's posture."""
        new = np.array([g for g in grasps.tolist() if g not in self._serving_hands], dtype=np.intp)
        if len(new):
            serves = np.ones(len(new), dtype=np.bool_)
            tips = self.tips(new)
            for stage in self._for(new):
                asked = np.flatnonzero(serves)
                serves[asked] = stage.some(asked).hand_serves(tips[asked])
            self._serving_hands.update(zip(new.tolist(), serves.tolist(), strict=True))
        return np.array([self._serving_hands[g] for g in grasps.tolist()], dtype=np.bool_)

    def holds(self, grasps: Indices) -> list[Hold]:
        """Return the postures in which grasps serve, every grasp looked at once."""
        new = np.array([g for g in grasps.tolist() if g not in self._held], dtype=np.intp)
        self._held.update({g: [] for g in new.tolist()})
        new = new[self.with_hands(new)]
        if len(new):
            for hold in self._looked_at(new):
                self._held[hold.grasp].append(hold)
        found = [h for g in grasps.tolist() for h in self._held[g]]
        self.record.is_served |= bool(found)
        return found

    def _looked_at(self, grasps: Indices) -> list[Hold]:
        stages, tips = self._for(grasps), self.tips(grasps)
        rows = self.arm.postures(tips)
        # the arm stands alike in all stages: the piece lies, or is held, or stands at one place
        rows = rows.only(stages[0].in_contact(rows))
        first: Indices | None = None
        for stage in stages:
            way = stage.way_of(rows, tips)
            first = way if first is None else first
            rows, first = rows.only(way >= 0), first[way >= 0]
        ways = np.zeros(len(rows.q), dtype=np.intp) if first is None else first
        return [
            Hold(self.arm, self.group, int(grasps[pose]), way, q)
            for pose, way, q in zip(rows.pose.tolist(), ways.tolist(), rows.q, strict=True)
        ]

    def _for(self, grasps: Indices) -> list[Stage]:
        if not self._roomy:
            self._roomy.extend(stage.with_room() for stage in self.stages)
        return [stage.some(grasps) for stage in self._roomy]
