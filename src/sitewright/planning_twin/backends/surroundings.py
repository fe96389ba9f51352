"""The part of a scene that matters to a motion: bodies that no arm can come near to are left out.

On a wall of 200 pieces a motion has to do with a few dozen of them. What is left out is proven to
be far away by lengths alone: a ball around each body, and how far an arm and what it carries reach
from where its rails may have it. Everything that looks at distances may then look at the rest.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose, norm
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.backends.identity_cache import IdentityCache
from sitewright.planning_twin.backends.kinematic_chain import (
    BASE,
    Array,
    chain_of,
    matrix_of,
)
from sitewright.planning_twin.backends.rail_solver import rails_before
from sitewright.planning_twin.scene import Attachment, Body, SceneSnapshot
from sitewright.robot_team.description import Description, JointKind

FAR_M = 0.5
"""What is left out is at least the clearance and so much away from everything that moves."""
_STRETCH_M = 4.0
"""Rails are looked at in stretches, so that many motions share one part of the scene."""
_REMEMBERED = 64
_ARMS_REMEMBERED = 16
_SHAPES_REMEMBERED = 8192
_Stretch = tuple[tuple[float, ...], tuple[float, ...]]
"""Lowest and highest position of each rail."""


@dataclass(frozen=True, slots=True)
class Surroundings:
    """A part of a scene.

    Attributes:
        scene: All robots with what they carry, and the bodies near to them.
        left_out: How many bodies with a shape are left out.
        beyond_m: All that is left out is at least so far from everything that moves or could.
    """

    scene: SceneSnapshot
    left_out: int
    beyond_m: float


@dataclass(frozen=True, slots=True, eq=False)
class _Rider:
    """An arm on its rails, if it has any.

    Attributes:
        rails: How many joints slide before the first one that turns.
        base_T_anchor: What the last of them carries, with all at zero; without rails the base.
        ways: rails x 3; where the anchor goes per metre of each, in the base.
        reach_m: No point of a link that moves is ever further from the anchor.
        tip_m: Nor is the tip.
    """

    rails: int
    base_T_anchor: Array
    ways: Array
    reach_m: float
    tip_m: float


@dataclass(slots=True, eq=False)
class _Still:
    """The bodies of a scene that stand still, as balls.

    Attributes:
        parts: Bodies of the scene without some of those, by which are left out.
    """

    ids: tuple[BodyId, ...]
    centre_m: Array
    radius_m: Array
    parts: dict[bytes, Mapping[BodyId, Body]]


@dataclass(frozen=True, slots=True)
class _Known:
    """What is known of a scene.

    Attributes:
        rails: How many joints of each robot slide before the first one that turns.
        standing: The stretches that the robots stand in.
        found: What is near while rails are within some stretches, robot by robot.
    """

    rails: Mapping[RobotId, int]
    standing: tuple[_Stretch, ...]
    found: dict[tuple[_Stretch, ...], Surroundings]


class SceneParts:
    """Finds the part of a scene that matters."""

    def __init__(self) -> None:
        self._rider_of = IdentityCache(_rider, size=_ARMS_REMEMBERED)
        self._radius_of: dict[int, tuple[Shape, float]] = {}
        self._still_of = IdentityCache(self._still, size=_REMEMBERED)
        self._known_of = IdentityCache(self._nothing_known, size=4 * _REMEMBERED)

    def around(
        self, scene: SceneSnapshot, moved: Mapping[RobotId, Iterable[Sequence[float]]]
    ) -> Surroundings:
        """Return what is near while some robots move and all others stand.

        Args:
            scene: The whole scene.
            moved: Postures of each that moves. Its rails are never beyond these.

        Returns:
            The same part for all motions within the same stretches of the rails.
        """
        known = self._known_of(scene)
        stretches = known.standing
        if any(known.rails[r] for r in moved):
            stretches = tuple(
                _stretch(known.rails[r], moved[r]) if r in moved else stands
                for r, stands in zip(scene.robots, known.standing, strict=True)
            )
        found = known.found.get(stretches)
        if found is None:
            found = known.found[stretches] = self._found(scene, stretches)
        return found

    def _nothing_known(self, scene: SceneSnapshot) -> _Known:
        rails = {r: self._rider_of(s.description).rails for r, s in scene.robots.items()}
        standing = tuple(_stretch(rails[r], (s.q_rad,)) for r, s in scene.robots.items())
        return _Known(rails, standing, {})

    def _found(self, scene: SceneSnapshot, stretches: tuple[_Stretch, ...]) -> Surroundings:
        still = self._still_of(scene.bodies)
        beyond_m = scene.clearance_m + FAR_M
        is_far = np.ones(len(still.ids), dtype=np.bool_)
        for (robot, state), stretch in zip(scene.robots.items(), stretches, strict=True):
            rider = self._rider_of(state.description)
            reach_m = max(rider.reach_m, rider.tip_m + _carried_m(scene, robot))
            low, high = _anchors(rider, matrix_of(state.world_T_base), stretch)
            outside = np.maximum(np.maximum(low - still.centre_m, still.centre_m - high), 0.0)
            gap_m = np.linalg.norm(outside, axis=1) - still.radius_m - reach_m
            is_far &= gap_m > beyond_m
        if not is_far.any():
            return whole(scene)
        bodies = still.parts.get(is_far.tobytes())
        if bodies is None:
            out = {i for i, far in zip(still.ids, is_far.tolist(), strict=True) if far}
            bodies = {i: b for i, b in scene.bodies.items() if i not in out}
            still.parts[is_far.tobytes()] = bodies
        return Surroundings(replace(scene, bodies=bodies), int(is_far.sum()), beyond_m)

    def _still(self, bodies: Mapping[BodyId, Body]) -> _Still:
        still = [b for b in bodies.values() if b.shape and isinstance(b.placement, Pose)]
        centres = [b.placement.position_m for b in still if isinstance(b.placement, Pose)]
        return _Still(
            ids=tuple(b.id for b in still),
            centre_m=np.array(centres, dtype=np.float64).reshape(-1, 3),
            radius_m=np.array([self._radius_m(b.shape) for b in still]),
            parts={},
        )

    def _radius_m(self, shape: Shape) -> float:
        """Return the radius of a shape's ball; shapes live long, and hashing one takes longer."""
        known = self._radius_of.get(id(shape))
        if known is None:
            if len(self._radius_of) >= _SHAPES_REMEMBERED:
                self._radius_of.clear()
            known = self._radius_of[id(shape)] = (shape, _radius_m(shape))
        return known[1]


def whole(scene: SceneSnapshot) -> Surroundings:
    """Return a scene of which nothing is left out."""
    return Surroundings(scene, left_out=0, beyond_m=math.inf)


def _stretch(rails: int, postures: Iterable[Sequence[float]]) -> _Stretch:
    if not rails:
        return (), ()
    columns = list(zip(*(q[:rails] for q in postures), strict=True))
    low = tuple(math.floor(min(c) / _STRETCH_M) * _STRETCH_M for c in columns)
    high = tuple(math.ceil(max(c) / _STRETCH_M) * _STRETCH_M for c in columns)
    return low, high


def _anchors(rider: _Rider, world_T_base: Array, stretch: _Stretch) -> tuple[Array, Array]:
    """Return opposite corners of a box, along the axes of the world, that holds the anchor."""
    at_zero = (world_T_base @ rider.base_T_anchor)[:3, 3]
    ways = rider.ways @ world_T_base[:3, :3].T
    ends = [ways * np.array(end)[:, None] for end in stretch]
    low, high = np.minimum(*ends).sum(axis=0), np.maximum(*ends).sum(axis=0)
    return at_zero + low, at_zero + high


def _carried_m(scene: SceneSnapshot, robot: RobotId) -> float:
    """Return how far any point of what a robot carries is from its tip at most."""
    reaches = (
        norm(b.placement.tip_T_body.position_m) + _radius_m(b.shape)
        for b in scene.bodies.values()
        if isinstance(b.placement, Attachment) and b.placement.robot == robot and b.shape
    )
    return max(reaches, default=0.0)


def _radius_m(shape: Shape) -> float:
    """Return the radius of the ball about a body's origin that holds it."""
    return max(norm(v) for part in shape for v in part.vertices_m())


def _rider(description: Description) -> _Rider:
    chain = chain_of(description)
    rails = rails_before(chain)
    frames = chain.frames(np.zeros((1, chain.joints)))[0]
    anchor = rails - 1 if rails else BASE
    rotations = frames[:rails, :3, :3]
    from_anchor_m = dict(_from_anchor(description, anchor))
    links = {link.name: link.shape for link in description.links if link.shape}
    moved = (link for link in links if chain.carrier_by_link[link][0] != BASE)
    return _Rider(
        rails=rails,
        base_T_anchor=frames[anchor],
        ways=np.einsum("nij,nj->ni", rotations, chain.axes[:rails]),
        reach_m=max((from_anchor_m[i] + _radius_m(links[i]) for i in moved), default=0.0),
        tip_m=from_anchor_m[description.tip],
    )


def _from_anchor(description: Description, anchor: int) -> Iterator[tuple[str, float]]:
    """Yield how far the origin of each link can be from the anchor's: all offsets stretched out."""
    joints = description.movable_joints
    start = joints[anchor].child if anchor != BASE else description.root
    steps: dict[str, list[tuple[str, float]]] = {}
    for joint in description.joints:
        step_m = norm(joint.parent_T_joint.position_m)
        if joint.kind is JointKind.PRISMATIC:
            step_m += max(abs(joint.lower_rad), abs(joint.upper_rad))
        steps.setdefault(joint.parent, []).append((joint.child, step_m))
        steps.setdefault(joint.child, []).append((joint.parent, step_m))
    waiting, seen = [(start, 0.0)], {start}
    while waiting:
        link, so_far_m = waiting.pop()
        yield link, so_far_m
        further = [(n, so_far_m + step_m) for n, step_m in steps.get(link, ()) if n not in seen]
        seen.update(n for n, _ in further)
        waiting += further
