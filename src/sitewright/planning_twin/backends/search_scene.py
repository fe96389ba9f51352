"""The padded scene that paths are searched in, kept by roboplan."""

from __future__ import annotations

import tempfile
from collections import OrderedDict
from collections.abc import Hashable, Iterable, Iterator, Mapping
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from sitewright.errors import BackendError
from sitewright.foundation.ids import RobotId
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.layout import attachment
from sitewright.planning_twin.backends.padding import padded
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.search_urdf import SearchRobots, SearchUrdf
from sitewright.planning_twin.scene import Attachment, Body, Pair, SceneSnapshot, pair_of
from sitewright.robot_team.description import Joints

_SCENES_REMEMBERED = 12
_UNIVERSE = "universe"
_GREY = (0.5, 0.5, 0.5, 1.0)


class SearchScene:
    """One roboplan scene for all snapshots that differ only in postures and places of boxes.

    Robots and what they carry stand in the URDF, everything that is a box and stands still is an
    object that can be moved. Pairs that the proof does not count are off here too.
    """

    def __init__(self, scene: SceneSnapshot, pad_m: float, counted: Iterable[Pair]) -> None:
        from roboplan.core import Scene, loadUrdfSceneDescriptionFromXml

        with tempfile.TemporaryDirectory(prefix="sitewright-search-") as folder:
            still = [b.id for b in scene.bodies.values() if not is_movable(b)]
            self._robots: SearchRobots = SearchUrdf(Path(folder), pad_m).write(scene, still)
            description = loadUrdfSceneDescriptionFromXml(self._robots.xml, [])
        self.roboplan: Any = Scene("cell", description)
        self._parts_of: dict[str, list[tuple[str, Array]]] = {}
        for body in scene.bodies.values():
            if is_movable(body) and not isinstance(body.placement, Attachment):
                self._parts_of[body.id] = list(self._added(body, pad_m))
        for robot, joints in self._robots.joints_of.items():
            self.roboplan.addGroup(robot, list(joints))
        self._teams: set[str] = set()
        self._order = list(self.roboplan.getJointNames())
        self._counted = frozenset(counted)
        self._left_out: frozenset[Pair] = frozenset()
        self._allow_uncounted()

    def place(self, scene: SceneSnapshot) -> None:
        """Put all boxes and postures where a snapshot has them."""
        for name, parts in self._parts_of.items():
            placement = scene.bodies[_body_id(scene, name)].placement
            if isinstance(placement, Attachment):
                raise BackendError(f"{name} is carried, but the search scene has it standing")
            world_T_body = matrix_of(placement)
            for part, body_T_part in parts:
                pose = np.asfortranarray(world_T_body @ body_T_part)
                self.roboplan.updateGeometryPlacement(part, _UNIVERSE, pose)
        self.roboplan.setJointPositions(self.posture(scene, {}))

    def posture(self, scene: SceneSnapshot, moved: Mapping[RobotId, Joints]) -> Array:
        """Return the positions of all joints in roboplan's order."""
        position_by_joint: dict[str, float] = {}
        for robot, joints in self._robots.joints_of.items():
            q_rad = moved.get(robot, scene.robots[robot].q_rad)
            position_by_joint.update(zip(joints, q_rad, strict=True))
        return np.array([position_by_joint[j] for j in self._order], dtype=np.float64)

    def joints_of(self, robot: RobotId) -> list[str]:
        """Return roboplan's names of a robot's joints."""
        return list(self._robots.joints_of[robot])

    def columns_of(self, robot: RobotId) -> list[int]:
        """Return where a robot's joints stand in a posture of all joints."""
        return [self._order.index(j) for j in self._robots.joints_of[robot]]

    def tip_of(self, scene: SceneSnapshot, robot: RobotId) -> str:
        """Return roboplan's name of a robot's tip frame."""
        return f"{robot}.{scene.robots[robot].description.tip}"

    def group_of(self, robots: tuple[RobotId, ...]) -> str:
        """Return roboplan's name of the group of some robots' joints."""
        if len(robots) == 1:
            return robots[0]
        name = " and ".join(robots)
        if name not in self._teams:
            self.roboplan.addGroup(name, [j for r in robots for j in self.joints_of(r)])
            self._teams.add(name)
        return name

    def leave_out(self, pairs: Iterable[Pair]) -> None:
        """Leave exactly these pairs out of the checks from now on."""
        wanted = self._counted.intersection(pairs)
        changes = {False: wanted - self._left_out, True: self._left_out - wanted}
        for is_on, changed in changes.items():
            if names := [n for pair in sorted(changed) for n in self._roboplan_pairs(pair)]:
                self.roboplan.setCollisions(names, is_on)
        self._left_out = wanted

    def _added(self, body: Body, pad_m: float) -> Iterator[tuple[str, Array]]:
        from roboplan.core import Box as RoboplanBox

        for number, part in enumerate(body.shape):
            grown = padded(part, pad_m)
            if isinstance(grown, Box):
                name = f"body.{body.id}.{number}"
                self.roboplan.addBoxGeometry(
                    name,
                    _UNIVERSE,
                    RoboplanBox(*grown.size_m),
                    np.asfortranarray(np.eye(4)),
                    np.array(_GREY),
                )
                yield name, matrix_of(grown.body_T_box)

    def _objects(self, name: str) -> list[str]:
        """Return roboplan's names of a link or body."""
        if name in self._parts_of:
            return [part for part, _ in self._parts_of[name]]
        link = self._robots.link_by_name.get(name)
        return [] if link is None else [link]

    def _roboplan_pairs(self, pair: Pair) -> list[tuple[str, str]]:
        a, b = pair
        return [(x, y) for x in self._objects(a) for y in self._objects(b)]

    def _allow_uncounted(self) -> None:
        names = [*self._parts_of, *self._robots.link_by_name]
        off = [
            names_of
            for a, b in combinations(names, 2)
            if pair_of(a, b) not in self._counted
            for names_of in self._roboplan_pairs((a, b))
        ]
        own = [pair for name in names for pair in combinations(self._objects(name), 2)]
        if off or own:
            self.roboplan.setCollisions([*off, *own], False)  # noqa: FBT003


class SearchScenes:
    """Builds search scenes, and uses one again while shapes and what is carried stay the same."""

    def __init__(self, proofs: ProofScenes) -> None:
        self._proofs = proofs
        self._scenes: OrderedDict[Hashable, SearchScene] = OrderedDict()

    def of(self, scene: SceneSnapshot, pad_m: float) -> SearchScene:
        """Return a search scene with everything where the snapshot has it."""
        arms = [(r, id(self._proofs.arm(s.description))) for r, s in scene.robots.items()]
        bases = [s.world_T_base for s in scene.robots.values()]
        bodies = [
            (b.id, b.shape, attachment(b) if is_movable(b) else b.placement)
            for b in scene.bodies.values()
        ]
        key = (pad_m, tuple(arms), tuple(bases), tuple(bodies))
        if key not in self._scenes:
            self._scenes[key] = SearchScene(scene, pad_m, self._counted(scene))
            if len(self._scenes) > _SCENES_REMEMBERED:
                self._scenes.popitem(last=False)
        self._scenes.move_to_end(key)
        found = self._scenes[key]
        found.place(scene)
        return found

    def _counted(self, scene: SceneSnapshot) -> set[Pair]:
        layout = self._proofs.of(scene).layout
        tables = (*layout.pairs_of.values(), *layout.standing_of.values())
        return {name for table in tables for name in table.names}


def is_movable(body: Body) -> bool:
    """Tell whether a body stands and is made of boxes, so that it can be moved in place."""
    return not isinstance(body.placement, Attachment) and all(
        isinstance(part, Box) for part in body.shape
    )


def _body_id(scene: SceneSnapshot, name: str) -> Any:  # noqa: ANN401
    return next(i for i in scene.bodies if i == name)
