"""Inverse kinematics of an arm on rails: positions of the rails are sampled, the arm is exact."""

from __future__ import annotations

import itertools

import numpy as np

from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.backends.kinematic_chain import BASE, Array, KinematicChain
from sitewright.planning_twin.backends.opw_solver import OpwSolver
from sitewright.planning_twin.backends.solver import OUTSIDE_LIMITS, nearest
from sitewright.planning_twin.backends.whole_turns import wrapped
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Joints

_SPACING_M = 0.35
_MOST_POSITIONS = 48
"""Of all rails together; a gantry of three gets a coarser grid. One rail alone keeps its spacing:
only the positions from which a pose is within reach are looked at.
"""
_FINER = 5
"""Steps of the finer grid between two positions of the coarse one."""
_REFINED = 3
"""So many positions, those that come nearest to the pose, are looked at more finely."""
_RIGHT = 1e-9
_RESERVE_M = 1e-6


def rails_before(chain: KinematicChain) -> int:
    """Return how many joints slide before the first one that turns."""
    return int(np.argmin(chain.is_prismatic)) if not chain.is_prismatic.all() else chain.joints


def arm_behind(chain: KinematicChain, rails: int) -> KinematicChain:
    """Return the arm alone; its base is the carriage of the last rail."""
    return KinematicChain(
        carrier_T_joint=chain.carrier_T_joint[rails:],
        axes=chain.axes[rails:],
        spins=chain.spins[rails:],
        is_prismatic=chain.is_prismatic[rails:],
        lower=chain.lower[rails:],
        upper=chain.upper[rails:],
        carrier_by_link={
            link: (joint - rails, joint_T_link)
            for link, (joint, joint_T_link) in chain.carrier_by_link.items()
            if joint - rails >= BASE
        },
        tip=chain.tip,
    )


class RailSolver:
    """Every branch of the arm at a grid of rail positions; where none serves, at a finer one.

    Only distance proves a pose unreachable: too far from everywhere that the rails lead to.
    """

    def __init__(self, chain: KinematicChain, arm: OpwSolver, rails: int) -> None:
        self.chain, self.arm, self._rails = chain, arm, rails
        frames = chain.frames(np.zeros((1, chain.joints)))[0, :rails]
        self._base_T_carriage = frames[-1]
        self._ways = np.einsum("nij,nj->ni", frames[:, :3, :3], chain.axes[:rails])
        self._lowest, self._highest = chain.lower[:rails], chain.upper[:rails]
        self._coarse, self._spacing_m = _grid(self._lowest, self._highest, _MOST_POSITIONS)
        self._grid = self._coarse
        if rails == 1:
            self._grid, self._spacing_m = _grid(self._lowest, self._highest, None)

    def tip(self, q: Joints) -> Array:
        """Return base_T_tip."""
        base_T_carriage = self._carriages(np.array([q[: self._rails]]))[0]
        return np.asarray(base_T_carriage @ self.arm.tip(q[self._rails :]))

    def postures(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return the postures at the rail positions that were looked at, `near`'s among them."""
        here = np.clip(near[: self._rails], self._lowest, self._highest)
        positions = np.concatenate((here[None], self._within_reach(base_T_tip)))
        found, extension_m = self._at(positions, base_T_tip)
        tried = len(positions)
        if not len(found):
            finer = self._finer(positions[np.argsort(-extension_m, kind="stable")[:_REFINED]])
            found, _ = self._at(finer, base_T_tip)
            tried += len(finer)
        if len(found):
            return found
        beyond_m = self.beyond_m(base_T_tip)
        if beyond_m > 0.0:
            reason = Sentence("the tip pose is out of reach from everywhere on the rails")
            return NoIk(is_proven=True, extension_m=beyond_m, reason=reason)
        is_near = bool((extension_m >= 0.0).any())
        reason = OUTSIDE_LIMITS if is_near else Sentence("the tip pose is out of reach")
        return NoIk(
            is_proven=False,
            tried=tried,
            reason=Sentence("{what} at {tried} positions of the rails", what=reason, tried=tried),
        )

    def next(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return the posture nearest to another one, with the rails where that has them."""
        found, _ = self._at(near[None, : self._rails], base_T_tip)
        if len(found):
            return np.asarray(nearest(found, near)[0])
        return NoIk(is_proven=False, tried=1, reason=Sentence("no posture with the rails at rest"))

    def _at(self, positions: Array, base_T_tip: Array) -> tuple[Array, Array]:
        """Return all postures inside the limits, and how far each position is within reach."""
        branches = self.arm.branches(np.linalg.inv(self._carriages(positions)) @ base_T_tip)
        rows = [
            np.hstack((np.tile(rail, (len(b.postures), 1)), b.postures))
            for rail, b in zip(positions, branches, strict=True)
        ]
        chain = self.chain
        inside = wrapped(np.concatenate(rows), chain.lower, chain.upper, chain.is_prismatic)
        return inside, np.array([b.extension_m for b in branches])

    def _within_reach(self, base_T_tip: Array) -> Array:
        """Return the positions of the grid from which a pose may be reached, else the nearest."""
        frames = self._carriages(self._grid)
        shoulders_m = frames[:, :3, 3] + frames[0, :3, :3] @ self.arm.shoulder_m
        away_m = np.linalg.norm(self.arm.wrist_m(base_T_tip) - shoulders_m, axis=1)
        near = away_m <= max(self.arm.reach_m + _RESERVE_M, float(np.sort(away_m)[:_REFINED][-1]))
        return np.asarray(self._grid[near])

    def _carriages(self, positions: Array) -> Array:
        """Return base_T_carriage at rail positions; rails shift, they never turn."""
        out = np.tile(self._base_T_carriage, (len(positions), 1, 1))
        out[:, :3, 3] += positions @ self._ways
        return out

    def in_carriages(self, base_T_tips: Array) -> tuple[Array, Array]:
        """Return the grid's positions of the rails, and each pose seen from each carriage.

        Args:
            base_T_tips: m x 4 x 4.

        Returns:
            r x rails, and m x r x 4 x 4.
        """
        carriage_T_base = np.linalg.inv(self._carriages(self._coarse))
        return self._coarse, np.asarray(carriage_T_base[None] @ base_T_tips[:, None])

    def corners(self) -> Array:
        """Return base_T_carriage at all ends of the rails, m x 4 x 4."""
        ends = itertools.product(*zip(self._lowest, self._highest, strict=True))
        return self._carriages(np.array(list(ends)))

    def _finer(self, positions: Array) -> Array:
        """Return positions between the grid's, along each rail, around the given ones."""
        shares = np.linspace(-1.0, 1.0, 2 * _FINER + 1)
        shifts = (shares[:, None, None] * np.diag(self._spacing_m)).reshape(-1, self._rails)
        near = (positions[:, None] + shifts).reshape(-1, self._rails)
        return np.unique(np.clip(near, self._lowest, self._highest), axis=0)

    def beyond_m(self, base_T_tip: Array) -> float:
        """Return how far a pose is out of reach from everywhere on the rails; 0 if it is not.

        The shoulder moves in a box that the rails span, the ball around it if they are not at
        right angles; nothing but distance is looked at.
        """
        half = (self._highest - self._lowest) / 2.0
        middle = self._carriages((self._lowest + half)[None])[0]
        shoulder = middle[:3, :3] @ self.arm.shoulder_m + middle[:3, 3]
        away = self.arm.wrist_m(base_T_tip) - shoulder
        skew = float(np.abs(self._ways @ self._ways.T - np.eye(self._rails)).max())
        if skew < _RIGHT:
            along = np.clip(self._ways @ away, -half, half)
            distance_m = float(np.linalg.norm(away - along @ self._ways))
        else:
            distance_m = float(np.linalg.norm(away) - half.sum())
        return max(0.0, distance_m - self.arm.reach_m - _RESERVE_M)


def _grid(lower: Array, upper: Array, most: int | None) -> tuple[Array, Array]:
    """Return evenly spread positions of all rails, ends included, and the spacing of each rail."""
    wanted = np.maximum(2, np.ceil((upper - lower) / _SPACING_M).astype(int) + 1)
    while most is not None and wanted.prod() > most:
        wanted[wanted.argmax()] -= 1
    axes = [np.linspace(a, b, n) for a, b, n in zip(lower, upper, wanted, strict=True)]
    return np.array(list(itertools.product(*axes))), (upper - lower) / (wanted - 1)
