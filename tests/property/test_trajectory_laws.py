from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sitewright.foundation.ids import RobotId
from sitewright.robot_team.description import Joints
from sitewright.robot_team.trajectory import Trajectory

Piece = tuple[float, Joints]
"""Duration and jerk of each joint."""

JOINTS = 3
pieces = st.lists(
    st.tuples(st.floats(0.01, 0.5), st.tuples(*[st.floats(-50.0, 50.0)] * JOINTS)),
    min_size=1,
    max_size=6,
)


def trajectory(parts: Sequence[Piece], start: Joints = (0.1, -0.2, 0.3)) -> Trajectory:
    """Integrate constant jerks from rest, joint by joint."""
    rest: Joints = (0.0,) * JOINTS
    times, q, v, a, jerks = [0.0], [start], [rest], [rest], []
    for h, jerk in parts:
        rows = list(zip(q[-1], v[-1], a[-1], jerk, strict=True))
        times.append(times[-1] + h)
        q.append(tuple(x + h * w + h * h * b / 2 + h**3 * j / 6 for x, w, b, j in rows))
        v.append(tuple(w + h * b + h * h * j / 2 for _, w, b, j in rows))
        a.append(tuple(b + h * j for _, _, b, j in rows))
        jerks.append(jerk)
    return Trajectory(
        robot=RobotId("a"),
        times_s=tuple(times),
        positions_rad=tuple(q),
        velocities_rad_s=tuple(v),
        accelerations_rad_s2=tuple(a),
        jerks_rad_s3=(*jerks, rest),
    )


@settings(max_examples=50)
@given(pieces)
def test_position_speed_and_acceleration_do_not_jump_at_a_knot(parts: list[Piece]) -> None:
    motion = trajectory(parts)
    for time_s in motion.times_s[1:-1]:
        before, after = motion.at(time_s - 1e-9), motion.at(time_s + 1e-9)
        for left, right in zip(before, after, strict=True):
            assert left == pytest.approx(right, abs=1e-5)


@settings(max_examples=50)
@given(pieces)
def test_a_trajectory_passes_through_its_knots(parts: list[Piece]) -> None:
    motion = trajectory(parts)
    for k, time_s in enumerate(motion.times_s):
        assert motion.at(time_s)[0] == pytest.approx(motion.positions_rad[k], abs=1e-9)
    assert motion.at(0.0)[0] == motion.start_rad
    assert motion.at(motion.duration_s)[0] == motion.end_rad


@settings(max_examples=50)
@given(pieces, st.floats(0.01, 0.99))
def test_speed_is_the_slope_of_position(parts: list[Piece], share: float) -> None:
    motion, h = trajectory(parts), 1e-6
    time_s = share * motion.duration_s
    if min(abs(time_s - t) for t in motion.times_s) < 2 * h:
        return
    here, there = motion.at(time_s - h)[0], motion.at(time_s + h)[0]
    slopes = [(b - a) / (2 * h) for a, b in zip(here, there, strict=True)]
    assert motion.at(time_s)[1] == pytest.approx(slopes, abs=1e-3)


def test_before_the_start_and_after_the_end_the_robot_stands() -> None:
    motion = trajectory([(0.2, (1.0, 0.0, 0.0)), (0.3, (0.0, 1.0, 0.0))])
    for time_s, q in ((-1.0, motion.start_rad), (9.0, motion.end_rad)):
        assert motion.at(time_s)[0] == q
        assert motion.at(time_s)[1] == (0.0, 0.0, 0.0)


def _nudged(rows: tuple[Joints, ...], row: int, by: float) -> tuple[Joints, ...]:
    changed = (rows[row][0] + by, *rows[row][1:])
    return (*rows[:row], changed, *rows[row + 1 :])


@settings(max_examples=30)
@given(pieces, st.data())
def test_the_hash_sees_every_number_and_whose_motion_it_is(
    parts: list[Piece], data: st.DataObject
) -> None:
    motion = trajectory(parts)
    field = data.draw(
        st.sampled_from(
            ["positions_rad", "velocities_rad_s", "accelerations_rad_s2", "jerks_rad_s3"]
        )
    )
    row = data.draw(st.integers(0, len(parts)))
    values = {field: _nudged(getattr(motion, field), row, 1e-5)}
    late = tuple(t + 1e-5 if t else t for t in motion.times_s)
    others = [
        replace(motion, **values),  # type: ignore[arg-type]
        replace(motion, times_s=late),
        replace(motion, robot=RobotId("b")),
    ]
    assert trajectory(parts).sha256() == motion.sha256()
    assert all(other.sha256() != motion.sha256() for other in others)
