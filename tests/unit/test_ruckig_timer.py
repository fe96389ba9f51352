"""Timing: on the line, within the limits, at rest at every corner."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ruckig import InputParameter, Result, Ruckig, Synchronization
from ruckig import Trajectory as RuckigTrajectory

from motion_scenes import A, kr120
from sitewright.planning_twin.backends.ruckig_timer import RuckigTimer
from sitewright.planning_twin.backends.trajectory_samples import positions_at, sample_times
from sitewright.planning_twin.motion import JointLimits, JointPath, PathSegment
from sitewright.robot_team.description import Joints

VELOCITY = tuple(j.velocity_rad_s for j in kr120().movable_joints)
LIMITS = JointLimits(
    velocity_rad_s=VELOCITY,
    acceleration_rad_s2=tuple(2.0 * v for v in VELOCITY),
    jerk_rad_s3=tuple(20.0 * v for v in VELOCITY),
)
JOINT = st.floats(-3.0, 3.0, allow_nan=False)
POSTURE = st.tuples(*[JOINT] * 6)


def path(*segments: tuple[Joints, ...]) -> JointPath:
    return JointPath(robot=A, segments=tuple(PathSegment(waypoints_rad=s) for s in segments))


def off_polyline(point: Joints, waypoints: tuple[Joints, ...]) -> float:
    best = math.inf
    for a, b in pairwise(waypoints):
        start, change, here = np.array(a), np.array(b) - np.array(a), np.array(point)
        square = float(change @ change)
        share = min(1.0, max(0.0, float((here - start) @ change) / square)) if square else 0.0
        best = min(best, float(np.abs(start + share * change - here).max()))
    return best


@settings(deadline=None, max_examples=25)
@given(st.lists(POSTURE, min_size=2, max_size=4, unique=True))
def test_the_trajectory_never_leaves_the_polyline_or_the_limits(waypoints: list[Joints]) -> None:
    timed = RuckigTimer().time(path(tuple(waypoints)), LIMITS)
    trajectory = timed.trajectory
    for t in np.linspace(0.0, trajectory.duration_s, 60):
        q, v, a = trajectory.at(float(t))
        assert off_polyline(q, tuple(waypoints)) <= 1e-9
        assert (np.abs(v) <= np.array(LIMITS.velocity_rad_s) + 1e-9).all()
        assert (np.abs(a) <= np.array(LIMITS.acceleration_rad_s2) + 1e-8).all()
    for jerks in trajectory.jerks_rad_s3:
        assert (np.abs(jerks) <= np.array(LIMITS.jerk_rad_s3) * (1 + 1e-9)).all()


def test_a_line_is_what_ruckig_makes_of_six_joints_in_phase() -> None:
    start, end = (0.0, -1.5, 1.5, 0.3, 0.8, -2.0), (1.2, -1.1, 1.0, -0.6, 1.1, 0.4)
    request = InputParameter(6)
    request.current_position, request.target_position = list(start), list(end)
    request.max_velocity = list(LIMITS.velocity_rad_s)
    request.max_acceleration = list(LIMITS.acceleration_rad_s2)
    request.max_jerk = list(LIMITS.jerk_rad_s3)
    request.synchronization = Synchronization.Phase
    theirs = RuckigTrajectory(6)
    assert Ruckig(6).calculate(request, theirs) == Result.Working
    ours = RuckigTimer().time(path((start, end)), LIMITS).trajectory
    assert ours.duration_s == pytest.approx(theirs.duration, rel=1e-9)
    for t in np.linspace(0.0, ours.duration_s, 101):
        position, velocity, _ = theirs.at_time(float(t))
        q, v, _ = ours.at(float(t))
        assert q == pytest.approx(position, abs=1e-9)
        assert v == pytest.approx(velocity, abs=1e-7)


def test_it_stands_still_at_every_corner_and_segment_end() -> None:
    a, b, c, d = ((0.0,) * 6, (0.5,) * 6, (0.5, 0.9, 0.5, 0.5, 0.5, 0.5), (0.0,) * 6)
    timed = RuckigTimer().time(path((a, b, c), (c, d)), LIMITS)
    trajectory = timed.trajectory
    for corner in (a, b, c, d):
        knots = [k for k, q in enumerate(trajectory.positions_rad) if q == corner]
        assert knots
        assert any(max(map(abs, trajectory.velocities_rad_s[k])) < 1e-12 for k in knots)
    assert timed.segment_ends_s[-1] == trajectory.duration_s
    at_end, speed, _ = trajectory.at(timed.segment_ends_s[0])
    assert at_end == pytest.approx(c, abs=1e-9)
    assert speed == pytest.approx((0.0,) * 6, abs=1e-9)


def test_waypoints_on_one_line_are_passed_without_a_stop() -> None:
    a, b, c = ((0.0,) * 6, (0.25,) * 6, (1.0,) * 6)
    direct = RuckigTimer().time(path((a, c)), LIMITS).trajectory
    passing = RuckigTimer().time(path((a, b, c)), LIMITS).trajectory
    assert passing.duration_s == pytest.approx(direct.duration_s, rel=1e-12)


def test_a_turning_point_on_one_line_is_a_stop() -> None:
    a, b, c = ((0.0,) * 6, (1.0,) * 6, (0.25,) * 6)
    trajectory = RuckigTimer().time(path((a, b, c)), LIMITS).trajectory
    assert b in trajectory.positions_rad
    assert trajectory.end_rad == c


def test_a_joint_that_hardly_moves_does_not_disturb() -> None:
    a, b = ((0.0,) * 6, (1.0, 5e-324, 0.0, 1e-300, 0.0, 0.0))
    trajectory = RuckigTimer().time(path((a, b)), LIMITS).trajectory
    alone = RuckigTimer().time(path((a, (1.0, 0.0, 0.0, 0.0, 0.0, 0.0))), LIMITS).trajectory
    assert trajectory.duration_s == alone.duration_s
    assert trajectory.end_rad == b


def test_standing_still_takes_no_time() -> None:
    timed = RuckigTimer().time(path(((0.3,) * 6, (0.3,) * 6)), LIMITS)
    assert timed.trajectory.duration_s == 0.0
    assert timed.trajectory.start_rad == timed.trajectory.end_rad == (0.3,) * 6
    assert timed.segment_ends_s == (0.0,)


def test_ends_and_knots_are_the_waypoints_to_the_bit() -> None:
    a, b = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6), (1.1, -0.7, 0.3, 2.4, -0.5, 0.1)
    trajectory = RuckigTimer().time(path((a, b)), LIMITS).trajectory
    assert trajectory.start_rad == a
    assert trajectory.end_rad == b
    assert list(trajectory.times_s) == sorted(trajectory.times_s)


@settings(deadline=None, max_examples=15)
@given(st.lists(POSTURE, min_size=2, max_size=3, unique=True))
def test_samples_are_dense_in_time_and_in_joint_travel(waypoints: list[Joints]) -> None:
    trajectory = RuckigTimer().time(path(tuple(waypoints)), LIMITS).trajectory
    times = sample_times(trajectory, step_s=0.01, step_rad=0.005)
    postures = positions_at(trajectory, times)
    assert times[0] == 0.0
    assert times[-1] == trajectory.duration_s
    assert np.diff(times).max() <= 0.01 + 1e-12
    assert np.abs(np.diff(postures, axis=0)).max() <= 0.005
    for k in range(0, len(times), max(1, len(times) // 20)):
        assert postures[k] == pytest.approx(trajectory.at(float(times[k]))[0], abs=1e-12)
