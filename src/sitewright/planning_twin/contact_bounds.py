"""The bounds of declared contacts: how deep, how long, and where in a motion they may be."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from itertools import groupby, pairwise

from sitewright.foundation.pose import Pose, cross, distance, norm, subtract, unit
from sitewright.planning_twin.motion import JointPath, PathSegment
from sitewright.planning_twin.scene import Attachment, Pair, SceneSnapshot
from sitewright.robot_team.kinematics import tip_pose

DEEPEST_M = -0.001
"""Sensed poses of bodies that touch may overlap by this much."""
DEEPEST_MATING_M = -0.003
"""A flange and the end effector that it mates with: the arm's envelope stands over its face."""
LONGEST_M = 0.035
"""The tip's way in contact: the last (first) three centimetres, and a sensed offset."""
LONGEST_SLIDE_M = 0.340
"""The same where a held piece slides along its neighbours."""
_STRAIGHT_M = 0.001
_TURN_RAD = 0.01
_ROUNDING_M = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class ContactUse:
    """How much of what is allowed a path uses.

    Attributes:
        deepest_m: Lowest threshold of a pair that moves; 0 if none may touch.
        longest_m: Longest way of the tip in one stretch in which something may touch.
        wrong: What goes beyond the bounds, for people.
    """

    deepest_m: float
    longest_m: float
    wrong: tuple[str, ...]


def contact_use(scene: SceneSnapshot, path: JointPath, pieces: Collection[str] = ()) -> ContactUse:
    """Return which contacts a path may make, and what of that is out of bounds.

    A pair may touch if its threshold is below zero. If the path moves the pair, it may touch
    only in one stretch at the start and one at the end of the path. These are straight, the tip
    does not turn in them, and they are short.

    Args:
        scene: What the path is certified in.
        path: Whose contacts are looked at.
        pieces: Names of pieces of material; one that is held may slide for longer.
    """
    touching = [_touching(scene, path, segment) for segment in path.segments]

    def longest_m(stretch: range) -> float:
        """A held piece may slide along its neighbours for longer than a tool may touch."""
        sliding = _carried(scene, path).intersection(pieces)
        pairs = {pair for number in stretch for pair in touching[number]}
        return LONGEST_SLIDE_M if all(sliding.intersection(p) for p in pairs) else LONGEST_M

    thresholds = [s.threshold_m[p] for s, t in zip(path.segments, touching, strict=True) for p in t]
    stretches = list(_stretches(touching))
    lengths = [_length_m(scene, path, stretch) for stretch in stretches]
    wrong = [
        *_too_deep(scene, path),
        *_in_the_middle(stretches, len(path.segments)),
        *(
            w
            for stretch in stretches
            for w in _bad_stretch(scene, path, stretch, longest_m(stretch))
        ),
    ]
    return ContactUse(
        deepest_m=min(thresholds, default=0.0),
        longest_m=max(lengths, default=0.0),
        wrong=tuple(wrong),
    )


def _touching(scene: SceneSnapshot, path: JointPath, segment: PathSegment) -> list[Pair]:
    """Return the pairs that the path moves and that may touch in a segment."""
    if len(set(segment.waypoints_rad)) == 1:
        return []
    moving = _carried(scene, path)
    return [
        pair
        for pair, threshold_m in segment.threshold_m.items()
        if threshold_m < 0.0 and any(name in moving for name in pair)
    ]


def _carried(scene: SceneSnapshot, path: JointPath) -> set[str]:
    """Return the names of all that the path's robot moves."""
    bodies = {b.id for b in scene.bodies.values() if _robot_of(b.placement) == path.robot}
    links = scene.robots[path.robot].description.links
    return {*bodies, *(f"{path.robot}/{link.name}" for link in links)}


def _robot_of(placement: Pose | Attachment) -> str | None:
    return placement.robot if isinstance(placement, Attachment) else None


def _too_deep(scene: SceneSnapshot, path: JointPath) -> Iterator[str]:
    arms = tuple(f"{robot}/" for robot in scene.robots)
    for number, segment in enumerate(path.segments):
        for pair, threshold_m in segment.threshold_m.items():
            is_mating = any(name.startswith(arms) for name in pair)
            deepest_m = DEEPEST_MATING_M if is_mating else DEEPEST_M
            if threshold_m < deepest_m - _ROUNDING_M:
                yield (
                    f"{' and '.join(pair)} may overlap by {-threshold_m * 1e3:.1f} mm in segment "
                    f"{number}; at most {-deepest_m * 1e3:.0f} mm are allowed"
                )


def _stretches(touching: list[list[Pair]]) -> Iterator[range]:
    """Yield the runs of segments in which something that moves may touch."""
    numbered = enumerate(touching)
    for may_touch, group in groupby(numbered, key=lambda item: bool(item[1])):
        if may_touch:
            numbers = [number for number, _ in group]
            yield range(numbers[0], numbers[-1] + 1)


def _in_the_middle(stretches: list[range], segments: int) -> Iterator[str]:
    for stretch in stretches:
        if stretch.start > 0 and stretch.stop < segments:
            yield f"segment {stretch.start} allows contacts in the middle of the path"


def _bad_stretch(
    scene: SceneSnapshot, path: JointPath, stretch: range, longest_m: float
) -> Iterator[str]:
    tips = _tips(scene, path, stretch)
    length_m = _length_m(scene, path, stretch)
    where = f"segments {stretch.start} to {stretch.stop - 1} allow contacts"
    if length_m > longest_m + _ROUNDING_M:
        yield f"{where} over {length_m * 1e3:.0f} mm; at most {longest_m * 1e3:.0f} mm are allowed"
    if any(tip.angle_to_rad(tips[0]) > _TURN_RAD for tip in tips):
        yield f"{where} while the tip turns"
    if any(_off_line_m(tip, tips[0], tips[-1]) > _STRAIGHT_M for tip in tips):
        yield f"{where} off a straight line"


def _tips(scene: SceneSnapshot, path: JointPath, stretch: range) -> list[Pose]:
    arm = scene.robots[path.robot].description
    return [tip_pose(arm, q) for k in stretch for q in path.segments[k].waypoints_rad]


def _length_m(scene: SceneSnapshot, path: JointPath, stretch: range) -> float:
    tips = _tips(scene, path, stretch)
    return sum(a.distance_to_m(b) for a, b in pairwise(tips))


def _off_line_m(point: Pose, start: Pose, end: Pose) -> float:
    way = subtract(end.position_m, start.position_m)
    if norm(way) == 0.0:
        return distance(point.position_m, start.position_m)
    return norm(cross(subtract(point.position_m, start.position_m), unit(way)))
