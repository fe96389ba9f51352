"""What moves with what, and what may stand where."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from builders_planning import EXAMPLES
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.layout.floor import Floor, floor_of, footprint
from sitewright.planning_twin.layout.movables import Shift, Yard, yard_of
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.formats.cell_toml import read_cell
from sitewright.robot_team.kinematics import tip_pose

UP = (0.0, 0.0, 1.0)
BOX = ((Box((1.0, 0.4, 0.3)),),)


def cell() -> Cell:
    return read_cell(EXAMPLES / "wooden_frame" / "cell.toml")


def house() -> Cell:
    return read_cell(EXAMPLES / "frame_house" / "cell.toml")


def fixtures_of(yard: Yard) -> dict[str, tuple[str, ...]]:
    return {m.id: m.fixtures for m in yard.movables}


def test_pedestals_and_pallets_go_along_and_floors_stay() -> None:
    assert fixtures_of(yard_of(house())) == {
        "kr120-a": ("pedestal-a",),
        "kr120-b": ("pedestal-b",),
        "stock-a-1": ("bearers-a1",),
        "stock-a-2": ("bearers-a2",),
        "stock-b-1": ("bearers-b1",),
        "stock-b-2": ("bearers-b2",),
    }
    assert fixtures_of(yard_of(cell()))["kr120-a"] == ()
    assert "pallet-thin" not in fixtures_of(yard_of(cell(), kept=["pallet-thin"]))


def test_a_robot_takes_its_pedestal_and_its_station_and_leaves_the_rest() -> None:
    before = house()
    yard = yard_of(before)
    after = yard.arranged({"kr120-a": Shift(0.5, -0.2, math.pi / 2)})
    base = after.robot_by_id["kr120-a"].world_T_base  # type: ignore[index]
    assert base.position_m == pytest.approx((0.5, 2.0, 0.40))
    assert base.x_axis == pytest.approx((1.0, 0.0, 0.0), abs=1e-9)
    robot = after.robot_by_id["kr120-a"]  # type: ignore[index]
    at_home = base @ tip_pose(robot.description, robot.home_q_rad)
    station = after.station_by_id["ready-a"].world_T_station  # type: ignore[index]
    assert station.distance_to_m(at_home) < 1e-9
    pedestal = after.fixture_by_id["pedestal-a"].world_T_fixture  # type: ignore[index]
    assert pedestal.position_m == pytest.approx((0.4, 2.0, 0.19))
    for name, fixture in before.fixture_by_id.items():
        if name != "pedestal-a":
            assert after.fixture_by_id[name] == fixture
    assert after.stock_place_by_id == before.stock_place_by_id


SHIFTS = st.tuples(*(st.floats(-2.0, 2.0) for _ in range(2)), st.floats(-3.1, 3.1))


@given(first=SHIFTS, second=SHIFTS)
def test_rectangles_meet_if_and_only_if_a_point_says_so(
    first: tuple[float, float, float], second: tuple[float, float, float]
) -> None:
    a, b = (_placed(*s) for s in (first, second))
    rectangles = [footprint(_corners(pose), pose) for pose in (a, b)]
    grid = [(x / 20.0, y / 20.0) for x in range(-10, 11) for y in range(-4, 5)]
    inside = any(_is_in(b, a.apply((x, y, 0.0))) for x, y in grid)
    inside |= any(_is_in(a, b.apply((x, y, 0.0))) for x, y in grid)
    if inside:
        assert rectangles[0].meets(rectangles[1], 1e-6)
    if not rectangles[0].meets(rectangles[1], 0.0):
        assert not inside
    assert rectangles[0].meets(rectangles[1], 0.1) == rectangles[1].meets(rectangles[0], 0.1)


def _placed(x: float, y: float, yaw: float) -> Pose:
    return translation(x, y, 0.0) @ rotation(UP, yaw)


def _corners(pose: Pose) -> list[tuple[float, float, float]]:
    return [pose.apply(v) for v in Box((1.0, 0.4, 0.3)).vertices_m()]


def _is_in(pose: Pose, point: tuple[float, float, float]) -> bool:
    """Tell whether a point is inside; on the edge is neither in nor out."""
    x, y, _ = pose.inverse().apply(point)
    return abs(x) < 0.5 - 1e-6 and abs(y) < 0.2 - 1e-6


def test_what_is_above_another_is_not_in_its_way() -> None:
    low = footprint([(0.0, 0.0, 0.0), (1.0, 1.0, 0.5)])
    high = footprint([(0.0, 0.0, 0.5), (1.0, 1.0, 0.9)])
    assert not low.meets(high, 0.1)


@pytest.fixture(scope="module")
def floor() -> Floor:
    yard = yard_of(cell())
    stock = {"pallet-thin": [((Box((1.8, 0.09, 0.2)),), translation(-1.6, -1.55, 0.4))]}
    building = [((Box((1.3, 2.4, 0.2)),), translation(0.0, 0.0, 0.5))]
    return floor_of(yard, stock, building)


def test_the_area_is_that_of_the_floor(floor: Floor) -> None:
    assert [*floor.area_m[0], *floor.area_m[1]] == pytest.approx([-4.5, -3.5, 4.5, 3.5])


@pytest.mark.parametrize(
    ("moves", "is_free"),
    [
        ({}, True),
        ({"kr120-a": Shift(-0.2, 0.1)}, True),
        ({"kr120-a": Shift(1.4, 0.0)}, False),  # into the table
        ({"kr120-a": Shift(0.0, 1.4)}, False),  # into the pallet
        ({"kr120-b": Shift(3.0, 0.0)}, False),  # out of the floor
        ({"pallet-thin": Shift(0.0, -1.3)}, False),  # onto the walkway
        ({"kr120-b": Shift(-3.1, 0.1)}, False),  # onto the other robot
        ({"pallet-thin": Shift(3.2, 0.0)}, True),
    ],
)
def test_things_keep_out_of_each_others_way(
    floor: Floor,
    moves: dict[str, Shift],
    is_free: bool,  # noqa: FBT001 - what is expected
) -> None:
    assert floor.is_free(moves) is is_free


def test_what_stands_close_already_may_stay_so(floor: Floor) -> None:
    yard = yard_of(cell())
    tight = floor_of(yard, {}, [((Box((1.3, 2.4, 0.9)),), translation(-1.6, 0.0, 0.5))])
    assert tight.is_free({})
    assert tight.is_free({"kr120-a": Shift(0.1, 0.0)})
    assert floor.fixed
