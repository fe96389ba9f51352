"""Generated walls that lie on the table of the case study's cell, as long or as dense as asked."""

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
from sitewright.foundation.pose import Pose, Vector, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.robot_team.cell import Fixture, StockPlace

SUPPORT_M: Vector = (2.4, 0.09, 0.14)
STUD_M: Vector = (1.8, 0.09, 0.04)
QUARTER = rotation((0.0, 0.0, 1.0), 1.5707963267948966)


def frame_wall(studs: int, *, pitch_m: float = 0.6) -> Project:
    """Return two rows of supports along y and studs across them, four nails each."""
    length_m = max(SUPPORT_M[0], (studs - 1) * pitch_m + 0.2)
    rows = -(-int(length_m * 1000) // int(SUPPORT_M[0] * 1000))
    targets = [
        _support(f"support-{side}-{k}", x, (k - (rows - 1) / 2.0) * SUPPORT_M[0])
        for k in range(rows)
        for side, x in (("w", -0.6), ("e", 0.6))
    ]
    targets += [
        _stud(f"stud-{k}", (k - (studs - 1) / 2.0) * pitch_m, targets) for k in range(studs)
    ]
    stock = [
        *_piles("thick", SUPPORT_M, "supporting-stud", 2 * rows, translation(-1.6, 1.55, 0.30)),
        *_piles("thin", STUD_M, "transverse-stud", studs, translation(-1.6, -1.55, 0.30)),
    ]
    return _project(targets, stock, table_m=(1.5, max(2.6, rows * SUPPORT_M[0] + 0.2), 0.42))


def lattice(layers: int, per_layer: int) -> Project:
    """Return crossed layers of laths on the table, each resting on the one below; no nails."""
    lath_m: Vector = (1.4, 0.045, 0.03)
    targets: list[Component] = []
    for layer in range(layers):
        below = [t.id for t in targets[-per_layer:]] if layer else []
        turn = QUARTER if layer % 2 else Pose()
        for k in range(per_layer):
            shift_m = (k - (per_layer - 1) / 2.0) * 1.4 / per_layer
            x, y = (shift_m, 0.0) if layer % 2 else (0.0, shift_m)
            targets.append(
                Component(
                    id=ComponentId(f"lath-{layer:02d}-{k:02d}"),
                    layer=Layer.TARGET,
                    type="lath",
                    geometry=BoxGeometry(lath_m),
                    world_T_component=translation(x, y, (layer + 0.5) * lath_m[2]) @ turn,
                    construction_parents=tuple(below),
                    ground=layer == 0,
                    order=layer,
                )
            )
    half = len(targets) // 2
    stock = [
        *_piles("south", lath_m, "lath", half, translation(-1.6, -1.4, 0.30), per_pile=30),
        *_piles(
            "north", lath_m, "lath", len(targets) - half, translation(-1.6, 1.4, 0.30), per_pile=30
        ),
    ]
    return _project(targets, stock, table_m=(1.5, 2.6, 0.42))


def _support(name: str, x_m: float, y_m: float) -> Component:
    return Component(
        id=ComponentId(name),
        layer=Layer.TARGET,
        type="supporting-stud",
        geometry=BoxGeometry(SUPPORT_M),
        world_T_component=translation(x_m, y_m, SUPPORT_M[2] / 2.0) @ QUARTER,
        ground=True,
        order=1,
    )


def _stud(name: str, y_m: float, supports: list[Component]) -> Component:
    under = [
        s
        for s in supports
        if s.type == "supporting-stud"
        and abs(s.world_T_component.position_m[1] - y_m) <= SUPPORT_M[0] / 2.0
    ]
    ends = {s.world_T_component.position_m[0]: s.id for s in under}
    return Component(
        id=ComponentId(name),
        layer=Layer.TARGET,
        type="transverse-stud",
        geometry=BoxGeometry(STUD_M),
        world_T_component=translation(0.0, y_m, SUPPORT_M[2] + STUD_M[2] / 2.0),
        construction_parents=tuple(ends.values()),
        order=2,
        hold_until_fasteners=2,
        operations=tuple(
            nail(f"{name}.nail-{number}", on=(name, ends[x]), at_m=(x, dy, STUD_M[2] / 2.0))
            for number, (x, dy) in enumerate(
                ((0.6, -0.025), (0.6, 0.025), (-0.6, -0.025), (-0.6, 0.025)), start=1
            )
        ),
    )


def _piles(
    name: str,
    size_m: Vector,
    kind: str,
    count: int,
    world_T_first: Pose,
    *,
    per_pile: int = 10,
) -> Iterator[tuple[Stack, list[Component], StockPlace, Fixture]]:
    """Yield piles side by side, each at a stock place and on a stand of its own."""
    away = -1.0 if world_T_first.position_m[1] < 0.0 else 1.0
    for number, start in enumerate(range(0, count, per_pile)):
        place = StockPlaceId(f"place-{name}-{number}")
        world_T_stock = translation(0.0, away * number * (size_m[1] + 0.15), 0.0) @ world_T_first
        items = [
            piece(f"{name}-{k}", kind=kind, size_m=size_m)
            for k in range(start, min(start + per_pile, count))
        ]
        stack = Stack(
            id=StackId(f"pile-{name}-{number}"), place=place, items=tuple(c.id for c in items)
        )
        x, y, z = world_T_stock.position_m
        stand = Fixture(
            id=f"stand-{name}-{number}",  # type: ignore[arg-type]
            shape=(Box((size_m[0], size_m[1], z)),),
            world_T_fixture=translation(x, y, z / 2.0),
        )
        yield stack, piled(stack, items), StockPlace(id=place, world_T_stock=world_T_stock), stand


def _project(
    targets: list[Component],
    stock: list[tuple[Stack, list[Component], StockPlace, Fixture]],
    *,
    table_m: Vector,
) -> Project:
    """Return the targets in the case study's cell, with a table and stock of their own."""
    project = read_project(EXAMPLES / "wooden_frame")
    pieces = [c for _, items, _, _ in stock for c in items]
    model = BuildingModel(
        name="generated wall",
        component_by_id={c.id: c for c in sorted((*targets, *pieces), key=lambda c: c.id)},
        stacks=tuple(stack for stack, _, _, _ in stock),
    )
    kept = {i: f for i, f in project.cell.fixture_by_id.items() if "stand" not in i}
    table = next(f for i, f in kept.items() if i == "assembly-table")
    cell = replace(
        project.cell,
        fixture_by_id={
            **kept,
            table.id: replace(table, shape=(Box(table_m),)),
            **{f.id: f for _, _, _, f in stock},
        },
        stock_place_by_id={p.id: p for _, _, p, _ in stock},
    )
    return replace(project, model=model, cell=cell)
