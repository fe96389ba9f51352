"""Colours of the reach picture: the standing of a target, and how many ways it has."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sitewright.planning_twin.reachability.verdict import Standing, TargetVerdict

INK, SOFT, PAPER, ALARM = "#1c2733", "#5c6b7a", "#ffffff", "#c0392b"
FIXTURE, FIXTURE_EDGE, FLOOR = "#e8ecf0", "#c0c9d3", "#fafbfc"
STOCK, STOCK_EDGE, STOCK_NAME = "#f1e6cf", "#b89a62", "#7a5c1e"
ZONE, ZONE_EDGE = "#f7dcd8", "#c0392b"
ROBOT_COLOURS = ("#2f6fab", "#d9822b", "#7d5ba6", "#0f8b8d", "#a23e48", "#5c6b7a")
_FEW, _SOME = 3, 9


@dataclass(frozen=True, slots=True)
class Look:
    """How a target is drawn, and what that means."""

    fill: str
    edge: str
    words: str


NARROW = Look("#d4ecd9", "#4c9a68", "buildable, 1 to 3 kinds of grasps")
EASY = Look("#8fcba2", "#2f7d4f", "buildable, 4 to 9 kinds")
AMPLE = Look("#4fa873", "#1f5f3c", "buildable, 10 kinds or more")
TEAM = Look("#1f7a5a", "#0d3b2b", "buildable, by two robots or more")
_OTHERS: Mapping[Standing, Look] = {
    Standing.WAITING: Look("#dfe4ea", "#8b98a8", "waits for what nobody builds"),
    Standing.NOT_FOUND: Look("#f6c667", "#a86a08", "no way found (not proven)"),
    Standing.IMPOSSIBLE: Look("#e58a7f", "#a32a1c", "proven impossible"),
}
LOOKS = (NARROW, EASY, AMPLE, TEAM, *_OTHERS.values())


def look_of(verdict: TargetVerdict) -> Look:
    """Return how a target is drawn."""
    if verdict.standing is not Standing.BUILDABLE:
        return _OTHERS[verdict.standing]
    if len(verdict.robots) > 1:
        return TEAM
    if verdict.ways <= _FEW:
        return NARROW
    return EASY if verdict.ways <= _SOME else AMPLE
