from __future__ import annotations

import math

import pytest

from sitewright.building_model.shapes import extent_of
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.setting_down import is_taken, pose_on

SIZE: Vector = (2.4, 0.09, 0.14)
PIECE = PieceShape(shape=(Box(SIZE),), size_m=SIZE, mass_kg=10.0)
SURFACE = translation(-3.0, 0.5, 0.3) @ rotation((0.0, 0.0, 1.0), 0.7)


@pytest.mark.parametrize("quarters", range(4))
@pytest.mark.parametrize("tip_rad", [-0.3, 0.0, 0.3])
@pytest.mark.parametrize("heading_rad", [0.0, 2.0])
def test_the_side_that_was_up_stays_up_and_the_piece_lies_on_the_surface(
    quarters: int, tip_rad: float, heading_rad: float
) -> None:
    roll = rotation((1.0, 0.0, 0.0), quarters * math.pi / 2.0 + tip_rad)
    lying = rotation((0.0, 0.0, 1.0), heading_rad) @ roll
    pose = pose_on(SURFACE, PIECE, lying)
    box = extent_of(PIECE.shape, pose)
    assert box.low_m[2] == pytest.approx(0.3)
    upright = rotation((1.0, 0.0, 0.0), quarters * math.pi / 2.0).inverse()
    was_up = upright.turn((0.0, 0.0, 1.0))
    assert pose.turn(was_up) == pytest.approx((0.0, 0.0, 1.0), abs=1e-9)
    assert pose.x_axis == pytest.approx(SURFACE.x_axis)


def test_a_buffer_is_taken_by_another_piece_and_not_by_the_piece_itself() -> None:
    mine, other = ComponentId("mine"), ComponentId("other")
    lying = {mine: pose_on(SURFACE, PIECE, Pose()), other: translation(5.0, 0.0, 0.0)}
    assert not is_taken(lying, SURFACE, by_other_than=mine)
    assert is_taken(lying, SURFACE, by_other_than=other)
