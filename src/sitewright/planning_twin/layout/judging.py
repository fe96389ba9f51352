"""How good an arrangement is: a quick guess for many, and the reach check for the few left."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from sitewright.foundation.pose import Vector
from sitewright.planning_twin.layout.movables import Arrangement
from sitewright.planning_twin.reachability.report import ReachReport

_PARTLY, _HOME = 0.1, 1.0
"""What a reached end of something that cannot be built counts; what a blocked home costs."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Judgement:
    """What the reach check says of an arrangement.

    Attributes:
        reached: Share of all ends and operations that some robot reaches, 0..1.
        blocked: Robots whose home posture is too near to something.
        missing_m: Where targets and operations are that nobody reaches.
    """

    arrangement: Arrangement
    report: ReachReport
    reached: float
    blocked: tuple[str, ...] = ()
    missing_m: tuple[Vector, ...] = ()

    @property
    def value(self) -> float:
        """What is buildable counts first; a robot that cannot leave its home undoes it all."""
        return self.report.share + _PARTLY * self.reached - _HOME * bool(self.blocked)

    @property
    def is_perfect(self) -> bool:
        """Whether there is nothing to gain."""
        return self.report.share == 1.0 and not self.blocked


class LayoutJudge(Protocol):
    """Judges arrangements; the same one is always judged alike."""

    def guess(self, arrangement: Arrangement) -> float:
        """Return about how much can be reached, 0..1, by inverse kinematics only."""
        ...

    def judge(self, arrangement: Arrangement) -> Judgement:
        """Return what the reach check says."""
        ...
