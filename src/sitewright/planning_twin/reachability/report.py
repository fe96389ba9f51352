"""A reach check from question to verdicts, as one value for those who show it."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.planning_twin.reachability.answer import ReachAnswer
from sitewright.planning_twin.reachability.question import ReachQuestion
from sitewright.planning_twin.reachability.verdict import Standing, TargetVerdict, share_of


@dataclass(frozen=True, slots=True, kw_only=True)
class ReachReport:
    """What was asked, what was found, and what it means.

    Attributes:
        verdicts: In construction order.
        notes: What else keeps robots from moving: home and parking postures that are not clear.
        seconds: What it took, opening the project aside.
    """

    question: ReachQuestion
    answer: ReachAnswer
    verdicts: tuple[TargetVerdict, ...]
    notes: tuple[str, ...] = ()
    seconds: float = 0.0

    @property
    def share(self) -> float:
        """Share of the targets that can be built, 0..1."""
        return share_of(self.verdicts)

    def count(self, standing: Standing) -> int:
        """Return how many targets stand so."""
        return sum(v.standing is standing for v in self.verdicts)
