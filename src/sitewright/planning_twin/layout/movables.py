"""What of a cell can be put elsewhere: robots and stock places, with what stands under them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum

from sitewright.foundation.ids import FixtureId, RobotId, StockPlaceId
from sitewright.foundation.pose import Pose, Vector, rotation, translation
from sitewright.foundation.shapes import moved
from sitewright.robot_team.cell import Cell, Fixture, StationKind

_UP: Vector = (0.0, 0.0, 1.0)
_NEAR_M = 0.06
"""A base plate may be so thick."""
_WIDEST_M2 = 6.0
"""A wider fixture is a floor or a table, and stays."""


class MovableKind(StrEnum):
    """What it is."""

    ROBOT = "robot"
    STOCK = "stock place"


@dataclass(frozen=True, slots=True, kw_only=True)
class Movable:
    """A robot or a stock place.

    Attributes:
        world_T_start: Where it is now.
        fixtures: What stands under it alone, and goes with it.
    """

    id: str
    kind: MovableKind
    world_T_start: Pose
    fixtures: tuple[FixtureId, ...] = ()


@dataclass(frozen=True, slots=True)
class Shift:
    """How far something is put elsewhere: along the world's axes, and about the vertical."""

    x_m: float = 0.0
    y_m: float = 0.0
    yaw_rad: float = 0.0

    @property
    def length_m(self) -> float:
        """Distance from where it was."""
        return math.hypot(self.x_m, self.y_m)

    def moves(self, movable: Movable) -> Pose:
        """Return the motion of the world that takes a movable, and all on it, elsewhere."""
        x, y, z = movable.world_T_start.position_m
        there = translation(x + self.x_m, y + self.y_m, z)
        return there @ rotation(_UP, self.yaw_rad) @ translation(-x, -y, -z)


Arrangement = Mapping[str, Shift]
"""Shifts by id; what is not named stays."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Yard:
    """A cell, and what of it may be put elsewhere.

    Attributes:
        movables: Robots first.
    """

    cell: Cell
    movables: tuple[Movable, ...] = field(default=())

    def arranged(self, arrangement: Arrangement) -> Cell:
        """Return the cell with everything where an arrangement puts it."""
        cell = self.cell
        for movable in self.movables:
            shift = arrangement.get(movable.id, Shift())
            if shift != Shift():
                cell = _moved(cell, movable, shift.moves(movable))
        return cell


def yard_of(cell: Cell, *, kept: Iterable[str] = ()) -> Yard:
    """Return what of a cell may be put elsewhere.

    Args:
        cell: Robots and stock places with a fixture of their own take it along; tool and buffer
            stations stay.
        kept: Ids of robots and stock places that stay where they are.
    """
    stay = frozenset(kept)
    poses: dict[str, tuple[MovableKind, Pose]] = {
        r.id: (MovableKind.ROBOT, r.world_T_base) for r in cell.robot_by_id.values()
    }
    poses |= {s.id: (MovableKind.STOCK, s.world_T_stock) for s in cell.stock_place_by_id.values()}
    under = {
        i: [f.id for f in cell.fixture_by_id.values() if _carries(f, pose)]
        for i, (_, pose) in poses.items()
    }
    loads = [f for found in under.values() for f in found]
    return Yard(
        cell=cell,
        movables=tuple(
            Movable(
                id=i,
                kind=kind,
                world_T_start=pose,
                fixtures=tuple(f for f in under[i] if loads.count(f) == 1),
            )
            for i, (kind, pose) in poses.items()
            if i not in stay
        ),
    )


def _carries(fixture: Fixture, pose: Pose) -> bool:
    """Tell whether a fixture is a pedestal, or a pallet, of what stands at a pose."""
    points = [
        v for part in moved(fixture.shape, fixture.world_T_fixture) for v in part.vertices_m()
    ]
    low_x, low_y = (min(p[k] for p in points) for k in (0, 1))
    high_x, high_y = (max(p[k] for p in points) for k in (0, 1))
    x, y, z = pose.position_m
    is_under = low_x <= x <= high_x and low_y <= y <= high_y
    is_small = (high_x - low_x) * (high_y - low_y) <= _WIDEST_M2
    return is_small and is_under and abs(max(p[2] for p in points) - z) <= _NEAR_M


def _moved(cell: Cell, movable: Movable, motion: Pose) -> Cell:
    fixtures = {
        i: replace(f, world_T_fixture=motion @ f.world_T_fixture)
        for i, f in cell.fixture_by_id.items()
        if i in movable.fixtures
    }
    cell = replace(cell, fixture_by_id={**cell.fixture_by_id, **fixtures})
    if movable.kind is MovableKind.STOCK:
        place = StockPlaceId(movable.id)
        old = cell.stock_place_by_id[place]
        new = replace(old, world_T_stock=motion @ old.world_T_stock)
        return replace(cell, stock_place_by_id={**cell.stock_place_by_id, place: new})
    return _with_robot(cell, RobotId(movable.id), motion)


def _with_robot(cell: Cell, robot: RobotId, motion: Pose) -> Cell:
    """Return the cell with a robot moved; its preparation station is where its home is."""
    old = cell.robot_by_id[robot]
    arms = {**cell.robot_by_id, robot: replace(old, world_T_base=motion @ old.world_T_base)}
    stations = {
        i: replace(s, world_T_station=motion @ s.world_T_station)
        for i, s in cell.station_by_id.items()
        if s.robot == robot and s.kind is StationKind.PREPARATION
    }
    return replace(cell, robot_by_id=arms, station_by_id={**cell.station_by_id, **stations})
