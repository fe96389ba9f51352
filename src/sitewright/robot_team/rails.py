"""Puts an arm on a track or gantry: one sliding joint per rail before its own joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from sitewright.errors import TeamError
from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.shapes import Shape
from sitewright.robot_team.description import Description, Joint, JointKind, Link

TRACK = "track"
"""Name of the root link of an arm on rails; it is fixed to the ground and has no shape."""
_GYRATION_M2 = 0.2
"""A carriage never turns; any moment of inertia serves a simulation."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rail:
    """A straight guide with a driven carriage.

    Attributes:
        axis: Unit vector of its positive direction, in the frame of the carriage before it (of
            the robot's base for the first).
        travel_m: Lowest and highest position of its carriage.
        speed_m_s: Largest speed.
        carriage: Convex pieces that move with it, in the carriage's frame.
        mass_kg: Of the carriage.
    """

    axis: Vector
    travel_m: tuple[float, float]
    speed_m_s: float
    carriage: Shape = ()
    mass_kg: float = 400.0


def on_rails(arm: Description, rails: Sequence[Rail], carriage_T_base: Pose) -> Description:
    """Return the arm with rails under it; joints ``rail_1`` .. come before the arm's own.

    Args:
        arm: A link called ``track`` or ``carriage_<n>`` is a TeamError.
        rails: From the ground outwards.
        carriage_T_base: Where the arm's root is fixed on the last carriage.
    """
    names = [TRACK, *(f"carriage_{k}" for k in range(1, len(rails) + 1))]
    if taken := sorted({link.name for link in arm.links} & set(names)):
        raise TeamError(
            f"{arm.name} has links called {', '.join(taken)}, as its rails have. Rename them in "
            "the URDF, or leave out the rails if it brings its own."
        )
    slides = [
        Joint(
            name=f"rail_{k}",
            kind=JointKind.PRISMATIC,
            parent=names[k - 1],
            child=names[k],
            axis=rail.axis,
            lower_rad=rail.travel_m[0],
            upper_rad=rail.travel_m[1],
            velocity_rad_s=rail.speed_m_s,
        )
        for k, rail in enumerate(rails, start=1)
    ]
    foot = Joint(
        name="rail_foot",
        kind=JointKind.FIXED,
        parent=names[-1],
        child=arm.root,
        parent_T_joint=carriage_T_base,
    )
    carriages = [_carriage(name, rail) for name, rail in zip(names[1:], rails, strict=True)]
    return replace(
        arm,
        name=f"{arm.name} on rails",
        links=(Link(name=TRACK), *carriages, *arm.links),
        joints=(*slides, foot, *arm.joints),
        root=TRACK,
        urdf="",
    )


def _carriage(name: str, rail: Rail) -> Link:
    moment = rail.mass_kg * _GYRATION_M2
    return Link(
        name=name,
        shape=rail.carriage,
        mass_kg=rail.mass_kg,
        inertia_kg_m2=(moment, 0.0, 0.0, moment, 0.0, moment),
    )
