"""Inverse kinematics of many tip poses at once: all postures, and what is proven where none is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import TURN, Array, KinematicChain
from sitewright.planning_twin.backends.opw_solver import OpwSolver
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.rail_solver import RailSolver
from sitewright.planning_twin.backends.solver import Solver
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.refusal import NoIk

_LIMIT_SLACK = 1e-9
_RESERVE_M = 1e-6
_SAME_BRANCH_RAD = 1.2
"""A joint turns no further than this from a contact to its pre-pose, unless it is near a
singular posture or on another branch."""
_SAME_RAIL_M = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Postures:
    """Postures for a batch of tip poses.

    Attributes:
        q: k x n, one posture inside the limits per row; whole turns of it are left out.
        pose: Number of the pose that each row is for.
        beyond_m: For each pose, how far it is out of reach; 0 if it is not, or nobody knows.
        is_never: For each pose, whether it is proven that it has no posture.
    """

    q: Array
    pose: Indices
    beyond_m: Array
    is_never: Flags

    def only(self, rows: Flags | Indices) -> Postures:
        """Return some of the postures."""
        return Postures(self.q[rows], self.pose[rows], self.beyond_m, self.is_never)

    def has(self) -> Flags:
        """Return which poses have a posture."""
        out = np.zeros(len(self.is_never), dtype=np.bool_)
        out[self.pose] = True
        return out


class ArmPoses:
    """Tip poses of one arm, in the frame of its base."""

    def __init__(self, solver: Solver) -> None:
        self._solver = solver

    @property
    def chain(self) -> KinematicChain:
        """The arm."""
        return self._solver.chain

    def postures(self, base_T_tips: Array, near: Array) -> Postures:
        """Return the postures of poses, m x 4 x 4.

        Args:
            base_T_tips: The poses.
            near: A posture; arms with more joints than a pose needs look for postures near it.
        """
        match self._solver:
            case OpwSolver():
                return _closed_form(self._solver, base_T_tips)
            case RailSolver():
                return _on_rails(self._solver, base_T_tips)
            case _:
                return _one_by_one(self._solver, base_T_tips, near)

    def quick(self, base_T_tips: Array) -> Postures:
        """Return postures for a guess: some may be missed, and nothing is proven.

        Of an arm without a closed form, whatever is not too far counts as reached.
        """
        match self._solver:
            case OpwSolver():
                return _quickly(self._solver, base_T_tips)
            case RailSolver():
                return _on_rails(self._solver, base_T_tips)
            case _:
                return _within_ball(self._solver, base_T_tips)

    def following(self, base_T_tips: Array, near: Postures) -> tuple[Array, Flags]:
        """Return, for each row of postures, the one for another pose that is nearest to it.

        Args:
            base_T_tips: A pose a short way on from each of those that `near` is for.
            near: Postures; rails stay where they are.

        Returns:
            k x n, and which rows have such a posture without a change of branch.
        """
        if not isinstance(self._solver, OpwSolver | RailSolver):
            return _followed(self._solver, base_T_tips, near)
        poses, pose_of_row = np.unique(near.pose, return_inverse=True)
        found = self.postures(base_T_tips[poses], near.q)
        if not len(found.q) or not len(near.q):
            return near.q, np.zeros(len(near.q), dtype=np.bool_)
        apart = near.q[:, None] - found.q[None]
        slides = self.chain.is_prismatic
        turns = np.where(slides, 0.0, TURN * np.round(apart / TURN))
        far = np.abs(apart - turns).max(axis=2)
        is_other = (pose_of_row[:, None] != found.pose[None]) | (
            np.abs(apart[..., slides]) > _SAME_RAIL_M
        ).any(axis=2)
        far[is_other] = np.inf
        best = far.argmin(axis=1)
        is_near = far[np.arange(len(best)), best] < _SAME_BRANCH_RAD
        return found.q[best], np.asarray(is_near)


def shoulder_ball(solver: Solver) -> tuple[Array, float]:
    """Return points of the shoulder in the base, and how far the wrist can be from them.

    On rails the points are the corners of where these lead. Of an arm without a closed form they
    are its first joint, and the length of all of it.
    """
    match solver:
        case OpwSolver():
            return solver.shoulder_m[None], solver.reach_m
        case RailSolver():
            carriages = solver.corners()
            return carriages[:, :3, :3] @ solver.arm.shoulder_m + carriages[
                :, :3, 3
            ], solver.arm.reach_m
        case _:
            offsets = solver.chain.carrier_T_joint[:, :3, 3]
            length_m = float(np.linalg.norm(offsets[1:], axis=1).sum())
            return offsets[:1], length_m


def _closed_form(solver: OpwSolver, base_T_tips: Array) -> Postures:
    """Return all branches; where the arm is too short, nothing is solved."""
    beyond_m = solver.too_far_m(base_T_tips)
    near = np.flatnonzero(beyond_m <= _RESERVE_M)
    found = _branches(solver, base_T_tips[near])
    beyond_m[near] = found.beyond_m
    is_never = np.ones(len(base_T_tips), dtype=np.bool_)
    is_never[near] = found.is_never
    return Postures(found.q, near[found.pose], beyond_m, is_never)


def _branches(solver: OpwSolver, base_T_tips: Array) -> Postures:
    """Return the branches of poses; the nudge that finds more of them only where none was found."""
    plain = _inside_limits(solver.chain, *solver.plain_slots(base_T_tips))
    left = np.flatnonzero(~plain.has())
    if not len(left):
        return plain
    more = _inside_limits(solver.chain, *solver.slots(base_T_tips[left]))
    beyond_m, is_never = plain.beyond_m.copy(), np.zeros(len(base_T_tips), dtype=np.bool_)
    beyond_m[left], is_never[left] = more.beyond_m, more.is_never
    q, pose = np.concatenate((plain.q, more.q)), np.append(plain.pose, left[more.pose])
    return Postures(q, pose, beyond_m, is_never)


def _quickly(solver: OpwSolver, base_T_tips: Array) -> Postures:
    beyond_m = solver.too_far_m(base_T_tips)
    near = np.flatnonzero(beyond_m <= _RESERVE_M)
    found = _inside_limits(solver.chain, *solver.plain_slots(base_T_tips[near]))
    beyond_m[near] = found.beyond_m
    return Postures(found.q, near[found.pose], beyond_m, np.zeros(len(base_T_tips), dtype=np.bool_))


def _within_ball(solver: Solver, base_T_tips: Array) -> Postures:
    centres, radius_m = shoulder_ball(solver)
    away_m = np.linalg.norm(base_T_tips[:, :3, 3] - centres[0], axis=1)
    beyond_m = np.maximum(0.0, away_m - radius_m)
    near = np.flatnonzero(beyond_m == 0.0)
    q = np.zeros((len(near), solver.chain.joints))
    return Postures(q, near, beyond_m, np.zeros(len(base_T_tips), dtype=np.bool_))


def _inside_limits(
    chain: KinematicChain, slots: Array, extension_m: Array, is_singular: Flags
) -> Postures:
    is_branch = np.asarray(np.isfinite(slots).all(axis=2), dtype=np.bool_)
    pose, _ = np.nonzero(is_branch)
    q, is_inside = _inside(chain, slots[is_branch])
    is_found = np.zeros(len(slots), dtype=np.bool_)
    is_found[pose[is_inside]] = True
    is_any = np.asarray(is_branch.any(axis=1))
    is_never = ~is_found & np.where(is_any, ~is_singular, extension_m < 0.0)
    beyond_m = np.where(is_any, 0.0, np.maximum(0.0, -extension_m))
    return Postures(q[is_inside], pose[is_inside], beyond_m, is_never)


def _on_rails(solver: RailSolver, base_T_tips: Array) -> Postures:
    """Return the postures at the coarse grid of rail positions; only distance proves a no."""
    rails, in_carriage = solver.in_carriages(base_T_tips)
    found = _closed_form(solver.arm, in_carriage.reshape(-1, 4, 4))
    pose, rail = np.divmod(found.pose, len(rails))
    q, is_inside = _inside(solver.chain, np.hstack((rails[rail], found.q)))
    beyond_m = np.array([solver.beyond_m(tip) for tip in base_T_tips])
    return Postures(q[is_inside], pose[is_inside], beyond_m, beyond_m > 0.0)


def _one_by_one(solver: Solver, base_T_tips: Array, near: Array) -> Postures:
    rows: list[Array] = [np.zeros((0, solver.chain.joints))]
    pose: list[int] = []
    beyond_m = np.zeros(len(base_T_tips))
    is_never = np.zeros(len(base_T_tips), dtype=np.bool_)
    for k, base_T_tip in enumerate(base_T_tips):
        found = solver.postures(base_T_tip, near)
        if isinstance(found, NoIk):
            beyond_m[k], is_never[k] = found.extension_m, found.is_proven
            continue
        rows.append(found)
        pose += [k] * len(found)
    return Postures(np.concatenate(rows), np.array(pose, dtype=np.intp), beyond_m, is_never)


def _followed(solver: Solver, base_T_tips: Array, near: Postures) -> tuple[Array, Flags]:
    q, is_near = near.q.copy(), np.zeros(len(near.q), dtype=np.bool_)
    for k, pose in enumerate(near.pose.tolist()):
        found = solver.next(base_T_tips[pose], near.q[k])
        if not isinstance(found, NoIk) and np.abs(found - near.q[k]).max() < _SAME_BRANCH_RAD:
            q[k], is_near[k] = found, True
    return q, is_near


def _inside(chain: KinematicChain, q: Array) -> tuple[Array, Flags]:
    """Return postures with each joint at its lowest turn, and which are inside the limits."""
    turns = np.ceil((chain.lower - _LIMIT_SLACK - q) / TURN)
    lowest = q + np.where(chain.is_prismatic, 0.0, TURN * turns)
    is_above = lowest >= chain.lower - _LIMIT_SLACK
    is_inside = (is_above & (lowest <= chain.upper + _LIMIT_SLACK)).all(axis=1)
    return np.clip(lowest, chain.lower, chain.upper), np.asarray(is_inside)
