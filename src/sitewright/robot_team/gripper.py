"""The shape of an end effector in the frame of its mount, with its fingers where they are."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape, moved
from sitewright.robot_team.description import Description, Joint, JointKind
from sitewright.robot_team.kinematics import link_poses, tip_pose

_SLACK_M = 1e-6
"""An aperture may miss the fingers' travel by this much, so that sensed values pass."""


def finger_parts(description: Description, aperture_m: float) -> dict[str, Shape]:
    """Return each finger's shape in the mount frame, by name (``left``, ``right``).

    Args:
        description: An end effector; one without prismatic joints has no fingers.
        aperture_m: Distance between the pads; a value beyond the fingers' travel is a ValueError.
    """
    shapes, poses = finger_shapes(description), mount_T_fingers(description, aperture_m)
    return {name: moved(shape, poses[name]) for name, shape in shapes.items()}


@lru_cache(maxsize=64)
def finger_shapes(description: Description) -> Mapping[str, Shape]:
    """Return each finger's shape in the finger's own frame, which moves with the finger."""
    mount_T_link = _opened(description, 0.0)
    shapes: dict[str, Shape] = {}
    for joint in _fingers(description):
        finger_T_mount = mount_T_link[joint.child].inverse()
        finger_T_link = {link: finger_T_mount @ pose for link, pose in mount_T_link.items()}
        shapes[_name(joint)] = _shape_of(description, joint.child, finger_T_link)
    return shapes


@lru_cache(maxsize=256)
def mount_T_fingers(description: Description, aperture_m: float) -> Mapping[str, Pose]:
    """Return where the fingers are in the mount frame; see `finger_parts`."""
    mount_T_link = _opened(description, aperture_m)
    return {_name(joint): mount_T_link[joint.child] for joint in _fingers(description)}


@lru_cache(maxsize=64)
def palm_shape(description: Description) -> Shape:
    """Return the shape of what does not move with a finger, in the mount frame."""
    return _shape_of(description, description.root, _opened(description, 0.0))


def shape_at(description: Description, aperture_m: float) -> Shape:
    """Return the whole end effector in the mount frame; a tool ignores the aperture."""
    fingers = finger_parts(description, aperture_m)
    return sum(fingers.values(), start=palm_shape(description))


@lru_cache(maxsize=64)
def mount_T_tcp(description: Description) -> Pose:
    """Return the tip frame in the mount frame; a gripper's does not move with its fingers."""
    return tip_pose(description, (0.0,) * len(description.movable_joints))


def _fingers(description: Description) -> list[Joint]:
    return [j for j in description.joints if j.kind is JointKind.PRISMATIC]


def _name(finger: Joint) -> str:
    return finger.name.removeprefix("finger_")


def _opened(description: Description, aperture_m: float) -> dict[str, Pose]:
    for joint in _fingers(description):
        if not joint.lower_rad - _SLACK_M <= aperture_m / 2.0 <= joint.upper_rad + _SLACK_M:
            raise ValueError(
                f"{description.name} opens from {2.0 * joint.lower_rad:.3f} to "
                f"{2.0 * joint.upper_rad:.3f} m, not {aperture_m:.3f} m"
            )
    q = tuple(
        aperture_m / 2.0 if j.kind is JointKind.PRISMATIC else 0.0
        for j in description.movable_joints
    )
    return link_poses(description, q)


def _shape_of(description: Description, first: str, frame_T_link: dict[str, Pose]) -> Shape:
    """Return the shapes of a link and of all that is fixed to it, in one frame."""
    rigid = {first}
    for joint in description.joints:
        if joint.kind is JointKind.FIXED and joint.parent in rigid:
            rigid.add(joint.child)
    return tuple(
        part
        for link in description.links
        if link.name in rigid
        for part in moved(link.shape, frame_T_link[link.name])
    )
