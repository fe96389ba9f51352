"""What a robot or an end effector is: links, joints, shapes. The URDF in values."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum

from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.shapes import Shape

Joints = tuple[float, ...]
"""Positions of a robot's movable joints in their order; radians (metres if prismatic)."""


class JointKind(StrEnum):
    """The URDF joint types that are supported."""

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"
    FIXED = "fixed"


@dataclass(frozen=True, slots=True, kw_only=True)
class Link:
    """A rigid link.

    Attributes:
        shape: Convex envelope pieces in the link frame.
        mass_kg: 0 for frames without a body.
        com_m: Centre of mass in the link frame.
        inertia_kg_m2: ixx, ixy, ixz, iyy, iyz, izz about the centre of mass.
    """

    name: str
    shape: Shape = ()
    mass_kg: float = 0.0
    com_m: Vector = (0.0, 0.0, 0.0)
    inertia_kg_m2: tuple[float, ...] = (0.0,) * 6


@dataclass(frozen=True, slots=True, kw_only=True)
class Joint:
    """A joint; limits are those of the URDF.

    Attributes:
        parent_T_joint: Frame of the joint (= of the child link at zero) in the parent link.
        axis: Unit axis in the joint frame.
        velocity_rad_s: Largest speed (m/s if prismatic).
    """

    name: str
    kind: JointKind
    parent: str
    child: str
    parent_T_joint: Pose = field(default_factory=Pose)
    axis: Vector = (1.0, 0.0, 0.0)
    lower_rad: float = 0.0
    upper_rad: float = 0.0
    velocity_rad_s: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Description:
    """A serial robot, or an end effector with its fingers.

    Attributes:
        joints: From the root outwards; the movable ones in this order are `Joints`.
        root: Name of the root link (``base_link``; for an end effector ``mount``).
        tip: Name of the tip frame (``tool0``; for an end effector ``tcp``, z = working direction).
        payload_kg: What a robot may carry at its flange, end effector included; 0 = not stated.
        urdf: Path of the URDF that it was read from, for engines that want the file.
    """

    name: str
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    root: str
    tip: str
    payload_kg: float = 0.0
    urdf: str = ""

    @property
    def movable_joints(self) -> tuple[Joint, ...]:
        """Joints that can move, from the root outwards."""
        return tuple(j for j in self.joints if j.kind is not JointKind.FIXED)
