"""Rails in `cell.toml`, and arms without closed form in `check`."""

from __future__ import annotations

import math
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from builders_arms import ur_like, urdf_text
from builders_building import EXAMPLES
from sitewright.app.checking import check
from sitewright.errors import CellRejectedError
from sitewright.foundation.ids import RobotId
from sitewright.robot_team.cell import Robot
from sitewright.robot_team.description import JointKind
from sitewright.robot_team.formats.cell_toml import read_cell
from sitewright.robot_team.kinematics import tip_pose

TRACK = (EXAMPLES / "track_frame" / "cell.toml").read_text(encoding="utf-8")
A = RobotId("kr120-a")


def robot(tmp_path: Path, edit: Callable[[str], str] = lambda text: text) -> Robot:
    path = tmp_path / "cell.toml"
    path.write_text(edit(TRACK), encoding="utf-8")
    return read_cell(path).robot_by_id[A]


def refusals(tmp_path: Path, old: str, new: str) -> str:
    assert old in TRACK
    with pytest.raises(CellRejectedError) as refused:
        robot(tmp_path, lambda text: text.replace(old, new, 1))
    return "\n".join(map(str, refused.value.problems))


def test_the_rail_is_the_first_joint_and_its_values_are_metres(tmp_path: Path) -> None:
    arm = robot(tmp_path)
    joints = arm.description.movable_joints
    assert [j.name for j in joints[:2]] == ["rail_1", "joint_a1"]
    assert joints[0].kind is JointKind.PRISMATIC
    assert (joints[0].lower_rad, joints[0].upper_rad, joints[0].velocity_rad_s) == (-2.4, 2.4, 1.5)
    assert arm.home_q_rad[0] == -1.6
    assert arm.home_q_rad[2] == pytest.approx(math.radians(-110))
    assert arm.parking_q_rad[1][0] == 2.4
    assert arm.max_acceleration_rad_s2[0] == 2.0
    at_home, beside = (
        arm.world_T_base @ tip_pose(arm.description, (at, *arm.home_q_rad[1:]))
        for at in (-1.6, -1.1)
    )
    x, y, z = (b - a for a, b in zip(at_home.position_m, beside.position_m, strict=True))
    assert (x, y, z) == pytest.approx((0.5, 0.0, 0.0))


def test_an_arm_can_hang_from_a_gantry(tmp_path: Path) -> None:
    def edit(text: str) -> str:
        lift = "{ axis = [0, 0, 2], travel_m = [0, 1], speed_m_s = 0.5 }"
        text = text.replace("} }] } } }]", "} }] } } }, " + lift + "]", 1)
        text = text.replace("home_q_deg = [-1.6, 0", "home_q_deg = [-1.6, 0.4, 0", 1)
        hang = "carriage_T_base = { q_wxyz = [0, 1, 0, 0] }\nhome_q_deg"
        text = text.replace("home_q_deg", hang, 1)
        text = text.replace("[[-2.4, 0, -130", "[[-2.4, 0, 0, -130", 1)
        text = text.replace("[2.4, 0, -130", "[2.4, 0, 0, -130", 1)
        return text.replace("= [2.0, 312", "= [2.0, 1.0, 312", 1)

    arm = robot(tmp_path, edit)
    assert [j.name for j in arm.description.movable_joints[:3]] == ["rail_1", "rail_2", "joint_a1"]
    assert arm.description.movable_joints[1].axis == (0.0, 0.0, 1.0)
    tip = tip_pose(arm.description, arm.home_q_rad)
    assert tip.z_axis[2] > 0.9, "a tool that looked down looks up when the arm is turned over"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("[-1.6, 0, -110", "[-3.6, 0, -110", "joint rail_1 at -3.600 m is outside its limits -2.4"),
        ("[-1.6, 0, -110", "[0, -110", "6 values for 7 joints. State one per joint: rail_1, "),
        ("travel_m = [-2.4, 2.4]", "travel_m = [2.4, -2.4]", "travel_m must rise"),
        ("axis = [0, -1, 0]", "axis = [0, 0, 0]", "the axis has no direction"),
        ("speed_m_s = 1.5", "speed_m_s = 0", "greater than 0"),
        ("speed_m_s = 1.5", "speed_m_s = nan", "speed_m_s"),
    ],
)
def test_a_wrong_rail_is_refused_in_plain_words(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    assert said in refusals(tmp_path, old, new)


def test_a_place_on_a_carriage_needs_a_rail(tmp_path: Path) -> None:
    text = (EXAMPLES / "wooden_frame" / "cell.toml").read_text(encoding="utf-8")
    path = tmp_path / "cell.toml"
    path.write_text(text.replace("home_q_deg", "carriage_T_base = {}\nhome_q_deg", 1))
    with pytest.raises(CellRejectedError, match="1 problem"):
        read_cell(path)


def test_names_that_the_rails_need_are_refused_in_the_urdf(tmp_path: Path) -> None:
    (tmp_path / "own.urdf").write_text(urdf_text(ur_like()).replace("link_1", "carriage_1"))
    model, own = 'model = "kuka-kr120-r2500-pro"', 'urdf = "own.urdf"\npayload_kg = 10'
    assert "links called carriage_1" in refusals(tmp_path, model, own)


def test_check_says_which_arm_is_searched_and_why(tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES / "wooden_frame", tmp_path / "frame")
    (tmp_path / "frame" / "own.urdf").write_text(urdf_text(ur_like()))
    cell = tmp_path / "frame" / "cell.toml"
    text = cell.read_text(encoding="utf-8").replace(
        'model = "kuka-kr120-r2500-pro"', 'urdf = "own.urdf"\npayload_kg = 100', 1
    )
    cell.write_text(text, encoding="utf-8")
    (found,) = (p for p in check(tmp_path / "frame") if p.code == "Q8")
    assert (found.severity, found.where) == ("W", "kr120-a")
    assert "axes 3 and 4 stand at 0 deg, not at 90" in found.message
