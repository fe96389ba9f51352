"""Whether a trajectory runs along a path and nowhere else, each segment in its time."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

from sitewright.planning_twin.motion import TimedPath
from sitewright.robot_team.description import Joints
from sitewright.robot_team.trajectory import Trajectory

TOLERANCE_RAD = 1e-7
"""So far a trajectory may be off its path; no point of an arm moves half a micrometre by that."""
_SAME_RAD = 1e-12
_SAME_S = 1e-9


@dataclass(frozen=True, slots=True)
class _Line:
    """A straight line of the path."""

    start: Joints
    end: Joints

    @property
    def change(self) -> Joints:
        return tuple(b - a for a, b in zip(self.start, self.end, strict=True))

    @property
    def share_slack(self) -> float:
        return TOLERANCE_RAD / max(abs(c) for c in self.change)

    def is_end(self, share: float) -> bool:
        return share >= 1.0 - self.share_slack

    def share_of(self, q: Joints) -> float:
        """Return where along the line the nearest point to a posture is: 0 start, 1 end."""
        change = self.change
        whole = sum(c * c for c in change)
        along = sum(c * (x - a) for c, x, a in zip(change, q, self.start, strict=True))
        return along / whole if whole > 0.0 else 0.0

    def distance_rad(self, q: Joints, share: float) -> float:
        """Return how far a posture is from a point of the line, by its worst joint."""
        points = zip(self.start, self.change, q, strict=True)
        return max(abs(a + share * c - x) for a, c, x in points)


def misfit(timed: TimedPath) -> str:
    """Return where a trajectory is not on its path, in one sentence; empty if it always is.

    Between knots a trajectory is a cubic. It stays on a line if its position, speed,
    acceleration and jerk do, and within the line's ends if its turning points do.
    """
    trajectory, segments = timed.trajectory, timed.path.segments
    if len(timed.segment_ends_s) != len(segments):
        return "its segments have no times"
    if wrong := _unsteady(trajectory):
        return wrong
    knot = 0
    for number, segment in enumerate(segments):
        lines = list(_lines(segment.waypoints_rad))
        pieces = []
        while knot + 1 < len(trajectory.times_s) and (
            trajectory.times_s[knot + 1] <= timed.segment_ends_s[number] + _SAME_S
        ):
            pieces.append(knot)
            knot += 1
        if wrong := _off(trajectory, pieces, lines):
            return f"in segment {number} {wrong}"
    if knot + 1 != len(trajectory.times_s):
        return "it goes on after its path has ended"
    ends = ((trajectory.start_rad, timed.path.start_rad), (trajectory.end_rad, timed.path.end_rad))
    if any(_apart_rad(a, b) > TOLERANCE_RAD for a, b in ends):
        return "it does not run from the path's start to its end"
    return ""


def _lines(waypoints: tuple[Joints, ...]) -> Iterator[_Line]:
    """Yield lines; waypoints on the line of their neighbours are no corners."""
    corners: list[Joints] = []
    for q in waypoints:
        if corners and _apart_rad(q, corners[-1]) <= _SAME_RAD:
            continue
        if len(corners) > 1:
            whole = _Line(corners[-2], q)
            share = whole.share_of(corners[-1])
            if 0.0 < share < 1.0 and whole.distance_rad(corners[-1], share) <= _SAME_RAD:
                corners.pop()
        corners.append(q)
    for a, b in pairwise(corners):
        yield _Line(a, b)


def _off(trajectory: Trajectory, pieces: list[int], lines: list[_Line]) -> str:
    """Return how the pieces of one segment leave its lines; empty if they run along all."""
    place, share = 0, 0.0
    for k in pieces:
        if place < len(lines) and lines[place].is_end(share) and _rests(trajectory, k):
            place, share = place + 1, 0.0
        if place == len(lines):
            if _moves(trajectory, k):
                return f"it goes on at {trajectory.times_s[k]:.3f} s where the lines have ended"
            continue
        line = lines[place]
        if not _is_along(trajectory, k, line):
            return f"it is off the line from {trajectory.times_s[k]:.3f} s on"
        share = line.share_of(_end_of(trajectory, k))
    is_done = place == len(lines) or (place == len(lines) - 1 and lines[place].is_end(share))
    return "" if is_done else "it does not come to the end"


def _is_along(trajectory: Trajectory, k: int, line: _Line) -> bool:
    """Tell whether a piece stays on a line, within its ends."""
    duration = trajectory.times_s[k + 1] - trajectory.times_s[k]
    start = line.share_of(trajectory.positions_rad[k])
    if line.distance_rad(trajectory.positions_rad[k], start) > TOLERANCE_RAD:
        return False
    rates = []
    for order, rows in enumerate(
        (trajectory.velocities_rad_s, trajectory.accelerations_rad_s2, trajectory.jerks_rad_s3),
        start=1,
    ):
        rate = _share_rate(line, rows[k])
        strayed = max(abs(x - rate * c) for x, c in zip(rows[k], line.change, strict=True))
        if strayed * duration**order > TOLERANCE_RAD:
            return False
        rates.append(rate)
    slack = line.share_slack
    shares = [start + _polynomial(rates, h) for h in (0.0, duration, *_turns(rates, duration))]
    return all(-slack <= s <= 1.0 + slack for s in shares)


def _unsteady(trajectory: Trajectory) -> str:
    """Return where a trajectory jumps, or does not rest at its ends; empty if nowhere."""
    for k in range(len(trajectory.times_s) - 1):
        if trajectory.times_s[k + 1] <= trajectory.times_s[k]:
            return f"its time does not go on at {trajectory.times_s[k]:.3f} s"
        if _apart_rad(_end_of(trajectory, k), trajectory.positions_rad[k + 1]) > TOLERANCE_RAD:
            return f"it jumps at {trajectory.times_s[k + 1]:.3f} s"
    if _moves(trajectory, len(trajectory.times_s) - 1):
        return "it does not end at rest"
    return ""


def _end_of(trajectory: Trajectory, k: int) -> Joints:
    h = trajectory.times_s[k + 1] - trajectory.times_s[k]
    rows = zip(
        trajectory.positions_rad[k],
        trajectory.velocities_rad_s[k],
        trajectory.accelerations_rad_s2[k],
        trajectory.jerks_rad_s3[k],
        strict=True,
    )
    return tuple(q + _polynomial([v, a, j], h) for q, v, a, j in rows)


def _polynomial(rates: list[float], h: float) -> float:
    speed, acceleration, jerk = rates
    return h * (speed + h * (acceleration / 2.0 + h * jerk / 6.0))


def _turns(rates: list[float], duration: float) -> list[float]:
    """Return the times within a piece at which its speed is zero."""
    speed, acceleration, jerk = rates
    if jerk == 0.0:
        found = [] if acceleration == 0.0 else [-speed / acceleration]
    else:
        square = acceleration**2 - 2.0 * jerk * speed
        roots = [] if square < 0.0 else [math.sqrt(square), -math.sqrt(square)]
        found = [(-acceleration + root) / jerk for root in roots]
    return [h for h in found if 0.0 < h < duration]


def _share_rate(line: _Line, row: Joints) -> float:
    change = line.change
    return sum(c * x for c, x in zip(change, row, strict=True)) / sum(c * c for c in change)


def _rests(trajectory: Trajectory, k: int) -> bool:
    return max(map(abs, trajectory.velocities_rad_s[k])) < 1e-6  # noqa: PLR2004


def _moves(trajectory: Trajectory, k: int) -> bool:
    return not _rests(trajectory, k)


def _apart_rad(a: Joints, b: Joints) -> float:
    return max(abs(x - y) for x, y in zip(a, b, strict=True))
