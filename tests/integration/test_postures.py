"""Home and parking postures are looked at when a project is opened."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from sitewright.app.checking import check
from sitewright.app.project import EXAMPLES, example_folder, open_project
from sitewright.errors import ModelRejectedError


@pytest.fixture
def project(tmp_path: Path) -> Path:
    shutil.copytree(example_folder("wooden_frame"), tmp_path / "frame")
    return tmp_path / "frame"


@pytest.mark.parametrize("example", EXAMPLES)
def test_the_examples_start_and_park_clear_of_everything(example: str) -> None:
    assert [p for p in check(example_folder(example)) if p.code == "Q7"] == []


def test_two_homes_that_meet_are_refused_with_both_names(project: Path) -> None:
    cell = project / "cell.toml"
    meeting = cell.read_text().replace(
        "home_q_deg = [0, -110, 110, 0, 80, 0]", "home_q_deg = [0, -50, 70, 0, 60, 0]"
    )
    cell.write_text(meeting)
    with pytest.raises(ModelRejectedError, match="home_q_deg is nearer than 10 mm") as refused:
        open_project(project)
    assert {p.where for p in refused.value.problems} == {"kr120-a", "kr120-b"}


def test_a_parking_posture_in_a_wall_is_a_warning(project: Path) -> None:
    cell = project / "cell.toml"
    wall = (
        '\n[[fixture]]\nid = "wall"\n'
        "geometry = { box = { size_m = [0.6, 0.1, 3.0] } }\n"
        "world_T_fixture = { p_m = [2.2, -0.75, 1.5] }\n"
    )
    cell.write_text(cell.read_text() + wall)
    found = [p for p in check(project) if p.code == "Q7"]
    assert found
    assert {(p.where, p.severity) for p in found} == {("kr120-b", "W")}
