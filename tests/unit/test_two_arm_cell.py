"""The cell that an import adds: what is to be built stands between its arms, on the floor."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from builders_building import EXAMPLES
from sitewright.app.two_arm_cell import two_arm_cell
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.laying import extents_as_laid
from sitewright.building_model.model import BuildingModel
from sitewright.construction_graph.siting import sited
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.robot_team.formats.cell_toml import read_cell

EXAMPLE = EXAMPLES / "frame_house" / "cell.toml"
LENGTHS = st.floats(-500.0, 500.0, allow_nan=False)


@cache
def frame() -> BuildingModel:
    return read_building(EXAMPLES / "wooden_frame" / "building.json")


def drawn_at(pose: Pose) -> BuildingModel:
    model = frame()
    moved = {
        i: replace(c, world_T_component=pose @ c.world_T_component)
        for i, c in model.component_by_id.items()
    }
    return replace(model, component_by_id=moved)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("cells")


@given(x=LENGTHS, y=LENGTHS, z=LENGTHS, turn=st.sampled_from([0.0, 1.5707963267948966]))
def test_wherever_it_is_drawn_it_stands_in_the_middle_on_the_floor(
    folder: Path, x: float, y: float, z: float, turn: float
) -> None:
    model = drawn_at(translation(x, y, z) @ rotation((0.0, 0.0, 1.0), turn))
    file = folder / "cell.toml"
    file.write_text(two_arm_cell(model, EXAMPLE), encoding="utf-8")
    placed = sited(read_cell(file), model)
    extents = extents_as_laid(replace(model, site_T_model=placed.world_T_model))
    for axis in (0, 1):
        low, high = min(e.low_m[axis] for e in extents), max(e.high_m[axis] for e in extents)
        assert low + high == pytest.approx(0.0, abs=1e-5)
    assert min(e.low_m[2] for e in extents) == pytest.approx(0.0, abs=1e-5)
    sizes = [max(e.high_m[k] for e in extents) - min(e.low_m[k] for e in extents) for k in (0, 1)]
    assert sizes[0] >= sizes[1], "its long side is along x"


def test_nothing_else_of_the_example_changes() -> None:
    before = EXAMPLE.read_text(encoding="utf-8").splitlines()
    after = two_arm_cell(frame(), EXAMPLE).splitlines()
    changed = [(a, b) for a, b in zip(before, after, strict=True) if a != b]
    assert len(changed) == 1
    assert all("world_T_model" in line for line in changed[0])
