"""Joint values of a cell file: degrees or radians where a joint turns, metres where it slides."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sitewright.robot_team.description import Description, Joint, JointKind, Joints

Values = Sequence[float] | None


def joint_values(description: Description, in_deg: Values, in_rad: Values) -> Joints:
    """Return values by joint in SI units; sliding joints have theirs in metres in both lists.

    A list of another length than the joints is converted as far as it goes.
    """
    if in_deg is None:
        return tuple(in_rad or ())
    joints = description.movable_joints
    turns = [j.kind is not JointKind.PRISMATIC for j in joints] + [True] * len(in_deg)
    return tuple(math.radians(v) if t else v for v, t in zip(in_deg, turns, strict=False))


def posture_faults(description: Description, name: str, q: Joints) -> Iterator[tuple[str, str]]:
    """Yield what is wrong with a posture, and what to do."""
    joints = description.movable_joints
    if len(q) != len(joints):
        names = ", ".join(j.name for j in joints)
        message = f"{name} has {len(q)} values for {len(joints)} joints."
        yield message, f"State one per joint: {names}."
        return
    for joint, value in zip(joints, q, strict=True):
        if not joint.lower_rad <= value <= joint.upper_rad:
            low, high, at = (_shown(joint, v) for v in (joint.lower_rad, joint.upper_rad, value))
            unit = "m" if joint.kind is JointKind.PRISMATIC else "deg"
            message = f"{name}: joint {joint.name} at {at} {unit} is outside its limits "
            yield f"{message}{low} .. {high}.", "Stay inside them."


def _shown(joint: Joint, value: float) -> str:
    if joint.kind is JointKind.PRISMATIC:
        return f"{value:.3f}"
    return f"{math.degrees(value):.1f}"
