"""Moved things in a cell file: numbers change where they stand, all the rest stays as written."""

from __future__ import annotations

import difflib
import math
import shutil
from pathlib import Path

import pytest

from builders_planning import EXAMPLES
from sitewright.app.cell_writing import with_poses, write_cell
from sitewright.app.clock import SystemClock
from sitewright.app.event_log import EventLog
from sitewright.app.ids import UuidSource
from sitewright.app.model_writing import OpenRunError
from sitewright.app.project import ProjectError, read_project
from sitewright.app.run_folder import next_run_folder
from sitewright.central_controller.events import RunStarted
from sitewright.foundation.ids import RunId
from sitewright.journal.sqlite import SqliteJournal
from sitewright.planning_twin.layout.movables import Shift, yard_of
from sitewright.robot_team.formats.cell_toml import read_cell

MOVES = {"kr120-b": Shift(-0.25, 0.1, math.radians(30)), "pallet-thin": Shift(0.2, -0.1)}


@pytest.fixture
def project(tmp_path: Path) -> Path:
    shutil.copytree(EXAMPLES / "wooden_frame", tmp_path / "frame")
    return tmp_path / "frame"


def test_only_the_lines_of_what_moves_change(project: Path) -> None:
    opened = read_project(project)
    old = (project / "cell.toml").read_text(encoding="utf-8")
    new = with_poses(old, opened.cell, yard_of(opened.cell).arranged(MOVES))
    lines = list(difflib.unified_diff(old.splitlines(), new.splitlines(), lineterm="", n=0))
    removed = [line for line in lines if line.startswith("-") and not line.startswith("---")]
    assert len(removed) == 3  # the base, the stock place, and the stand under it
    assert all("p_m" in line for line in removed)
    assert new.count("#") == old.count("#")


def test_nothing_moved_is_the_same_text(project: Path) -> None:
    cell = read_project(project).cell
    for file in EXAMPLES.glob("*/cell*.toml"):
        text = file.read_text(encoding="utf-8")
        assert with_poses(text, read_cell(file), read_cell(file)) == text
    assert with_poses("", cell, cell) == ""


def test_the_written_cell_means_what_was_proposed(project: Path) -> None:
    opened = read_project(project)
    wanted = yard_of(opened.cell).arranged(MOVES)
    before = (project / "cell.toml").read_bytes()
    backup = write_cell(opened, wanted)
    assert backup.read_bytes() == before
    found = read_cell(project / "cell.toml")
    for robot, unit in wanted.robot_by_id.items():
        other = found.robot_by_id[robot].world_T_base
        assert other.distance_to_m(unit.world_T_base) < 1e-9
        assert other.angle_to_rad(unit.world_T_base) < 1e-7
    place = next(iter(p for i, p in found.stock_place_by_id.items() if i == "pallet-thin"))
    assert place.world_T_stock.position_m == pytest.approx((-1.4, -1.65, 0.30))
    assert not list(project.glob(".cell.toml*"))


def test_a_turn_is_written_where_none_stood(project: Path) -> None:
    file = project / "cell.toml"
    text = file.read_text(encoding="utf-8").replace(
        "p_m = [-1.6, 0.0, 0.0], q_wxyz = [1, 0, 0, 0]", "p_m = [-1.6, 0.0, 0.0]"
    )
    file.write_text(text, encoding="utf-8")
    opened = read_project(project)
    write_cell(opened, yard_of(opened.cell).arranged({"kr120-a": Shift(yaw_rad=math.pi / 2)}))
    turned = next(iter(read_cell(file).robot_by_id.values())).world_T_base
    assert turned.x_axis == pytest.approx((0.0, 1.0, 0.0), abs=1e-9)


def test_a_file_that_changed_meanwhile_is_not_overwritten(project: Path) -> None:
    opened = read_project(project)
    file = project / "cell.toml"
    edited = file.read_text(encoding="utf-8").replace(
        "p_m = [1.6, 0.0, 0.0]", "p_m = [1.7, 0.0, 0.0]"
    )
    file.write_text(edited, encoding="utf-8")
    with pytest.raises(ProjectError, match="changed meanwhile"):
        write_cell(opened, yard_of(opened.cell).arranged(MOVES))
    assert file.read_text(encoding="utf-8") == edited


def test_an_open_run_keeps_its_cell(project: Path) -> None:
    opened = read_project(project)
    folder = next_run_folder(project / "runs")
    folder.create()
    with SqliteJournal(folder.journal) as journal:
        clock = SystemClock()
        log = EventLog(folder, journal, clock=clock, ids=UuidSource(clock))
        log.append(RunStarted(run=RunId(folder.run), project="frame", hashes={}))
    with pytest.raises(OpenRunError):
        write_cell(opened, yard_of(opened.cell).arranged(MOVES))
    assert not (project / "cell.toml.bak").exists()
