"""Free motion that holds its proof: search, proof, and what to try when the proof fails."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from sitewright.foundation.ids import RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.motion import (
    MotionRequest,
    PathSegment,
    PlanningBackends,
)
from sitewright.planning_twin.refusal import BlockedBy, NoPath, NotClear
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.robot_team.description import Joints

FIRST_NODES = 500
_MORE_NODES = 6
_FINE_STEP_RAD = 0.01
_SEED_STEP = 1


def plan_free_motion(  # noqa: PLR0913 - engines, scene, who, where to, contacts, budget
    backends: PlanningBackends,
    scene: SceneSnapshot,
    robot: RobotId,
    goal_rad: Joints,
    threshold_m: Mapping[Pair, float],
    *,
    seed: int,
    max_nodes: int = FIRST_NODES,
) -> PathSegment | BlockedBy | NoPath | NotClear:
    """Return a path that holds a proof, from the robot's posture in `scene` to a goal posture.

    A path that the proof refuses is tried again before it was shortened, then from another
    seed, then with finer steps; a search that runs out of nodes once with six times as many.
    One that ran out of time is not repeated.

    Args:
        backends: Engines.
        scene: All bodies, and the posture that the robot starts from.
        robot: Who moves.
        goal_rad: Where to.
        threshold_m: Declared contacts that persist in this motion.
        seed: The same seed gives the same path.
        max_nodes: First budget of the search.

    Returns:
        The path, whose certificate is still to be made; or the pairs that block start or goal, an
        exhausted search, or the last proof's objection.
    """
    request = MotionRequest(
        robot=robot, goal_rad=goal_rad, threshold_m=threshold_m, max_nodes=max_nodes
    )
    return fulfilled(backends, scene, request, seed=seed)


def fulfilled(
    backends: PlanningBackends, scene: SceneSnapshot, request: MotionRequest, *, seed: int
) -> PathSegment | BlockedBy | NoPath | NotClear:
    """Return a path that holds a proof, to any goal of a request and for all who move.

    What is tried, and in which order, is said at `plan_free_motion`.
    """
    refusal: NoPath | NotClear | None = None
    seeds: list[int] = []
    for attempt, attempt_seed in _attempts(request, seed):
        if isinstance(refusal, NoPath) and attempt.max_nodes <= refusal.nodes:
            continue
        seeds.append(attempt_seed)
        found = backends.planner.plan(scene, attempt, seed=attempt_seed)
        if isinstance(found, BlockedBy):
            return found
        if isinstance(found, NoPath):
            refusal = replace(found, seeds=tuple(dict.fromkeys(seeds)))
            if not found.is_reproducible:
                return refusal
            continue
        segment = PathSegment(waypoints_rad=found, threshold_m=dict(request.threshold_m))
        refusal = backends.certifier.objection(scene, request.path(segment))
        if refusal is None:
            return segment
    if refusal is None:
        return NoPath(nodes=request.max_nodes, seeds=(seed,), reason=Sentence("nothing was tried"))
    return refusal


def _attempts(request: MotionRequest, seed: int) -> Iterator[tuple[MotionRequest, int]]:
    """Yield what to try, in order."""
    many = replace(request, max_nodes=request.max_nodes * _MORE_NODES)
    yield request, seed
    yield replace(request, is_shortcut=False), seed
    yield request, seed + _SEED_STEP
    yield replace(request, step_rad=_FINE_STEP_RAD), seed
    yield many, seed
    yield replace(many, step_rad=_FINE_STEP_RAD, is_shortcut=False), seed + _SEED_STEP
