"""Inverse kinematics by iteration, for arms without a closed form."""

from __future__ import annotations

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array, KinematicChain, distinct
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Joints

_STARTS = 48
_ITERATIONS = 120
_DAMPING = 1e-3
_LARGEST_STEP_RAD = 0.5
_SOLVED = 1e-10
_SEED = 0


class NumericSolver:
    """Damped least squares from seeded starts; what it does not find may exist all the same."""

    def __init__(self, chain: KinematicChain) -> None:
        self.chain = chain

    def tip(self, q_rad: Joints) -> Array:
        """Return base_T_tip of a posture."""
        return np.asarray(self.chain.tips(np.array([q_rad], dtype=np.float64))[0])

    def branches(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return the postures that the starts lead to, the one from `near` among them."""
        chain = self.chain
        rng = np.random.default_rng(_SEED)
        q = rng.uniform(chain.lower, chain.upper, (_STARTS, chain.joints))
        q[0] = near
        for _ in range(_ITERATIONS):
            frames = chain.frames(q)
            error = _error(self._tips(frames), base_T_tip)
            if (np.abs(error).max(axis=1) < _SOLVED).all():
                break
            q = np.clip(q + _step(self._jacobian(frames), error), chain.lower, chain.upper)
        error = _error(chain.tips(q), base_T_tip)
        found = distinct(q[np.abs(error).max(axis=1) < _SOLVED])
        if len(found):
            return found
        return NoIk(
            is_proven=False, tried=_STARTS, reason=f"none of {_STARTS} starts led to the tip pose"
        )

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
    square = jacobian @ transposed + weight * np.eye(6) + 1e-12 * np.eye(6)
    step = (transposed @ np.linalg.solve(square, error[..., None]))[..., 0]
    largest = np.abs(step).max(axis=1, keepdims=True)
    return np.asarray(step * np.minimum(1.0, _LARGEST_STEP_RAD / np.maximum(largest, 1e-12)))
