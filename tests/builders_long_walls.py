"""Generated walls of any number of studs, built by arms on tracks as long as the wall."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from builders_building import nail, piece
from builders_planning import EXAMPLES
from sitewright.app.project import Project, read_project
from sitewright.building_model.component import BoxGeometry, Component, Layer
from sitewright.building_model.model import BuildingModel, Stack
from sitewright.building_model.piling import piled
from sitewright.foundation.ids import ComponentId, StackId, StockPlaceId
from sitewright.foundation.pose import Vector, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.robot_team.cell import Cell, Fixture, Robot, StockPlace
from sitewright.robot_team.description import Joints

BAY_M = 2.44
STUDS_PER_BAY = 3
STUD_PITCH_M = 0.78
SUPPORT_M: Vector = (2.4, 0.09, 0.14)
STUD_M: Vector = (1.8, 0.09, 0.04)
_PILE_M: Vector = (-1.55, 0.0, 1.55)
"""Places of piles around the middle of their bay, along the track."""
_STOCK_Y_M = -3.25
_STOCK_Z_M = 0.60
_ACROSS = rotation((0.0, 0.0, 1.0), 1.5707963267948966)
_END_M = 2.5
"""Rails, beds and floor go on for so much beyond the wall."""


def long_wall(studs: int) -> Project:
    """Return bays of two supports and three studs in a row, four nails in each stud.

    The cell is that of the example with tracks, its tracks, table and floor drawn out; each two
    bays have their piles behind the track of the robot that fetches.
    """
    bays = -(-studs // STUDS_PER_BAY)
    middles = [(k - (bays - 1) / 2.0) * BAY_M for k in range(bays)]
    targets: list[Component] = []
    stock: list[tuple[Stack, list[Component], StockPlace, Fixture]] = []
    left = studs
    for number, x_m in enumerate(middles):
        here = min(STUDS_PER_BAY, left)
        left -= here
        targets += _bay(number, x_m, here)
        stock += _piles(number, x_m, here)
    project = read_project(EXAMPLES / "track_frame")
    pieces = [c for _, items, _, _ in stock for c in items]
    model = BuildingModel(
        name="generated long wall",
        component_by_id={c.id: c for c in sorted((*targets, *pieces), key=lambda c: c.id)},
        stacks=tuple(stack for stack, _, _, _ in stock),
    )
    cell = _drawn_out(project.cell, bays * BAY_M)
    cell = replace(
        cell,
        fixture_by_id={**cell.fixture_by_id, **{f.id: f for _, _, _, f in stock}},
        stock_place_by_id={p.id: p for _, _, p, _ in stock},
    )
    return replace(project, model=model, cell=cell)


def _bay(number: int, x_m: float, studs: int) -> Iterator[Component]:
    supports = {
        y: Component(
            id=ComponentId(f"bay-{number:03d}.support-{side}"),
            layer=Layer.TARGET,
            type="supporting-stud",
            geometry=BoxGeometry(SUPPORT_M),
            world_T_component=translation(x_m, y, SUPPORT_M[2] / 2.0),
            ground=True,
            order=2 * number,
        )
        for side, y in (("n", 0.6), ("s", -0.6))
    }
    yield from supports.values()
    for k in range(studs):
        name = f"bay-{number:03d}.stud-{k}"
        shift_m = (k - (STUDS_PER_BAY - 1) / 2.0) * STUD_PITCH_M
        world_T_stud = translation(x_m + shift_m, 0.0, SUPPORT_M[2] + STUD_M[2] / 2.0) @ _ACROSS
        yield Component(
            id=ComponentId(name),
            layer=Layer.TARGET,
            type="transverse-stud",
            geometry=BoxGeometry(STUD_M),
            world_T_component=world_T_stud,
            construction_parents=tuple(s.id for s in supports.values()),
            order=2 * number + 1,
            hold_until_fasteners=2,
            operations=tuple(
                nail(f"{name}.nail-{i}", on=(name, supports[y].id), at_m=(y, d, STUD_M[2] / 2.0))
                for i, (y, d) in enumerate(
                    ((0.6, -0.025), (0.6, 0.025), (-0.6, -0.025), (-0.6, 0.025)), start=1
                )
            ),
        )


def _piles(
    number: int, x_m: float, studs: int
) -> Iterator[tuple[Stack, list[Component], StockPlace, Fixture]]:
    """Yield a bay's piles one behind the other: its two supports in front, its studs behind."""
    for kind, size_m, count, y_m in (
        ("supporting-stud", SUPPORT_M, 2, _STOCK_Y_M),
        ("transverse-stud", STUD_M, studs, _STOCK_Y_M + 0.3),
    ):
        name = f"bay-{number:03d}.{kind}"
        items = [piece(f"{name}-{k}", kind=kind, size_m=size_m) for k in range(count)]
        stack = Stack(
            id=StackId(f"pile-{name}"),
            place=StockPlaceId(f"place-{name}"),
            items=tuple(c.id for c in items),
        )
        stand = Fixture(
            id=f"stand-{name}",  # type: ignore[arg-type]
            shape=(Box((SUPPORT_M[0], 0.2, _STOCK_Z_M)),),
            world_T_fixture=translation(x_m, y_m, _STOCK_Z_M / 2.0),
        )
        place = StockPlace(id=stack.place, world_T_stock=translation(x_m, y_m, _STOCK_Z_M))
        yield stack, piled(stack, items), place, stand


def _drawn_out(cell: Cell, length_m: float) -> Cell:
    """Return the cell with floor, table, beds and rails for a wall of this length."""
    size_by_id = {
        "floor": (length_m + 4.0 * _END_M, 10.0, 0.10),
        "assembly-table": (length_m + 0.4, 1.50, 0.70),
        "bed-a": (length_m + _END_M, 0.80, 0.06),
        "bed-b": (length_m + _END_M, 0.80, 0.06),
    }
    half_m = length_m / 2.0
    return replace(
        cell,
        fixture_by_id={
            i: replace(f, shape=(Box(size_by_id[i]),))
            for i, f in cell.fixture_by_id.items()
            if i in size_by_id
        },
        robot_by_id={i: _on_rail(r, half_m) for i, r in cell.robot_by_id.items()},
    )


def _on_rail(robot: Robot, half_m: float) -> Robot:
    rail, *arm = robot.description.joints
    rail = replace(rail, lower_rad=-half_m, upper_rad=half_m)

    def at(q: Joints) -> Joints:
        return (half_m if q[0] > 0.0 else -half_m, *q[1:])

    return replace(
        robot,
        description=replace(robot.description, joints=(rail, *arm)),
        home_q_rad=at(robot.home_q_rad),
        waits_along_rails=True,
        parking_q_rad=tuple(at(q) for q in robot.parking_q_rad),
    )
