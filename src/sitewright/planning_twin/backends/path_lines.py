"""A joint path as straight lines in arrays, and intervals of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.motion import JointPath, TeamPath

_SAME_WAYPOINT_RAD = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class PathLines:
    """All straight lines of a path.

    Attributes:
        start: lines x joints.
        change: lines x joints; end minus start.
        segment: Number of the segment of each line.
    """

    start: Array
    change: Array
    segment: Indices

    def at(self, line: Indices, share: Array) -> Array:
        """Return the posture at a share, 0..1, of each given line."""
        return np.asarray(self.start[line] + share[:, None] * self.change[line])

    def share_of_segment(self, line: int, share: float) -> float:
        """Return how far along its segment, 0..1, a point of a line is, by joint travel."""
        lengths = np.abs(self.change).max(axis=1)
        mine = np.flatnonzero(self.segment == self.segment[line])
        whole = lengths[mine].sum()
        before = lengths[mine[mine < line]].sum()
        return float((before + share * lengths[line]) / whole) if whole > 0.0 else 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Intervals:
    """Pieces of lines, each seen from its middle.

    Attributes:
        line: Number of the line.
        middle, half: Share of the line, 0..1.
    """

    line: Indices
    middle: Array
    half: Array

    def halves(self) -> Intervals:
        """Return both halves of every interval: all first halves, then all second ones."""
        half = self.half / 2.0
        return Intervals(
            line=np.concatenate((self.line, self.line)),
            middle=np.concatenate((self.middle - half, self.middle + half)),
            half=np.concatenate((half, half)),
        )

    def take(self, chosen: Indices) -> Intervals:
        """Return some of the intervals."""
        return Intervals(line=self.line[chosen], middle=self.middle[chosen], half=self.half[chosen])


def lines_of(path: JointPath | TeamPath) -> PathLines:
    """Return the lines of a path; a path with a gap between its segments is a ValueError."""
    _require_unbroken(path)
    starts, ends, segments = [], [], []
    for number, segment in enumerate(path.segments):
        for a, b in zip(segment.waypoints_rad, segment.waypoints_rad[1:], strict=False):
            starts.append(a)
            ends.append(b)
            segments.append(number)
    start, end = np.array(starts, dtype=np.float64), np.array(ends, dtype=np.float64)
    return PathLines(start=start, change=end - start, segment=np.array(segments, dtype=np.intp))


def equal_intervals(pieces: Indices) -> Intervals:
    """Return each line cut into a number of equal intervals."""
    line = np.repeat(np.arange(len(pieces)), pieces)
    number = np.concatenate([np.arange(n) for n in pieces])
    half = 0.5 / pieces[line]
    return Intervals(line=line, middle=(2.0 * number + 1.0) * half, half=half)


def _require_unbroken(path: JointPath | TeamPath) -> None:
    who = " and ".join(path.robots)
    for k, segment in enumerate(path.segments):
        if len(segment.waypoints_rad) < 2:  # noqa: PLR2004 - a line has two ends
            raise ValueError(f"segment {k} of the path of {who} has no line")
    for k, (a, b) in enumerate(zip(path.segments, path.segments[1:], strict=False)):
        pairs = zip(a.waypoints_rad[-1], b.waypoints_rad[0], strict=True)
        gap = max(abs(x - y) for x, y in pairs)
        if gap > _SAME_WAYPOINT_RAD:
            raise ValueError(
                f"segment {k + 1} of the path of {who} starts {gap:.2e} rad away from "
                "where the one before ends"
            )
