"""Ways as an operator would teach them: up, around the robot's base at a height, and down."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from benchmarks.motion.trial import NotNarrowError, Trial

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.planning_twin.motion import Kinematics
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.scene import RobotInScene
from sitewright.planning_twin.straight import straight_line
from sitewright.robot_team.description import Joints

_ARC_STEP_RAD = math.radians(12.0)
_MOST_TURN_RAD = 0.9
"""A joint that turns further between two points of an arc would change its branch."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Carry:
    """Where a tip goes, in the frame of its robot's base.

    Attributes:
        lift_m: So far straight up, before the arc and behind it.
        slide_m: So far along the tip's x axis, before it goes up and after it came down.
        arc_radius_m: Halfway around, the tip is so far from the base's axis.
    """

    start: Pose
    goal: Pose
    lift_m: tuple[float, float]
    slide_m: tuple[float, float] = (0.0, 0.0)
    arc_radius_m: float | None = None


def pointing_down(x_m: float, y_m: float, z_m: float, yaw_rad: float) -> Pose:
    """Return a tip that looks down; its x axis has this direction in the plan."""
    hint = (math.cos(yaw_rad), math.sin(yaw_rad), 0.0)
    return Pose.from_z_axis((x_m, y_m, z_m), (0.0, 0.0, -1.0), hint)


def tilted(pose: Pose, pitch_rad: float, roll_rad: float) -> Pose:
    """Return a pose turned about its own y and x axes."""
    turn = rotation((0.0, 1.0, 0.0), pitch_rad) @ rotation((1.0, 0.0, 0.0), roll_rad)
    return pose @ turn


def in_base(trial: Trial, robot: RobotId, world_T_tip: Pose) -> Pose:
    """Return a pose of the world in a robot's base."""
    return trial.scene.robots[robot].world_T_base.inverse() @ world_T_tip


def carried(trial: Trial, robot: RobotId, carry: Carry, near_rad: Joints) -> tuple[Joints, ...]:
    """Return the waypoints of a way.

    Args:
        trial: Has the robot.
        robot: Who moves.
        carry: The way.
        near_rad: The posture at the start is the one nearest to it.

    Raises:
        NotNarrowError: The arm cannot go this way.
    """
    kinematics = trial.backends.kinematics
    arm = replace(trial.scene.robots[robot], world_T_base=Pose())
    up, down = (translation(0.0, 0.0, lift_m) for lift_m in carry.lift_m)
    out, into = (
        pose @ translation(slide_m, 0.0, 0.0)
        for pose, slide_m in zip((carry.start, carry.goal), carry.slide_m, strict=True)
    )
    lifted, above = up @ out, down @ into
    way = list(_straight(kinematics, arm, carry.start, out, near_rad))
    way += _straight(kinematics, arm, out, lifted, way[-1])[1:]
    for pose in _arc(lifted, above, carry.arc_radius_m):
        following = kinematics.follow(arm.description, pose, way[-1])
        if isinstance(following, NoIk):
            raise NotNarrowError(following.reason)
        way.append(following)
    way += _straight(kinematics, arm, above, into, way[-1])[1:]
    way += _straight(kinematics, arm, into, carry.goal, way[-1])[1:]
    for a, b in pairwise(way):
        if np.abs(np.subtract(a, b)).max() > _MOST_TURN_RAD:
            raise NotNarrowError("the arm would change its branch")
    return (way[0], *(b for a, b in pairwise(way) if a != b))


def _straight(
    kinematics: Kinematics, arm: RobotInScene, start: Pose, goal: Pose, near_rad: Joints
) -> tuple[Joints, ...]:
    found = straight_line(kinematics, arm, start, goal, near_rad)
    if isinstance(found, NoIk):
        raise NotNarrowError(found.reason)
    return found


def _arc(start: Pose, goal: Pose, radius_m: float | None) -> list[Pose]:
    """Return poses that turn around the base; radius, height and direction change evenly.

    Args:
        start: Not returned.
        goal: The last one.
        radius_m: Halfway the tip is so far from the base's axis.
    """
    (r_a, azimuth_a, z_a), (r_b, azimuth_b, z_b) = _cylindrical(start), _cylindrical(goal)
    first, last = (
        rotation((0.0, 0.0, 1.0), -azimuth) @ Pose((0.0, 0.0, 0.0), pose.quaternion_wxyz)
        for azimuth, pose in ((azimuth_a, start), (azimuth_b, goal))
    )
    turn = last @ first.inverse()
    axis, angle = _axis_angle(turn)
    steps = max(4, math.ceil(abs(azimuth_b - azimuth_a) / _ARC_STEP_RAD))
    out = []
    for k in range(1, steps + 1):
        s = k / steps
        r = (1.0 - s) * r_a + s * r_b
        if radius_m is not None:
            r += 4.0 * s * (1.0 - s) * (radius_m - (r_a + r_b) / 2.0)
        azimuth = (1.0 - s) * azimuth_a + s * azimuth_b
        about = rotation((0.0, 0.0, 1.0), azimuth) @ rotation(axis, s * angle) @ first
        place = (r * math.cos(azimuth), r * math.sin(azimuth), (1.0 - s) * z_a + s * z_b)
        out.append(Pose(place, about.quaternion_wxyz))
    return out


def _cylindrical(pose: Pose) -> tuple[float, float, float]:
    x, y, z = pose.position_m
    return math.hypot(x, y), math.atan2(y, x), z


def _axis_angle(turn: Pose) -> tuple[tuple[float, float, float], float]:
    w, x, y, z = turn.quaternion_wxyz
    if w < 0.0:
        w, x, y, z = -w, -x, -y, -z
    sine = math.sqrt(x * x + y * y + z * z)
    if sine < 1e-9:  # noqa: PLR2004 - no turn
        return (0.0, 0.0, 1.0), 0.0
    return (x / sine, y / sine, z / sine), 2.0 * math.atan2(sine, w)
