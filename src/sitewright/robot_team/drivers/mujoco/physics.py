"""MuJoCo behind names: compile, step, read poses, and go on after a change of what holds what."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitewright.errors import BackendError
from sitewright.foundation.mjcf.model import MjcfModel
from sitewright.foundation.mjcf.text import mjcf_text
from sitewright.foundation.pose import Pose, Vector

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Motion:
    """Positions and speeds by joint name, drive targets, and the clock.

    Attributes:
        position: Joint positions; seven numbers (m, quaternion wxyz) for a free piece.
        velocity: Joint speeds; six numbers for a free piece.
        target: Where each drive is sent.
    """

    time_s: float = 0.0
    position: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    velocity: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    target: Mapping[str, float] = field(default_factory=dict)


class Physics:
    """One compiled model with its state.

    Attributes:
        m: The compiled model.
        d: Its state; both are replaced by `rebuild`.
    """

    def __init__(self, model: MjcfModel, motion: Motion) -> None:
        self._compile(model)
        self.restore(motion)

    def rebuild(self, model: MjcfModel) -> None:
        """Compile a changed model and go on from the present positions and speeds."""
        before = self.motion()
        self._compile(model)
        self.restore(before)

    def _compile(self, model: MjcfModel) -> None:
        try:
            self.m = mujoco.MjModel.from_xml_string(mjcf_text(model))
        except ValueError as error:
            raise BackendError(f"MuJoCo cannot build the cell: {error}") from error
        self.d = mujoco.MjData(self.m)
        names = [self.m.body(i).name for i in range(self.m.nbody)]
        self.body_names: tuple[str, ...] = tuple(names)
        self._body_number = {name: i for i, name in enumerate(names)}
        self.joints = {self.m.joint(i).name: i for i in range(self.m.njnt)}
        self.drives = {self.m.actuator(i).name: i for i in range(self.m.nu)}

    def motion(self) -> Motion:
        """Return the present positions, speeds, targets and time by name."""
        return Motion(
            time_s=float(self.d.time),
            position={n: tuple(self.d.qpos[self._q(i)].tolist()) for n, i in self.joints.items()},
            velocity={n: tuple(self.d.qvel[self._v(i)].tolist()) for n, i in self.joints.items()},
            target={n: float(self.d.ctrl[i]) for n, i in self.drives.items()},
        )

    def restore(self, motion: Motion) -> None:
        """Set what a motion knows; joints that it does not know stay where the model puts them."""
        self.d.time = motion.time_s
        for name, number in self.joints.items():
            if name in motion.position:
                self.d.qpos[self._q(number)] = motion.position[name]
                self.d.qvel[self._v(number)] = motion.velocity.get(name, 0.0)
        for name, number in self.drives.items():
            here = self.d.qpos[self._q(self.joints[name])][0]
            self.d.ctrl[number] = motion.target.get(name, here)
        mujoco.mj_forward(self.m, self.d)

    def _q(self, joint: int) -> slice:
        start = int(self.m.jnt_qposadr[joint])
        return slice(start, start + (7 if self._is_free(joint) else 1))

    def _v(self, joint: int) -> slice:
        start = int(self.m.jnt_dofadr[joint])
        return slice(start, start + (6 if self._is_free(joint) else 1))

    def _is_free(self, joint: int) -> bool:
        return bool(self.m.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE)

    def refresh(self) -> None:
        """Bring poses and contacts up to the present joint positions."""
        mujoco.mj_forward(self.m, self.d)

    def body(self, name: str) -> int:
        """Return the number of a body; an unknown name is a KeyError."""
        return self._body_number[name]

    def has_body(self, name: str) -> bool:
        """Tell whether there is a body of that name."""
        return name in self._body_number

    def pose(self, name: str) -> Pose:
        """Return the world pose of a body."""
        number = self.body(name)
        position, quaternion = self.d.xpos[number].tolist(), self.d.xquat[number].tolist()
        return Pose(tuple(position), tuple(quaternion))

    def joint_numbers(self, names: Sequence[str]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Return the addresses of one-number joints in positions and in speeds."""
        numbers = [self.joints[n] for n in names]
        return (
            np.array([self.m.jnt_qposadr[i] for i in numbers], dtype=np.int64),
            np.array([self.m.jnt_dofadr[i] for i in numbers], dtype=np.int64),
        )

    def geoms(self, body: str) -> range:
        """Return the numbers of a body's collision shapes."""
        start = int(self.m.body_geomadr[self.body(body)])
        return range(start, start + int(self.m.body_geomnum[self.body(body)]))

    def gap_m(self, first: str, second: str, limit_m: float) -> float:
        """Return the distance of two bodies, negative inside each other, or at most `limit_m`."""
        return min(
            (
                mujoco.mj_geomDistance(self.m, self.d, a, b, limit_m, None)
                for a in self.geoms(first)
                for b in self.geoms(second)
            ),
            default=limit_m,
        )

    def touching(self, first: Iterable[str], second: str) -> set[str]:
        """Return which of the first bodies are in contact with the second."""
        other = self.body(second)
        wanted = {self.body(name): name for name in first}
        pairs = self.m.geom_bodyid[self.d.contact.geom] if self.d.ncon else ()
        found: set[str] = set()
        for a, b in pairs:
            if other in (a, b):
                found |= {wanted[x] for x in (int(a), int(b)) if x in wanted}
        return found

    def stretch_m(self, body: str, direction: Vector, tip: Vector) -> list[tuple[float, float]]:
        """Return where a ray from `tip` runs inside a body, as intervals of its length.

        Args:
            body: The body that is hit or not.
            direction: Unit vector of the ray in the world.
            tip: Start of the ray in the world.
        """
        return sorted(
            interval
            for geom in self.geoms(body)
            if (interval := self._inside(geom, np.array(tip), np.array(direction))) is not None
        )

    def _inside(self, geom: int, tip: Array, direction: Array) -> tuple[float, float] | None:
        """Where a line enters and leaves one convex shape: seen from outside, both ways."""
        far = 100.0
        there = self._hit(geom, tip - far * direction, direction)
        back = self._hit(geom, tip + far * direction, -direction)
        if there < 0.0 or back < 0.0:
            return None
        return there - far, far - back

    def _hit(self, geom: int, start: Array, direction: Array) -> float:
        if self.m.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH:
            return float(mujoco.mj_rayMesh(self.m, self.d, geom, start, direction))
        return float(
            mujoco.mju_rayGeom(
                self.d.geom_xpos[geom],
                self.d.geom_xmat[geom],
                self.m.geom_size[geom],
                start,
                direction,
                self.m.geom_type[geom],
            )
        )
