"""Whether a target can be reached at all, found out without the planner's code.

Forward kinematics and the search for postures are written anew here: products of the joint
frames, and damped least squares within the joints' limits from many starts. All freedoms that
the planner states are gone through: robots, pieces, faces, pitches, half turns and offsets of a
grasp; robots and leans of a tool; both ends of the straight way to contact. Collisions are not
looked at: a "no" here needs no scene.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice, product

import numpy as np
import numpy.typing as npt

from sitewright.app.project import Project
from sitewright.building_model.component import BoxGeometry, Component, Layer, Operation
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import EndEffector, EndEffectorKind, Robot
from sitewright.robot_team.description import Description, Joint, JointKind

Array = npt.NDArray[np.float64]
_STARTS, _ITERATIONS, _AT_ONCE = 40, 80, 64
_DAMPING, _STEP_RAD = 1e-4, 0.4
_SAME = 1e-5
_BEFORE_CONTACT_M = 0.120
"""The planner comes straight to contacts from so far off; pieces come in from above."""
_PITCHES_DEG = (0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0)
_OFFSETS_M = tuple(k / 10.0 for k in range(-6, 7))
_TILTS_DEG = (0.0, 2.5, 5.0, 10.0)
_BEARINGS_DEG = tuple(45.0 * k for k in range(8))
_LEAST_PAD_M = 0.005


@dataclass(frozen=True, slots=True)
class Unreachable:
    """Why nothing reaches a target: the part of it, as the check names it."""

    what: str


def unreachable(project: Project, target: ComponentId) -> Unreachable | None:
    """Return what of a target no robot reaches in any stated way, None if all is reached."""
    component = project.model.component_by_id[target]
    for operation in component.operations:
        if not any(_does(project, robot, component, operation) for robot in _robots(project)):
            return Unreachable(str(operation.id))
    if not any(_handles(project, robot, component) for robot in _robots(project)):
        return Unreachable(str(target))
    return None


def _robots(project: Project) -> list[Robot]:
    return list(project.cell.robot_by_id.values())


def _tools(project: Project, robot: Robot, kind: EndEffectorKind) -> Iterator[EndEffector]:
    for name in robot.end_effectors:
        tool = project.cell.end_effector_by_id[name]
        if tool.kind is kind:
            yield tool


def _does(project: Project, robot: Robot, component: Component, operation: Operation) -> bool:
    at = project.cell.world_T_model @ component.world_T_component @ operation.component_T_operation
    for tool in _tools(project, robot, EndEffectorKind.TOOL):
        if operation.process in tool.processes:
            tcps = matrix(at) @ np.array(list(_leans(tool)))
            tcp_T_tip = np.linalg.inv(_mount_T_tcp(tool))
            if (reached(robot, tcps @ tcp_T_tip) & reached(robot, _backed(tcps) @ tcp_T_tip)).any():
                return True
    return False


def _backed(world_T_tcps: Array) -> Array:
    """Return tool poses before contact: straight back along the tool."""
    back = np.eye(4)
    back[2, 3] = -_BEFORE_CONTACT_M
    return world_T_tcps @ back


def _leans(tool: EndEffector) -> Iterator[Array]:
    """Yield operation_T_tcp: upright, then leaning in eight directions, stood off by the nose."""
    for tilt_deg in _TILTS_DEG:
        tilt = math.radians(tilt_deg)
        if tilt > tool.max_tilt_rad + 1e-9:
            return
        for bearing_deg in _BEARINGS_DEG if tilt else (0.0,):
            bearing = math.radians(bearing_deg)
            lean = turn((math.cos(bearing), math.sin(bearing), 0.0), tilt)
            lean[2, 3] = -tool.nose_half_width_m * math.sin(tilt)
            yield lean


def _handles(project: Project, robot: Robot, component: Component) -> bool:
    """Tell whether some grasp of some piece reaches both where it lies and the target."""
    target = matrix(project.cell.world_T_model @ component.world_T_component)
    above = target.copy()
    above[2, 3] += _BEFORE_CONTACT_M
    stock = [matrix(p) for p in _lying(project, component)]
    for tool in _tools(project, robot, EndEffectorKind.GRIPPER):
        grasps = iter(_grasps(component, tool))
        while some := list(islice(grasps, _AT_ONCE)):
            for world_T_piece in (target, above):
                some = list(np.array(some)[reached(robot, world_T_piece @ np.array(some))])
                if not some:
                    break
            if some and any(reached(robot, at @ np.array(some)).any() for at in stock):
                return True
    return False


def _lying(project: Project, component: Component) -> Iterator[Pose]:
    model, cell = project.model, project.cell
    for stack in model.stacks:
        world_T_stock = cell.stock_place_by_id[stack.place].world_T_stock
        for item in stack.items:
            piece = model.component_by_id[item]
            if piece.layer is Layer.MATERIAL and piece.type == component.type:
                yield world_T_stock @ piece.world_T_component


def _grasps(component: Component, tool: EndEffector) -> Iterator[Array]:
    """Yield piece_T_tip of all faces, pitches, half turns and offsets, tcp at the middle or higher.

    How deep the fingers go depends on the gripper's shape; both ends of what is possible are
    taken, so that a grasp in between is reached if both are.
    """
    assert isinstance(component.geometry, BoxGeometry)
    size, (low, high) = component.geometry.size_m, tool.grips_m or (0.0, 0.0)
    for (axis, closing), sign in product(((2, 1), (1, 2)), (-1.0, 1.0)):
        if not low <= size[closing] <= high:
            continue
        approach = np.zeros(3)
        approach[axis] = sign
        for offset_m, pitch_deg, half_turn in product(_OFFSETS_M, _PITCHES_DEG, (1.0, -1.0)):
            if abs(offset_m) > size[0] / 2.0 - 0.05 + 1e-9:
                continue
            x_axis = np.array([half_turn, 0.0, 0.0])
            frame = np.eye(4)
            frame[:3, :3] = np.column_stack((x_axis, np.cross(approach, x_axis), approach))
            pitched = frame @ turn((0.0, 1.0, 0.0), math.radians(pitch_deg))
            for depth_m in (0.0, -size[axis] / 2.0 + _LEAST_PAD_M):
                there = pitched.copy()
                there[:3, 3] = approach * depth_m + np.array([offset_m, 0.0, 0.0])
                yield there @ np.linalg.inv(_mount_T_tcp(tool))


def _mount_T_tcp(tool: EndEffector) -> Array:
    shut = np.zeros((1, len(tool.description.movable_joints)))
    return np.asarray(_forward_with_rates(tool.description, shut)[0][0])


def reached(robot: Robot, world_T_tips: Array) -> npt.NDArray[np.bool_]:
    """Tell of each tip pose, n x 4 x 4, whether some start ends in it."""
    arm = robot.description
    joints = arm.movable_joints
    low, high = (
        np.array([getattr(j, side) for j in joints]) for side in ("lower_rad", "upper_rad")
    )
    lots = np.random.default_rng(0)
    starts = np.vstack((robot.home_q_rad, lots.uniform(low, high, (_STARTS, len(low)))))
    q = np.tile(starts, (len(world_T_tips), 1))
    wanted = np.repeat(
        np.linalg.inv(matrix(robot.world_T_base)) @ world_T_tips, len(starts), axis=0
    )
    is_found = np.zeros(len(q), dtype=np.bool_)
    for _ in range(_ITERATIONS):
        tip, rates = _forward_with_rates(arm, q)
        off = _off(tip, wanted)
        is_found |= np.abs(tip - wanted).max(axis=(1, 2)) < _SAME
        damped = rates @ rates.transpose(0, 2, 1) + _DAMPING * np.eye(6)
        change = np.einsum("nij,ni->nj", rates, np.linalg.solve(damped, off[:, :, None])[:, :, 0])
        longest = np.abs(change).max(axis=1, keepdims=True)
        q = np.clip(q + change * np.minimum(1.0, _STEP_RAD / np.maximum(longest, 1e-12)), low, high)
    return np.asarray(is_found.reshape(len(world_T_tips), -1).any(axis=1))


def _off(tip: Array, wanted: Array) -> Array:
    """Return how far tips are off: metres, and the turn that is missing, about the base's axes."""
    turned = 0.5 * np.cross(tip[:, :3, :3], wanted[:, :3, :3], axis=1).sum(axis=2)
    return np.hstack((wanted[:, :3, 3] - tip[:, :3, 3], turned))


def _forward_with_rates(description: Description, q: Array) -> tuple[Array, Array]:
    """Return root_T_tip of each row of postures, and how it moves per joint, n x 6 x joints."""
    number = {j.name: k for k, j in enumerate(description.movable_joints)}
    frame = np.tile(np.eye(4), (len(q), 1, 1))
    axes, origins = np.zeros((2, len(q), 3, len(number)))
    is_sliding = np.zeros(len(number), dtype=np.bool_)
    for joint in _chain(description):
        frame = frame @ matrix(joint.parent_T_joint)
        if joint.kind is JointKind.FIXED:
            continue
        k = number[joint.name]
        axes[:, :, k], origins[:, :, k] = frame[:, :3, :3] @ np.array(joint.axis), frame[:, :3, 3]
        is_sliding[k] = joint.kind is JointKind.PRISMATIC
        frame = frame @ _moved(joint, q[:, k])
    arms = frame[:, :3, 3][:, :, None] - origins
    rates = np.concatenate((np.cross(axes, arms, axis=1), axes), axis=1)
    rates[:, :3, is_sliding], rates[:, 3:, is_sliding] = axes[:, :, is_sliding], 0.0
    return frame, rates


def _chain(description: Description) -> list[Joint]:
    by_child = {j.child: j for j in description.joints}
    chain, link = list[Joint](), description.tip
    while link != description.root:
        chain.append(by_child[link])
        link = by_child[link].parent
    return chain[::-1]


def _moved(joint: Joint, values: Array) -> Array:
    """Return the motion of a joint for each value, n x 4 x 4; turns by Rodrigues' formula."""
    out = np.tile(np.eye(4), (len(values), 1, 1))
    if joint.kind is JointKind.PRISMATIC:
        out[:, :3, 3] = values[:, None] * np.array(joint.axis)
        return out
    x, y, z = np.array(joint.axis) / np.linalg.norm(joint.axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    sine, rest = np.sin(values)[:, None, None], (1.0 - np.cos(values))[:, None, None]
    out[:, :3, :3] += sine * cross + rest * (cross @ cross)
    return out


def turn(axis: tuple[float, float, float], angle_rad: float) -> Array:
    """Return a rotation about an axis through the origin, by Rodrigues' formula."""
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    out = np.eye(4)
    out[:3, :3] += math.sin(angle_rad) * cross + (1.0 - math.cos(angle_rad)) * cross @ cross
    return out


def matrix(pose: Pose) -> Array:
    """Return a pose as a 4 x 4 matrix."""
    w, x, y, z = pose.quaternion_wxyz
    out = np.eye(4)
    out[:3, :3] = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    out[:3, 3] = pose.position_m
    return out
