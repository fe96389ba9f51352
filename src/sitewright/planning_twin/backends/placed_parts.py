"""Where all parts are in many postures at once: what stands still is kept once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.pair_table import Indices

_STILL = -1


@dataclass(frozen=True, slots=True, eq=False)
class PlacedParts:
    """Frames of n parts in m postures, of which k parts move.

    A long trajectory on a site of many pieces has thousands of postures in which most parts
    stand still.

    Attributes:
        frames: (n + m k) x 4 x 4, world_T_part: all parts as they stand, then those that move,
            posture by posture.
        slot: n, the number of a part among those that move, or -1.
        moving: k.
    """

    frames: Array
    slot: Indices
    moving: int

    @classmethod
    def of(cls, world_T_part: Array, rows: Indices, moved: Array) -> PlacedParts:
        """Return the parts with some of them moved.

        Args:
            world_T_part: n x 4 x 4, all parts as they stand.
            rows: k, the parts that move.
            moved: m x k x 4 x 4, their frames in every posture.
        """
        slot = np.full(len(world_T_part), _STILL)
        slot[rows] = np.arange(len(rows))
        frames = np.concatenate((world_T_part, moved.reshape(-1, 4, 4)))
        return cls(frames, slot, len(rows))

    def at(self, posture: Indices, part: Indices) -> Indices:
        """Return the rows in `frames` of parts in postures, element by element."""
        slot = self.slot[part]
        moved = len(self.slot) + posture * self.moving + slot
        return np.where(slot == _STILL, part, moved)

    def in_every_posture(self, rows: Indices) -> Array:
        """Return world_T_part of some parts in all postures, m x r x 4 x 4."""
        postures = (len(self.frames) - len(self.slot)) // max(1, self.moving)
        grid = np.meshgrid(np.arange(postures), rows, indexing="ij")
        return np.asarray(self.frames[self.at(*grid)])
