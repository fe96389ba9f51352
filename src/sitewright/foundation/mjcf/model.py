"""What a MuJoCo model is made of, as values; `text` writes them down."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum

from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.shapes import ConvexPart


class Freedom(StrEnum):
    """How a body may move relative to its parent."""

    HINGE = "hinge"
    SLIDE = "slide"
    FREE = "free"


@dataclass(frozen=True, slots=True, kw_only=True)
class Inertial:
    """Mass properties that do not come from the shape.

    Attributes:
        com_m: Centre of mass in the body frame.
        inertia_kg_m2: ixx, ixy, ixz, iyy, iyz, izz about the centre of mass, body axes.
    """

    mass_kg: float
    com_m: Vector
    inertia_kg_m2: tuple[float, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """A joint between a body and its parent, at the body's origin.

    Attributes:
        direction: Unit axis in the body frame; ignored for a free body.
        limits: Lower and upper position, rad or m; None = no limit.
    """

    name: str
    freedom: Freedom
    direction: Vector = (0.0, 0.0, 1.0)
    limits: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Solid:
    """A body of the simulation with all that hangs on it.

    Attributes:
        parent_T_body: Pose in the parent body at joint position zero.
        shape: Convex pieces in the body frame; they collide.
        inertial: Mass properties; None = from shape and density.
        density_kg_m3: Used only without `inertial`.
        axis: How it moves; None = fixed to its parent.
        is_weightless: Gravity is balanced, as a robot controller does for its own arm.
        friction: Sliding friction; a contact takes the larger of two.
    """

    name: str
    parent_T_body: Pose = field(default_factory=Pose)
    shape: tuple[ConvexPart, ...] = ()
    inertial: Inertial | None = None
    density_kg_m3: float = 0.0
    axis: Axis | None = None
    is_weightless: bool = False
    friction: float = 0.6
    children: tuple[Solid, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Weld:
    """Two bodies held together, as by a grip or a nail."""

    name: str
    body: str
    other: str
    body_T_other: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class Servo:
    """A position drive on a joint.

    Attributes:
        stiffness: Force per position error, N m/rad or N/m; it is critically damped.
        force_limit: Largest force, N m or N; 0 = none.
    """

    joint: str
    stiffness: float
    force_limit: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class MjcfModel:
    """A whole simulation.

    Attributes:
        excluded: Pairs of body names that never collide.
        coupled: Pairs of joints that always have the same position.
        step_s: Time step.
    """

    name: str
    solids: tuple[Solid, ...]
    servos: tuple[Servo, ...] = ()
    welds: tuple[Weld, ...] = ()
    excluded: tuple[tuple[str, str], ...] = ()
    coupled: tuple[tuple[str, str], ...] = ()
    step_s: float = 0.002
