"""Who is in the way: the smallest sets of things that would have to go for a posture to be free."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.moment import moment_of
from sitewright.planning_twin.refusal import BlockedBy
from sitewright.planning_twin.scene import Pair, SceneSnapshot, owner_of
from sitewright.robot_team.description import Joints

_MOST_REMOVALS = 6


def blocked_by(
    scene: SceneSnapshot,
    robot: RobotId,
    blocked: Iterable[tuple[Joints, tuple[Pair, ...]]],
    reason: str = "",
) -> BlockedBy:
    """Return the refusal of a pose that none of its postures is clear for.

    Args:
        scene: Where the postures were looked at.
        robot: Who should have taken them.
        blocked: Each posture with the pairs that are too near in it.
        reason: As `BlockedBy` has it.
    """
    postures = list(blocked)
    q_rad, easiest = min(postures, key=lambda p: (_weight(scene, robot, p[1]), len(p[1])))
    return BlockedBy(
        pairs=easiest,
        removals=removals(scene, robot, [pairs for _, pairs in postures]),
        reason=reason,
        moment=moment_of(scene, {robot: q_rad}, easiest[0]),
    )


def removals(
    scene: SceneSnapshot, robot: RobotId, blocked: Iterable[tuple[Pair, ...]]
) -> tuple[tuple[str, ...], ...]:
    """Return the smallest sets of bodies and robots whose removal frees a posture.

    A posture in which the robot meets itself is freed by nothing.
    """
    found = {things_in_the_way(scene, robot, pairs) for pairs in blocked} - {None, frozenset()}
    sets = sorted((s for s in found if s), key=lambda s: (len(s), sorted(s)))
    smallest = [s for k, s in enumerate(sets) if not any(other < s for other in sets[:k])]
    return tuple(tuple(sorted(s)) for s in smallest[:_MOST_REMOVALS])


def things_in_the_way(
    scene: SceneSnapshot, robot: RobotId, pairs: Iterable[Pair]
) -> frozenset[str] | None:
    """Return the bodies and other robots in pairs; None if the robot itself is in its way.

    What another robot carries stands for that robot.
    """
    found: set[str] = set()
    for pair in pairs:
        others = {owner for name in pair if (owner := owner_of(scene, name) or name) != robot}
        if not others:
            return None
        found |= others
    return frozenset(found)


def _weight(scene: SceneSnapshot, robot: RobotId, pairs: tuple[Pair, ...]) -> float:
    things = things_in_the_way(scene, robot, pairs)
    return float("inf") if things is None else len(things)
