"""All parts of a scene for pinocchio: joints, geometry, and which pairs of parts are looked at."""

from __future__ import annotations

from typing import Any

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.kinematic_chain import BASE, Array, KinematicChain
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.proof_scene import ProofScene

_UNIVERSE = 0


class SearchModel:
    """Robots and parts as one model; a part's number is its row in the layout.

    Pinocchio keeps a tree of enclosing boxes, so that a check costs little more with many parts.

    Attributes:
        columns_of: Where each robot's joints stand in a posture of all joints.
    """

    def __init__(self, proof: ProofScene, margin_m: float) -> None:
        import pinocchio

        self._pin: Any = pinocchio
        layout = proof.layout
        self._model: Any = pinocchio.Model()
        self.columns_of: dict[RobotId, Indices] = {}
        self._tips: dict[RobotId, int] = {}
        carrier = np.full(len(layout.parts), _UNIVERSE)
        poses = proof.world_T_part.copy()
        for robot, arm in layout.arms.items():
            joints = self._add_arm(robot, arm.chain, proof.world_T_base[robot])
            rows, joint = layout.rows_of[robot], layout.joints_of[robot]
            is_moved = joint != BASE
            carrier[rows[is_moved]] = joints[joint[is_moved]]
            poses[rows[is_moved]] = layout.joint_T_part_of[robot][is_moved]
        self._still = np.flatnonzero(carrier == _UNIVERSE)
        self._data: Any = self._model.createData()
        self._geometry: Any = pinocchio.GeometryModel()
        for k, part in enumerate(layout.parts):
            self._geometry.addGeometryObject(
                pinocchio.GeometryObject(
                    str(k), int(carrier[k]), self._se3(poses[k]), part.geometry
                )
            )
        counted = np.zeros((len(layout.parts),) * 2, dtype=np.bool_)
        for table in layout.pairs_of.values():
            counted[np.minimum(table.a, table.b), np.maximum(table.a, table.b)] = True
        self._geometry.setCollisionPairs(counted)
        self._placed: Any = pinocchio.GeometryData(self._geometry)
        for request in self._placed.collisionRequests:
            request.security_margin = margin_m
        self._number_of_pair = np.array(self._geometry.collisionPairMapping)
        self._tree: Any = pinocchio.BroadPhaseManager_DynamicAABBTreeCollisionManager(
            self._model, self._geometry, self._placed
        )

    def place(self, world_T_part: Array) -> None:
        """Put everything that no joint moves where it is now."""
        for k in self._still.tolist():
            self._geometry.geometryObjects[k].placement = self._se3(world_T_part[k])

    def look_at(self, a: Indices, b: Indices) -> None:
        """Look from now on at exactly these pairs of parts."""
        wanted = np.zeros((self._geometry.ngeoms,) * 2, dtype=np.bool_)
        wanted[np.minimum(a, b), np.maximum(a, b)] = True
        self._placed.setActiveCollisionPairs(self._geometry, wanted)

    def set_margins(self, a: Indices, b: Indices, margin_m: Array) -> None:
        """Let pairs of parts come as near as this; never further than the model's own margin."""
        numbers = self._number_of_pair[np.minimum(a, b), np.maximum(a, b)]
        for number, margin in zip(numbers.tolist(), margin_m.tolist(), strict=True):
            self._placed.collisionRequests[number].security_margin = margin

    def is_hit(self, q: Array) -> bool:
        """Tell whether any pair is nearer than the margin in a posture of all joints."""
        found = self._pin.computeCollisions(self._model, self._data, self._tree, q, True)  # noqa: FBT003
        return bool(found)

    def tip(self, robot: RobotId, q: Array) -> Array:
        """Return a robot's tip frame in the world, 4 x 4."""
        self._pin.forwardKinematics(self._model, self._data, q)
        frame = self._pin.updateFramePlacement(self._model, self._data, self._tips[robot])
        return np.asarray(frame.homogeneous)

    def tip_rates(self, robot: RobotId, q: Array) -> Array:
        """Return how the tip moves and turns in the world per joint of its robot, 6 x joints."""
        rates = self._pin.computeFrameJacobian(
            self._model, self._data, q, self._tips[robot], self._pin.LOCAL_WORLD_ALIGNED
        )
        return np.asarray(rates[:, self.columns_of[robot]])

    def _add_arm(self, robot: RobotId, chain: KinematicChain, world_T_base: Array) -> Indices:
        """Add a robot's joints; return their numbers."""
        first, parent = self._model.nq, _UNIVERSE
        numbers: list[int] = []
        for i in range(chain.joints):
            parent_T_joint = chain.carrier_T_joint[i]
            if i == 0:
                parent_T_joint = world_T_base @ parent_T_joint
            kind = (
                self._pin.JointModelPrismaticUnaligned
                if chain.is_prismatic[i]
                else self._pin.JointModelRevoluteUnaligned
            )
            parent = self._model.addJoint(
                parent, kind(chain.axes[i]), self._se3(parent_T_joint), f"{robot}/{i}"
            )
            numbers.append(parent)
        self.columns_of[robot] = np.arange(first, self._model.nq)
        joint, joint_T_tip = chain.carrier_by_link[chain.tip]
        frame = self._pin.Frame(
            f"{robot}/tip", numbers[joint], 0, self._se3(joint_T_tip), self._pin.FrameType.OP_FRAME
        )
        self._tips[robot] = self._model.addFrame(frame)
        return np.array(numbers, dtype=np.intp)

    def _se3(self, frame: Array) -> Any:  # noqa: ANN401 - pinocchio's pose
        return self._pin.SE3(np.ascontiguousarray(frame[:3, :3]), frame[:3, 3])
