"""Jerk-limited timing that never leaves the certified lines."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from typing_extensions import override

from sitewright.errors import BackendError
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.motion import JointLimits, JointPath, TimedPath, Timer
from sitewright.robot_team.description import Joints
from sitewright.robot_team.trajectory import Trajectory

_SAME_POSTURE_RAD = 1e-12
_STRAIGHT_RAD = 1e-12
"""A waypoint this near to the line of its neighbours is passed without a stop."""
_NO_TIME_S = 1e-12
_HARDLY = 1e-9
"""Joints that travel so much less than another one are far from their own limits."""


class RuckigTimer(Timer):
    """Times every straight line from rest to rest with all joints in step.

    Along a line all joints share one motion law, so the law is computed once, for the share of
    the line that has been travelled, under the limits that the slowest joint sets. That is what
    synchronising the phases of all joints means, and no rounding can make a joint drop out.
    """

    @override
    def time(self, path: JointPath, limits: JointLimits) -> TimedPath:
        knots = _Knots(start=np.array(path.start_rad, dtype=np.float64))
        ends: list[float] = []
        for segment in path.segments:
            corners = _corners(np.array(segment.waypoints_rad, dtype=np.float64))
            for a, b in pairwise(corners):
                knots.travel(a, b, _law(b - a, limits))
            ends.append(knots.now_s)
        return TimedPath(
            path=path,
            trajectory=knots.trajectory(path),
            segment_ends_s=tuple(ends),
        )


@dataclass(frozen=True, slots=True, eq=False)
class _Law:
    """Share of a line over time: seven or fewer pieces of constant jerk.

    Attributes:
        duration_s: Of each piece.
        share, speed, acceleration, jerk: At the start of each piece.
    """

    duration_s: Array
    share: Array
    speed: Array
    acceleration: Array
    jerk: Array


@dataclass(slots=True, eq=False)
class _Knots:
    """The trajectory while it is put together."""

    start: Array
    now_s: float = 0.0
    times: list[float] = field(default_factory=list)
    rows: list[tuple[Array, Array, Array, Array]] = field(default_factory=list)

    def travel(self, a: Array, b: Array, law: _Law) -> None:
        """Append the motion from a to b."""
        change = b - a
        rows = zip(law.duration_s, law.share, law.speed, law.acceleration, law.jerk, strict=True)
        for duration_s, share, speed, acceleration, jerk in rows:
            self.times.append(self.now_s)
            self.rows.append(
                (a + share * change, speed * change, acceleration * change, jerk * change)
            )
            self.now_s += float(duration_s)
        self.start = b

    def trajectory(self, path: JointPath) -> Trajectory:
        rest = np.zeros_like(self.start)
        rows = [*self.rows, (self.start, rest, rest, rest)]
        q, v, a, j = (tuple(_joints(row[k]) for row in rows) for k in range(4))
        return Trajectory(
            robot=path.robot,
            times_s=(*self.times, self.now_s),
            positions_rad=q,
            velocities_rad_s=v,
            accelerations_rad_s2=a,
            jerks_rad_s3=j,
        )


def _joints(row: Array) -> Joints:
    return tuple(float(v) for v in row)


def _corners(waypoints: Array) -> list[Array]:
    """Return the waypoints without repeats and without those on the line of their neighbours."""
    corners: list[Array] = []
    for point in waypoints:
        if corners and np.abs(point - corners[-1]).max() <= _SAME_POSTURE_RAD:
            continue
        if len(corners) > 1 and _is_passed(corners[-2], corners[-1], point):
            corners.pop()
        corners.append(point)
    return corners


def _is_passed(a: Array, b: Array, c: Array) -> bool:
    whole, part = c - a, b - a
    share = float(part @ whole) / float(whole @ whole) if whole.any() else 0.0
    return 0.0 < share < 1.0 and float(np.abs(part - share * whole).max()) <= _STRAIGHT_RAD


def _law(change: Array, limits: JointLimits) -> _Law:
    from ruckig import InputParameter, Result, Ruckig, Trajectory

    travel = np.abs(change)
    request = InputParameter(1)
    request.current_position, request.target_position = [0.0], [1.0]
    request.max_velocity = [_share_limit(limits.velocity_rad_s, travel)]
    request.max_acceleration = [_share_limit(limits.acceleration_rad_s2, travel)]
    request.max_jerk = [_share_limit(limits.jerk_rad_s3, travel)]
    trajectory = Trajectory(1)
    result = Ruckig(1).calculate(request, trajectory)
    if result != Result.Working:
        raise BackendError(f"ruckig could not time a line: {result}")
    profile = trajectory.profiles[0][0]
    duration = np.array(profile.t)
    lasting = np.flatnonzero(duration > _NO_TIME_S)
    return _Law(
        duration_s=duration[lasting],
        share=np.array(profile.p)[lasting],
        speed=np.array(profile.v)[lasting],
        acceleration=np.array(profile.a)[lasting],
        jerk=np.array(profile.j)[lasting],
    )


def _share_limit(limit: Joints, travel: Array) -> float:
    """Return the limit on the share of a line under which every joint keeps its own limit."""
    moving = travel > _HARDLY * travel.max()
    return float((np.array(limit, dtype=np.float64)[moving] / travel[moving]).min())
