"""Whether a piece can be fastened while it is held, found out without the planner's code.

All stated freedoms are gone through anew: every grasp in every posture of the arm that holds, and
for each fastener every lean of the tool, turned by quarters too, in every posture of the arm that
drives. Postures come from `independent_postures`, distances from MuJoCo. Only what the act itself
needs is looked at: the two arms, gripper, tool and piece, the supports, the fixtures. Where this
finds no way, nothing can; where it finds one, something else may still be in the way.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations, product

import mujoco
import numpy as np

from independent_postures import ScrewArm, link_frames
from independent_reach import Array, matrix, turn
from sitewright.app.project import Project
from sitewright.building_model.component import BoxGeometry, Component, Operation
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.shapes import Box, ConvexPart, Shape
from sitewright.robot_team.cell import EndEffector, EndEffectorKind, Robot
from sitewright.robot_team.description import Description, JointKind

_PITCHES_DEG = (0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0)
_OFFSETS_M = tuple(k / 10.0 for k in range(-6, 7))
_TILTS_DEG = (0.0, 2.5, 5.0, 10.0)
_BEARINGS_DEG = tuple(45.0 * k for k in range(8))
_QUARTERS_DEG = (0.0, 90.0, 180.0, 270.0)
_ABOVE_SUPPORT_M, _LEAST_PAD_M, _END_M = 0.002, 0.005, 0.05
_NEIGHBOUR_M, _CONTACT_M = 0.001, -0.001
_FAR_M = 0.05
_RANDOM_POSTURES = 60

Frames = Mapping[str, Array]
"""World pose of each body: ``robot/link``, ``end effector:link``, component or fixture."""
Pairs = list[tuple[str, str, float]]
"""Two bodies, and the distance in metres that they keep."""


@dataclass(frozen=True, slots=True)
class HeldCheck:
    """What became of all ways to hold a piece.

    Attributes:
        ways: So many ways to hold it: grasp and posture.
        posts: So many postures of tools that nothing but the holder could be in the way of.
        enough: So many of the ways let enough fasteners be driven.
        grasps: piece_T_tip of each grasp, and whether one of its ways is among those.
    """

    ways: int
    posts: int
    enough: int
    grasps: tuple[tuple[Array, bool], ...]

    @property
    def is_impossible(self) -> bool:
        """No way lets enough be driven, and there was something to look at."""
        return self.ways > 0 and self.posts > 0 and self.enough == 0


def held_check(
    project: Project, target: ComponentId, *, quarter_turns: bool = True, every: int = 1
) -> HeldCheck:
    """Go through all ways to hold a target's piece, and to drive its fasteners meanwhile.

    Args:
        project: The supports are taken to stand where they belong.
        target: With fasteners.
        quarter_turns: Tools are turned about their axis as well.
        every: Only each so-manieth grasp; 1 is all of them.
    """
    act = _Act(project, target)
    operations = act.component.operations
    forced = {o.id for o in operations if o.needs_hold}
    needed = max(act.component.hold_until_fasteners, len(forced))
    ways = most_posts = enough = 0
    grasps: list[tuple[Array, bool]] = []
    for holder, gripper in act.tools(EndEffectorKind.GRIPPER):
        posts = {o.id: list(act.posts(holder, o, quarter_turns=quarter_turns)) for o in operations}
        most_posts = max(most_posts, sum(map(len, posts.values())))
        for grasp in list(_grasps(act.component, gripper))[::every]:
            before = enough
            for held in act.holds(holder, gripper, *grasp):
                ways += 1
                free = {o for o, some in posts.items() if any(act.is_free(p, held) for p in some)}
                enough += len(free) >= needed and forced <= free
            grasps.append((grasp[1], enough > before))
    return HeldCheck(ways, most_posts, enough, tuple(grasps))


class _Space:
    """Distances between bodies, by MuJoCo; poses are written into its data."""

    def __init__(self, shapes: Mapping[str, Shape]) -> None:
        spec = mujoco.MjSpec()
        self._parts: dict[str, list[int]] = {}
        count = 0
        for body, shape in shapes.items():
            self._parts[body] = list(range(count, count + len(shape)))
            for part in shape:
                _add(spec, f"g{count}", part)
                count += 1
        self._model = spec.compile()
        self._data = mujoco.MjData(self._model)
        mujoco.mj_forward(self._model, self._data)
        self._body_T_geom = np.tile(np.eye(4), (count, 1, 1))
        self._body_T_geom[:, :3, :3] = self._data.geom_xmat.reshape(-1, 3, 3)
        self._body_T_geom[:, :3, 3] = self._data.geom_xpos
        self._radius_m = self._model.geom_rbound.copy()

    def too_near(self, pairs: Pairs, *frames: Frames) -> tuple[str, str, float] | None:
        """Return the first pair that comes too near, if one does."""
        at = {name: pose for some in frames for name, pose in some.items()}
        return next((p for p in pairs if self._distance_m(at, p[0], p[1]) < p[2]), None)

    def _distance_m(self, at: Frames, a: str, b: str) -> float:
        """Return the distance of two bodies, negative inside; infinite if they are far apart."""
        least_m = math.inf
        for i, j in product(self._parts[a], self._parts[b]):
            left, right = at[a] @ self._body_T_geom[i], at[b] @ self._body_T_geom[j]
            apart_m = math.dist(left[:3, 3], right[:3, 3])
            if apart_m - self._radius_m[i] - self._radius_m[j] < _FAR_M:
                for geom, pose in ((i, left), (j, right)):
                    self._data.geom_xpos[geom] = pose[:3, 3]
                    self._data.geom_xmat[geom] = pose[:3, :3].reshape(9)
                found_m = mujoco.mj_geomDistance(self._model, self._data, i, j, _FAR_M, None)
                least_m = min(least_m, found_m)
        return least_m


def _add(spec: mujoco.MjSpec, name: str, part: ConvexPart) -> None:
    if isinstance(part, Box):
        spec.worldbody.add_geom(
            name=name,
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=[s / 2.0 for s in part.size_m],
            pos=part.body_T_box.position_m,
            quat=part.body_T_box.quaternion_wxyz,
        )
    else:
        spec.add_mesh(name=name, uservert=np.array(part.points_m).ravel())
        spec.worldbody.add_geom(name=name, type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name)


@dataclass(slots=True)
class _Post:
    """An arm at a fastener. The pair that was too near last is asked first."""

    frames: Frames
    last: tuple[str, str, float] | None = None


class _Act:
    """A target at its place with what it needs: supports, fixtures, arms, end effectors."""

    def __init__(self, project: Project, target: ComponentId) -> None:
        self.project, self.clearance_m = project, project.cell.clearance_m
        self.component = project.model.component_by_id[target]
        self._still: dict[str, Array] = {
            str(f.id): matrix(f.world_T_fixture) for f in project.cell.fixture_by_id.values()
        }
        for name in (target, *self.component.construction_parents):
            component = project.model.component_by_id[name]
            self._still[name] = matrix(project.cell.world_T_model @ component.world_T_component)
        self._space = _Space(self._shapes())
        self._own: dict[tuple[str, str], Pairs] = {}

    def tools(self, kind: EndEffectorKind) -> Iterator[tuple[Robot, EndEffector]]:
        """Yield robots with their end effectors of one kind."""
        for robot in self.project.cell.robot_by_id.values():
            for name in robot.end_effectors:
                tool = self.project.cell.end_effector_by_id[name]
                if tool.kind is kind:
                    yield robot, tool

    def holds(
        self, robot: Robot, gripper: EndEffector, width_m: float, piece_T_tip: Array
    ) -> Iterator[Frames]:
        """Yield an arm that holds the piece by a grasp, for each posture that meets nothing."""
        piece, parents = self.component.id, self.component.construction_parents
        pairs = self._own_pairs(robot, gripper)
        for name in self._bodies(robot, gripper):
            is_hand = name.startswith(f"{gripper.id}:")
            for other in self._still:
                if other == piece and (is_hand or name in self._last_links(robot)):
                    continue  # rigid to one another
                keeps_m = _NEIGHBOUR_M if is_hand and other in parents else self.clearance_m
                pairs.append((name, other, keeps_m))
        tip = self._still[piece] @ piece_T_tip
        for frames in self._standing(robot, gripper, tip, width_m):
            if self._space.too_near(pairs, self._still, frames) is None:
                yield frames

    def posts(self, holder: Robot, operation: Operation, *, quarter_turns: bool) -> Iterator[_Post]:
        """Yield every arm at a fastener that meets nothing of the act but who holds the piece."""
        at = self._still[self.component.id] @ matrix(operation.component_T_operation)
        for robot, tool in self.tools(EndEffectorKind.TOOL):
            if robot.id == holder.id or operation.process not in tool.processes:
                continue
            pairs = self._own_pairs(robot, tool)
            for name, other in product(self._bodies(robot, tool), self._still):
                is_contact = name.startswith(f"{tool.id}:") and other == self.component.id
                pairs.append((name, other, _CONTACT_M if is_contact else self.clearance_m))
            for lean in _leans(tool, _QUARTERS_DEG if quarter_turns else (0.0,)):
                tip = at @ lean @ np.linalg.inv(_mount_T_tcp(tool.description))
                for frames in self._standing(robot, tool, tip, 0.0):
                    if self._space.too_near(pairs, self._still, frames) is None:
                        yield _Post(frames)

    def is_free(self, post: _Post, held: Frames) -> bool:
        """Tell whether an arm that drives and one that holds keep clear of each other."""
        pairs = [(a, b, self.clearance_m) for a, b in product(post.frames, held)]
        if post.last is not None and post.last[1] in held:
            pairs.insert(0, post.last)
        post.last = self._space.too_near(pairs, post.frames, held)
        return post.last is None

    def _shapes(self) -> dict[str, Shape]:
        cell, model = self.project.cell, self.project.model
        found: dict[str, Shape] = {str(f.id): f.shape for f in cell.fixture_by_id.values()}
        found |= {n: (Box(_size(model.component_by_id[n])),) for n in self._still if n not in found}  # type: ignore[index]
        for robot in cell.robot_by_id.values():
            found |= {f"{robot.id}/{k.name}": k.shape for k in robot.description.links if k.shape}
        for tool in cell.end_effector_by_id.values():
            found |= {f"{tool.id}:{k.name}": k.shape for k in tool.description.links if k.shape}
        return found

    def _standing(
        self, robot: Robot, tool: EndEffector, world_T_tip: Array, width_m: float
    ) -> Iterator[Frames]:
        """Yield the bodies of an arm in each posture that brings its tip to a pose."""
        arm, base = robot.description, matrix(robot.world_T_base)
        names = [j.name for j in arm.movable_joints]
        for q in ScrewArm.of(arm).postures(np.linalg.inv(base) @ world_T_tip):
            yield self._frames(robot, tool, dict(zip(names, q.tolist(), strict=True)), width_m)

    def _frames(
        self, robot: Robot, tool: EndEffector, values: dict[str, float], width_m: float
    ) -> Frames:
        base = matrix(robot.world_T_base)
        links = link_frames(robot.description, values)
        slides = (j for j in tool.description.movable_joints if j.kind is JointKind.PRISMATIC)
        hand = link_frames(tool.description, {j.name: width_m / 2.0 for j in slides})
        tip = base @ links[robot.description.tip]
        found = {f"{robot.id}/{name}": base @ pose for name, pose in links.items()}
        found |= {f"{tool.id}:{name}": tip @ pose for name, pose in hand.items()}
        return {name: found[name] for name in self._with_shape(robot, tool)}

    def _with_shape(self, robot: Robot, tool: EndEffector) -> list[str]:
        links = [f"{robot.id}/{k.name}" for k in robot.description.links if k.shape]
        return links + [f"{tool.id}:{k.name}" for k in tool.description.links if k.shape]

    def _bodies(self, robot: Robot, tool: EndEffector) -> list[str]:
        """Return the bodies of an arm that move."""
        foot = f"{robot.id}/{robot.description.root}"
        return [name for name in self._with_shape(robot, tool) if name != foot]

    @staticmethod
    def _last_links(robot: Robot) -> set[str]:
        """Return the links that are rigid to the tip."""
        arm = robot.description
        by_child = {j.child: j for j in arm.joints}
        found, link = {arm.tip}, arm.tip
        while by_child[link].kind is JointKind.FIXED:
            link = by_child[link].parent
            found.add(link)
        return {f"{robot.id}/{name}" for name in found}

    def _own_pairs(self, robot: Robot, tool: EndEffector) -> Pairs:
        """Return the pairs of one arm that some posture keeps apart; the list is the caller's."""
        key = (robot.id, tool.id)
        if key not in self._own:
            self._own[key] = self._apart(robot, tool)
        return list(self._own[key])

    def _apart(self, robot: Robot, tool: EndEffector) -> Pairs:
        hand = {n for n in self._with_shape(robot, tool) if n.startswith(f"{tool.id}:")}
        rigid = hand | self._last_links(robot)
        joined = {
            frozenset((f"{robot.id}/{j.parent}", f"{robot.id}/{j.child}"))
            for j in robot.description.joints
        }
        pairs = [
            (a, b, self.clearance_m)
            for a, b in combinations(self._with_shape(robot, tool), 2)
            if not {a, b} <= rigid and frozenset((a, b)) not in joined
        ]
        lots = np.random.default_rng(0)
        joints = robot.description.movable_joints
        apart: set[tuple[str, str, float]] = set()
        for _ in range(_RANDOM_POSTURES):
            values = {j.name: lots.uniform(j.lower_rad, j.upper_rad) for j in joints}
            frames = self._frames(robot, tool, values, 0.0)
            rest = (p for p in pairs if p not in apart)
            apart |= {p for p in rest if self._space.too_near([p], frames) is None}
        return [p for p in pairs if p in apart]


def _size(component: Component) -> tuple[float, float, float]:
    assert isinstance(component.geometry, BoxGeometry)
    return component.geometry.size_m


def _mount_T_tcp(description: Description) -> Array:
    return link_frames(description, {})[description.tip]


def _grasps(component: Component, gripper: EndEffector) -> Iterator[tuple[float, Array]]:
    """Yield opening and piece_T_tip of each grasp that comes from above."""
    size, (low, high) = _size(component), gripper.grips_m or (0.0, 0.0)
    if not low <= size[1] <= high:
        return
    down = np.array([0.0, 0.0, -1.0])
    mount_T_tcp = _mount_T_tcp(gripper.description)
    for pitch_deg, half_turn in product(_PITCHES_DEG, (1.0, -1.0)):
        x_axis = np.array([half_turn, 0.0, 0.0])
        frame = np.eye(4)
        frame[:3, :3] = np.column_stack((x_axis, np.cross(down, x_axis), down))
        frame = frame @ turn((0.0, 1.0, 0.0), math.radians(pitch_deg))
        past_m = _fingers_end_m(gripper.description, frame @ np.linalg.inv(mount_T_tcp), size[1])
        depth_m = min(0.0, size[2] / 2.0 - _ABOVE_SUPPORT_M - past_m)
        if depth_m <= -size[2] / 2.0 + _LEAST_PAD_M:
            continue
        for offset_m in _OFFSETS_M:
            if abs(offset_m) <= size[0] / 2.0 - _END_M + 1e-9:
                there = frame.copy()
                there[:3, 3] = (offset_m, 0.0, -depth_m)
                yield size[1], there @ np.linalg.inv(mount_T_tcp)


def _fingers_end_m(description: Description, frame: Array, width_m: float) -> float:
    """Return how far below the tcp the lowest point of a finger is, in a piece's frame."""
    slides = {j.child: j for j in description.joints if j.kind is JointKind.PRISMATIC}
    at = link_frames(description, {j.name: width_m / 2.0 for j in slides.values()})
    shapes = {k.name: k.shape for k in description.links}
    return -min(
        float((frame @ at[finger] @ np.append(vertex, 1.0))[2])
        for finger in slides
        for part in shapes[finger]
        for vertex in part.vertices_m()
    )


def _leans(tool: EndEffector, turns_deg: tuple[float, ...]) -> Iterator[Array]:
    """Yield operation_T_tcp: upright, then leaning in eight directions, stood off by the nose."""
    for tilt_deg, bearing_deg, turn_deg in product(_TILTS_DEG, _BEARINGS_DEG, turns_deg):
        tilt, bearing = math.radians(tilt_deg), math.radians(bearing_deg)
        if tilt > tool.max_tilt_rad + 1e-9 or (tilt == 0.0 and bearing_deg):
            continue
        lean = turn((math.cos(bearing), math.sin(bearing), 0.0), tilt)
        lean[2, 3] = -tool.nose_half_width_m * math.sin(tilt)
        yield lean @ turn((0.0, 0.0, 1.0), math.radians(turn_deg))
