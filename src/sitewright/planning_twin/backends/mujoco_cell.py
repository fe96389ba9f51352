"""A snapshot as a MuJoCo model: only geometry, for the second opinion."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Box, Hull, Shape
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.layout import Layout
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.remembered import Remembered
from sitewright.planning_twin.scene import Attachment, Pair, SceneSnapshot, link_name, pair_of
from sitewright.robot_team.description import JointKind

_CELLS_REMEMBERED = 12
_MARGIN_RESERVE_M = 0.0002


class MujocoCell:
    """A compiled model for all snapshots that differ only in postures and places of still bodies.

    Every still body is a MuJoCo body of its own, because pairs are left out body by body.

    Attributes:
        layout: Parts and pairs of the proof; who carries what stays the same.
        model, data: MuJoCo's.
        name_by_body: Names as in pairs, by MuJoCo's body number.
        margin_m: Pairs nearer than this are reported.
    """

    def __init__(self, scene: SceneSnapshot, margin_m: float, layout: Layout) -> None:
        import mujoco

        self._mujoco: Any = mujoco
        self.margin_m = margin_m
        self.layout = layout
        writer = _SpecWriter(mujoco, margin_m / 2.0 + _MARGIN_RESERVE_M)
        writer.add(scene)
        writer.leave_out({name for table in layout.pairs_of.values() for name in table.names})
        self.model: Any = writer.spec.compile()
        self.data: Any = mujoco.MjData(self.model)
        self.name_by_body = {self.model.body(n).id: n for n in writer.names}
        self._body_by_name = {n: i for i, n in self.name_by_body.items()}
        self._address_of = {
            robot: [int(self.model.joint(j).qposadr[0]) for j in joints]
            for robot, joints in writer.joints_of.items()
        }
        self._standing: dict[RobotId, tuple[Indices, Indices]] = {}
        self._is_carried_by = {
            robot: np.array([writer.robot_of.get(n) == robot for n in self._names()])
            for robot in scene.robots
        }

    def place(self, scene: SceneSnapshot) -> None:
        """Put all still bodies and all robots where a snapshot has them."""
        for body in scene.bodies.values():
            if body.shape and not isinstance(body.placement, Attachment):
                number = self.model.body(body.id).id
                self.model.body_pos[number] = body.placement.position_m
                self.model.body_quat[number] = body.placement.quaternion_wxyz
        for robot, state in scene.robots.items():
            self.data.qpos[self._address_of[robot]] = state.q_rad

    def look_at(self, robot: RobotId | None) -> None:
        """Look from now on only at pairs that a robot's motion can change; None: at all pairs.

        MuJoCo looks at a pair if one side's type meets the other side's affinity.
        """
        carried = True if robot is None else self._is_carried_by[robot]
        self.model.body_contype[:] = carried
        self.model.geom_contype[:] = self.model.body_contype[self.model.geom_bodyid]

    def touching(self, robot: RobotId, q: Array) -> tuple[Array, Array] | None:
        """Return what is within the margin at a posture of one robot; None if nothing is.

        Returns:
            Body numbers, n x 2, and distances in metres, n.
        """
        self.data.qpos[self._address_of[robot]] = q
        self._mujoco.mj_kinematics(self.model, self.data)
        self._mujoco.mj_collision(self.model, self.data)
        if not self.data.ncon:
            return None
        contact = self.data.contact
        return self.model.geom_bodyid[contact.geom], np.array(contact.dist)

    def contacts(self, robot: RobotId, q: Array) -> Iterator[tuple[Pair, float]]:
        """Yield the pairs within the margin at a posture of one robot, and their distances."""
        found = self.touching(robot, q)
        if found is not None:
            for (a, b), distance_m in zip(*(f.tolist() for f in found), strict=True):
                yield self.pair(a, b), distance_m

    def _names(self) -> list[str]:
        return [self.name_by_body.get(n, "") for n in range(self.model.nbody)]

    def pair(self, a: int, b: int) -> Pair:
        """Return the names of two bodies."""
        return pair_of(self.name_by_body[a], self.name_by_body[b])

    def table(
        self, robot: RobotId, standing: float, otherwise: float, values: Mapping[Pair, float]
    ) -> Array:
        """Return a value for each pair of body numbers, n x n, symmetric.

        Args:
            robot: Whose motion the pairs are about.
            standing: Of pairs that count and that the robot does not change.
            otherwise: Of all others.
            values: Of some pairs, whatever they are.
        """
        table = np.full((self.model.nbody, self.model.nbody), otherwise)
        if robot not in self._standing:
            self._standing[robot] = self._numbers(self.layout.standing_of[robot].names)
        a, b = self._standing[robot]
        table[a, b] = table[b, a] = standing
        a, b = self._numbers(values)
        table[a, b] = table[b, a] = [v for p, v in values.items() if self._is_here(p)]
        return table

    def _numbers(self, pairs: Iterable[Pair]) -> tuple[Indices, Indices]:
        number = self._body_by_name
        here = [(number[a], number[b]) for a, b in pairs if self._is_here((a, b))]
        rows = np.array(here, dtype=np.intp).reshape(-1, 2)
        return rows[:, 0], rows[:, 1]

    def _is_here(self, pair: Pair) -> bool:
        return pair[0] in self._body_by_name and pair[1] in self._body_by_name


@dataclass(frozen=True, slots=True)
class _Mount:
    """A MuJoCo body, and the pose of a description's link in it."""

    body: Any
    body_T_link: Pose


class _SpecWriter:
    def __init__(self, mujoco: Any, margin_m: float) -> None:  # noqa: ANN401 - untyped library
        self._mujoco = mujoco
        self._margin_m = margin_m
        self.spec = mujoco.MjSpec()
        # pairs are left out one by one, on evidence, not because one is the other's parent
        self.spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_FILTERPARENT
        self.names: list[str] = []
        self.joints_of: dict[RobotId, list[str]] = {}
        self.robot_of: dict[str, RobotId] = {}

    def add(self, scene: SceneSnapshot) -> None:
        mounts = {robot: self._add_robot(scene, robot) for robot in scene.robots}
        for body in scene.bodies.values():
            if not body.shape:
                continue
            if isinstance(body.placement, Attachment):
                tip = mounts[body.placement.robot]
                self.robot_of[body.id] = body.placement.robot
                self._add_body(
                    tip.body, body.id, tip.body_T_link @ body.placement.tip_T_body, body.shape
                )
            else:
                self._add_body(self.spec.worldbody, body.id, body.placement, body.shape)

    def leave_out(self, counted: set[Pair]) -> None:
        """Leave out the pairs of one robot's things that the proof does not count."""
        for a, b in combinations(self.names, 2):
            robot = self.robot_of.get(a)
            if robot is not None and robot == self.robot_of.get(b) and pair_of(a, b) not in counted:
                self.spec.add_exclude(bodyname1=a, bodyname2=b)

    def _add_robot(self, scene: SceneSnapshot, robot: RobotId) -> _Mount:
        state = scene.robots[robot]
        shapes = {link.name: link.shape for link in state.description.links}
        joints = self.joints_of.setdefault(robot, [])

        def add_link(parent: Any, link: str, pose: Pose) -> Any:  # noqa: ANN401
            name = link_name(robot, link)
            self.robot_of[name] = robot
            return self._add_body(parent, name, pose, shapes[link])

        mount_of = {
            state.description.root: add_link(
                self.spec.worldbody, state.description.root, state.world_T_base
            )
        }
        for joint in state.description.joints:
            body = add_link(mount_of[joint.parent], joint.child, joint.parent_T_joint)
            mount_of[joint.child] = body
            if joint.kind is not JointKind.FIXED:
                name = f"{robot}/{joint.name}"
                joints.append(name)
                body.add_joint(name=name, type=self._joint_type(joint.kind), axis=joint.axis)
        return _Mount(mount_of[state.description.tip], Pose())

    def _joint_type(self, kind: JointKind) -> Any:  # noqa: ANN401
        types = self._mujoco.mjtJoint
        return types.mjJNT_SLIDE if kind is JointKind.PRISMATIC else types.mjJNT_HINGE

    def _add_body(self, parent: Any, name: str, parent_T_body: Pose, shape: Shape) -> Any:  # noqa: ANN401
        body = parent.add_body(
            name=name, pos=parent_T_body.position_m, quat=parent_T_body.quaternion_wxyz
        )
        # nothing moves by forces here; MuJoCo only wants every moving body to have a mass
        body.mass, body.inertia, body.explicitinertial = 1.0, (1.0, 1.0, 1.0), True
        self.names.append(name)
        for number, part in enumerate(shape):
            match part:
                case Box(size_m=size_m, body_T_box=body_T_box):
                    body.add_geom(
                        type=self._mujoco.mjtGeom.mjGEOM_BOX,
                        size=[s / 2.0 for s in size_m],
                        pos=body_T_box.position_m,
                        quat=body_T_box.quaternion_wxyz,
                        margin=self._margin_m,
                    )
                case Hull(points_m=points_m):
                    mesh = f"{name}#{number}"
                    self.spec.add_mesh(
                        name=mesh,
                        uservert=np.array(points_m, dtype=np.float64).ravel(),
                        inertia=self._mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX,
                    )
                    body.add_geom(
                        type=self._mujoco.mjtGeom.mjGEOM_MESH,
                        meshname=mesh,
                        margin=self._margin_m,
                    )
        return body


class MujocoCells:
    """Compiles snapshots; a model is used again while shapes and what is carried stay the same."""

    def __init__(self, proofs: ProofScenes) -> None:
        self._proofs = proofs
        self._cells: Remembered[MujocoCell] = Remembered(size=_CELLS_REMEMBERED)

    def of(self, scene: SceneSnapshot) -> MujocoCell:
        """Return the model with everything where the snapshot has it."""
        layout = self._proofs.of(scene).layout
        key = (scene.clearance_m, id(layout))  # the cell keeps its layout
        found = self._cells.of(key, lambda: MujocoCell(scene, scene.clearance_m, layout))
        found.place(scene)
        return found
