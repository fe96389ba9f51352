"""Where a robot waits: at its home, or with that posture anywhere along its rails.

A robot that `waits_along_rails` is at its preparation station wherever its carriage stands, as
long as its arm is as at home. On a long track it need not drive to the end after each piece.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sitewright.foundation.pose import Pose, Vector, add, dot, scale, subtract
from sitewright.robot_team.cell import Robot
from sitewright.robot_team.description import Description, JointKind, Joints

_BESIDE_M = (2.0, 3.5)
"""So far along the rail beside the work a robot is out of the way of those who go on there."""
_ROUND_DIGITS = 6


def rails_of(description: Description) -> int:
    """Return how many joints slide before the first one that turns."""
    kinds = [joint.kind for joint in description.movable_joints]
    return next((k for k, kind in enumerate(kinds) if kind is not JointKind.PRISMATIC), len(kinds))


def is_at_home(robot: Robot, q_rad: Joints, *, within_rad: float) -> bool:
    """Tell whether a robot stands as at its preparation station.

    Args:
        robot: The robot.
        q_rad: Its joints.
        within_rad: How far each joint may be off, metres for one that slides.
    """
    wanted = waiting_q_rad(robot, q_rad)
    return max(abs(a - b) for a, b in zip(q_rad, wanted, strict=True)) < within_rad


def waiting_q_rad(robot: Robot, q_rad: Joints) -> Joints:
    """Return how a robot waits if it does not drive for it: home, with its rails as they are."""
    if not robot.waits_along_rails:
        return robot.home_q_rad
    rails = rails_of(robot.description)
    return (*q_rad[:rails], *robot.home_q_rad[rails:])


def foot_m(robot: Robot, q_rad: Joints) -> Vector:
    """Return where a robot stands: its base, or where it rides if it waits along its rails."""
    if not robot.waits_along_rails:
        return robot.world_T_base.position_m
    rail = _longest_rail(robot)
    at_zero, way = _foot(robot, rail)
    return add(at_zero, scale(way, q_rad[rail]))


def home_opposite(robot: Robot, world_p_m: Vector) -> Joints:
    """Return the home posture with the carriage as near to a point as its longest rail leads.

    Only for a robot that waits along its rails; for others it is the home posture.
    """
    if not robot.waits_along_rails:
        return robot.home_q_rad
    rail = _longest_rail(robot)
    at_m = _clipped(robot, rail, _along(robot, rail, world_p_m))
    return _with_rail(robot.home_q_rad, rail, at_m)


def waiting_postures(
    robot: Robot, declared: Sequence[Joints], now_rad: Joints, work_m: Vector
) -> tuple[Joints, ...]:
    """Return where a robot may go to be out of the way, in order of preference.

    Args:
        robot: The robot.
        declared: Its home, or its parking postures, as the cell has them.
        now_rad: Its joints now.
        work_m: Where others go on working, a point in the world.

    Returns:
        For a robot that waits along its rails first the arm of each declared posture beside the
        work, the nearest places first; then, and for all others only, what is declared.
    """
    found: dict[Joints, None] = {}
    if robot.waits_along_rails:
        rail, first = _longest_rail(robot), rails_of(robot.description)
        for posture in declared:
            for at_m in _beside(robot, rail, now_rad, work_m):
                beside = _with_rail((*now_rad[:first], *posture[first:]), rail, at_m)
                found[beside] = None
    return tuple(dict.fromkeys((*found, *declared)))


def _beside(robot: Robot, rail: int, now_rad: Joints, work_m: Vector) -> Iterator[float]:
    """Yield positions of a rail beside the work: where it is if that will do, then near ones."""
    now_m, work_at_m = now_rad[rail], _along(robot, rail, work_m)
    if abs(now_m - work_at_m) >= _BESIDE_M[0]:
        yield now_m
    for away_m in _BESIDE_M:
        sides = [round(work_at_m + sign * away_m, _ROUND_DIGITS) for sign in (-1.0, 1.0)]
        for at_m in sorted(sides, key=lambda at_m: (abs(at_m - now_m), at_m)):
            if at_m == _clipped(robot, rail, at_m):
                yield at_m


def _longest_rail(robot: Robot) -> int:
    joints = robot.description.movable_joints[: rails_of(robot.description)]
    return max(range(len(joints)), key=lambda k: joints[k].upper_rad - joints[k].lower_rad)


def _along(robot: Robot, rail: int, world_p_m: Vector) -> float:
    """Return the position of a rail at which the arm's foot is nearest to a point."""
    foot, direction = _foot(robot, rail)
    return dot(direction, subtract(world_p_m, foot))


def _foot(robot: Robot, rail: int) -> tuple[Vector, Vector]:
    """Return where the arm's foot is with one rail at zero, and the way of that rail."""
    pose_by_link = {robot.description.root: robot.world_T_base}
    way: Vector = (0.0, 0.0, 0.0)
    slid = 0
    for joint in robot.description.joints:
        parent = pose_by_link[joint.parent]
        if joint.kind is JointKind.REVOLUTE:
            return parent.position_m, way
        pose = parent @ joint.parent_T_joint
        if joint.kind is JointKind.PRISMATIC:
            if slid == rail:
                way = pose.turn(joint.axis)
            else:
                pose = pose @ Pose(scale(joint.axis, robot.home_q_rad[slid]))
            slid += 1
        pose_by_link[joint.child] = pose
    return pose_by_link[robot.description.tip].position_m, way


def _clipped(robot: Robot, rail: int, at_m: float) -> float:
    joint = robot.description.movable_joints[rail]
    return min(max(at_m, joint.lower_rad), joint.upper_rad)


def _with_rail(q_rad: Joints, rail: int, at_m: float) -> Joints:
    return (*q_rad[:rail], at_m, *q_rad[rail + 1 :])
