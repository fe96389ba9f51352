"""Which long side of the building a component is brought from, and which face the gripper meets."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from sitewright.building_model.component import BoxGeometry, Component
from sitewright.building_model.inference.blocking import STEP_M, Obstacles, samples
from sitewright.building_model.inference.order import Arrival
from sitewright.building_model.inference.solid import Solid
from sitewright.building_model.inference.statics import GROUND_M, Statics
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import (
    Pose,
    Vector,
    add,
    cross,
    distance,
    dot,
    rotation,
    scale,
    subtract,
    unit,
)

STANDOFF_M = 1.0
"""An arm is taken to stand this far off the middle of a long side ..."""
SHOULDER_M = 1.1
"""... with its shoulder this high above the ground."""
CORRIDOR_M = 0.6
"""Gripper and wrist need this much room in front of the face."""
_HALF_WIDTH_M = 0.10
_NEAR_M = 0.30
"""What is this near to a component's middle does not hide it."""
_LEANS = 0.2
_COVERED = 2.0
_BLOCKED = 4.0
_ASIDE = 0.3
_OFFSETS_M = (0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6)
_FACES = ((1, 1.0), (1, -1.0), (2, 1.0), (2, -1.0))
_RIGHT_ANGLE = 1.5707963267948966


@dataclass(frozen=True, slots=True, kw_only=True)
class Surroundings:
    """The building's long axis and where arms are taken to stand, in the model frame.

    Attributes:
        along: Unit vector of the long side.
        shoulder_m: By side (``a``: to the left of `along` seen from above, ``b``: opposite).
    """

    along: Vector
    middle_m: Vector
    shoulder_m: dict[str, Vector]


def surroundings_of(statics: Statics) -> Surroundings:
    """Look at the extent of the building and put an arm on each long side."""
    up = statics.up
    along, across = _horizontal_axes(up)
    solids = list(statics.solid_by_id.values())
    if _extent(solids, across) > _extent(solids, along):
        along, across = across, scale(along, -1.0)
    middle = _sum(scale(axis, _middle(solids, axis)) for axis in (along, across))
    ground_m = min(s.lowest_m(up) for s in solids)
    half_m = _extent(solids, across) / 2.0 + STANDOFF_M
    raised = add(middle, scale(up, ground_m + SHOULDER_M))
    return Surroundings(
        along=along,
        middle_m=middle,
        shoulder_m={
            "a": add(raised, scale(across, half_m)),
            "b": subtract(raised, scale(across, half_m)),
        },
    )


class Site:
    """What stands already when a component comes: all that came before it."""

    def __init__(self, statics: Statics, coming: Sequence[Arrival]) -> None:
        self.statics = statics
        self._place = {a.id: k for k, a in enumerate(coming)}
        solids = [statics.solid_by_id[a.id] for a in coming]
        self._obstacles = Obstacles(solids, _HALF_WIDTH_M)

    def is_there(self, other: ComponentId, before: ComponentId) -> bool:
        """Whether a component came before another one."""
        return self._place.get(other, len(self._place)) < self._place[before]

    def is_hidden(self, component: ComponentId, middle: Vector, shoulder_m: Vector) -> bool:
        """Whether something that it is not joined to stands between its middle and a shoulder."""
        towards = subtract(shoulder_m, middle)
        room_m = distance(middle, shoulder_m) - STEP_M
        start = add(middle, scale(unit(towards), _NEAR_M))
        joined = self.statics.joined[component]
        return self._obstacles.hide(
            start,
            unit(towards),
            max(0.0, room_m - _NEAR_M),
            self._place[component],
            {self._place[j] for j in joined if j in self._place},
        )

    def blocked(
        self, component: ComponentId, corridors: Sequence[tuple[Vector, Vector]]
    ) -> list[bool]:
        """Return for each start and direction whether something stands in the corridor there."""
        starts, directions = np.array(corridors).swapaxes(0, 1)
        points = samples(starts, directions, CORRIDOR_M)
        near = self._obstacles.near(points, self._place[component])
        held = self._obstacles.held(points, near.tolist())
        return [bool(corridor.any()) for corridor in np.split(held, len(corridors))]


def side_of(component: Component, arrival: Arrival, site: Site, around: Surroundings) -> str:
    """Return the long side that a component comes from.

    Its way in decides; if that leads to neither side, the side from which it is in plain sight
    (what it is joined to does not hide it); if both or none is, the nearer one.
    """
    outwards = unit(subtract(around.shoulder_m["a"], around.shoulder_m["b"]))
    lean = dot(arrival.way.direction, outwards) if arrival.way is not None else 0.0
    if abs(lean) > _LEANS:
        return "a" if lean > 0.0 else "b"
    middle = component.world_T_component.position_m
    return min(
        "ab",
        key=lambda side: (
            site.is_hidden(component.id, middle, around.shoulder_m[side]),
            round(distance(middle, around.shoulder_m[side]), 4),
        ),
    )


def turn_of(component: Component, site: Site, shoulder_m: Vector) -> Pose:
    """Return how the piece lies on its pile: turned about its length, the gripper's face up.

    The gripper takes a piece from above, and still has it by this face when it is placed: it
    should look at the arm, with room in front, and the faces beside it free for the fingers.

    Args:
        component: A box-shaped target.
        site: What is built before it.
        shoulder_m: Where the arm's shoulder is taken to be.
    """
    pose = component.world_T_component
    axes = (pose.x_axis, pose.y_axis, pose.z_axis)
    looks = [_look(component, axes, *face) for face in _FACES]
    blocked = iter(site.blocked(component.id, [c for look in looks for c in look.corridors]))
    worth = [
        _worth(component, site, shoulder_m, look, [next(blocked) for _ in look.corridors])
        for look in looks
    ]
    axis, sign = _FACES[worth.index(max(worth))]
    if axis == 1:
        return rotation((1.0, 0.0, 0.0), sign * _RIGHT_ANGLE)
    return Pose() if sign > 0.0 else rotation((1.0, 0.0, 0.0), 2.0 * _RIGHT_ANGLE)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Look:
    """One long face of a component, as the gripper would meet it.

    Attributes:
        closing: Direction in which the fingers close.
        offsets_m: Places along the component's middle line.
        corridors: For each place its point on the face, and the way out of it.
    """

    normal: Vector
    closing: Vector
    offsets_m: Sequence[float]
    corridors: Sequence[tuple[Vector, Vector]]


def _look(
    component: Component, axes: tuple[Vector, Vector, Vector], axis: int, sign: float
) -> _Look:
    assert isinstance(component.geometry, BoxGeometry)  # noqa: S101 - solids are boxes
    size_m = component.geometry.size_m
    normal = scale(axes[axis], sign)
    surface = add(component.world_T_component.position_m, scale(normal, size_m[axis] / 2.0))
    offsets = [o for o in _OFFSETS_M if o == 0.0 or abs(o) < size_m[0] / 2.0 - _HALF_WIDTH_M]
    return _Look(
        normal=normal,
        closing=axes[3 - axis],
        offsets_m=offsets,
        corridors=[(add(surface, scale(axes[0], o)), normal) for o in offsets],
    )


def _worth(
    component: Component, site: Site, shoulder_m: Vector, look: _Look, blocked: Sequence[bool]
) -> float:
    covered = sum(
        share
        for other, share, direction in _covers(component, site.statics)
        if (other is None or site.is_there(other, component.id))
        and (dot(direction, look.normal) > _LEANS or abs(dot(direction, look.closing)) > _LEANS)
    )
    towards = unit(subtract(shoulder_m, component.world_T_component.position_m))
    return (
        dot(look.normal, towards)
        - _COVERED * covered
        - min(
            _BLOCKED if is_blocked else _ASIDE * abs(o)
            for o, is_blocked in zip(look.offsets_m, blocked, strict=True)
        )
    )


def _covers(
    component: Component, statics: Statics
) -> list[tuple[ComponentId | None, float, Vector]]:
    """Return what touches its long faces: who (None: the ground), share of a face, direction."""
    assert isinstance(component.geometry, BoxGeometry)  # noqa: S101 - solids are boxes
    length, width, height = component.geometry.size_m
    area_m2 = length * min(width, height)
    found: list[tuple[ComponentId | None, float, Vector]] = [
        (c.other, min(1.0, c.area_m2 / area_m2), c.normal) for c in statics.touching[component.id]
    ]
    if statics.solid_by_id[component.id].lowest_m(statics.up) <= statics.ground_m + GROUND_M:
        found.append((None, 1.0, scale(statics.up, -1.0)))
    return found


def _horizontal_axes(up: Vector) -> tuple[Vector, Vector]:
    hint: Vector = (1.0, 0.0, 0.0) if abs(up[0]) < abs(up[2]) else (0.0, 0.0, 1.0)
    along = unit(subtract(hint, scale(up, dot(up, hint))))
    return along, cross(up, along)


def _extent(solids: list[Solid], axis: Vector) -> float:
    return max(s.highest_m(axis) for s in solids) - min(s.lowest_m(axis) for s in solids)


def _middle(solids: list[Solid], axis: Vector) -> float:
    return (max(s.highest_m(axis) for s in solids) + min(s.lowest_m(axis) for s in solids)) / 2.0


def _sum(vectors: Iterable[Vector]) -> Vector:
    total: Vector = (0.0, 0.0, 0.0)
    for vector in vectors:
        total = add(total, vector)
    return total
