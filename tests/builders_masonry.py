"""A stored wall of blocks for two arms with clamps, in a cell that is only a first guess."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from builders_building import piece
from builders_planning import EXAMPLES, A, B
from sitewright.app.project import Project, read_project
from sitewright.building_model.component import BoxGeometry, Component, Layer
from sitewright.building_model.model import BuildingModel, Stack
from sitewright.building_model.piling import piled
from sitewright.foundation.ids import ComponentId, EndEffectorId, StackId, StockPlaceId
from sitewright.foundation.pose import Pose, Vector, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.robot_team.cell import Cell, EndEffector, EndEffectorKind, Fixture, StockPlace
from sitewright.robot_team.formats.urdf import read_urdf

CLAMP = Path(__file__).parents[1] / "benchmarks" / "block_clamp.urdf"
DENSITY_KG_M3 = 600.0
"""Autoclaved aerated concrete: a whole block weighs 22 kg."""
_HEIGHT_M, _WIDTH_M, _LENGTH_M, _HALF_LENGTH_M = 0.20, 0.40, 0.46, 0.26
_PER_PILE = 7
_MIDDLE_M = (-3.0, 0.5, 0.1)
"""Puts the middle of the stored wall over the origin, its foot on the floor."""


def block_wall(file: Path, *, density_kg_m3: float = DENSITY_KG_M3) -> Project:
    """Return the stored wall as boxes, with open head joints, in a cell that nobody thought about.

    Args:
        file: A `compas_assembly` of blocks.
        density_kg_m3: What the blocks are made of.
    """
    graph = json.loads(file.read_text(encoding="utf-8"))["data"]["graph"]["data"]
    targets = list(_blocks(graph, density_kg_m3))
    kinds = sorted({t.type for t in targets})
    stock = [pile for kind in kinds for pile in _piles(kind, targets, density_kg_m3)]
    places = {
        pile[0].place: StockPlace(id=pile[0].place, world_T_stock=_place(k))
        for k, pile in enumerate(stock)
    }
    pieces = [c for stack, items in stock for c in piled(stack, items)]
    model = BuildingModel(
        name="wall of blocks",
        component_by_id={c.id: c for c in sorted((*targets, *pieces), key=lambda c: c.id)},
        stacks=tuple(stack for stack, _ in stock),
    )
    project = read_project(EXAMPLES / "wooden_frame")
    cell = replace(_with_clamps(project.cell), stock_place_by_id=places)
    return replace(project, model=model, cell=cell)


def _blocks(graph: dict[str, Any], density_kg_m3: float) -> Iterator[Component]:
    corners = {
        name: np.array([[v[a] for a in "xyz"] for v in node["block"]["data"]["vertex"].values()])
        for name, node in graph["node"].items()
    }
    near = {(u, v) for u, others in graph["edge"].items() for v in others}
    near |= {(v, u) for u, v in near}
    for name, points in corners.items():
        middle = points.mean(axis=0)
        along = points[2, :2] - points[1, :2]
        is_half = float(np.linalg.norm(along)) < _WIDTH_M
        below = [v for u, v in near if u == name and corners[v][:, 2].mean() < middle[2] - 0.1]
        x, y, z = (float(m) for m in middle)
        yield Component(
            id=ComponentId(f"block-{int(name):02d}"),
            layer=Layer.TARGET,
            type="half-block" if is_half else "block",
            geometry=BoxGeometry(_size(is_half=is_half)),
            world_T_component=translation(x, y, z)
            @ rotation((0.0, 0.0, 1.0), float(np.arctan2(along[1], along[0]))),
            construction_parents=tuple(ComponentId(f"block-{int(v):02d}") for v in sorted(below)),
            ground=not below,
            order=round(10.0 * z),
            density_kg_m3=density_kg_m3,
        )


def _size(*, is_half: bool) -> Vector:
    return (_HALF_LENGTH_M if is_half else _LENGTH_M, _WIDTH_M, _HEIGHT_M)


def _piles(
    kind: str, targets: list[Component], density_kg_m3: float
) -> Iterator[tuple[Stack, list[Component]]]:
    count = sum(t.type == kind for t in targets)
    size_m = _size(is_half=kind == "half-block")
    for first in range(0, count, _PER_PILE):
        items = [
            piece(f"stock-{kind}-{k:02d}", kind=kind, size_m=size_m, density_kg_m3=density_kg_m3)
            for k in range(first, min(first + _PER_PILE, count))
        ]
        name = f"{kind}-{first // _PER_PILE}"
        yield (
            Stack(
                id=StackId(f"pile-{name}"),
                place=StockPlaceId(f"place-{name}"),
                items=tuple(c.id for c in items),
            ),
            items,
        )


def _place(number: int) -> Pose:
    """Return the place of a pile: in a row behind the robots."""
    return translation(-3.6 + 0.9 * number, 3.2, 0.0)


def _with_clamps(cell: Cell) -> Cell:
    clamps = {}
    robots = {}
    for robot, x_m in ((A, -1.6), (B, 1.6)):
        name = EndEffectorId(f"clamp-{robot[-1]}")
        clamps[name] = EndEffector(
            id=name,
            kind=EndEffectorKind.GRIPPER,
            description=read_urdf(CLAMP),
            station=None,
            grips_m=(0.150, 0.450),
            opens_to_m=0.500,
        )
        robots[robot] = replace(
            cell.robot_by_id[A],
            id=robot,
            world_T_base=translation(x_m, 2.0, 0.03) @ rotation((0.0, 0.0, 1.0), -np.pi / 2.0),
            end_effectors=(name,),
            mounted=name,
        )
    floor = Fixture(
        id=next(i for i in cell.fixture_by_id if i == "floor"),
        shape=(Box((12.0, 10.0, 0.1)),),
        world_T_fixture=translation(0.0, 0.0, -0.05),
    )
    return replace(
        cell,
        world_T_model=translation(*_MIDDLE_M),
        robot_by_id=robots,
        end_effector_by_id=clamps,
        station_by_id={
            s.id: replace(s, robot=r)
            for r, s in zip((A, B), list(cell.station_by_id.values())[:2], strict=True)
        },
        fixture_by_id={floor.id: floor},
        zone_by_id={},
    )
