"""The second proof: every pair of every line by separating planes, halving where need be."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from typing_extensions import override

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.audit import CertificateAudit, Fault, Objection, Reproof
from sitewright.planning_twin.backends.audit.gaps import GapFinder, Placed
from sitewright.planning_twin.backends.audit.pairs import PartPair, pairs_of
from sitewright.planning_twin.backends.audit.parts import Array, Part, frames_of, parts_of
from sitewright.planning_twin.motion import Certificate, JointPath, PathSegment, TeamPath
from sitewright.planning_twin.scene import Pair, SceneSnapshot

Indices = npt.NDArray[np.intp]
RESERVE_M = 2e-6
"""For rounding, and for a trajectory that may leave its path by 1e-7 rad."""
STANDING_SHARE = 0.5
"""Pairs that a path leaves alone must keep this share of the clearance."""
CLAIM_SLACK_M = 0.0005
"""The claimed closest distance is proven but for this."""
_SMALLEST_TRAVEL_M = 4e-6
_FAR_M = 10.0
"""A certificate may claim infinity where nothing is to be kept apart."""


class SeparatingPlanes(CertificateAudit):
    """Proves by planes, with its own kinematics, pairs and travel bounds."""

    @override
    def reprove(
        self, scene: SceneSnapshot, path: JointPath | TeamPath, claimed: Certificate
    ) -> Reproof:
        cell = _Cell(scene, path)
        needs = [_needs(cell, scene, segment, claimed) for segment in path.segments]
        found = cell.standing(needs)
        for number, segment in enumerate(path.segments):
            for a, b in pairwise(segment.waypoints_rad):
                if found is None:
                    found = cell.line(number, np.array(a), np.array(b), needs[number])
        objections = () if found is None else (found,)
        return Reproof(objections=objections, pairs=len(cell.pairs), gaps=cell.gaps.looked)


@dataclass(frozen=True, slots=True, eq=False)
class _Needs:
    """What each pair of parts must keep, by its number.

    Attributes:
        threshold_m: Of a pair that the path moves.
        claimed_m: The same, or what the certificate claims if that is more (but for a slack).
        standing_m: Of a pair that it does not move.
    """

    threshold_m: Array
    claimed_m: Array
    standing_m: Array


def _needs(cell: _Cell, scene: SceneSnapshot, segment: PathSegment, claimed: Certificate) -> _Needs:
    declared: Mapping[Pair, float] = segment.threshold_m
    names = [pair.name for pair in cell.pairs]
    threshold = np.array([declared.get(n, scene.clearance_m) for n in names])
    claim = min(claimed.closest_distance_m - CLAIM_SLACK_M, _FAR_M)
    is_telling = np.array([p.name not in declared and not p.is_neighbour for p in cell.pairs])
    return _Needs(
        threshold_m=threshold,
        claimed_m=np.where(is_telling, np.maximum(threshold, claim), threshold),
        standing_m=np.array([declared.get(n, scene.clearance_m * STANDING_SHARE) for n in names]),
    )


class _Cell:
    """A scene and who moves in it."""

    def __init__(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> None:
        self._scene, self._robots = scene, path.robots
        self.pairs = pairs_of(scene, parts_of(scene))
        self.gaps = GapFinder()
        self._rates = np.array([self._rate(pair) for pair in self.pairs])
        self._is_moving = self._rates.any(axis=1)
        self._still = {
            robot: frames_of(arm, arm.q_rad)
            for robot, arm in scene.robots.items()
            if robot not in path.robots
        }

    def standing(self, needs: list[_Needs]) -> Objection | None:
        """Return the first pair that the path leaves alone and that is too near."""
        frames = self._frames(self._posture())
        needed = np.max([n.standing_m for n in needs], axis=0)
        for number in np.flatnonzero(~self._is_moving):
            gap = self._gap(int(number), frames, float(needed[number]) + RESERVE_M)
            if gap < needed[number] + RESERVE_M:
                return _too_near(self.pairs[number].name, gap, needed[number], "standing by")
        return None

    def line(self, segment: int, a: Array, b: Array, needs: _Needs) -> Objection | None:
        """Return the first pair that is not proven on a line, None if all are."""
        travel = self._rates @ np.abs(b - a)
        open_intervals = [(0.5, 0.5, np.flatnonzero(self._is_moving))]
        while open_intervals:
            middle, half, numbers = open_intervals.pop()
            frames = self._frames(a + middle * (b - a))
            left = []
            for number in self._not_far(numbers, frames, needs.claimed_m + travel * half):
                needed = needs.claimed_m[number] + RESERVE_M
                gap = self._gap(number, frames, needed + travel[number] * half)
                if gap >= needed + travel[number] * half:
                    continue
                if gap < needed or travel[number] * half < _SMALLEST_TRAVEL_M:
                    where = f"in segment {segment} at {middle:.6f} of a line"
                    return self._objection(number, gap, needs, where)
                left.append(number)
            if left:
                rest = np.array(left)
                open_intervals.append((middle + half / 2.0, half / 2.0, rest))
                open_intervals.append((middle - half / 2.0, half / 2.0, rest))
        return None

    def _objection(self, number: int, gap: float, needs: _Needs, where: str) -> Objection:
        name, threshold_m = self.pairs[number].name, float(needs.threshold_m[number])
        if gap < threshold_m + RESERVE_M or needs.claimed_m[number] == threshold_m:
            return _too_near(name, gap, threshold_m, where)
        claimed_m = float(needs.claimed_m[number]) + CLAIM_SLACK_M
        return Objection(
            fault=Fault.CLAIM,
            what=f"{' and '.join(name)} are said to stay {claimed_m * 1e3:.2f} mm apart, but only "
            f"{gap * 1e3:.2f} mm are proven {where}",
        )

    def _rate(self, pair: PartPair) -> Array:
        """Return a pair's rates for the joints of all who move, one robot after the other."""
        rates = []
        for robot in self._robots:
            joints = len(self._scene.robots[robot].description.movable_joints)
            rates.append(pair.rates_m.get(robot, np.zeros(joints)))
        return np.concatenate(rates)

    def _posture(self) -> Array:
        return np.array([q for r in self._robots for q in self._scene.robots[r].q_rad])

    def _frames(self, q: Array) -> dict[RobotId, dict[str, Array]]:
        """Return the frames of all arms, those that move at a posture of theirs."""
        frames = dict(self._still)
        first = 0
        for robot in self._robots:
            arm = self._scene.robots[robot]
            last = first + len(arm.q_rad)
            frames[robot] = frames_of(arm, tuple(q[first:last].tolist()))
            first = last
        return frames

    def _not_far(
        self, numbers: Indices, frames: dict[RobotId, dict[str, Array]], needed: Array
    ) -> Iterator[int]:
        """Yield the pairs whose enclosing balls do not show enough distance already."""
        middles: dict[int, Array] = {}
        for number in numbers.tolist():
            pair = self.pairs[number]
            for part in (pair.a, pair.b):
                if id(part) not in middles:
                    frame = _frame_of(part, frames)
                    middles[id(part)] = frame[:3, :3] @ part.middle_m + frame[:3, 3]
            between = middles[id(pair.a)] - middles[id(pair.b)]
            balls_m = pair.a.radius_m + pair.b.radius_m
            if float(np.sqrt(between @ between)) - balls_m < needed[number] + RESERVE_M:
                yield number

    def _gap(self, number: int, frames: dict[RobotId, dict[str, Array]], enough_m: float) -> float:
        pair = self.pairs[number]
        placed: list[Placed] = [(p, _frame_of(p, frames)) for p in (pair.a, pair.b)]
        return self.gaps.gap_m(number, placed[0], placed[1], enough_m)


def _frame_of(part: Part, frames: dict[RobotId, dict[str, Array]]) -> Array:
    return np.eye(4) if part.robot is None else frames[part.robot][part.frame]


def _too_near(name: Pair, gap_m: float, needed_m: float, where: str) -> Objection:
    return Objection(
        fault=Fault.DISTANCE,
        what=f"{' and '.join(name)} are proven to be {gap_m * 1e3:.2f} mm apart {where}, "
        f"not {needed_m * 1e3:.2f} mm",
    )
