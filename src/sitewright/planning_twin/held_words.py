"""Why too few fasteners can be driven while a piece is held, in words."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.foundation.ids import OperationId, RobotId
from sitewright.planning_twin.refusal import HeldFreedoms
from sitewright.planning_twin.tacking import Tacking, forced_tacks, tacks_needed


def too_few_words(tacking: Tacking, never: HeldFreedoms | None) -> str:
    """Return how many of the fasteners can be driven, who is in the way, and how sure it is.

    Args:
        tacking: All ways to hold the piece, put to the test.
        never: Over what it is proven, if it is.
    """
    if never is None:
        return f"{_how_many(tacking)}{_in_the_way(tacking.robot, tacking.hindered())}"
    pairs = {operation: f" ({' and '.join(pair)})" for operation, pair in never.blocked}
    own = _in_the_way(tacking.robot, [f"{o}{pair}" for o, pair in pairs.items()])
    who = " and ".join(never.robots) or "nobody"
    return (
        f"{_how_many(tacking)}{own}; proven over all {never.grasps} grasps in every posture "
        f"({never.ways} ways to hold it), and up to {never.tool_poses} tool poses of {who} "
        "for each fastener in every posture"
    )


def _in_the_way(holder: RobotId, fasteners: Iterable[str]) -> str:
    names = " and ".join(fasteners)
    return f", since {holder}, which holds it, is in the way of {names}" if names else ""


def _how_many(tacking: Tacking) -> str:
    task, most, ways = tacking.context.task, tacking.most, tacking.insufficient
    missing = _missing(forced_tacks(task), most)
    if missing:
        return (
            f"{' and '.join(missing)} must be driven while the piece is held, and no tool gets "
            f"there in any of the {ways} ways to hold it"
        )
    return (
        f"at most {len(most)} of the {tacks_needed(task)} fasteners that must be driven "
        f"before letting go can be driven while it is held (in {ways} ways to hold it)"
    )


def _missing(wanted: Iterable[OperationId], found: Iterable[OperationId]) -> list[OperationId]:
    known = set(found)
    return [o for o in wanted if o not in known]
