"""The proof scene: unpadded convex parts of a snapshot, who carries them, which pairs count."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import count
from typing import cast

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.backends.arm_model import ArmModel, arm_model
from sitewright.planning_twin.backends.convex_part import compiled
from sitewright.planning_twin.backends.identity_cache import IdentityCache
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.layout import Layout, attachment, laid_out
from sitewright.planning_twin.backends.placed_parts import PlacedParts
from sitewright.planning_twin.backends.remembered import Remembered
from sitewright.planning_twin.backends.surroundings import SceneParts, Surroundings
from sitewright.planning_twin.scene import Body, SceneSnapshot
from sitewright.robot_team.description import Description

_ARMS_REMEMBERED = 16
_LAYOUTS_REMEMBERED = 64
_SCENES_REMEMBERED = 96
_SHAPES_REMEMBERED = 4096


@dataclass(frozen=True, slots=True, eq=False)
class ProofScene:
    """A layout with all parts placed.

    Attributes:
        world_T_part: n x 4 x 4, robots at the postures of the snapshot.
        clearance_m: Distance of undeclared pairs.
    """

    layout: Layout
    world_T_base: Mapping[RobotId, Array]
    world_T_part: Array
    clearance_m: float

    def placed(self, robot: RobotId, q: Array) -> PlacedParts:
        """Return all parts in each posture (row) of one robot."""
        return self.placed_together((robot,), q)

    def placed_together(self, robots: tuple[RobotId, ...], q: Array) -> PlacedParts:
        """Return all parts for each row of postures of some robots, one after the other."""
        layout = self.layout
        rows = np.concatenate([layout.rows_of[r] for r in robots])
        moved = np.empty((len(q), len(rows), 4, 4))
        first = part = 0
        for robot in robots:
            chain = layout.arms[robot].chain
            frames = self.world_T_base[robot] @ chain.frames(q[:, first : first + chain.joints])
            parts = slice(part, part + len(layout.rows_of[robot]))
            carried_by = frames[:, layout.joints_of[robot]]
            moved[:, parts] = carried_by @ layout.joint_T_part_of[robot]
            first, part = first + chain.joints, parts.stop
        return PlacedParts.of(self.world_T_part, rows, moved)

    def standing(self) -> PlacedParts:
        """Return all parts as the snapshot has them."""
        none = np.empty(0, dtype=np.intp)
        return PlacedParts.of(self.world_T_part, none, np.empty((1, 0, 4, 4)))


class ProofScenes:
    """Compiles snapshots; what they have in common with earlier ones is used again."""

    def __init__(self) -> None:
        self._revision_of = IdentityCache(SceneSnapshot.revision, size=_SCENES_REMEMBERED)
        self._scene_of = IdentityCache(self._compile, size=_SCENES_REMEMBERED)
        self._parts = SceneParts()
        self._arm_of = IdentityCache(arm_model, size=_ARMS_REMEMBERED)
        self._layouts: Remembered[Layout] = Remembered(size=_LAYOUTS_REMEMBERED)
        self._frames: Remembered[Array] = Remembered(size=_SHAPES_REMEMBERED)
        self._number_of = IdentityCache(_shape_numbers(), size=_SHAPES_REMEMBERED)

    def of(self, scene: SceneSnapshot) -> ProofScene:
        """Return the compiled scene."""
        return self._scene_of(scene)

    def around(
        self, scene: SceneSnapshot, moved: Mapping[RobotId, Iterable[Sequence[float]]]
    ) -> Surroundings:
        """Return the part of a scene that matters while some robots move (see `SceneParts`)."""
        return self._parts.around(scene, moved)

    def revision(self, scene: SceneSnapshot) -> str:
        """Return the scene's revision; hashing takes longer than many proofs."""
        return self._revision_of(scene)

    def arm(self, description: Description) -> ArmModel:
        """Return the compiled arm."""
        return self._arm_of(description)

    def _compile(self, scene: SceneSnapshot) -> ProofScene:
        layout = self._layout(scene)
        still = [self._standing(b) for b in scene.bodies.values() if attachment(b) is None]
        world_T_part = np.zeros((len(layout.parts), 4, 4))
        if still:
            frames = np.concatenate(still)
            world_T_part[: len(frames)] = frames
        proof = ProofScene(
            layout=layout,
            world_T_base={r: matrix_of(s.world_T_base) for r, s in scene.robots.items()},
            world_T_part=world_T_part,
            clearance_m=scene.clearance_m,
        )
        for robot, state in scene.robots.items():
            rows = layout.rows_of[robot]
            posture = np.array([state.q_rad], dtype=np.float64)
            world_T_part[rows] = proof.placed(robot, posture).in_every_posture(rows)[0]
        return proof

    def _standing(self, body: Body) -> Array:
        """Return world_T_part of a body that stands, part by part."""
        pose = cast("Pose", body.placement)

        def placed() -> Array:
            parts = [part.body_T_part for part in map(compiled, body.shape)]
            return matrix_of(pose) @ np.array(parts).reshape(-1, 4, 4)

        return self._frames.of((self._number_of(body.shape), pose), placed)

    def _layout(self, scene: SceneSnapshot) -> Layout:
        arms = {r: self._arm_of(s.description) for r, s in scene.robots.items()}
        robots = tuple((r, id(arms[r]), s.world_T_base) for r, s in scene.robots.items())
        bodies = ((b.id, self._number_of(b.shape), attachment(b)) for b in scene.bodies.values())
        return self._layouts.of((robots, tuple(bodies)), lambda: laid_out(scene, arms))


def _shape_numbers() -> Callable[[Shape], int]:
    """Return a function that gives equal shapes the same number, and others another one."""
    fresh = count()

    @lru_cache(maxsize=_SHAPES_REMEMBERED)
    def number(_shape: Shape) -> int:
        return next(fresh)

    return number
