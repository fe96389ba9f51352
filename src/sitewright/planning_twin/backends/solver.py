"""What every way to solve an arm's inverse kinematics offers, in arrays."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.backends.kinematic_chain import Array, KinematicChain
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Joints

OUTSIDE_LIMITS = Sentence("every posture for the tip pose is outside the joint limits")


class Solver(Protocol):
    """Inverse kinematics of one arm."""

    @property
    def chain(self) -> KinematicChain:
        """The arm that it solves."""
        ...

    def tip(self, q: Joints) -> Array:
        """Return base_T_tip of a posture."""
        ...

    def postures(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return postures inside the limits, whole turns included, one per row."""
        ...

    def next(self, base_T_tip: Array, near: Array) -> Array | NoIk:
        """Return the posture for a pose a short way from that of `near`; rails stay where they are.

        The answer can be far away where the arm has to change its branch.
        """
        ...


def nearest(postures: Array, near: Array) -> Array:
    """Return the postures in order of their distance; a metre counts as a radian."""
    order = np.argsort(np.linalg.norm(postures - near, axis=1), kind="stable")
    return np.asarray(postures[order])
