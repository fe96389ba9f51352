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


Part = tuple[float, tuple[float, float, float], tuple[float, float, float]]
"""Mass in kg, size and middle of a box in m."""

_PARTS: dict[str, Part] = {
    "base_link": (120, (0.5, 0.5, 0.40), (0, 0, 0.20)),
    "shoulder": (80, (0.36, 0.5, 0.36), (0, 0.12, 0)),
    "upper": (90, (1.53, 0.26, 0.26), (0.675, 0, 0)),
    "fore": (60, (1.38, 0.20, 0.20), (0.62, 0, 0)),
    "wrist_1": (20, (0.18, 0.24, 0.2), (0, 0.10, 0)),
    "wrist_2": (15, (0.18, 0.18, 0.2), (0, 0, 0.1)),
    "wrist_3": (5, (0.16, 0.10, 0.16), (0, 0.165, 0)),
}
_LAST = [
    ("1.35 -0.30 0", "0 1 0"),
    ("1.25 0 0", "0 1 0"),
    ("0 0.26 0", "0 0 1"),
    ("0 0 0.228", "0 1 0"),
]


def offset_wrist_urdf() -> str:
    """A handler of 2.6 m whose wrist axes do not meet, with shapes and masses."""
    return _robot_text(_PARTS, [("0 0 0.70", "0 0 1"), ("0 0.33 0", "0 1 0"), *_LAST])


def seven_joint_urdf() -> str:
    """The same with its upper arm cut in two, which turn against each other."""
    parts = dict(list(_PARTS.items())[:2])
    parts["upper_a"] = (50, (0.60, 0.26, 0.26), (0.20, 0, 0))
    parts["upper_b"] = (45, (0.90, 0.24, 0.24), (0.50, 0, 0))
    parts |= dict(list(_PARTS.items())[3:])
    joints = [("0 0 0.70", "0 0 1"), ("0 0.33 0", "0 1 0"), ("0.5 0 0", "1 0 0")]
    return _robot_text(parts, [*joints, ("0.85 -0.30 0", "0 1 0"), *_LAST[1:]])


def _robot_text(parts: dict[str, Part], joints: list[tuple[str, str]]) -> str:
    names = list(parts)
    rows = [_link_text(name, *parts[name]) for name in names]
    rows += [
        f'<joint name="j{k + 1}" type="revolute"><origin xyz="{origin}"/>'
        f'<parent link="{names[k]}"/><child link="{names[k + 1]}"/><axis xyz="{axis}"/>'
        '<limit lower="-6.28" upper="6.28" velocity="2.0" effort="1"/></joint>'
        for k, (origin, axis) in enumerate(joints)
    ]
    rows.append(
        f'<link name="tool0"/><joint name="flange" type="fixed"><parent link="{names[-1]}"/>'
        f'<child link="tool0"/><origin xyz="0 0.222 0" rpy="{-math.pi / 2.0} 0 0"/></joint>'
    )
    return f'<robot name="own"><sitewright payload_kg="90"/>{"".join(rows)}</robot>'


def _link_text(
    name: str, mass: float, size: tuple[float, float, float], middle: tuple[float, float, float]
) -> str:
    x, y, z = (mass / 12.0 * (size[a] ** 2 + size[b] ** 2) for a, b in ((1, 2), (0, 2), (0, 1)))
    origin = f'<origin xyz="{" ".join(map(str, middle))}"/>'
    return (
        f'<link name="{name}"><inertial>{origin}<mass value="{mass}"/>'
        f'<inertia ixx="{x}" iyy="{y}" izz="{z}" ixy="0" ixz="0" iyz="0"/></inertial>'
        f'<collision>{origin}<geometry><box size="{" ".join(map(str, size))}"/></geometry>'
        "</collision></link>"
    )
