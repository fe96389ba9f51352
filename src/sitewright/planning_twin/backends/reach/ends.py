"""Ends of motions, many at once: the hand at tip poses, then the arm in the postures for them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.reach.arm_poses import Postures
from sitewright.planning_twin.backends.reach.bench import ArmBench
from sitewright.planning_twin.backends.reach.clearance import Around, Thresholds
from sitewright.planning_twin.backends.reach.load import Load, Moving
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.refusal import BlockedBy, NoIk
from sitewright.planning_twin.scene import Pair


@dataclass(slots=True)
class Blame:
    """Who was in the way, as far as it was looked at: the fewest pairs of any posture."""

    pairs: tuple[Pair, ...] = ()

    def note(self, found: Sequence[tuple[Pair, ...]]) -> None:
        """Remember the smallest set of pairs."""
        for pairs in found:
            if pairs and (not self.pairs or len(pairs) < len(self.pairs)):
                self.pairs = pairs

    def refusal(self) -> NoIk | BlockedBy:
        """Return who was in the way; nobody was if the straight last part changes its branch."""
        if self.pairs:
            return BlockedBy(pairs=self.pairs)
        return NoIk(is_proven=False, reason="no straight way in keeps to one branch of the arm")


@dataclass(frozen=True, slots=True, eq=False)
class End:
    """What is carried to an end of a motion, and what is near.

    Attributes:
        contact: Distances to keep in contact.
        free: Distances to keep at the pre-pose.
        world_T_piece: Of the carried piece in contact; None if none is carried.
    """

    arm: ArmBench
    load: Load
    around: Sequence[Around]
    contact: Thresholds
    free: Thresholds
    world_T_piece: Array | None = None
    blame: Blame = field(default_factory=Blame)

    def piece_clear(self, way_m: Array | None = None) -> bool:
        """Tell whether the carried piece is clear in contact, or a way off; so for every grasp."""
        piece = self.load.piece()
        if piece is None or self.world_T_piece is None:
            return True
        frame = self.world_T_piece.copy()
        if way_m is not None:
            frame[:3, 3] += way_m
        thresholds = self.contact if way_m is None else self.free.padded()
        return bool(self._is_clear(piece.moving, piece.placed(frame[None]), thresholds).all())

    def hand_clear(self, world_T_tips: Array, way_m: Array | None = None) -> Flags:
        """Return at which tip poses the hand is clear, whatever the arm's posture.

        Args:
            world_T_tips: m x 4 x 4, contact poses.
            way_m: m x 3, from contact to pre-pose, to ask for that one instead.
        """
        tips = world_T_tips.copy()
        if way_m is not None:
            tips[:, :3, 3] += way_m
        hand = self.load.hand()
        thresholds = self.contact if way_m is None else self.free.padded()
        return self._is_clear(hand.moving, hand.placed(tips), thresholds)

    def clear(self, rows: Postures) -> Flags:
        """Return in which postures in contact the arm is clear; the hand is not looked at."""
        return self._arm_clear(rows.q, np.zeros((len(rows.q), 3)), self.contact)

    def leaves(self, rows: Postures, world_T_tips: Array, way_m: Array) -> Flags:
        """Return which postures in contact have one at the pre-pose in which the arm is clear.

        Args:
            rows: Postures in contact.
            world_T_tips: m x 4 x 4, the contact poses that they are for.
            way_m: m x 3, from contact to pre-pose.
        """
        off = world_T_tips.copy()
        off[:, :3, 3] += way_m
        q, exists = self.arm.following(off, rows)
        out = exists.copy()
        out[exists] = self._arm_clear(q[exists], way_m[rows.pose[exists]], self.free.padded())
        return out

    def _arm_clear(self, q: Array, shift_m: Array, thresholds: Thresholds) -> Flags:
        if not len(q):
            return np.zeros(0, dtype=np.bool_)
        return self._is_clear(
            self.load.moving, self.load.placed(q, self._pieces(shift_m)), thresholds
        )

    def _is_clear(self, moving: Moving, placed: Array, thresholds: Thresholds) -> Flags:
        found = self.arm.engines.clearance.too_near(moving, placed, self.around, thresholds)
        self.blame.note(found)
        return np.array([not pairs for pairs in found], dtype=np.bool_)

    def _pieces(self, shift_m: Array) -> Array | None:
        if self.world_T_piece is None:
            return None
        out = np.tile(self.world_T_piece, (len(shift_m), 1, 1))
        out[:, :3, 3] += shift_m
        return out
