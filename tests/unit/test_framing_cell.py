"""The cell that an import lays out for a panel of any size."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from builders_frame import beam, upright
from sitewright.app.framing_cell import framing_cell
from sitewright.building_model.laying import laid_flat
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import Extent, extent_of, shape_of
from sitewright.construction_graph.siting import sited
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.formats.cell_toml import read_cell


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("cells")


def panel(width_m: float, height_m: float, studs: int) -> BuildingModel:
    """Return a panel of boards 45 x 95 as it is laid, its studs at even distances."""
    step_m = (width_m - 0.045) / (studs - 1)
    plates = [
        beam(name, (0.0, 0.0, z), (width_m, 0.095, 0.045))
        for name, z in (("sole", 0.0225), ("head", height_m - 0.0225))
    ]
    stud = (height_m - 0.09, 0.045, 0.095)
    parts = [
        *plates,
        *(
            upright(f"stud-{k}", (step_m * k - (width_m - 0.045) / 2.0, 0.0, height_m / 2.0), stud)
            for k in range(studs)
        ),
    ]
    laid = laid_flat(BuildingModel(name="panel", component_by_id={c.id: c for c in parts}))
    assert isinstance(laid, BuildingModel)
    return laid


def cell_of(folder: Path, laid: BuildingModel) -> Cell:
    file = folder / "cell.toml"
    file.write_text(framing_cell(laid), encoding="utf-8")
    return sited(read_cell(file), laid)


def boxes(cell: Cell, *names: str) -> list[Extent]:
    return [
        extent_of(f.shape, f.world_T_fixture)
        for i, f in cell.fixture_by_id.items()
        if i.startswith(names)
    ]


def shared(one: Extent, other: Extent, axis: int) -> float:
    return min(one.high_m[axis], other.high_m[axis]) - max(one.low_m[axis], other.low_m[axis])


sizes = {
    "width_m": st.floats(0.5, 2.0),
    "height_m": st.floats(1.0, 3.0),
    "studs": st.integers(2, 4),
}


@settings(max_examples=10)
@given(**sizes)
def test_every_piece_lies_on_the_table_or_on_tongues_to_both_sides_of_its_middle(
    folder: Path, width_m: float, height_m: float, studs: int
) -> None:
    laid = panel(width_m, height_m, studs)
    cell = cell_of(folder, laid)
    tops = boxes(cell, "framing-table", "tongue")
    for component in laid.component_by_id.values():
        piece = extent_of(shape_of(component), cell.world_T_model @ component.world_T_component)
        under = [
            t
            for t in tops
            if abs(t.high_m[2] - piece.low_m[2]) < 1e-6
            and all(shared(t, piece, k) > 0.0 for k in (0, 1))
        ]
        for k in (0, 1):
            middle = (piece.low_m[k] + piece.high_m[k]) / 2.0
            assert min(max(t.low_m[k], piece.low_m[k]) for t in under) < middle
            assert max(min(t.high_m[k], piece.high_m[k]) for t in under) > middle


@settings(max_examples=10)
@given(**sizes)
def test_before_the_end_of_every_stud_there_is_room_for_the_nose_of_the_nail_gun(
    folder: Path, width_m: float, height_m: float, studs: int
) -> None:
    laid = panel(width_m, height_m, studs)
    cell = cell_of(folder, laid)
    assume(boxes(cell, "tongue"))
    step_m = (width_m - 0.045) / (studs - 1)
    for box in boxes(cell, "framing-table", "tongue"):
        for x in (step_m * k - (width_m - 0.045) / 2.0 for k in range(studs)):
            is_beside = box.low_m[0] > x + 0.08 or box.high_m[0] < x - 0.08
            assert is_beside or max(abs(box.low_m[1]), abs(box.high_m[1])) < height_m / 2.0 - 0.11


@settings(max_examples=10)
@given(**sizes)
def test_what_stands_in_the_cell_stands_apart_and_the_tracks_pass_both_ends(
    folder: Path, width_m: float, height_m: float, studs: int
) -> None:
    cell = cell_of(folder, panel(width_m, height_m, studs))
    standing = boxes(cell, "framing-table", "tongue", "bed", "bearers")
    for one, other in combinations(standing, 2):
        gaps = [
            max(one.low_m[k] - other.high_m[k], other.low_m[k] - one.high_m[k]) for k in range(3)
        ]
        assert max(gaps) > -2e-6
    for robot in cell.robot_by_id.values():
        rail = robot.description.movable_joints[0]
        assert rail.lower_rad < -height_m / 2.0 < height_m / 2.0 < rail.upper_rad
