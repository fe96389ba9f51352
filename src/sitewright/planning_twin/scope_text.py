"""Poses, joints and bodies as texts that are equal where a refusal cannot tell them apart."""

from __future__ import annotations

from sitewright.foundation.canonical import Json, sha256_hex
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.scene import Attachment, Body, arm_text, shape_hash
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.description import Joints

STEP_M = 1e-4
"""Sensed poses never repeat to the bit; what moved by this much has another text."""
TURN_STEP = 1e-5
"""Of a quaternion's numbers: a turn of 0.00005 rad changes one of them by as much."""
JOINT_STEP = 1e-4
"""Radians, or metres of a rail."""


def pose_text(pose: Pose) -> list[int]:
    """Return a pose in whole steps."""
    position = (round(x / STEP_M) for x in pose.position_m)
    turn = (round(x / TURN_STEP) for x in pose.quaternion_wxyz)
    return [*position, *turn]


def joints_text(q_rad: Joints) -> list[int]:
    """Return a posture in whole steps."""
    return [round(q / JOINT_STEP) for q in q_rad]


def tool_text(tool: EndEffector) -> Json:
    """Return an end effector with its shape and what it can do."""
    shape = sha256_hex(arm_text(tool.description))
    drives = (tool.processes, tool.fasteners, tool.max_tilt_rad, tool.nose_half_width_m)
    return [tool.id, shape, list(tool.grips_m or ()), tool.opens_to_m, repr(drives)]


def body_text(body: Body) -> Json:
    """Return a body with its shape and where it stands, or who carries it how."""
    placement = body.placement
    if isinstance(placement, Attachment):
        return [shape_hash(body.shape), placement.robot, *pose_text(placement.tip_T_body)]
    return [shape_hash(body.shape), *pose_text(placement)]
