"""A serial arm in arrays: forward kinematics of many postures at once."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from sitewright.errors import TeamError
from sitewright.foundation.pose import Pose
from sitewright.robot_team.description import Description, Joint, JointKind

Array = npt.NDArray[np.float64]
BASE = -1
"""Number of the frame that no joint moves."""
TURN = 2.0 * math.pi


@dataclass(frozen=True, slots=True, eq=False)
class KinematicChain:
    """Constants of a serial arm.

    Attributes:
        carrier_T_joint: n x 4 x 4; each joint's zero frame in the frame of the joint before it,
            the first one in the base.
        axes: n x 3, in the joint's own frame.
        spins: n x 3 x 3; the axes as matrices of the vector product.
        is_prismatic: One flag per joint.
        lower, upper: Limits of the joints, radians or metres.
        carrier_by_link: For every link the number of the joint that moves it (`BASE` = none)
            and its fixed pose in that joint's frame.
        tip: Link at the end.
    """

    carrier_T_joint: Array
    axes: Array
    spins: Array
    is_prismatic: npt.NDArray[np.bool_]
    lower: Array
    upper: Array
    carrier_by_link: Mapping[str, tuple[int, Array]]
    tip: str
    _once: Array = field(init=False, repr=False)
    _twice: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        # a joint's frame is its zero frame + f `_once` + g `_twice`: f = sin q and g = 1 - cos q
        # where it turns, f = q and g = 0 where it slides
        once, twice = np.zeros((2, self.joints, 4, 4))
        turns = ~self.is_prismatic
        once[turns, :3, :3] = self.spins[turns]
        once[~turns, :3, 3] = self.axes[~turns]
        twice[turns, :3, :3] = self.spins[turns] @ self.spins[turns]
        object.__setattr__(self, "_once", self.carrier_T_joint @ once)
        object.__setattr__(self, "_twice", self.carrier_T_joint @ twice)

    @property
    def joints(self) -> int:
        """How many joints can move."""
        return len(self.axes)

    def frames(self, q: Array) -> Array:
        """Return base_T_joint of every joint, behind its motion.

        Args:
            q: m x n positions.

        Returns:
            m x (n + 1) x 4 x 4; the last entry is the base itself, so that `BASE` finds it.
        """
        once = np.where(self.is_prismatic, q, np.sin(q))[..., None, None]
        twice = np.where(self.is_prismatic, 0.0, 1.0 - np.cos(q))[..., None, None]
        local = self.carrier_T_joint + once * self._once + twice * self._twice
        out = np.empty((len(q), self.joints + 1, 4, 4))
        out[:, BASE] = np.eye(4)
        before = out[:, BASE]
        for i in range(self.joints):
            np.matmul(before, local[:, i], out=out[:, i])
            before = out[:, i]
        return out

    def tips(self, q: Array) -> Array:
        """Return base_T_tip of every posture, m x 4 x 4."""
        joint, joint_T_tip = self.carrier_by_link[self.tip]
        return np.asarray(self.frames(q)[:, joint] @ joint_T_tip)


def cross_matrices(axes: Array) -> Array:
    """Return, for every row, the matrix that takes the vector product with it from the left."""
    x, y, z = axes.T
    out = np.zeros((len(axes), 3, 3))
    out[:, 0, 1], out[:, 0, 2], out[:, 1, 2] = -z, y, -x
    return out - out.transpose(0, 2, 1)


def matrix_of(pose: Pose) -> Array:
    """Return a pose as a 4 x 4 array; the quaternion is brought to length one first.

    A rotation that is scaled by only 1e-6 makes the closed form lose half of its solutions.
    """
    w, x, y, z = pose.quaternion_wxyz
    px, py, pz = pose.position_m
    s = 2.0 / (w * w + x * x + y * y + z * z)
    return np.array(
        (
            (1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), px),
            (s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x), py),
            (s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y), pz),
            (0.0, 0.0, 0.0, 1.0),
        )
    )


def pose_of(matrix: Array) -> Pose:
    """Return a 4 x 4 array as a pose."""
    return Pose.from_matrix(tuple(tuple(float(v) for v in row) for row in matrix))


def chain_of(description: Description) -> KinematicChain:
    """Compile a description; an arm that branches between its joints is a TeamError."""
    carrier: dict[str, tuple[int, Array]] = {description.root: (BASE, np.eye(4))}
    frames: list[Array] = []
    for joint in description.joints:
        number, joint_T_parent = carrier[joint.parent]
        frame = joint_T_parent @ matrix_of(joint.parent_T_joint)
        if joint.kind is JointKind.FIXED:
            carrier[joint.child] = (number, frame)
            continue
        _require_serial(description, joint, carried_by=number, expected=len(frames) - 1)
        carrier[joint.child] = (len(frames), np.eye(4))
        frames.append(frame)
    movable = description.movable_joints
    axes = np.array([j.axis for j in movable], dtype=np.float64).reshape(-1, 3)
    return KinematicChain(
        carrier_T_joint=np.array(frames).reshape(-1, 4, 4),
        axes=axes,
        spins=cross_matrices(axes),
        is_prismatic=np.array([j.kind is JointKind.PRISMATIC for j in movable], dtype=np.bool_),
        lower=np.array([j.lower_rad for j in movable]),
        upper=np.array([j.upper_rad for j in movable]),
        carrier_by_link=carrier,
        tip=description.tip,
    )


def _require_serial(
    description: Description, joint: Joint, *, carried_by: int, expected: int
) -> None:
    if carried_by != expected:
        raise TeamError(
            f"{description.name}: joint {joint.name!r} does not follow the joint before it; only "
            "serial arms can be planned for."
        )
