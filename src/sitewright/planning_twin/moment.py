"""A moment to look at: the posture in which two bodies came too near, and what was where in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.scene import Attachment, Pair, SceneSnapshot, owner_of
from sitewright.robot_team.description import Joints


@dataclass(frozen=True, slots=True, kw_only=True)
class Moment:
    """Where the robots of a refusal stood when a pair was too near; all else is as sensed.

    Attributes:
        q_rad: Posture of each robot that moved, and of each other one that the pair is about.
        bodies: What these robots carried, and where the pair's own bodies stood.
    """

    q_rad: Mapping[RobotId, Joints]
    bodies: Mapping[BodyId, Pose | Attachment]


def moment_of(
    scene: SceneSnapshot, moved: Mapping[RobotId, Joints], pair: Pair | tuple[()]
) -> Moment:
    """Return the moment of a scene in which some robots stand at other postures.

    Args:
        scene: All bodies, and the other robots' postures.
        moved: Postures that were looked at, by robot.
        pair: The two that are too near.
    """
    owners = {owner for name in pair if (owner := owner_of(scene, name)) is not None}
    others = {r: scene.robots[r].q_rad for r in sorted(owners - set(moved))}
    postures = {**moved, **others}
    return Moment(
        q_rad=postures,
        bodies={
            name: body.placement
            for name, body in scene.bodies.items()
            if (
                name in pair
                if isinstance(body.placement, Pose)
                else _is_on(body.placement, postures)
            )
        },
    )


def by_robot(
    scene: SceneSnapshot, robots: tuple[RobotId, ...], q_rad: Joints
) -> dict[RobotId, Joints]:
    """Return whose joints are whose in a posture of several robots, one after the other."""
    found: dict[RobotId, Joints] = {}
    first = 0
    for robot in robots:
        count = len(scene.robots[robot].q_rad)
        found[robot] = q_rad[first : first + count]
        first += count
    return found


def _is_on(placement: Attachment, robots: Mapping[RobotId, Joints]) -> bool:
    return placement.robot in robots
