"""Arms as URDF text: random ones with a spherical wrist, and well-known kinds without."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sitewright.foundation.pose import Pose, Vector, from_axis_angle, rotation, translation
from sitewright.robot_team.description import Description, Joint, JointKind, Link

_X, _Y, _Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@dataclass(frozen=True, slots=True)
class Step:
    """A joint of a chain: its frame in the one before, and its axis there."""

    frame: Pose
    axis: Vector
    kind: JointKind = JointKind.REVOLUTE
    limits: tuple[float, float] = (-math.pi, math.pi)


def chain(name: str, steps: Sequence[Step], tip: Pose) -> Description:
    names = ["base_link", *(f"link_{k}" for k in range(1, len(steps) + 1))]
    joints = [
        Joint(
            name=f"joint_{k + 1}",
            kind=s.kind,
            parent=names[k],
            child=names[k + 1],
            parent_T_joint=s.frame,
            axis=s.axis,
            lower_rad=s.limits[0],
            upper_rad=s.limits[1],
            velocity_rad_s=2.0,
        )
        for k, s in enumerate(steps)
    ]
    flange = Joint(
        name="flange", kind=JointKind.FIXED, parent=names[-1], child="tool0", parent_T_joint=tip
    )
    return Description(
        name=name,
        links=tuple(Link(name=n) for n in (*names, "tool0")),
        joints=(*joints, flange),
        root="base_link",
        tip="tool0",
        payload_kg=10.0,
    )


def random_opw(seed: int) -> Description:
    """A 6R arm with spherical wrist, its frames turned and shifted as no maker would."""
    random = np.random.default_rng(seed)
    a1, a2, b = random.uniform(-0.4, 0.4, 3)
    c1, c2, c3, c4 = random.uniform(0.2, 1.2, 4)
    places = [
        (0.0, 0.0, 0.0),
        (a1, b, c1),
        (0.0, 0.0, c2),
        (a2, 0.0, 0.0),
        (0.0, 0.0, c3),
        (0.0, 0.0, 0.0),
    ]
    axes = [_Z, _Y, _Y, _Z, _Y, _Z]
    upright = [
        (translation(*map(float, place)), axis) for place, axis in zip(places, axes, strict=True)
    ]
    steps, before = [], random_pose(random).inverse()
    for frame, axis in upright:
        sign = -1.0 if random.random() < 0.5 else 1.0
        turned = rotation(axis, float(random.uniform(-math.pi, math.pi)))
        along = translation(*(float(random.uniform(-0.3, 0.3)) * x for x in axis))
        gauge = turned @ along @ Pose(quaternion_wxyz=random_pose(random).quaternion_wxyz)
        own_axis = gauge.inverse().turn(axis)
        x, y, z = (sign * c for c in own_axis)
        steps.append(Step(before.inverse() @ frame @ gauge, (x, y, z)))
        before = gauge
    flange = before.inverse() @ translation(0.0, 0.0, float(c4)) @ random_pose(random)
    return chain(f"opw-{seed}", steps, flange)


def random_pose(random: np.random.Generator) -> Pose:
    x, y, z = random.normal(size=3).tolist()
    length = math.hypot(x, y, z)
    turn = from_axis_angle((x / length, y / length, z / length), float(random.uniform(0, 3)))
    px, py, pz = random.uniform(-0.5, 0.5, 3).tolist()
    return Pose((px, py, pz), turn)


def ur_like() -> Description:
    """Six joints, the last three axes do not meet (lengths of the class of a UR10e)."""
    full = (-2 * math.pi, 2 * math.pi)
    steps = [
        Step(translation(0.0, 0.0, 0.181), _Z, limits=full),
        Step(translation(0.0, 0.176, 0.0), _Y, limits=full),
        Step(translation(0.613, -0.137, 0.0), _Y, limits=full),
        Step(translation(0.572, 0.0, 0.0), _Y, limits=full),
        Step(translation(0.0, 0.135, 0.0), _Z, limits=full),
        Step(translation(0.0, 0.0, 0.120), _Y, limits=full),
    ]
    return chain("ur-like", steps, translation(0.0, 0.117, 0.0) @ rotation(_X, -math.pi / 2.0))


def seven_axes() -> Description:
    """Seven turning joints, alternately along and across the arm."""
    lengths = (0.36, 0.0, 0.42, 0.0, 0.40, 0.0, 0.0)
    axes = (_Z, _Y, _Z, _Y, _Z, _Y, _Z)
    steps = [
        Step(translation(0.0, 0.0, h), a, limits=(-2.1, 2.1))
        for h, a in zip(lengths, axes, strict=True)
    ]
    return chain("seven-axes", steps, translation(0.0, 0.0, 0.15))


def urdf_text(description: Description) -> str:
    """Return the arm as URDF, for engines that read it themselves."""
    rows = [f'<link name="{link.name}"/>' for link in description.links]
    for joint in description.joints:
        rpy = " ".join(map(repr, roll_pitch_yaw(joint.parent_T_joint)))
        xyz = " ".join(map(repr, map(float, joint.parent_T_joint.position_m)))
        axis = " ".join(map(repr, map(float, joint.axis)))
        rows.append(
            f'<joint name="{joint.name}" type="{joint.kind.value}">'
            f'<parent link="{joint.parent}"/><child link="{joint.child}"/>'
            f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>'
            f'<limit lower="{joint.lower_rad}" upper="{joint.upper_rad}" velocity="2" effort="1"/>'
            "</joint>"
        )
    return f'<robot name="{description.name}">{"".join(rows)}</robot>'


def roll_pitch_yaw(pose: Pose) -> tuple[float, float, float]:
    (r00, _, _, _), (r10, _, _, _), (r20, r21, r22, _), _ = pose.matrix()
    return (
        math.atan2(r21, r22),
        math.atan2(-r20, math.hypot(r00, r10)),
        math.atan2(r10, r00),
    )
