"""Another way for a motion that a person called unsafe: by way of a posture aside of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from random import Random

from sitewright.foundation.ids import RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.free_motion import plan_free_motion
from sitewright.planning_twin.motion import PathSegment, PlanningBackends
from sitewright.planning_twin.refusal import NoPath
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.robot_team.description import Joints

_MOST_TRIED = 24
_ASIDE = 0.6
"""So far a joint of the arm may be from the middle of the direct way, rad (m on a rail)."""
_LEAST_ASIDE = 0.25
"""So far at least one joint is aside, so that people see the difference."""
_NODES = 200


def plan_detour(  # noqa: PLR0913 -- engines, scene, who, where to, contacts, which one
    backends: PlanningBackends,
    scene: SceneSnapshot,
    robot: RobotId,
    goal_rad: Joints,
    threshold_m: Mapping[Pair, float],
    *,
    seed: int,
    number: int,
) -> PathSegment | NoPath:
    """Return a path that leads by way of a posture aside of the direct way; seeded.

    Args:
        backends: Engines.
        scene: All bodies, and the posture that the robot starts from.
        robot: Who moves.
        goal_rad: Where to.
        threshold_m: Declared contacts that persist in this motion.
        seed: The same seed and number give the same path.
        number: How often a way was called unsafe; each gives another one.

    Returns:
        The path, whose certificate is still to be made; or that none was found.
    """
    dice = Random(f"{seed}/{number}")  # noqa: S311 -- the same must come again
    for via_rad in _aside(scene, robot, goal_rad, dice):
        if not backends.collision.is_clear(scene, robot, via_rad, threshold_m, is_padded=True):
            continue
        there = plan_free_motion(
            backends, scene, robot, via_rad, threshold_m, seed=seed, max_nodes=_NODES
        )
        if not isinstance(there, PathSegment):
            continue
        on = plan_free_motion(
            backends,
            scene.with_joints(robot, via_rad),
            robot,
            goal_rad,
            threshold_m,
            seed=seed,
            max_nodes=_NODES,
        )
        if isinstance(on, PathSegment):
            waypoints = (*there.waypoints_rad, *on.waypoints_rad[1:])
            return PathSegment(waypoints_rad=waypoints, threshold_m=dict(threshold_m))
    return NoPath(
        nodes=_NODES,
        seeds=(seed,),
        reason=Sentence("no other way was found than the one that was called unsafe"),
    )


def _aside(
    scene: SceneSnapshot, robot: RobotId, goal_rad: Joints, dice: Random
) -> Iterator[Joints]:
    """Yield postures aside of the middle of the direct way, within the joint limits."""
    arm = scene.robots[robot]
    middle = [(a + b) / 2.0 for a, b in zip(arm.q_rad, goal_rad, strict=True)]
    joints = arm.description.movable_joints
    for _ in range(_MOST_TRIED):
        aside = [dice.uniform(-_ASIDE, _ASIDE) for _ in middle]
        if max(map(abs, aside)) >= _LEAST_ASIDE:
            yield tuple(
                min(max(q + off, j.lower_rad), j.upper_rad)
                for q, off, j in zip(middle, aside, joints, strict=True)
            )
