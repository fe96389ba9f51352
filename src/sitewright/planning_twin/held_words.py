"""Why too few fasteners can be driven while a piece is held, in words."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.foundation.ids import OperationId, RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.refusal import HeldFreedoms
from sitewright.planning_twin.tacking import Tacking, forced_tacks, tacks_needed


def too_few_words(tacking: Tacking, never: HeldFreedoms | None) -> Sentence:
    """Return how many of the fasteners can be driven, who is in the way, and how sure it is.

    Args:
        tacking: All ways to hold the piece, put to the test.
        never: Over what it is proven, if it is.
    """
    few, holder = _how_many(tacking), tacking.robot
    if never is None:
        return _in_the_way(few, holder, tuple(tacking.hindered()))
    own = tuple(
        Sentence("{fastener} ({pair:and})", fastener=operation, pair=why.pairs[0])
        for operation, why in never.blocked
    )
    return Sentence(
        "{few}; proven over all {grasps} grasps in every posture ({ways} ways to hold it), and "
        "up to {poses} tool poses of {robots:and} for each fastener in every posture",
        few=_in_the_way(few, holder, own),
        grasps=never.grasps,
        ways=never.ways,
        poses=never.tool_poses,
        robots=tuple(never.robots) or (Sentence("nobody"),),
    )


def _in_the_way(few: Sentence, holder: RobotId, fasteners: tuple[str, ...]) -> Sentence:
    if not fasteners:
        return few
    return Sentence(
        "{few}, since {robot}, which holds it, is in the way of {fasteners:and}",
        few=few,
        robot=holder,
        fasteners=fasteners,
    )


def _how_many(tacking: Tacking) -> Sentence:
    task, most, ways = tacking.context.task, tacking.most, tacking.insufficient
    missing = _missing(forced_tacks(task), most)
    if missing:
        return Sentence(
            "{missing:and} must be driven while the piece is held, and no tool gets "
            "there in any of the {ways} ways to hold it",
            missing=tuple(missing),
            ways=ways,
        )
    return Sentence(
        "at most {most} of the {needed} fasteners that must be driven "
        "before letting go can be driven while it is held (in {ways} ways to hold it)",
        most=len(most),
        needed=tacks_needed(task),
        ways=ways,
    )


def _missing(wanted: Iterable[OperationId], found: Iterable[OperationId]) -> list[OperationId]:
    known = set(found)
    return [o for o in wanted if o not in known]
