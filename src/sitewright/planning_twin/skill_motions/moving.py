"""Builds one planned motion: search, proof, timing and second opinion, in this order."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import islice

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.approach import Approach, Approaches, Reaching, Touch
from sitewright.planning_twin.detour import plan_detour
from sitewright.planning_twin.free_motion import plan_free_motion
from sitewright.planning_twin.jobsite import scene_of
from sitewright.planning_twin.moment import moment_of
from sitewright.planning_twin.motion import (
    Certificate,
    JointLimits,
    JointPath,
    PathSegment,
    PlannedMotion,
)
from sitewright.planning_twin.refusal import (
    BlockedBy,
    Disagreement,
    NoIk,
    NoPath,
    NotClear,
    Refusal,
)
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.planning_twin.skill_motions.resting import resting_contacts
from sitewright.planning_twin.skill_motions.stage import Stage, with_joints
from sitewright.planning_twin.skill_motions.way_out import stands_in_contact, way_out
from sitewright.robot_team.cell import Robot
from sitewright.robot_team.description import Joints

_MOST_MOTIONS = 4
"""So many approaches get a path search before the skill is refused."""
_MOST_POSTURES = 2
"""Postures of the arm that are tried for one contact pose."""
_JERK_PER_ACCELERATION_HZ = 10.0
_SAME_POSTURE_RAD = 1e-6
_POSE = 6
"""A pose has so many freedoms."""


def limits_of(robot: Robot, speed: float = 1.0) -> JointLimits:
    """Return a robot's joint limits, velocities scaled by `speed`."""
    return JointLimits(
        velocity_rad_s=tuple(j.velocity_rad_s * speed for j in robot.description.movable_joints),
        acceleration_rad_s2=robot.max_acceleration_rad_s2,
        jerk_rad_s3=tuple(a * _JERK_PER_ACCELERATION_HZ for a in robot.max_acceleration_rad_s2),
    )


def finished_motion(
    stage: Stage,
    robot: RobotId,
    scene: SceneSnapshot,
    segments: tuple[PathSegment, ...],
    *,
    speed: float = 1.0,
) -> PlannedMotion | NotClear | Disagreement:
    """Certify, time and cross-check a path, while the other robots rest in their contacts."""
    backends = stage.context.backends
    resting = resting_contacts(stage, robot)
    path = JointPath(robot=robot, segments=tuple(_with_resting(s, resting) for s in segments))
    certificate = backends.certifier.certify(scene, path)
    if isinstance(certificate, NotClear):
        return certificate
    return _timed(stage, scene, path, certificate, speed)


def _timed(
    stage: Stage, scene: SceneSnapshot, path: JointPath, certificate: Certificate, speed: float
) -> PlannedMotion | Disagreement:
    backends = stage.context.backends
    timed = backends.timer.time(path, limits_of(stage.robot(path.robot), speed))
    opinion = backends.cross_check.check(scene, timed)
    if isinstance(opinion, Disagreement):
        return opinion
    return PlannedMotion(timed=timed, certificate=certificate, agreement=opinion)


def move_to(
    stage: Stage,
    robot: RobotId,
    goal_rad: Joints,
    tail: tuple[PathSegment, ...] = (),
    *,
    out: tuple[PathSegment, ...] | None = None,
) -> PlannedMotion | Refusal:
    """Plan from where a robot stands to a posture, then along `tail`.

    Args:
        stage: The site now.
        robot: Who moves; what it holds moves along.
        goal_rad: End of the free motion, start of the tail.
        tail: Straight approach that follows.
        out: Straight lines out of contact, to go first. None: a robot that was stopped in contact
            goes straight out of it.
    """
    resting = resting_contacts(stage, robot)
    lead = _lead(stage, robot) if out is None else out
    if isinstance(lead, NoIk):
        return lead
    start_rad = lead[-1].waypoints_rad[-1] if lead else stage.q_rad(robot)
    outside = scene_of(with_joints(stage.site, robot, start_rad))
    free = _free_segments(stage, outside, robot, goal_rad, resting)
    if not isinstance(free, tuple):
        return free
    standing = PathSegment(waypoints_rad=(goal_rad, goal_rad))
    segments = (*lead, *free, *tail) or (standing,)
    return finished_motion(stage, robot, scene_of(stage.site), segments)


def move_to_first(
    stage: Stage,
    robot: RobotId,
    goals_rad: Iterable[Joints],
    *,
    out: tuple[PathSegment, ...] | None = None,
) -> PlannedMotion | Refusal:
    """Plan to the first of some postures that can be reached; else return why not to the last."""
    refusal: Refusal = NoIk(is_proven=False, reason=Sentence("there is no posture to go to"))
    for goal_rad in goals_rad:
        motion = move_to(stage, robot, goal_rad, out=out)
        if isinstance(motion, PlannedMotion):
            return motion
        refusal = motion
    return refusal


def _lead(stage: Stage, robot: RobotId) -> tuple[PathSegment, ...] | NoIk:
    return way_out(stage, robot) if stands_in_contact(stage, robot) else ()


def _free_segments(
    stage: Stage,
    scene: SceneSnapshot,
    robot: RobotId,
    goal_rad: Joints,
    resting: Mapping[Pair, float],
) -> tuple[PathSegment, ...] | BlockedBy | NoPath | NotClear:
    start_rad = scene.robots[robot].q_rad
    if max(abs(a - b) for a, b in zip(start_rad, goal_rad, strict=True)) < _SAME_POSTURE_RAD:
        return ()
    backends, seed = stage.context.backends, stage.context.seed
    if stage.detour:
        way = plan_detour(backends, scene, robot, goal_rad, resting, seed=seed, number=stage.detour)
        return (way,) if isinstance(way, PathSegment) else way
    found = plan_free_motion(backends, scene, robot, goal_rad, resting, seed=seed)
    return (found,) if isinstance(found, PathSegment) else found


def _with_resting(segment: PathSegment, resting: Mapping[Pair, float]) -> PathSegment:
    return replace(segment, threshold_m={**resting, **segment.threshold_m})


@dataclass(frozen=True, slots=True, kw_only=True)
class Reached:
    """A motion to a contact pose.

    Attributes:
        first_refusal: Why the first pose that was tried would not do; None if it is this one.
    """

    motion: PlannedMotion
    touch: Touch
    first_refusal: Refusal | None = None


def reach_any(
    stage: Stage,
    robot: RobotId,
    touches: Iterable[Touch],
    *,
    serves: Callable[[Reaching, Approach], bool] = lambda _reaching, _approach: True,
    wanted_rad: Joints | None = None,
) -> Reached | Refusal:
    """Plan to the first contact pose that can be reached, trying the cheapest freedoms first.

    Args:
        stage: The site now.
        robot: Who reaches.
        touches: Contact poses in order of preference.
        serves: What the approach must also allow, e.g. the strokes that follow.
        wanted_rad: Posture in contact that was proven before. An arm with more joints than a
            pose needs finds it again only from itself.
    """
    is_redundant = len(stage.q_rad(robot)) > _POSE
    near_rad = wanted_rad if wanted_rad and is_redundant else stage.q_rad(robot)
    resting = resting_contacts(stage, robot)
    reaching = stage.reaching(robot)
    refusals: list[Refusal] = []
    motions = 0
    first: Refusal | None = None
    for touch in touches:
        declared = replace(
            touch,
            near_m={**resting, **touch.near_m},
            free_m={**resting, **touch.free_m},
        )
        search = Approaches(reaching, declared, near_rad)
        serving = 0
        for approach in islice((a for a in search if serves(reaching, a)), _MOST_POSTURES):
            serving += 1
            motion = move_to(stage, robot, approach.pre_rad, approach.segments)
            if isinstance(motion, PlannedMotion):
                return Reached(motion=motion, touch=touch, first_refusal=first)
            refusals.append(motion)
            motions += 1
            if motions >= _MOST_MOTIONS:
                return most_telling(refusals)
        if not search.found:
            refusals.append(search.why_not())
        elif not serving:
            refusals.append(search.why_none_serves(wanted_rad))
        first = first or refusals[-1]
    return most_telling(refusals)


def move_to_any(stage: Stage, robot: RobotId, world_T_tip: Pose) -> PlannedMotion | Refusal:
    """Plan a free motion to a tip pose that touches nothing."""
    reaching = stage.reaching(robot)
    postures = reaching.solve(world_T_tip, stage.q_rad(robot))
    if isinstance(postures, NoIk):
        return postures
    resting = resting_contacts(stage, robot)
    refusals: list[Refusal] = []
    for q_rad in postures:
        if pairs := reaching.violations(q_rad, resting, is_padded=True):
            moment = moment_of(reaching.scene, {robot: q_rad}, pairs[0])
            refusals.append(BlockedBy(pairs=pairs, moment=moment))
            continue
        motion = move_to(stage, robot, q_rad)
        if isinstance(motion, PlannedMotion):
            return motion
        refusals.append(motion)
        if len(refusals) >= _MOST_MOTIONS:
            break
    return most_telling(refusals)


def most_telling(refusals: list[Refusal]) -> Refusal:
    """Return the refusal that says most: who is in the way before an exhausted search."""
    blocked = [r for r in refusals if isinstance(r, BlockedBy)]
    if blocked:
        return min(blocked, key=lambda r: len(r.pairs))
    searched = [r for r in refusals if not isinstance(r, NoIk)]
    if searched:
        return searched[-1]
    unreachable = [r for r in refusals if isinstance(r, NoIk)]
    if not unreachable:
        return NoIk(is_proven=False, tried=0, reason=Sentence("there was no pose to try"))
    return NoIk(
        is_proven=all(r.is_proven for r in unreachable),
        extension_m=min(r.extension_m for r in unreachable),
        tried=sum(r.tried for r in unreachable),
        reason=unreachable[0].reason,
    )
