"""Apply-finish: parallel straight strokes over a patch, at the process's speed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.pose import Pose, Vector, distance, rotation, scale, translation
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.approach import NEIGHBOUR_M, Approach, Reaching, Touch
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.jobsite import bodies_of_tool, scene_of
from sitewright.planning_twin.motion import PathSegment, PlannedMotion
from sitewright.planning_twin.refusal import Disagreement, NoIk, NotClear
from sitewright.planning_twin.scene import Pair
from sitewright.planning_twin.skill_motions.moving import finished_motion
from sitewright.planning_twin.skill_motions.resting import resting_contacts
from sitewright.planning_twin.skill_motions.stage import (
    PlannedSkill,
    SkillRefusal,
    Stage,
    pose_json,
    with_joints,
)
from sitewright.planning_twin.task import declared
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.description import Joints
from sitewright.robot_team.gripper import mount_T_tcp
from sitewright.robot_team.skill import SkillCall

_YAWS_DEG = (0.0, 90.0, 180.0, -90.0)
_SAMPLES_PER_STROKE = 60
_A_LITTLE_LESS = 0.99
"""Speeds between two samples may be a little higher than at them."""
_REQUIRED_COVERAGE = 0.95


def stroke_points(spot: Spot) -> list[Vector]:
    """Return the corners of the serpentine in the patch frame, at the face (z = 0)."""
    patch = spot.patch
    if patch is None:
        raise ValueError(f"{spot.operation} has no patch")
    length_m, breadth_m = patch.size_m
    count = max(1, math.ceil(breadth_m / patch.width_m))
    pitch_m = breadth_m / count
    points: list[Vector] = []
    for k in range(count):
        y = -breadth_m / 2.0 + (k + 0.5) * pitch_m
        ends = [(-length_m / 2.0, y, 0.0), (length_m / 2.0, y, 0.0)]
        points += ends if k % 2 == 0 else ends[::-1]
    return points


def first_touches(spot: Spot, tool: EndEffector, piece: ComponentId) -> Iterator[Touch]:
    """Yield the tip poses at the start of the first stroke, one for each turn about the tool."""
    tcp_T_tip = mount_T_tcp(tool.description).inverse()
    start = _tcp_at(spot, stroke_points(spot)[0])
    for yaw_deg in _YAWS_DEG:
        turned = start @ rotation((0.0, 0.0, 1.0), math.radians(yaw_deg))
        yield Touch(
            world_T_tip=turned @ tcp_T_tip,
            back_off=scale(turned.z_axis, -1.0),
            near_m=_near(tool, piece),
            label=f"turned {yaw_deg:g} deg",
        )


def covers_patch(reaching: Reaching, spot: Spot, approach: Approach) -> bool:
    """Tell whether every stroke can follow from an approach without changing the arm's branch."""
    lines = _lines(reaching, spot, approach.touch.world_T_tip, approach.contact_rad)
    return not isinstance(lines, NoIk)


def plan_apply_finish(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Plan the strokes from where the tool stands now, the start of the first one."""
    spot = stage.context.task.spot(call.arguments[0])
    piece = stage.context.task.placed
    if spot is None or spot.patch is None or piece is None:
        reason = Sentence("{spot} has no patch or no piece", spot=call.arguments[0])
        return SkillRefusal(call=call, refusal=NoIk(is_proven=True, reason=reason))
    tip = stage.tip(call.robot)
    lines = _lines(stage.reaching(call.robot), spot, tip, stage.q_rad(call.robot))
    if isinstance(lines, NoIk):
        return SkillRefusal(call=call, refusal=lines)
    threshold = {**resting_contacts(stage, call.robot), **_near(stage.tool(call.robot), piece)}
    motion = _at_process_speed(stage, call.robot, spot, lines, threshold)
    if not isinstance(motion, PlannedMotion):
        return SkillRefusal(call=call, refusal=motion)
    site = with_joints(stage.site, call.robot, motion.timed.path.end_rad)
    return PlannedSkill(motions=(motion,), params=_params(spot, piece), site_after=site)


def _params(spot: Spot, piece: ComponentId) -> dict[str, Json]:
    patch = spot.patch
    if patch is None:
        raise ValueError(f"{spot.operation} has no patch")
    return {
        "operation": spot.operation,
        "piece": piece,
        "world_T_patch": pose_json(spot.world_T_operation),
        "size_m": list(patch.size_m),
        "standoff_m": patch.standoff_m,
        "width_m": patch.width_m,
        "coverage": _REQUIRED_COVERAGE,
    }


def _near(tool: EndEffector, piece: ComponentId) -> dict[Pair, float]:
    return declared(NEIGHBOUR_M, bodies_of_tool(tool), (BodyId(piece),))


def _tcp_at(spot: Spot, point: Vector) -> Pose:
    standoff_m = 0.0 if spot.patch is None else spot.patch.standoff_m
    return spot.world_T_operation @ translation(point[0], point[1], -standoff_m)


def _lines(
    reaching: Reaching, spot: Spot, world_T_tip: Pose, start_rad: Joints
) -> list[tuple[Joints, ...]] | NoIk:
    """Return one joint polyline per straight piece of the serpentine."""
    points = [spot.world_T_operation.turn(p) for p in stroke_points(spot)]
    lines: list[tuple[Joints, ...]] = []
    pose, q_rad = world_T_tip, start_rad
    for here, there in pairwise(points):
        shift = tuple(b - a for a, b in zip(here, there, strict=True))
        goal = translation(*shift) @ pose
        line = reaching.line(pose, goal, q_rad)
        if isinstance(line, NoIk):
            return line
        lines.append(line)
        pose, q_rad = goal, line[-1]
    return lines


def _at_process_speed(
    stage: Stage,
    robot: RobotId,
    spot: Spot,
    lines: list[tuple[Joints, ...]],
    threshold: dict[Pair, float],
) -> PlannedMotion | NotClear | Disagreement:
    """Return the strokes, timed slower until the tip never moves faster than the process may.

    Short strokes are limited by acceleration, so that a lower speed limit does not bind at once.
    """
    segments = tuple(PathSegment(waypoints_rad=w, threshold_m=threshold) for w in lines)
    scene = scene_of(stage.site)
    motion = finished_motion(stage, robot, scene, segments)
    if not isinstance(motion, PlannedMotion) or spot.patch is None:
        return motion
    share = 1.0
    while (peak_m_s := _peak_tip_speed(stage, robot, motion)) > spot.patch.speed_m_s:
        share *= spot.patch.speed_m_s / peak_m_s * _A_LITTLE_LESS
        motion = finished_motion(stage, robot, scene, segments, speed=share)
        if not isinstance(motion, PlannedMotion):
            return motion
    return motion


def _peak_tip_speed(stage: Stage, robot: RobotId, motion: PlannedMotion) -> float:
    trajectory = motion.timed.trajectory
    count = _SAMPLES_PER_STROKE * len(motion.timed.path.segments)
    step_s = trajectory.duration_s / count
    arm, kinematics = stage.robot(robot).description, stage.context.backends.kinematics
    tip_T_tcp = mount_T_tcp(stage.tool(robot).description)
    postures = (trajectory.at(k * step_s)[0] for k in range(count + 1))
    tips = [(kinematics.tip(arm, q) @ tip_T_tcp).position_m for q in postures]
    return max(distance(a, b) for a, b in pairwise(tips)) / step_s
