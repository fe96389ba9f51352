"""Writes the pair tables of a scene: which pairs count, and who changes their distance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.arm_model import ArmModel, CarriedPart
from sitewright.planning_twin.backends.kinematic_chain import BASE, Array
from sitewright.planning_twin.backends.pair_table import Indices, PairTable
from sitewright.planning_twin.scene import pair_of

Flags = npt.NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Thing:
    """A link or a body: what pairs are named after.

    Attributes:
        radii: Per part: how far it swings per radian of each joint of its robot.
    """

    name: str
    robot: RobotId | None
    link: str | None
    parts: tuple[CarriedPart, ...]
    radii: tuple[Array | None, ...]

    @property
    def joint(self) -> int:
        """Number of the joint that carries it."""
        return self.parts[0].joint if self.robot is not None and self.parts else BASE


class PairWriter:
    """All pairs of some things that can ever come nearer, as arrays."""

    def __init__(self, things: Sequence[Thing], arms: Mapping[RobotId, ArmModel]) -> None:
        self._things, self._arms = things, arms
        self._number_of = {r: k for k, r in enumerate(arms)}
        self._robot = np.array(
            [-1 if t.robot is None else self._number_of[t.robot] for t in things], dtype=np.intp
        )
        self._joint = np.array([t.joint for t in things], dtype=np.intp)
        self._count = np.array([len(t.parts) for t in things], dtype=np.intp)
        self._first = np.cumsum(self._count) - self._count
        self._a, self._b = np.nonzero(np.triu(self._counted(), k=1))

    def tables(self, robot: RobotId) -> tuple[PairTable, PairTable]:
        """Return the pairs that a robot's joints change, and those that they leave alone."""
        is_moved = (self._robot == self._number_of[robot]) & (self._joint != BASE)
        is_changed = is_moved[self._a] | is_moved[self._b]
        return self._table(robot, is_changed), self._table(robot, ~is_changed)

    def _counted(self) -> Flags:
        """Return which things can ever collide by a motion, neighbours aside."""
        robot, joint = self._robot, self._joint
        is_one_arm = (robot[:, None] == robot) & (robot >= 0)
        is_rigid = is_one_arm & (joint[:, None] == joint)
        is_still = joint == BASE
        has_parts = self._count > 0
        counted = ~(is_rigid | (is_still[:, None] & is_still)) & (has_parts[:, None] & has_parts)
        for a, b in self._neighbours():
            counted[a, b] = counted[b, a] = False
        return np.asarray(counted)

    def _neighbours(self) -> list[list[int]]:
        number_of = {(t.robot, t.link): k for k, t in enumerate(self._things) if t.link}
        return [
            [number_of[robot, link] for link in links]
            for robot, arm in self._arms.items()
            for links in arm.neighbours
        ]

    def _table(self, robot: RobotId, chosen: Flags) -> PairTable:
        a, b = self._a[chosen], self._b[chosen]
        joint_a, joint_b = (self._joint_in(side, robot) for side in (a, b))
        is_a_outer = (self._robot[a] == self._number_of[robot]) & (self._joint[a] >= joint_b)
        outer, inner = np.where(is_a_outer, a, b), np.where(is_a_outer, b, a)
        pair, i, j = self._rows(outer, inner)
        shared = np.where(is_a_outer, joint_b, joint_a) + 1
        joints = self._arms[robot].chain.joints
        is_own = np.arange(joints) >= shared[pair][:, None]
        is_near = np.abs(self._joint[a] - self._joint[b]) == 1
        is_one_arm = (self._robot[a] == self._robot[b]) & (self._robot[a] >= 0)
        things = self._things
        return PairTable(
            a=i,
            b=j,
            name=pair,
            names=tuple(
                pair_of(things[x].name, things[y].name)
                for x, y in zip(a.tolist(), b.tolist(), strict=True)
            ),
            is_neighbour=(is_near & is_one_arm)[pair],
            weights=np.where(is_own, self._radii(robot)[i], 0.0),
        )

    def _joint_in(self, chosen: Indices, robot: RobotId) -> Indices:
        """Return the joints of `robot` that carry things, `BASE` where none of its joints does."""
        is_mine = self._robot[chosen] == self._number_of[robot]
        return np.where(is_mine, self._joint[chosen], BASE)

    def _rows(self, outer: Indices, inner: Indices) -> tuple[Indices, Indices, Indices]:
        """Return every part of one thing with every part of the other: pair, and both parts."""
        width = self._count[inner]
        rows = self._count[outer] * width
        pair = np.repeat(np.arange(len(outer)), rows)
        within = np.arange(len(pair)) - np.repeat(np.cumsum(rows) - rows, rows)
        i, j = np.divmod(within, width[pair])
        return pair, self._first[outer][pair] + i, self._first[inner][pair] + j

    def _radii(self, robot: RobotId) -> Array:
        """Return how far each part swings per radian of a robot's joints; 0 for others' parts."""
        none = np.zeros(self._arms[robot].chain.joints)
        return np.array(
            [
                radii if thing.robot == robot and radii is not None else none
                for thing in self._things
                for radii in thing.radii
            ]
        ).reshape(-1, len(none))
