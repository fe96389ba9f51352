"""All postures of an arm with a spherical wrist, found without the planner's code.

The arm is taken as screws: axes and points on them at zero, read off its joint frames. The centre
of the wrist gives the first three joints (one turn, then a triangle), the direction of the last
axis the next two, what is left the last one. Each answer is held against the product of the joint
frames; it is written for arms whose second and third axis are parallel.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from independent_reach import Array, matrix, turn
from sitewright.robot_team.description import Description, Joint, JointKind

_EXACT = 1e-6
_STRAIGHT = 1e-4
_TURN = 2.0 * math.pi


class MorePosturesError(Exception):
    """Joints share a turn freely, or an axis does not fit: the list would not be complete."""


def link_frames(description: Description, values: dict[str, float]) -> dict[str, Array]:
    """Return root_T_link of every link; joints that are not named stand at zero."""
    frames = {description.root: np.eye(4)}
    for joint in description.joints:
        frames[joint.child] = (
            frames[joint.parent]
            @ matrix(joint.parent_T_joint)
            @ _moved(joint, values.get(joint.name, 0.0))
        )
    return frames


def _moved(joint: Joint, value: float) -> Array:
    if joint.kind is JointKind.FIXED:
        return np.eye(4)
    if joint.kind is JointKind.REVOLUTE:
        return turn(joint.axis, value)
    out = np.eye(4)
    out[:3, 3] = value * np.array(joint.axis)
    return out


@dataclass(frozen=True, slots=True)
class ScrewArm:
    """Six axes at zero: directions and points, 6 x 3 each, in the frame of the base."""

    description: Description
    directions: Array
    points: Array
    base_T_tip: Array
    wrist: Array

    @classmethod
    def of(cls, description: Description) -> ScrewArm:
        """Read the axes off an arm; one that this is not written for is refused."""
        frames, joints = link_frames(description, {}), description.movable_joints
        if len(joints) != 6:
            raise MorePosturesError(description.name)
        w = np.array([frames[j.child][:3, :3] @ np.array(j.axis) for j in joints])
        w /= np.linalg.norm(w, axis=1, keepdims=True)
        o = np.array([frames[j.child][:3, 3] for j in joints])
        across = [np.eye(3) - np.outer(d, d) for d in w[3:]]
        wrist = np.linalg.solve(sum(across), sum(p @ q for p, q in zip(across, o[3:], strict=True)))
        away = max(
            float(np.linalg.norm(p @ (wrist - q))) for p, q in zip(across, o[3:], strict=True)
        )
        if away > _EXACT or np.linalg.norm(np.cross(w[1], w[2])) > _EXACT:
            raise MorePosturesError(f"{description.name} has no such axes")
        return cls(description, w, o, frames[description.tip], wrist)

    def postures(self, base_T_tip: Array) -> list[Array]:
        """Return every posture within the limits, one of each set that whole turns make."""
        moved = base_T_tip @ np.linalg.inv(self.base_T_tip)
        found: list[Array] = []
        for first_three in self._arm((moved @ np.append(self.wrist, 1.0))[:3]):
            rest = np.linalg.inv(self._product(first_three)) @ moved
            for last_three in self._wrist(np.asarray(rest[:3, :3], dtype=np.float64)):
                q = self._within(np.array((*first_three, *last_three)))
                if q is not None and all(_differ(q, other) for other in found):
                    found.append(q)
        for q in found:
            names = (j.name for j in self.description.movable_joints)
            frames = link_frames(self.description, dict(zip(names, q.tolist(), strict=True)))
            assert np.abs(frames[self.description.tip] - base_T_tip).max() < _EXACT
        return found

    def _arm(self, p: Array) -> Iterator[tuple[float, float, float]]:
        """Yield the first three joints that bring the centre of the wrist to a point."""
        w, o, c = self.directions, self.points, self.wrist
        r = p - o[0]
        along = w[0] * (w[0] @ r)
        for q1 in _angles(
            w[1] @ (r - along), -(w[1] @ np.cross(w[0], r)), w[1] @ (c - o[0] - along)
        ):
            unturned = o[0] + turn(tuple(w[0]), -q1)[:3, :3] @ r
            wanted, u, v = (_across(w[1], x) for x in (unturned - o[1], o[2] - o[1], c - o[2]))
            lack = (wanted @ wanted - u @ u - v @ v) / 2.0
            for q3 in _angles(u @ v, u @ np.cross(w[2], v), lack):
                there = u + turn(tuple(w[2]), q3)[:3, :3] @ v
                yield q1, _angle_about(w[1], there, wanted), q3

    def _wrist(self, rest: Array) -> Iterator[tuple[float, float, float]]:
        """Yield the last three joints that make a rotation."""
        w4, w5, w6 = self.directions[3:]
        aim = rest @ w6
        skew = (w5 @ w6) * (w5 @ w4)
        for q5 in _angles(w4 @ w6 - skew, w4 @ np.cross(w5, w6), w4 @ aim - skew):
            bent = turn(tuple(w5), q5)[:3, :3]
            if np.linalg.norm(_across(w4, bent @ w6)) < _STRAIGHT:
                raise MorePosturesError("the wrist is straight")
            q4 = _angle_about(w4, bent @ w6, aim)
            left = bent.T @ turn(tuple(w4), -q4)[:3, :3] @ rest
            yield q4, q5, _angle_about(w6, w5, left @ w5)

    def _product(self, values: tuple[float, ...]) -> Array:
        out = np.eye(4)
        for k, value in enumerate(values):
            step = turn(tuple(self.directions[k]), value)
            step[:3, 3] = self.points[k] - step[:3, :3] @ self.points[k]
            out = out @ step
        return out

    def _within(self, q: Array) -> Array | None:
        joints = self.description.movable_joints
        low = np.array([j.lower_rad for j in joints])
        high = np.array([j.upper_rad for j in joints])
        lifted = q + _TURN * np.ceil((low - 1e-9 - q) / _TURN)
        return lifted if (lifted <= high + 1e-9).all() else None


def _angles(a: Array, b: Array, c: Array) -> tuple[float, ...]:
    """Return the angles with a cos + b sin = c; all are numbers."""
    size = math.hypot(a, b)
    if size < _EXACT:
        raise MorePosturesError("a joint turns freely")
    if abs(c) > size:
        return ()
    middle, half = math.atan2(b, a), math.acos(c / size)
    return (middle - half, middle + half)


def _across(axis: Array, vector: Array) -> Array:
    return np.asarray(vector - axis * (axis @ vector))


def _angle_about(axis: Array, start: Array, end: Array) -> float:
    a, b = _across(axis, start), _across(axis, end)
    return math.atan2(float(axis @ np.cross(a, b)), float(a @ b))


def _differ(q: Array, other: Array) -> bool:
    off = (q - other + math.pi) % _TURN - math.pi
    return bool(np.abs(off).max() > _STRAIGHT)
