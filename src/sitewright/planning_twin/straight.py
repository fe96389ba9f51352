"""A straight line of the tip as joint waypoints: as few as keep the tip on the line."""

from __future__ import annotations

from sitewright.foundation.pose import Pose, Vector, add, distance, scale, subtract
from sitewright.planning_twin.motion import Kinematics
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.scene import RobotInScene
from sitewright.robot_team.description import Joints

_MOST_SEGMENTS = 32
_JUMP_RAD_PER_M = 0.15 / 0.005


def straight_line(
    kinematics: Kinematics,
    arm: RobotInScene,
    start: Pose,
    end: Pose,
    near_rad: Joints,
    *,
    max_chord_m: float = 0.0005,
) -> tuple[Joints, ...] | NoIk:
    """Return joint waypoints of a straight tip line of fixed orientation.

    Args:
        kinematics: Inverse kinematics of the arm.
        arm: The arm and where it stands.
        start: World pose of the tip at the start.
        end: World pose at the end; its position is used, its orientation must be the same.
        near_rad: Posture at the start, which fixes the branch.
        max_chord_m: How far the tip may leave the line between two waypoints.
    """
    segments = 1
    while segments <= _MOST_SEGMENTS:
        line = _waypoints(kinematics, arm, start, end, near_rad, segments)
        if isinstance(line, NoIk):
            return line
        if _chord_m(kinematics, arm, start.position_m, end.position_m, line) <= max_chord_m:
            return line
        segments *= 2
    return NoIk(is_proven=False, reason="the arm cannot keep the tip on the straight line")


def _waypoints(
    kinematics: Kinematics,
    arm: RobotInScene,
    start: Pose,
    end: Pose,
    near_rad: Joints,
    segments: int,
) -> tuple[Joints, ...] | NoIk:
    base_T_world = arm.world_T_base.inverse()
    shift = subtract(end.position_m, start.position_m)
    step_m = distance(start.position_m, end.position_m) / segments
    line = [near_rad]
    for k in range(1, segments + 1):
        position = add(start.position_m, scale(shift, k / segments))
        pose = base_T_world @ Pose(position, start.quaternion_wxyz)
        solutions = kinematics.solve(arm.description, pose, line[-1])
        if isinstance(solutions, NoIk):
            return solutions
        jump = max(abs(a - b) for a, b in zip(solutions[0], line[-1], strict=True))
        if jump > max(_JUMP_RAD_PER_M * step_m, 1e-3):
            return NoIk(is_proven=False, reason="the arm would have to change its branch")
        line.append(solutions[0])
    return tuple(line)


def _chord_m(
    kinematics: Kinematics,
    arm: RobotInScene,
    start_m: Vector,
    end_m: Vector,
    line: tuple[Joints, ...],
) -> float:
    """Return the largest distance of the middle of a segment from where it should be."""
    worst_m = 0.0
    count = len(line) - 1
    for k, (a, b) in enumerate(zip(line[:-1], line[1:], strict=True)):
        middle = tuple((x + y) / 2.0 for x, y in zip(a, b, strict=True))
        tip_m = (arm.world_T_base @ kinematics.tip(arm.description, middle)).position_m
        wanted_m = add(start_m, scale(subtract(end_m, start_m), (k + 0.5) / count))
        worst_m = max(worst_m, distance(tip_m, wanted_m))
    return worst_m
