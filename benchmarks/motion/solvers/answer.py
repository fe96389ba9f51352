"""What a solver says to a query."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from benchmarks.motion.query import MotionQuery

from sitewright.robot_team.description import Joints

BUDGET_S = 2.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """A path or none.

    Attributes:
        waypoints_rad: Empty if nothing was found. Where there are two paths, shortened and as
            found, the shortened one.
        otherwise_rad: The path as it was found, in case the proof refuses the shortened one.
        spent_s: CPU time, set-up of the scene included.
        reason: Why nothing was found.
    """

    waypoints_rad: tuple[Joints, ...] = ()
    otherwise_rad: tuple[Joints, ...] = ()
    spent_s: float
    reason: str = ""


class Solver(Protocol):
    """Answers queries; the witnesses are out of its sight."""

    @property
    def name(self) -> str:
        """Name for tables."""
        ...

    def solve(self, query: MotionQuery, seed: int) -> Answer:
        """Return an answer within the budget."""
        ...


def joints(values: list[float]) -> Joints:
    """Return plain numbers as a posture."""
    return tuple(float(v) for v in values)
