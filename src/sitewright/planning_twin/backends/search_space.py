"""The joints that a search moves, in a padded scene: free postures, free lines, straight tips."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.search_scene import SearchScene
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.description import Joints

_TIP_STEP_M = 0.02
"""Along so much of a straight line of the tip, a line in joint space strays by under 0.1 mm."""
_DAMPED = 1e-4**2 * np.eye(6)
_FASTEST_TURN_RAD = 0.12
"""A joint that would turn further on one step is near a singular posture."""


Bounds = tuple[Joints, Joints]
"""Lowest and highest position of each joint of a robot."""


class SearchSpace:
    """Some robots' joints, one robot after the other; all other joints stand still.

    Attributes:
        lower, upper: Limits.
        weights: How much a turn of each joint counts in distances: the time that it takes,
            compared with the slowest joint.
        lines: How many lines were looked at so far.
    """

    def __init__(
        self,
        search: SearchScene,
        scene: SceneSnapshot,
        bounds: Mapping[RobotId, Bounds],
        step_rad: float,
    ) -> None:
        """Look at some robots in a scene.

        Args:
            search: The padded scene.
            scene: Where all others stand.
            bounds: Who moves, and how far each joint may go.
            step_rad: Between two postures that are looked at on a line.
        """
        robots = tuple(bounds)
        self._search = search
        self._step_rad = step_rad
        self._full = search.posture({})
        self._columns = np.concatenate([search.columns_of(r) for r in robots])
        self._robots = robots
        self._counts = [len(search.columns_of(r)) for r in robots]
        joints = [j for r in robots for j in scene.robots[r].description.movable_joints]
        self.lower = np.array([v for low, _ in bounds.values() for v in low])
        self.upper = np.array([v for _, high in bounds.values() for v in high])
        speed = np.array([j.velocity_rad_s or 1.0 for j in joints])
        self._speed = speed
        self.weights = speed.min() / speed
        self.lines = 0

    def is_free(self, q: Array) -> bool:
        """Tell whether a posture is inside the limits and touches nothing."""
        return self._is_inside(q) and not self._search.is_hit(self._posture(q))

    def is_free_line(self, a: Array, b: Array) -> bool:
        """Tell whether no sample of a line touches anything; `a` is known to be free."""
        self.lines += 1
        if not self._is_inside(b):
            return False
        return not self._search.is_hit_between(self._posture(a), self._posture(b), self._step_rad)

    def distances(self, points: Array, q: Array) -> Array:
        """Return how far some postures are from another one, squared."""
        difference = (points - q) * self.weights
        return np.asarray(np.einsum("ij,ij->i", difference, difference))

    def distance(self, a: Array, b: Array) -> float:
        """Return how far two postures are apart."""
        return float(np.linalg.norm((a - b) * self.weights))

    def duration_s(self, a: Array, b: Array) -> float:
        """Return how long a line takes at full speed."""
        return float((np.abs(b - a) / self._speed).max())

    @property
    def tips(self) -> range:
        """Numbers of the robots that move."""
        return range(len(self._robots))

    def joints_of(self, tip: int) -> slice:
        """Return which joints move a robot's tip."""
        first = sum(self._counts[:tip])
        return slice(first, first + self._counts[tip])

    def tip_axes(self, tip: int, q: Array) -> Array:
        """Return the axes of a robot's tip frame in the world, row by row."""
        return np.asarray(self._search.tip(self._robots[tip], self._posture(q))[:3, :3].T)

    def straight(self, tip: int, q: Array, direction: Array, length_m: float) -> Iterator[Array]:
        """Yield free postures along a straight line of one robot's tip, until something is hit.

        Each step is right to the second order: the first one by the midpoint rule, the others by
        what the rates were here and one step before.

        Args:
            tip: Number of the robot.
            q: Where it starts; not yielded.
            direction: Shift in the world, of length one; the tip does not turn.
            length_m: At most so far.
        """
        shift = np.concatenate((direction * _TIP_STEP_M, np.zeros(3)))
        before: Array | None = None
        for _ in range(round(length_m / _TIP_STEP_M)):
            here = self._rates(tip, q, shift)
            if before is None:
                step = self._rates(tip, q + here / 2.0, shift)
            else:
                step = 1.5 * here - 0.5 * before
            following = q + step
            if np.abs(step).max() > _FASTEST_TURN_RAD or not self.is_free_line(q, following):
                return
            yield following
            q, before = following, here

    def _rates(self, tip: int, q: Array, shift: Array) -> Array:
        """Return how far the joints turn for a small shift of a tip, 3 along and 3 about axes."""
        mine = self.joints_of(tip)
        rows = self._search.tip_rates(self._robots[tip], self._posture(q))
        square = rows @ rows.T + _DAMPED
        rates = np.zeros_like(q)
        rates[mine] = rows.T @ np.linalg.solve(square, shift)
        return rates

    def _is_inside(self, q: Array) -> bool:
        return not bool(((q < self.lower) | (q > self.upper)).any())

    def _posture(self, q: Array) -> Array:
        full = self._full.copy()
        full[self._columns] = q
        return full
