"""Seeded frames on the table of the case study's cell, as a planner of such cells might meet them.

Everything that is drawn by lot stays within what the cell could hold: supports and studs fit on
the table and on the pallets, pieces fit between the fingers, nails fit the nail gun. Whether the
arms reach everything, and what is in the way, is left open.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from random import Random

import pytest

from builders_building import nail, piece
from builders_planning import EXAMPLES, B
from sitewright.app.project import Project, read_project
from sitewright.building_model.component import BoxGeometry, Component, Layer, Operation
from sitewright.building_model.model import BuildingModel, Stack
from sitewright.building_model.piling import piled
from sitewright.foundation.ids import ComponentId, StackId, StockPlaceId
from sitewright.foundation.pose import Pose, Vector, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.robot_team.cell import Cell, Fixture, StockPlace

pytest.importorskip("shapely", reason="needs shapely, which the extra 'rhino' brings")

from shapely import Point, Polygon, box
from shapely.affinity import rotate, translate

_UP: Vector = (0.0, 0.0, 1.0)
_QUARTER_RAD = math.pi / 2.0
_STAND_FOOT_M = -0.02
"""Height of the floor's top."""
_STAND_WIDTH_M, _RIM_M = 0.30, 0.10
_ROOM_M = 0.10
"""Between what stands side by side on the floor."""


def _footprint(x_m: float, y_m: float, along_m: float, across_m: float, turn_rad: float) -> Polygon:
    flat = box(-along_m / 2.0, -across_m / 2.0, along_m / 2.0, across_m / 2.0)
    return translate(rotate(flat, turn_rad, origin=(0.0, 0.0), use_radians=True), x_m, y_m)


_TAKEN = (
    _footprint(0.0, 0.0, 1.5, 2.6, 0.0),  # the assembly table
    _footprint(-3.2, 0.0, 0.3, 2.5, 0.0),  # the buffer
    _footprint(0.0, -2.9, 8.0, 0.1, 0.0),  # the walkway
    Point(-1.6, 0.0).buffer(0.5),  # robot A's foot
)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Lot:
    """What was drawn for one frame; metres and radians.

    Attributes:
        support_x_m: Where the supports lie across the table, from one robot to the other.
        stud_y_m: Where the studs lie along the supports.
        turn_rad: Turn of the whole frame on the table.
        nails: For each support, so many nails in each stud.
        hold_until: So many of a stud's nails before it is let go.
        pallets: Place and turn of the supports' and of the studs' pallet.
    """

    support_m: Vector
    stud_m: Vector
    support_x_m: tuple[float, ...]
    stud_y_m: tuple[float, ...]
    turn_rad: float
    shift_m: tuple[float, float]
    nails: int
    hold_until: int
    pallets: tuple[Pose, Pose]


def random_frame(seed: int, *, nailer_away_m: float = 0.0) -> Project:
    """Return the frame of a seed: two or three supports, two to six studs, nails, two pallets.

    Args:
        seed: Of all lots.
        nailer_away_m: The nailer stands so much further from the table than in the case study.
    """
    lot = _drawn(Random(seed))  # noqa: S311 - frames are no secrets
    project = read_project(EXAMPLES / "wooden_frame")
    model_T_frame = translation(*lot.shift_m, 0.0) @ rotation(_UP, lot.turn_rad)
    supports = list(_supports(lot, model_T_frame))
    targets = [*supports, *_studs(lot, model_T_frame, supports)]
    stacks = [
        _pile("supporting-stud", lot.support_m, len(lot.support_x_m)),
        _pile("transverse-stud", lot.stud_m, len(lot.stud_y_m)),
    ]
    pieces = [c for stack, items in stacks for c in piled(stack, items)]
    model = BuildingModel(
        name=f"random frame {seed}",
        component_by_id={c.id: c for c in sorted((*targets, *pieces), key=lambda c: c.id)},
        stacks=tuple(stack for stack, _ in stacks),
    )
    return replace(
        project, model=model, cell=_with_nailer(_with_pallets(project.cell, lot), nailer_away_m)
    )


def _drawn(lots: Random) -> _Lot:
    rows = lots.choice((2, 2, 2, 3))
    reach_x_m = lots.uniform(0.35, 0.70)
    count = lots.randint(2, 6)
    support_m = (lots.uniform(1.4, 2.4), lots.choice((0.06, 0.09, 0.12)), lots.uniform(0.06, 0.16))
    stud_m = (
        2.0 * reach_x_m + lots.uniform(0.12, 0.6),
        lots.choice((0.06, 0.09, 0.12)),
        lots.uniform(0.035, 0.07),
    )
    nails = lots.choice((1, 2))
    return _Lot(
        support_m=support_m,
        stud_m=stud_m,
        support_x_m=(-reach_x_m, reach_x_m) if rows == 2 else (-reach_x_m, 0.0, reach_x_m),
        stud_y_m=tuple(_spread(lots, count, support_m[0] / 2.0 - 0.1, 2.5 * stud_m[1])),
        turn_rad=lots.choice((0.0, 0.0, lots.uniform(-0.12, 0.12))),
        shift_m=(lots.uniform(-0.05, 0.05), lots.uniform(-1.0, 1.0) * (1.25 - support_m[0] / 2.0)),
        nails=nails,
        hold_until=lots.choice((1, 1, 2)),
        pallets=(_pallet(lots, 1.0, support_m), _pallet(lots, -1.0, stud_m)),
    )


def _spread(lots: Random, count: int, half_m: float, least_gap_m: float) -> list[float]:
    """Return places within +-half, at least a gap apart, in order; as many as there is room for."""
    count = min(count, int(2.0 * half_m / least_gap_m) + 1)
    free_m = 2.0 * half_m - (count - 1) * least_gap_m
    cuts = sorted(lots.uniform(0.0, free_m) for _ in range(count))
    return [cut + k * least_gap_m - half_m for k, cut in enumerate(cuts)]


def _pallet(lots: Random, side: float, size_m: Vector) -> Pose:
    """Return the pose of a pallet's surface on one side of robot A, with room around it."""
    while True:
        x_m, y_m = -1.6 + lots.uniform(-0.4, 0.3), side * lots.uniform(1.45, 1.8)
        z_m, turn_rad = lots.uniform(0.2, 0.5), lots.uniform(-0.35, 0.35)
        footprint = _footprint(x_m, y_m, size_m[0] + _RIM_M, _STAND_WIDTH_M, turn_rad)
        if all(footprint.distance(thing) > _ROOM_M for thing in _TAKEN):
            return translation(x_m, y_m, z_m) @ rotation(_UP, turn_rad)


def _supports(lot: _Lot, model_T_frame: Pose) -> Iterator[Component]:
    for number, x_m in enumerate(lot.support_x_m, start=1):
        lying = translation(x_m, 0.0, lot.support_m[2] / 2.0) @ rotation(_UP, _QUARTER_RAD)
        yield Component(
            id=ComponentId(f"support-{number}"),
            layer=Layer.TARGET,
            type="supporting-stud",
            geometry=BoxGeometry(lot.support_m),
            world_T_component=model_T_frame @ lying,
            ground=True,
            order=1,
        )


def _studs(lot: _Lot, model_T_frame: Pose, supports: list[Component]) -> Iterator[Component]:
    z_m = lot.support_m[2] + lot.stud_m[2] / 2.0
    for number, y_m in enumerate(lot.stud_y_m, start=1):
        name = f"stud-{number}"
        yield Component(
            id=ComponentId(name),
            layer=Layer.TARGET,
            type="transverse-stud",
            geometry=BoxGeometry(lot.stud_m),
            world_T_component=model_T_frame @ translation(0.0, y_m, z_m),
            construction_parents=tuple(s.id for s in supports),
            order=2,
            hold_until_fasteners=lot.hold_until,
            operations=tuple(_nails(lot, name, supports)),
        )


def _nails(lot: _Lot, stud: str, supports: list[Component]) -> Iterator[Operation]:
    spread_m = 0.22 * lot.stud_m[1]
    number = 0
    for x_m, support in zip(lot.support_x_m, supports, strict=True):
        for k in range(lot.nails):
            number += 1
            across_m = 0.0 if lot.nails == 1 else (spread_m, -spread_m)[k]
            yield nail(
                f"{stud}.nail-{number}",
                on=(stud, support.id),
                at_m=(x_m, across_m, lot.stud_m[2] / 2.0),
            )


def _pile(kind: str, size_m: Vector, count: int) -> tuple[Stack, list[Component]]:
    items = [piece(f"{kind}-piece-{k}", kind=kind, size_m=size_m) for k in range(1, count + 1)]
    stack = Stack(
        id=StackId(f"pile-{kind}"),
        place=StockPlaceId(f"pallet-{kind}"),
        items=tuple(c.id for c in items),
    )
    return stack, items


def _with_pallets(cell: Cell, lot: _Lot) -> Cell:
    """Return the cell with this frame's pallets instead of its own."""
    kept = {i: f for i, f in cell.fixture_by_id.items() if not i.startswith("pallet-")}
    places = {}
    for kind, size_m, pose in zip(
        ("supporting-stud", "transverse-stud"),
        (lot.support_m, lot.stud_m),
        lot.pallets,
        strict=True,
    ):
        place = StockPlace(id=StockPlaceId(f"pallet-{kind}"), world_T_stock=pose)
        places[place.id] = place
        height_m = pose.position_m[2] - _STAND_FOOT_M
        stand = Fixture(
            id=f"pallet-{kind}-stand",  # type: ignore[arg-type]
            shape=(Box((size_m[0] + _RIM_M, _STAND_WIDTH_M, height_m)),),
            world_T_fixture=pose @ translation(0.0, 0.0, -height_m / 2.0),
        )
        kept[stand.id] = stand
    return replace(cell, fixture_by_id=kept, stock_place_by_id=places)


def _with_nailer(cell: Cell, away_m: float) -> Cell:
    nailer = cell.robot_by_id[B]
    there = replace(nailer, world_T_base=translation(away_m, 0.0, 0.0) @ nailer.world_T_base)
    return replace(cell, robot_by_id={**cell.robot_by_id, B: there})
