"""Trajectories with thin things planted in their way, and a dense look at them by MuJoCo."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt
from benchmarks.motion.trial import HOME, A, B, Trial, give_gripper, give_nailer, two_arms

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.backends.audit.parts import NO_JOINT, frames_of, parts_of
from sitewright.planning_twin.backends.mujoco_cell import MujocoCell
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.motion import Certifier, PathSegment, TeamPath
from sitewright.planning_twin.scene import Attachment, Body, SceneSnapshot
from sitewright.robot_team.description import Joints

Array = npt.NDArray[np.float64]
STEP_M = 0.001
"""No point moves further between two samples."""
_REACH_M = 4.5
"""No point of these arms, of what they hold and of their tools is further from an axis."""
_ENGINE_M = 1e-5
"""Of MuJoCo's distances."""
_CLEARANCES_M = (0.0, 0.002, 0.010)
_TEAM_SHARE = 0.3
_PLACES = {"start": (0.0, 0.03), "middle": (0.3, 0.7), "end": (0.97, 1.0)}
_NEAR = ("held", "tool", "link")
_NUDGES_M = (0.0003, 0.003)
_AWAY_M = 0.8
_DIRECTIONS = 6
_HALVINGS = 13
_CLUTTER_M = (3.0, 9.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Planted:
    """A trajectory with a thin thing near it.

    Attributes:
        what: Sheet, wire or needle, and whereabouts.
        path: Certified without the thing.
        things: The bodies that were planted.
    """

    what: str
    scene: SceneSnapshot
    path: TeamPath
    things: tuple[BodyId, ...]


@dataclass(frozen=True, slots=True)
class DenseVerdict:
    """What dense samples saw.

    Attributes:
        collides: Something penetrates at a sample.
        is_near: Something is nearer than the clearance at a sample.
    """

    collides: bool
    is_near: bool
    samples: int


def planted(certifier: Certifier, seed: int) -> Planted | None:
    """Return a trajectory with a thing in or near its way; None if the bare one is not clear."""
    rng = np.random.default_rng([4711, seed])
    trial = _cell(rng)
    robots = (A, B) if rng.random() < _TEAM_SHARE else (A,)
    path = _random_path(rng, robots)
    if certifier.objection(trial.scene, path) is not None:
        return None
    kind, size = _thin(rng)
    where, near = (str(rng.choice(list(names))) for names in (_PLACES, _NEAR))
    point = _point_of_motion(rng, trial.scene, path, where, near)
    w, x, y, z = _unit(rng.normal(size=4))
    turn = (w, x, y, z)
    inside = np.array(Pose((0.0, 0.0, 0.0), turn).apply(_inner(rng, size)))
    there = point - inside
    name = BodyId("thin")

    def scene_at(place: Array) -> SceneSnapshot:
        pose = Pose((float(place[0]), float(place[1]), float(place[2])), turn)
        return trial.scene.with_body(Body(id=name, shape=(Box(size),), placement=pose))

    if rng.random() < 0.8:  # noqa: PLR2004 - most graze
        there = _grazing(rng, certifier, path, scene_at, there)
    team = "both arms" if len(robots) > 1 else "one arm"
    return Planted(
        what=f"{kind}, {where}, near {near}, {team}",
        scene=scene_at(there),
        path=path,
        things=(name,),
    )


def with_clutter(case: Planted, seed: int, count: int) -> Planted:
    """Return a case with boxes all around, most of them too far away for any arm.

    Those are what a proof leaves out by lengths alone; whether it may is what is tried.
    """
    rng, scene = np.random.default_rng([815, seed]), case.scene
    names = tuple(BodyId(f"clutter-{k}") for k in range(count))
    for name in names:
        around, away_m = float(rng.uniform(0.0, math.tau)), float(rng.uniform(*_CLUTTER_M))
        x_m, y_m = away_m * math.cos(around), away_m * math.sin(around)
        x, y, z = rng.uniform(0.02, 0.6, 3).tolist()
        pose = Pose((x_m, y_m, float(rng.uniform(0.0, 4.0))))
        scene = scene.with_body(Body(id=name, shape=(Box((x, y, z)),), placement=pose))
    return replace(case, scene=scene, things=(*case.things, *names))


def look_densely(case: Planted) -> DenseVerdict:
    """Look at samples in between which no point moves further than a millimetre.

    Samples that something can only have come near by moving faster than it does are left out.
    Kinematics and distances are MuJoCo's.
    """
    return _Dense(case).verdict()


class _Dense:
    def __init__(self, case: Planted) -> None:
        import mujoco

        self._mujoco: Any = mujoco
        self._case = case
        proofs = ProofScenes()
        self._cell = MujocoCell(case.scene, 0.0, proofs.of(case.scene).layout)
        self._cell.place(case.scene)
        model = self._cell.model
        names = [self._cell.name_by_body.get(int(b), "") for b in model.geom_bodyid]
        moving = {r: self._geoms(names, r) for r in case.path.robots}
        things = [g for g, n in enumerate(names) if n in case.things]
        pairs = [(t, g) for t in things for geoms in moving.values() for g in geoms]
        if len(moving) > 1:
            pairs += [(a, b) for a in moving[A] for b in moving[B]]
        self._pairs = np.array(pairs)
        self._rounds_m = model.geom_rbound[self._pairs].sum(axis=1)

    def verdict(self) -> DenseVerdict:
        clearance_m = self._case.scene.clearance_m
        least_m, samples, is_near = clearance_m, 0, False
        for a, b in pairwise(np.array(self._case.path.segments[0].waypoints_rad)):
            steps = max(1, math.ceil(float(np.abs(b - a).sum()) * _REACH_M / STEP_M))
            number = 0
            while number <= steps:
                samples += 1
                distance_m = self._distance_m(a + number / steps * (b - a))
                if distance_m < -_ENGINE_M:
                    return DenseVerdict(collides=True, is_near=True, samples=samples)
                if distance_m < clearance_m - _ENGINE_M:
                    is_near, least_m = True, 0.0
                number += max(1, math.floor((distance_m - least_m) / STEP_M))
        return DenseVerdict(collides=False, is_near=is_near, samples=samples)

    def _distance_m(self, q: Array) -> float:
        """Return the smallest distance of the pairs, at most one metre."""
        model, data = self._cell.model, self._cell.data
        for k, robot in enumerate(self._case.path.robots):
            for number, address in enumerate(self._addresses(robot)):
                data.qpos[address] = q[6 * k + number]
        self._mujoco.mj_kinematics(model, data)
        places = data.geom_xpos[self._pairs]
        bounds = np.linalg.norm(places[:, 0] - places[:, 1], axis=1) - self._rounds_m
        least_m = 1.0
        for row in np.argsort(bounds):
            if bounds[row] >= least_m:
                break
            first, second = self._pairs[row].tolist()
            found = self._mujoco.mj_geomDistance(model, data, first, second, least_m, None)
            least_m = min(least_m, float(found))
        return least_m

    def _addresses(self, robot: RobotId) -> list[int]:
        joints = self._case.scene.robots[robot].description.movable_joints
        return [int(self._cell.model.joint(f"{robot}/{j.name}").qposadr[0]) for j in joints]

    def _geoms(self, names: list[str], robot: RobotId) -> list[int]:
        """Return the numbers of all that a robot moves."""
        scene = self._case.scene
        arm = scene.robots[robot].description
        moved = {f"{robot}/{link.name}" for link in arm.links if link.name != arm.root}
        for body in scene.bodies.values():
            if isinstance(body.placement, Attachment) and body.placement.robot == robot:
                moved.add(body.id)
        return [g for g, n in enumerate(names) if n in moved]


def _cell(rng: np.random.Generator) -> Trial:
    trial = two_arms(rng)
    give_gripper(trial, A, (float(rng.choice((0.8, 1.4, 1.8))), 0.09, 0.04))
    give_nailer(trial, B)
    clearance_m = float(rng.choice(_CLEARANCES_M))
    trial.scene = replace(trial.scene, clearance_m=clearance_m)
    return trial


def _random_path(rng: np.random.Generator, robots: tuple[RobotId, ...]) -> TeamPath:
    turns = np.concatenate([np.array(HOME) for _ in robots])
    spread = float(rng.choice((0.1, 0.4, 0.8)))
    rows = turns + rng.uniform(-spread, spread, (int(rng.integers(2, 4)), len(turns)))
    waypoints: tuple[Joints, ...] = tuple(tuple(row) for row in rows.tolist())
    return TeamPath(robots=robots, segments=(PathSegment(waypoints_rad=waypoints),))


def _thin(rng: np.random.Generator) -> tuple[str, tuple[float, float, float]]:
    thick = float(rng.choice((0.0005, 0.001, 0.002, 0.005)))
    kind = int(rng.integers(3))
    if kind == 0:
        return "sheet", (thick, float(rng.uniform(0.02, 0.5)), float(rng.uniform(0.02, 0.5)))
    if kind == 1:
        return "wire", (thick, thick, float(rng.uniform(0.3, 1.5)))
    return "needle", (thick, thick, float(rng.uniform(0.01, 0.12)))


def _inner(rng: np.random.Generator, size: tuple[float, float, float]) -> Vector:
    x, y, z = rng.uniform(-0.5, 0.5, 3) * size
    return float(x), float(y), float(z)


def _unit(values: Array) -> list[float]:
    return [float(v) for v in values / np.linalg.norm(values)]


def _point_of_motion(
    rng: np.random.Generator, scene: SceneSnapshot, path: TeamPath, where: str, near: str
) -> Array:
    """Return a corner of something that moves, at a moment of the motion."""
    low, high = _PLACES[where]
    waypoints = np.array(path.segments[0].waypoints_rad)
    at = float(rng.uniform(low, high)) * (len(waypoints) - 1)
    k = min(int(at), len(waypoints) - 2)
    q = waypoints[k] + (at - k) * (waypoints[k + 1] - waypoints[k])
    chosen = int(rng.integers(len(path.robots)))
    robot = path.robots[chosen]
    parts = [p for p in parts_of(scene) if p.robot == robot and p.joint != NO_JOINT]
    if near == "link":
        parts = [p for p in parts if p.is_link]
    else:
        parts = [p for p in parts if p.name.endswith("-held") == (near == "held")] or parts
    part = parts[int(rng.integers(len(parts)))]
    mine = tuple(q[6 * chosen : 6 * chosen + 6].tolist())
    frame = frames_of(scene.robots[robot], mine)[part.frame]
    corner = part.points_m[int(rng.integers(len(part.points_m)))]
    return np.asarray(frame[:3, :3] @ corner + frame[:3, 3])


def _grazing(
    rng: np.random.Generator,
    certifier: Certifier,
    path: TeamPath,
    scene_at: Callable[[Array], SceneSnapshot],
    there: Array,
) -> Array:
    """Return a place where the thing is about to touch: hardest to tell for any check."""
    for _ in range(_DIRECTIONS):
        away = _AWAY_M * np.array(_unit(rng.normal(size=3)))
        if certifier.objection(scene_at(there + away), path) is None:
            break
    else:
        return there
    near, far = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = (near + far) / 2.0
        if certifier.objection(scene_at(there + middle * away), path) is None:
            far = middle
        else:
            near = middle
    nudge = float(rng.normal()) * float(rng.choice(_NUDGES_M))
    return np.asarray(there + far * away - nudge * away / _AWAY_M)
