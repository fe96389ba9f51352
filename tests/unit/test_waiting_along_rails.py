"""Robots that wait beside their work, wherever that is along their rails."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from builders_building import EXAMPLES
from builders_long_walls import long_wall
from sitewright.errors import CellRejectedError
from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import distance
from sitewright.robot_team.cell import Robot
from sitewright.robot_team.formats.cell_toml import read_cell
from sitewright.robot_team.kinematics import link_poses
from sitewright.robot_team.waiting import (
    foot_m,
    home_opposite,
    is_at_home,
    waiting_postures,
    waiting_q_rad,
)

A = RobotId("kr120-a")
LONG = long_wall(30).cell.robot_by_id[A]
"""Its rail runs from -12.2 m to 12.2 m, along x."""
SHORT = read_cell(EXAMPLES / "track_frame" / "cell.toml").robot_by_id[A]
"""It does not wait along its rail."""
metres = st.floats(-12.2, 12.2)


def at(robot: Robot, rail_m: float) -> tuple[float, ...]:
    return (rail_m, *robot.parking_q_rad[0][1:])


def foot_by_kinematics(robot: Robot, q_rad: tuple[float, ...]) -> tuple[float, float, float]:
    root = next(j.parent for j in robot.description.joints if j.name == "joint_a1")
    return (robot.world_T_base @ link_poses(robot.description, q_rad)[root]).position_m


@given(rail_m=metres, x_m=st.floats(-30.0, 30.0), y_m=st.floats(-2.0, 2.0))
def test_opposite_is_where_the_foot_comes_nearest_to_a_point(
    rail_m: float, x_m: float, y_m: float
) -> None:
    assert distance(foot_m(LONG, at(LONG, rail_m)), foot_by_kinematics(LONG, at(LONG, rail_m))) < (
        1e-9
    )
    point = (x_m, y_m, 1.0)
    best, other = home_opposite(LONG, point), at(LONG, rail_m)
    assert best[1:] == LONG.home_q_rad[1:]
    assert distance(foot_m(LONG, best), point) <= distance(foot_m(LONG, other), point) + 1e-9


@given(rail_m=metres, x_m=metres)
def test_it_waits_beside_the_work_as_near_as_it_can_and_at_last_where_the_cell_says(
    rail_m: float, x_m: float
) -> None:
    work = (x_m, 0.0, 1.0)
    found = waiting_postures(LONG, (LONG.home_q_rad,), at(LONG, rail_m), work)
    assert LONG.home_q_rad in found
    beside = [q for q in found if q != LONG.home_q_rad]
    assert all(q[1:] == LONG.home_q_rad[1:] and -12.2 <= q[0] <= 12.2 for q in beside)
    away_m = [distance(foot_m(LONG, q), foot_m(LONG, home_opposite(LONG, work))) for q in beside]
    assert min(away_m) > 2.0 - 1e-6
    if abs(rail_m - x_m) > 2.0 + 1e-9:
        assert found[0][0] == rail_m
    else:
        assert abs(found[0][0] - rail_m) < 2.0 + 2.0 + 1e-6


def test_its_preparation_station_is_wherever_it_stands_with_its_arm_as_at_home() -> None:
    elsewhere = (3.0, *LONG.home_q_rad[1:])
    assert waiting_q_rad(LONG, elsewhere) == elsewhere
    assert is_at_home(LONG, elsewhere, within_rad=0.02)
    assert not is_at_home(LONG, at(LONG, 3.0), within_rad=0.02)


def test_others_wait_only_where_the_cell_says() -> None:
    elsewhere = (0.5, *SHORT.home_q_rad[1:])
    assert not is_at_home(SHORT, elsewhere, within_rad=0.02)
    assert waiting_q_rad(SHORT, elsewhere) == SHORT.home_q_rad
    assert home_opposite(SHORT, (2.0, 0.0, 1.0)) == SHORT.home_q_rad
    declared = SHORT.parking_q_rad
    assert waiting_postures(SHORT, declared, elsewhere, (0.0, 0.0, 1.0)) == declared
    assert foot_m(SHORT, elsewhere) == SHORT.world_T_base.position_m


def test_a_gantry_slides_its_longest_rail_and_leaves_the_others() -> None:
    first, *arm = LONG.description.joints
    cross = replace(
        first, name="rail_2", parent="carriage_1", child="carriage_2", axis=(1.0, 0.0, 0.0)
    )
    cross = replace(cross, lower_rad=-1.0, upper_rad=1.0)
    foot = replace(arm[0], parent="carriage_2")
    gantry = replace(
        LONG,
        description=replace(LONG.description, joints=(first, cross, foot, *arm[1:])),
        home_q_rad=(0.0, 0.5, *LONG.home_q_rad[1:]),
    )
    assert home_opposite(gantry, (4.0, 0.0, 1.0)) == pytest.approx((4.0, 0.5, *LONG.home_q_rad[1:]))
    assert math.isclose(foot_m(gantry, gantry.home_q_rad)[1], -1.7 + 0.5)


def test_a_robot_without_rails_cannot_wait_along_them(tmp_path: Path) -> None:
    text = (EXAMPLES / "wooden_frame" / "cell.toml").read_text(encoding="utf-8")
    changed = text.replace(
        'subtype = "handler"', 'subtype = "handler"\nwaits_along_rails = true', 1
    )
    assert changed != text
    (tmp_path / "cell.toml").write_text(changed, encoding="utf-8")
    with pytest.raises(CellRejectedError, match="waits_along_rails"):
        read_cell(tmp_path / "cell.toml")
