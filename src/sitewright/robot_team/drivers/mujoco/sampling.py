"""Trajectories as arrays, one row per time step; and how to stop on the path."""

from __future__ import annotations

import numpy as np

from sitewright.robot_team.description import Joint
from sitewright.robot_team.drivers.mujoco.physics import Array
from sitewright.robot_team.trajectory import Trajectory

_SLACK_RAD = 1e-3
_SPEED_SLACK = 1.01


def samples(trajectory: Trajectory, step_s: float) -> tuple[Array, Array, Array]:
    """Return positions, speeds and accelerations at 0, step, 2 step ... and at the end."""
    count = int(np.ceil(trajectory.duration_s / step_s - 1e-9)) + 1
    times = np.minimum(np.arange(count) * step_s, trajectory.duration_s)
    knots = np.array(trajectory.times_s)
    piece = np.clip(np.searchsorted(knots, times, side="right") - 1, 0, len(knots) - 1)
    h = (times - knots[piece])[:, None]
    q, v, a, j = (
        np.array(rows)[piece]
        for rows in (
            trajectory.positions_rad,
            trajectory.velocities_rad_s,
            trajectory.accelerations_rad_s2,
            trajectory.jerks_rad_s3,
        )
    )
    return (
        q + h * (v + h * (a / 2.0 + h * j / 6.0)),
        v + h * (a + h * j / 2.0),
        a + h * j,
    )


def broken_limit(rows: tuple[Array, Array, Array], joints: tuple[Joint, ...]) -> str:
    """Return which joint a sampled motion would send past its limits; empty if none.

    The driver checks this itself, whatever the planner said.
    """
    positions, speeds, _ = rows
    if positions.shape[1] != len(joints):
        return f"{positions.shape[1]} joints instead of {len(joints)}"
    for number, joint in enumerate(joints):
        column = positions[:, number]
        if not np.isfinite(column).all() or not np.isfinite(speeds[:, number]).all():
            return f"{joint.name}: not a number"
        if (
            column.min() < joint.lower_rad - _SLACK_RAD
            or column.max() > joint.upper_rad + _SLACK_RAD
        ):
            return f"{joint.name}: position limit"
        if (
            joint.velocity_rad_s
            and np.abs(speeds[:, number]).max() > _SPEED_SLACK * joint.velocity_rad_s
        ):
            return f"{joint.name}: speed limit"
    return ""
