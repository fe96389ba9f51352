"""A straight line of the tip as the fewest joint-space lines that stay close to it."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sitewright.foundation.pose import Pose, Quaternion, add, scale, subtract
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.motion import Kinematics
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.scene import RobotInScene
from sitewright.robot_team.description import Description, Joints

MAX_CHORD_M = 0.0005
_MAX_CHORD_RAD = 0.002
_MAX_JUMP_RAD = 0.15
_JUMP_LENGTH_M = 0.005
_JUMP_ANGLE_RAD = 0.05
"""A joint may turn by the largest jump for each such stretch of the tip's line or turn."""
_PIECES = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128)
_PROBES = (0.25, 0.5, 0.75)
_SAME_M = 1e-6
_SAME_RAD = 1e-6


def straight_line(
    kinematics: Kinematics,
    robot_in_scene: RobotInScene,
    world_T_tip_start: Pose,
    world_T_tip_end: Pose,
    near_rad: Joints,
    *,
    max_chord_m: float = MAX_CHORD_M,
) -> tuple[Joints, ...] | NoIk:
    """Return waypoints whose joint-space lines keep the tip within a chord of a straight line.

    The tip shifts and turns evenly. The first waypoint is `near_rad` itself if the tip is at the
    start there.

    Args:
        kinematics: Of the robot.
        robot_in_scene: Description and base; its posture is not looked at.
        world_T_tip_start: Where the line starts.
        world_T_tip_end: Where it ends.
        near_rad: The posture nearest to it is the first waypoint; each further one is nearest to
            the one before.
        max_chord_m: Largest distance of the tip from the line.
    """
    line = _Line(kinematics, robot_in_scene, world_T_tip_start, world_T_tip_end)
    start_rad = line.posture(0.0, near_rad)
    if isinstance(start_rad, NoIk):
        return start_rad
    refusal = NoIk(is_proven=False, reason=Sentence("the line cannot be followed closely enough"))
    for pieces in _PIECES:
        found = _waypoints(line, start_rad, pieces)
        if isinstance(found, NoIk):
            if found.is_proven:
                return found
            refusal = found
        elif all(
            line.is_followed(found[k], found[k + 1], k / pieces, 1.0 / pieces, max_chord_m)
            for k in range(pieces)
        ):
            return found
    return refusal


def _waypoints(line: _Line, start_rad: Joints, pieces: int) -> tuple[Joints, ...] | NoIk:
    waypoints = [start_rad]
    allowed_rad = line.allowed_jump_rad(1.0 / pieces)
    for k in range(1, pieces + 1):
        found = line.posture(k / pieces, waypoints[-1])
        if isinstance(found, NoIk):
            return found
        jump = max(abs(a - b) for a, b in zip(found, waypoints[-1], strict=True))
        if jump > allowed_rad:
            return NoIk(
                is_proven=False,
                reason=Sentence(
                    "the arm would have to change its branch on the line ({jump_rad:.2f} rad)",
                    jump_rad=jump,
                ),
            )
        waypoints.append(found)
    return tuple(waypoints)


class _Line:
    def __init__(self, kinematics: Kinematics, robot: RobotInScene, start: Pose, end: Pose) -> None:
        base_T_world = robot.world_T_base.inverse()
        self._kinematics = kinematics
        self._description: Description = robot.description
        self._start, self._end = base_T_world @ start, base_T_world @ end
        self._is_point = self._start.distance_to_m(self._end) < _SAME_M

    def pose(self, share: float) -> Pose:
        """Return base_T_tip at a share, 0..1, of the line."""
        if share in (0.0, 1.0):
            return self._end if share else self._start
        way = subtract(self._end.position_m, self._start.position_m)
        return Pose(
            add(self._start.position_m, scale(way, share)),
            _between(self._start.quaternion_wxyz, self._end.quaternion_wxyz, share),
        )

    def posture(self, share: float, near_rad: Joints) -> Joints | NoIk:
        """Return the posture nearest to another one that puts the tip on the line."""
        pose = self.pose(share)
        if share == 0.0 or self._is_point:
            here = self._kinematics.tip(self._description, near_rad)
            if here.distance_to_m(pose) < _SAME_M and here.angle_to_rad(pose) < _SAME_RAD:
                return near_rad
        return self._kinematics.follow(self._description, pose, near_rad)

    def allowed_jump_rad(self, share: float) -> float:
        """Return how far a joint may turn on a share of the line."""
        length = self._start.distance_to_m(self._end) * share / _JUMP_LENGTH_M
        angle = self._start.angle_to_rad(self._end) * share / _JUMP_ANGLE_RAD
        return _MAX_JUMP_RAD * max(1.0, length + angle)

    def is_followed(self, a: Joints, b: Joints, start: float, share: float, chord_m: float) -> bool:
        """Tell whether the tip stays on the line while the joints go straight from a to b."""
        for probe, tip in self._probes(a, b):
            wanted = self.pose(start + probe * share)
            if self._off_line_m(tip) > chord_m or tip.angle_to_rad(wanted) > _MAX_CHORD_RAD:
                return False
        return True

    def _probes(self, a: Joints, b: Joints) -> Iterator[tuple[float, Pose]]:
        for probe in _PROBES:
            q = tuple(x + probe * (y - x) for x, y in zip(a, b, strict=True))
            yield probe, self._kinematics.tip(self._description, q)

    def _off_line_m(self, tip: Pose) -> float:
        """Return the distance of a tip position from the line, its ends included."""
        way = subtract(self._end.position_m, self._start.position_m)
        here = subtract(tip.position_m, self._start.position_m)
        square = math.fsum(w * w for w in way)
        along = math.fsum(h * w for h, w in zip(here, way, strict=True))
        share = min(1.0, max(0.0, along / square)) if square > 0.0 else 0.0
        return math.dist(here, scale(way, share))


def _between(a: Quaternion, b: Quaternion, share: float) -> Quaternion:
    """Return the rotation at a share of the shorter turn from a to b."""
    cosine = math.fsum(x * y for x, y in zip(a, b, strict=True))
    sign = -1.0 if cosine < 0.0 else 1.0
    angle = math.acos(min(1.0, abs(cosine)))
    if angle < 1e-9:  # noqa: PLR2004 - no turn
        return a
    w_a, w_b = math.sin((1.0 - share) * angle), sign * math.sin(share * angle)
    mixed = tuple(w_a * x + w_b * y for x, y in zip(a, b, strict=True))
    length = math.sqrt(math.fsum(m * m for m in mixed))
    return (mixed[0] / length, mixed[1] / length, mixed[2] / length, mixed[3] / length)
