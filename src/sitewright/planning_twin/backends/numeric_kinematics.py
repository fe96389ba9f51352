"""Inverse kinematics by iteration, for arms without a closed form."""

from __future__ import annotations

import numpy as np

from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.backends.kinematic_chain import Array, KinematicChain
from sitewright.planning_twin.backends.solver import OUTSIDE_LIMITS, nearest
from sitewright.planning_twin.backends.whole_turns import distinct, wrapped
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Joints

_STARTS = 96
_ITERATIONS = 60
_STEPS_ON = 25
_DAMPING = 1e-3
_LARGEST_STEP = 0.5
_SOLVED = 1e-10
_POSE = 6
_SEED = 0


class NumericSolver:
    """Damped least squares from seeded starts; what it does not find may exist all the same.

    An arm with six joints or fewer is free to leave its limits on the way: what it finds outside
    is turned back by whole turns or dropped. One with more joints than a pose needs is kept
    inside, since it has other ways to get there.
    """

    def __init__(self, chain: KinematicChain) -> None:
        self.chain = chain
        is_free = ~chain.is_prismatic & (chain.joints <= _POSE)
        self._lower = np.where(is_free, -np.inf, chain.lower)
        self._upper = np.where(is_free, np.inf, chain.upper)

    def tip(self, q: Joints) -> Array:
        """Return base_T_tip of a posture."""
        return np.asarray(self.chain.tips(np.array([q], dtype=np.float64))[0])

    def postures(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return the postures that the starts lead to, the one from `near` among them."""
        chain = self.chain
        if not np.isfinite(base_T_tip).all():
            return NoIk(is_proven=False, reason=Sentence("the tip pose is not a number"))
        found = distinct(
            self._iterated(self._starts(near), base_T_tip, _ITERATIONS), chain.is_prismatic
        )
        if not len(found):
            return NoIk(
                is_proven=False,
                tried=_STARTS,
                reason=Sentence("none of {starts} starts led to the tip pose", starts=_STARTS),
            )
        allowed = wrapped(found, chain.lower, chain.upper, chain.is_prismatic)
        if len(allowed):
            return allowed
        return NoIk(is_proven=False, tried=len(found), reason=OUTSIDE_LIMITS)

    def next(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return where the iteration leads to from one posture, or else the nearest of all."""
        chain = self.chain
        found = self._iterated(near[None], base_T_tip, _STEPS_ON)
        if len(found) and ((found >= chain.lower) & (found <= chain.upper)).all():
            return np.asarray(found[0])
        others = self.postures(base_T_tip, near)
        return others if isinstance(others, NoIk) else nearest(others, near)[0]

    def _starts(self, near: Array) -> Array:
        chain = self.chain
        lower = np.where(chain.is_prismatic, chain.lower, np.maximum(chain.lower, -np.pi))
        upper = np.where(chain.is_prismatic, chain.upper, np.minimum(chain.upper, np.pi))
        lower, upper = (
            np.where(lower < upper, x, y) for x, y in ((lower, chain.lower), (upper, chain.upper))
        )
        q = np.random.default_rng(_SEED).uniform(lower, upper, (_STARTS, chain.joints))
        q[0] = near
        return q

    def _iterated(self, q: Array, base_T_tip: Array, iterations: int) -> Array:
        """Return the postures that solve the pose, of those that the starts lead to."""
        solved: list[Array] = []
        for _ in range(iterations):
            frames = self.chain.frames(q)
            error = _error(self._tips(frames), base_T_tip)
            is_open = ~(np.abs(error).max(axis=1) < _SOLVED)  # not a number stays open
            solved.append(q[~is_open])
            if not is_open.any():
                break
            q, error, frames = q[is_open], error[is_open], frames[is_open]
            q = np.clip(q + _step(self._jacobian(frames), error), self._lower, self._upper)
        return np.concatenate(solved)

    def _tips(self, frames: Array) -> Array:
        joint, joint_T_tip = self.chain.carrier_by_link[self.chain.tip]
        return np.asarray(frames[:, joint] @ joint_T_tip)

    def _jacobian(self, frames: Array) -> Array:
        """Return m x 6 x n: velocity of the tip's origin and angular velocity, in the base."""
        tips = self._tips(frames)
        joints = frames[:, :-1]
        axes = np.einsum("mnij,nj->mni", joints[..., :3, :3], self.chain.axes)
        arms = tips[:, None, :3, 3] - joints[..., :3, 3]
        slides = self.chain.is_prismatic[:, None]
        linear = np.where(slides, axes, np.cross(axes, arms))
        angular = np.where(slides, 0.0, axes)
        return np.concatenate((linear, angular), axis=2).transpose(0, 2, 1)


def _error(tips: Array, target: Array) -> Array:
    """Return m x 6: the missing shift and the missing turn as a rotation vector, in the base."""
    turn = target[:3, :3] @ tips[:, :3, :3].transpose(0, 2, 1)
    sine_axis = 0.5 * np.stack(
        (
            turn[:, 2, 1] - turn[:, 1, 2],
            turn[:, 0, 2] - turn[:, 2, 0],
            turn[:, 1, 0] - turn[:, 0, 1],
        ),
        axis=1,
    )
    sine = np.linalg.norm(sine_axis, axis=1)
    angle = np.arctan2(sine, 0.5 * (np.trace(turn, axis1=1, axis2=2) - 1.0))
    factor = np.where(sine > 1e-12, angle / np.maximum(sine, 1e-12), 1.0)  # noqa: PLR2004
    half_turn = (sine <= 1e-12) & (angle > 1.0)  # noqa: PLR2004 - any axis serves to get away
    rotation = factor[:, None] * sine_axis
    rotation[half_turn] = (np.pi, 0.0, 0.0)
    return np.concatenate((target[:3, 3] - tips[:, :3, 3], rotation), axis=1)


def _step(jacobian: Array, error: Array) -> Array:
    transposed = jacobian.transpose(0, 2, 1)
    weight = _DAMPING * np.minimum(1.0, np.linalg.norm(error, axis=1))[:, None, None]
    square = jacobian @ transposed + weight * np.eye(_POSE) + 1e-12 * np.eye(_POSE)
    step = (transposed @ np.linalg.solve(square, error[..., None]))[..., 0]
    largest = np.abs(step).max(axis=1, keepdims=True)
    return np.asarray(step * np.minimum(1.0, _LARGEST_STEP / np.maximum(largest, 1e-12)))
