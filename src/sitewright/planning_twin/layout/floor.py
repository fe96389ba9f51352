"""The floor of a cell: where things may stand, and what would stand in whose way."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, islice, pairwise

from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.shapes import Shape, moved
from sitewright.planning_twin.layout.movables import Arrangement, Movable, MovableKind, Shift, Yard
from sitewright.robot_team.cell import Cell, Robot
from sitewright.robot_team.kinematics import link_poses

_ELBOW_ROOM_M = 0.10
"""Between what stands side by side."""
_OVERLAP_M = 0.01
_AROUND_M, _FLOOR_M2 = 2.0, 12.0
Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Footprint:
    """A rectangle on the floor, turned or not, and the heights that it takes up."""

    corners_m: tuple[Point, ...]
    low_m: float
    high_m: float

    def shifted(self, motion: Pose) -> Footprint:
        """Return it moved on the floor."""
        points = [motion.apply((x, y, 0.0)) for x, y in self.corners_m]
        return Footprint(tuple((x, y) for x, y, _ in points), self.low_m, self.high_m)

    def meets(self, other: Footprint, room_m: float) -> bool:
        """Tell whether two would stand in each other's way, or nearer than some room."""
        heights_m = min(self.high_m, other.high_m) - max(self.low_m, other.low_m)
        if heights_m <= _OVERLAP_M:
            return False
        axes = (*_normals(self.corners_m), *_normals(other.corners_m))
        return all(_gap_m(self.corners_m, other.corners_m, axis) < room_m for axis in axes)

    def is_within(self, area_m: tuple[Point, Point]) -> bool:
        """Tell whether it lies in a rectangle along the world's axes."""
        (low_x, low_y), (high_x, high_y) = area_m
        return all(low_x <= x <= high_x and low_y <= y <= high_y for x, y in self.corners_m)


@dataclass(frozen=True, slots=True, kw_only=True)
class Floor:
    """Where things may stand.

    Attributes:
        area_m: Corners of the floor area that may be used.
        footprints: Of each movable where it is now, with all on it.
        fixed: Of what stays: the building, tables, fences, tool racks.
        tolerated: Pairs that meet already, by id or number of what is fixed.
    """

    area_m: tuple[Point, Point]
    yard: Yard
    footprints: Mapping[str, Footprint]
    fixed: tuple[Footprint, ...]
    tolerated: frozenset[tuple[str, str]] = frozenset()

    def is_free(self, arrangement: Arrangement) -> bool:
        """Tell whether an arrangement keeps to the area, and nothing stands in another's way."""
        placed = self.placed(arrangement)
        moving = [i for i, shift in arrangement.items() if shift != Shift()]
        is_within = all(placed[i].is_within(self.area_m) for i in moving)
        return is_within and not set(self.meeting(placed)) - self.tolerated

    def placed(self, arrangement: Arrangement) -> dict[str, Footprint]:
        """Return the footprints of all movables in an arrangement."""
        return {
            m.id: self.footprints[m.id].shifted(arrangement.get(m.id, Shift()).moves(m))
            for m in self.yard.movables
        }

    def meeting(self, placed: Mapping[str, Footprint]) -> Iterator[tuple[str, str]]:
        """Yield the pairs that would stand in each other's way."""
        for a, b in combinations(sorted(placed), 2):
            if placed[a].meets(placed[b], _ELBOW_ROOM_M):
                yield a, b
        for a in sorted(placed):
            for number, other in enumerate(self.fixed):
                if placed[a].meets(other, _ELBOW_ROOM_M):
                    yield a, f"fixed {number}"


def floor_of(
    yard: Yard,
    pieces: Mapping[str, Sequence[tuple[Shape, Pose]]],
    building: Sequence[tuple[Shape, Pose]],
    area_m: tuple[Point, Point] | None = None,
) -> Floor:
    """Return where the movables of a cell may stand.

    Args:
        yard: The cell.
        pieces: What lies at each stock place, where it lies now.
        building: Targets and what else of the model stands or must be kept out of.
        area_m: Corners of the floor area; that of the widest fixture by default.
    """
    cell = yard.cell
    taken = {f for m in yard.movables for f in m.fixtures}
    fixed = [(f.shape, f.world_T_fixture) for i, f in cell.fixture_by_id.items() if i not in taken]
    fixed += [(z.shape, z.world_T_zone) for z in cell.zone_by_id.values()]
    whole = [p for body in building for p in _points([body])]
    still = [footprint(_points([body])) for body in fixed]
    floor = Floor(
        area_m=area_m or _widest(cell),
        yard=yard,
        footprints={m.id: _of(cell, m, pieces.get(m.id, ())) for m in yard.movables},
        fixed=(*still, *([footprint(whole)] if whole else [])),
    )
    here = floor.placed({})
    return replace(floor, tolerated=frozenset(floor.meeting(here)))


def footprint(points: Sequence[Vector], frame: Pose | None = None) -> Footprint:
    """Return the rectangle around points, along the axes of a frame (the world's by default)."""
    at = frame or Pose()
    local = [at.inverse().apply(p) for p in points]
    xs, ys = [p[0] for p in local], [p[1] for p in local]
    corners = [(min(xs), min(ys)), (max(xs), min(ys)), (max(xs), max(ys)), (min(xs), max(ys))]
    placed = [at.apply((x, y, 0.0)) for x, y in corners]
    heights_m = [p[2] for p in points]
    return Footprint(tuple((x, y) for x, y, _ in placed), min(heights_m), max(heights_m))


def _of(cell: Cell, movable: Movable, pieces: Iterable[tuple[Shape, Pose]]) -> Footprint:
    """Return the footprint of a robot's foot, or of all pieces at a stock place."""
    fixtures = (cell.fixture_by_id[f] for f in movable.fixtures)
    bodies = [(f.shape, f.world_T_fixture) for f in fixtures]
    if movable.kind is MovableKind.ROBOT:
        bodies += _foot(next(r for i, r in cell.robot_by_id.items() if i == movable.id))
    bodies += pieces
    points = _points(bodies) or [movable.world_T_start.position_m]
    return footprint(points, movable.world_T_start)


def _foot(robot: Robot) -> list[tuple[Shape, Pose]]:
    """Return the links that no joint moves, and those that a rail carries the arm on."""
    poses = link_poses(robot.description, robot.home_q_rad)
    root = next(link for link in robot.description.links if link.name == robot.description.root)
    return [(root.shape, robot.world_T_base @ poses[root.name])]


def _points(bodies: Iterable[tuple[Shape, Pose]]) -> list[Vector]:
    return [v for shape, at in bodies for part in moved(shape, at) for v in part.vertices_m()]


def _widest(cell: Cell) -> tuple[Point, Point]:
    """Return the area of the widest fixture, or two metres around everything."""
    rectangles = [
        footprint(_points([(f.shape, f.world_T_fixture)])) for f in cell.fixture_by_id.values()
    ]
    widest = max(rectangles, key=_area_m2, default=None)
    bases = [r.world_T_base.position_m[:2] for r in cell.robot_by_id.values()]
    if widest is not None and _area_m2(widest) > _FLOOR_M2:
        return widest.corners_m[0], widest.corners_m[2]
    points = [*bases, *(c for r in rectangles for c in r.corners_m)]
    low, high = ((f(p[0] for p in points), f(p[1] for p in points)) for f in (min, max))
    return (low[0] - _AROUND_M, low[1] - _AROUND_M), (high[0] + _AROUND_M, high[1] + _AROUND_M)


def _area_m2(rectangle: Footprint) -> float:
    a, b, _, d = rectangle.corners_m
    return math.dist(a, b) * math.dist(a, d)


def _normals(corners: Sequence[Point]) -> Iterator[Point]:
    for (ax, ay), (bx, by) in islice(pairwise(corners), 2):
        length = math.hypot(bx - ax, by - ay) or 1.0
        yield (ay - by) / length, (bx - ax) / length


def _gap_m(a: Sequence[Point], b: Sequence[Point], axis: Point) -> float:
    """Return how far two rectangles are apart along an axis; negative where they overlap."""
    along_a, along_b = ([x * axis[0] + y * axis[1] for x, y in c] for c in (a, b))
    return max(min(along_a) - max(along_b), min(along_b) - max(along_a))
