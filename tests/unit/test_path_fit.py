"""A trajectory runs along its path and nowhere else; anything else is told."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion_scenes import HOME, A
from sitewright.planning_twin.backends.ruckig_timer import RuckigTimer
from sitewright.planning_twin.motion import JointLimits, JointPath, PathSegment, TimedPath
from sitewright.planning_twin.path_fit import misfit
from sitewright.robot_team.description import Joints

LIMITS = JointLimits(
    velocity_rad_s=(2.0,) * 6, acceleration_rad_s2=(4.0,) * 6, jerk_rad_s3=(40.0,) * 6
)
NEXT: Joints = (0.5, -1.5, 1.5, 0.2, 1.0, -0.3)
LAST: Joints = (0.7, -1.5, 1.3, 0.2, 1.0, 0.4)
MANY = st.tuples(*[st.floats(-3.0, 3.0)] * 6)


def timed(*segments: tuple[Joints, ...]) -> TimedPath:
    path = JointPath(robot=A, segments=tuple(PathSegment(waypoints_rad=s) for s in segments))
    return RuckigTimer().time(path, LIMITS)


FRAME = timed((HOME, NEXT), (NEXT, LAST))


def shifted(rows: tuple[Joints, ...], row: int, joint: int, by: float) -> tuple[Joints, ...]:
    changed = tuple(v + by if k == joint else v for k, v in enumerate(rows[row]))
    return (*rows[:row], changed, *rows[row + 1 :])


@given(st.lists(MANY, min_size=2, max_size=5), st.integers(1, 3))
def test_what_the_timer_makes_fits_its_path(points: list[Joints], cut: int) -> None:
    cut = min(cut, len(points) - 1)
    segments = (tuple(points[: cut + 1]), tuple(points[cut:]))
    assert misfit(timed(*(s for s in segments if len(s) > 1))) == ""


def test_standing_still_fits() -> None:
    assert misfit(timed((HOME, HOME))) == ""


def test_waypoints_on_one_line_are_passed() -> None:
    middle = tuple((a + b) / 2 for a, b in zip(HOME, NEXT, strict=True))
    assert misfit(timed((HOME, middle, NEXT))) == ""


@pytest.mark.parametrize("joint", range(6))
def test_a_bulge_between_two_knots_is_told(joint: int) -> None:
    """The knots are all on the path; only the cubic between two of them leaves it."""
    trajectory = FRAME.trajectory
    h = trajectory.times_s[2] - trajectory.times_s[1]
    bulge = 0.01
    bent = replace(
        trajectory,
        velocities_rad_s=shifted(trajectory.velocities_rad_s, 1, joint, bulge / h),
        accelerations_rad_s2=shifted(trajectory.accelerations_rad_s2, 1, joint, -6 * bulge / h**2),
        jerks_rad_s3=shifted(trajectory.jerks_rad_s3, 1, joint, 12 * bulge / h**3),
    )
    end = bent.at(math.nextafter(bent.times_s[2], 0.0))[0]
    assert end == pytest.approx(trajectory.positions_rad[2], abs=1e-9)
    assert "off the line" in misfit(replace(FRAME, trajectory=bent))


def test_a_detour_beyond_the_end_of_a_line_is_told() -> None:
    """There and back on the very same straight line, but past its end."""
    beyond = tuple(b + 0.1 * (b - a) for a, b in zip(HOME, NEXT, strict=True))
    longer = timed((HOME, beyond), (beyond, NEXT))
    path = JointPath(
        robot=A,
        segments=(PathSegment(waypoints_rad=(HOME, NEXT)), PathSegment(waypoints_rad=(NEXT, NEXT))),
    )
    assert misfit(replace(longer, path=path))


def test_another_order_of_waypoints_is_told() -> None:
    other = timed((HOME, LAST), (LAST, NEXT))
    assert misfit(replace(FRAME, trajectory=other.trajectory))


def test_a_segment_at_the_wrong_time_is_told() -> None:
    """In the time of the second segment, with its thresholds, the robot is still in the first."""
    early = (FRAME.segment_ends_s[0] * 0.5, FRAME.segment_ends_s[1])
    assert "segment 0" in misfit(replace(FRAME, segment_ends_s=early))


def test_a_jump_is_told() -> None:
    trajectory = FRAME.trajectory
    jumping = replace(trajectory, positions_rad=shifted(trajectory.positions_rad, 3, 0, 1e-3))
    assert "jumps" in misfit(replace(FRAME, trajectory=jumping))


def test_a_path_that_is_not_run_to_its_end_is_told() -> None:
    half = timed((HOME, NEXT))
    assert misfit(replace(FRAME, trajectory=half.trajectory))
    whole = replace(FRAME, trajectory=half.trajectory, segment_ends_s=half.segment_ends_s)
    assert "no times" in misfit(whole)


def test_going_on_after_the_end_is_told() -> None:
    short = replace(FRAME.path, segments=FRAME.path.segments[:1])
    cut = replace(FRAME, path=short, segment_ends_s=FRAME.segment_ends_s[:1])
    assert "goes on" in misfit(cut)


def test_ending_in_motion_is_told() -> None:
    trajectory = FRAME.trajectory
    last = len(trajectory.times_s) - 1
    fast = replace(trajectory, velocities_rad_s=shifted(trajectory.velocities_rad_s, last, 0, 0.1))
    assert "rest" in misfit(replace(FRAME, trajectory=fast))
