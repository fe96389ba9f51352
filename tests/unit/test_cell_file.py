"""`cell.toml`: what is read, what is refused, and in which words."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest

from builders_building import EXAMPLES
from sitewright.errors import CellRejectedError, Problem
from sitewright.foundation.ids import EndEffectorId, RobotId, StationId
from sitewright.robot_team.cell import Capability, Cell, StationKind
from sitewright.robot_team.formats.cell_toml import read_cell
from sitewright.robot_team.kinematics import tip_pose

SOURCE = EXAMPLES / "wooden_frame" / "cell.toml"
Edit = Callable[[str], str]


def swap(old: str, new: str, count: int = 1) -> Edit:
    def edit(text: str) -> str:
        assert old in text, old
        return text.replace(old, new, count)

    return edit


def append(text: str) -> Edit:
    return lambda before: f"{before}\n{text}\n"


def read(tmp_path: Path, *edits: Edit) -> Cell:
    text = SOURCE.read_text(encoding="utf-8")
    for edit in edits:
        text = edit(text)
    path = tmp_path / "cell.toml"
    path.write_text(text, encoding="utf-8")
    return read_cell(path)


def rejected(tmp_path: Path, *edits: Edit) -> tuple[Problem, ...]:
    with pytest.raises(CellRejectedError) as refusal:
        read(tmp_path, *edits)
    return refusal.value.problems


def test_the_case_study_cell_is_complete(tmp_path: Path) -> None:
    cell = read(tmp_path)
    handler = cell.robot_by_id[RobotId("kr120-a")]
    finisher = cell.robot_by_id[RobotId("kr120-b")]
    assert handler.home_q_rad == pytest.approx(
        tuple(math.radians(x) for x in (0, -110, 110, 0, 80, 0))
    )
    assert handler.can == {
        Capability.GRASPING,
        Capability.POSITIONING,
        Capability.RELEASING,
        Capability.RETRACTING,
    }
    assert Capability.TOOL_CHANGING in finisher.can
    assert finisher.end_effectors == ("nail-gun", "screwdriver", "paint-head")
    assert handler.description.payload_kg == 120.0
    assert {s.kind for s in cell.station_by_id.values()} == set(StationKind)


def test_a_preparation_station_stands_at_home(tmp_path: Path) -> None:
    cell = read(tmp_path)
    robot = cell.robot_by_id[RobotId("kr120-b")]
    home = robot.world_T_base @ tip_pose(robot.description, robot.home_q_rad)
    assert cell.station_by_id[StationId("ready-b")].world_T_station == home


def test_a_robot_without_a_preparation_station_gets_one(tmp_path: Path) -> None:
    bare = read(tmp_path, lambda t: t.replace('kind = "preparation"\nrobot = "kr120-b"', _TOOLS))
    ready = bare.station_by_id[StationId("ready-kr120-b")]
    assert (ready.kind, ready.robot) == (StationKind.PREPARATION, "kr120-b")


_TOOLS = 'kind = "tool"\nworld_T_station = { p_m = [9, 9, 1] }'


def test_angles_may_be_in_radians(tmp_path: Path) -> None:
    swapped = swap("home_q_deg = [0, -110, 110, 0, 80, 0]", "home_q_rad = [0, -1.5, 1.5, 0, 1, 0]")
    assert read(tmp_path, swapped).robot_by_id[RobotId("kr120-a")].home_q_rad[1] == -1.5


def test_accelerations_default_to_twice_the_speed(tmp_path: Path) -> None:
    line = "max_acceleration_deg_s2 = [312, 312, 312, 660, 660, 1230]\n"
    robot = read(tmp_path, swap(line, "")).robot_by_id[RobotId("kr120-a")]
    assert robot.max_acceleration_rad_s2[0] == pytest.approx(math.radians(312), rel=1e-3)


def test_an_own_urdf_is_found_beside_the_cell(tmp_path: Path) -> None:
    tool = '<robot name="probe"><link name="mount"/><link name="tcp"/><joint name="j" type="fixed">'
    tool += '<parent link="mount"/><child link="tcp"/><origin xyz="0 0 0.2"/></joint></robot>'
    (tmp_path / "probe.urdf").write_text(tool)
    cell = read(tmp_path, swap("builtin:paint-head", "probe.urdf"))
    assert cell.end_effector_by_id[EndEffectorId("paint-head")].description.name == "probe"


@pytest.mark.parametrize(
    ("edit", "code", "place", "words"),
    [
        (swap("clearance_m", "clearence_m"), "K1", "site.clearence_m", "mean clearance_m"),
        (swap("clearance_m = 0.010", "clearance_m = nan"), "K3", "site.clearance_m", "finite"),
        (swap("clearance_m = 0.010", "clearance_m = 2024-01-01"), "K1", "site.clearance_m", "num"),
        (swap("cell/1", "cell/9"), "K1", "schema", "sitewright.cell/1"),
        (
            swap("[0, -110, 110, 0, 80, 0]", "[0, -110, 110]"),
            "L2",
            "robot[kr120-a]",
            "3 values for 6",
        ),
        (
            swap("home_q_deg = [0, -110", "home_q_deg = [0, -200"),
            "L2",
            "robot[kr120-a]",
            "-200.0 deg is outside its limits -155.0 .. 35.0",
        ),
        (
            swap('mounted = "gripper-s"', 'mounted = "nail-gun"'),
            "L2",
            "robot[kr120-a]",
            "not among",
        ),
        (
            swap('["nail-gun", "screw', '["nail-gum", "screw'),
            "L1",
            "robot[kr120-b].end_effectors",
            "Did you mean nail-gun?",
        ),
        (
            swap('station = "tools-b"', 'station = "buffer-a"'),
            "L1",
            "end_effector[nail-gun].station",
            "no tool station 'buffer-a'",
        ),
        (
            swap("p_m = [0.45, 0.0, 0.0]", "p_m = [0.0, 0.0, 0.0]"),
            "L2",
            "end_effector[paint-head]",
            "same place",
        ),
        (
            swap("p_m = [1.6, 0.0, 0.0]", "p_m = [-1.5, 0.0, 0.0]"),
            "L2",
            "robot[kr120-b]",
            "0.10 m apart",
        ),
        (swap('id = "floor"', 'id = "walkway"'), "D1", "walkway", "fixture, zone"),
        (swap("opens_to_m = 0.170", "opens_to_m = 0.5"), "L2", "end_effector[gripper-s]", "travel"),
        (swap("opens_to_m = 0.170", ""), "K1", "end_effector[gripper-s]", "opens_to_m"),
        (swap(", 0.140]", ", 0.020]"), "K1", "end_effector[gripper-s]", "grips_m must rise"),
        (swap("kr120-r2500-pro", "kr120-r9"), "L3", "robot[kr120-a]", "kuka-kr120-r2500-pro"),
        (
            swap("builtin:nail-gun", "none.urdf"),
            "R1",
            "end_effector[nail-gun]: none.urdf",
            "No such",
        ),
        (swap('robot = "kr120-a"', 'robot = "kr120-c"'), "L1", "station[ready-a].robot", "kr120-c"),
        (
            swap('can = ["fastening", "finishing", "tool-changing"]', ""),
            "L2",
            "robot[kr120-b]",
            "change",
        ),
        (append("[simulation]\nseed = 1e400"), "K3", "simulation.seed", "finite"),
    ],
)
def test_a_faulty_cell_is_told_with_its_place(
    tmp_path: Path, edit: Edit, code: str, place: str, words: str
) -> None:
    found = [p for p in rejected(tmp_path, edit) if (p.code, p.where) == (code, place)]
    assert any(words in p.message for p in found), rejected(tmp_path, edit)


@pytest.mark.parametrize(
    ("text", "words"),
    [("robot = [", "Not TOML"), ("x = " + "[" * 20_000, "nested"), ("a=1\na=2", "overwrite")],
)
def test_text_that_is_no_toml_is_refused(tmp_path: Path, text: str, words: str) -> None:
    (problem,) = rejected(tmp_path, lambda _: text)
    assert problem.code == "E5"
    assert words in problem.message


def test_a_missing_cell_is_refused_in_words(tmp_path: Path) -> None:
    with pytest.raises(CellRejectedError, match="No such file"):
        read_cell(tmp_path / "none.toml")


def test_all_problems_of_a_cell_come_together(tmp_path: Path) -> None:
    found = rejected(
        tmp_path,
        swap('mounted = "gripper-s"', 'mounted = "nail-gun"'),
        swap("builtin:screwdriver", "builtin:screwdrivr"),
        swap('id = "floor"', 'id = "walkway"'),
        swap("[0, -110, 110, 0, 80, 0]", "[0, -110, 110]"),
    )
    assert {p.code for p in found} == {"D1", "L2", "L3"}
    assert len(found) >= 4
