"""One thing that is done at a contact (take, lift, place, let go), and the ways from there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.reach.arm_poses import Postures
from sitewright.planning_twin.backends.reach.ends import End
from sitewright.planning_twin.backends.whole_turns import Flags


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """A straight way from contacts to pre-poses.

    Attributes:
        shift_m: m x 3, one for each contact; a carried piece goes the same way with all of them.
    """

    number: int
    shift_m: Array


@dataclass(frozen=True, slots=True, eq=False)
class Stage:
    """Clear in contact, and at the pre-pose of one way at least, the most welcome first."""

    end: End
    ways: tuple[Way, ...]

    def some(self, rows: Indices) -> Stage:
        """Return the stage for some of the contacts."""
        return Stage(self.end, tuple(Way(w.number, w.shift_m[rows]) for w in self.ways))

    def with_room(self) -> Stage:
        """Return the stage with the ways that the carried piece has room for, if it has any."""
        if not self.end.piece_clear():
            return Stage(self.end, ())
        return Stage(self.end, tuple(w for w in self.ways if self.end.piece_clear(w.shift_m[0])))

    def hand_serves(self, world_T_tips: Array) -> Flags:
        """Return at which tip poses the hand is clear, and at the pre-pose of some way too."""
        is_out = np.zeros(len(world_T_tips), dtype=np.bool_)
        serves = self.end.hand_clear(world_T_tips) if self.ways else is_out
        for way in self.ways:
            asked = np.flatnonzero(serves & ~is_out)
            is_out[asked] = self.end.hand_clear(world_T_tips[asked], way.shift_m[asked])
        return serves & is_out

    def in_contact(self, rows: Postures) -> Flags:
        """Return in which postures in contact the arm is clear."""
        return self.end.clear(rows)

    def way_of(self, rows: Postures, world_T_tips: Array) -> Indices:
        """Return, for each clear posture in contact, the number of its first clear way, or -1."""
        first = np.full(len(rows.q), -1, dtype=np.intp)
        for way in self.ways:
            asked = np.flatnonzero(first < 0)
            poses = np.unique(rows.pose[asked])
            hand = np.zeros(len(world_T_tips), dtype=np.bool_)
            hand[poses] = self.end.hand_clear(world_T_tips[poses], way.shift_m[poses])
            asked = asked[hand[rows.pose[asked]]]
            is_out = self.end.leaves(rows.only(asked), world_T_tips, way.shift_m)
            first[asked[is_out]] = way.number
        return first
