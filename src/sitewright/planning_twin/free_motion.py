"""Free motion that holds its certificate: search, proof, and what to try when the proof fails."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.motion import (
    Certificate,
    JointPath,
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


@dataclass(frozen=True, slots=True, kw_only=True)
class FreeMotion:
    """A free path with its proof.

    Attributes:
        certificate: Of this segment alone; a longer path needs one of its own.
    """

    segment: PathSegment
    certificate: Certificate


def plan_free_motion(  # noqa: PLR0913 - engines, scene, who, where to, contacts, budget
    backends: PlanningBackends,
    scene: SceneSnapshot,
    robot: RobotId,
    goal_rad: Joints,
    threshold_m: Mapping[Pair, float],
    *,
    seed: int,
    max_nodes: int = FIRST_NODES,
) -> FreeMotion | BlockedBy | NoPath | NotClear:
    """Return a certified path from the robot's posture in `scene` to a goal posture.

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
        The path, the pairs that block start or goal, an exhausted search, or the last proof's
        objection.
    """
    request = MotionRequest(
        robot=robot, goal_rad=goal_rad, threshold_m=threshold_m, max_nodes=max_nodes
    )
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
        motion = _proven(backends, scene, attempt, found)
        if isinstance(motion, FreeMotion):
            return motion
        refusal = motion
    if refusal is None:
        return NoPath(nodes=max_nodes, seeds=(seed,), reason="nothing was tried")
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


def _proven(
    backends: PlanningBackends,
    scene: SceneSnapshot,
    request: MotionRequest,
    waypoints_rad: tuple[Joints, ...],
) -> FreeMotion | NotClear:
    segment = PathSegment(waypoints_rad=waypoints_rad, threshold_m=dict(request.threshold_m))
    path = JointPath(robot=request.robot, segments=(segment,))
    certificate = backends.certifier.certify(scene, path)
    if isinstance(certificate, NotClear):
        return certificate
    return FreeMotion(segment=segment, certificate=certificate)
