"""Samples of a trajectory, so dense that no joint moves far between two of them."""

from __future__ import annotations

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.robot_team.trajectory import Trajectory


def sample_times(trajectory: Trajectory, *, step_s: float, step_rad: float) -> Array:
    """Return rising times from start to end, at most `step_s` apart.

    No joint moves more than `step_rad` from one to the next.
    """
    count = max(1, int(np.ceil(trajectory.duration_s / step_s)))
    times = np.linspace(0.0, trajectory.duration_s, count + 1)
    jumps = np.abs(np.diff(positions_at(trajectory, times), axis=0)).max(axis=1, initial=0.0)
    # a cubic piece can run unevenly within a step: a third more samples than the mean asks for
    pieces = np.maximum(1, np.ceil(1.33 * jumps / step_rad)).astype(int)
    starts = np.repeat(times[:-1], pieces)
    widths = np.repeat(np.diff(times) / pieces, pieces)
    numbers = np.concatenate([np.arange(n) for n in pieces])
    return np.append(starts + numbers * widths, times[-1])


def positions_at(trajectory: Trajectory, times: Array) -> Array:
    """Return the joint positions at many times, one row each."""
    knots = np.array(trajectory.times_s)
    piece = np.clip(np.searchsorted(knots, times, side="right") - 1, 0, len(knots) - 1)
    h = np.maximum(times - knots[piece], 0.0)[:, None]
    q, v, a, j = (
        np.array(rows, dtype=np.float64)[piece]
        for rows in (
            trajectory.positions_rad,
            trajectory.velocities_rad_s,
            trajectory.accelerations_rad_s2,
            trajectory.jerks_rad_s3,
        )
    )
    return np.asarray(q + h * (v + h * (a / 2.0 + h * j / 6.0)))
