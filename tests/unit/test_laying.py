"""Panels drawn standing are laid flat: how they lie, and what cannot be laid."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from builders_frame import beam, upright
from sitewright.building_model.component import Component, Layer
from sitewright.building_model.laying import NoPanel, laid_flat, size_as_laid_m
from sitewright.building_model.merging import in_coordinates_of
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import extent_of, shape_of
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector, rotation, translation

WIDE_M, HIGH_M, THICK_M = 1.29, 2.49, 0.095
BOARD_M = 0.012
places = st.tuples(*[st.floats(-40.0, 40.0)] * 3)
turns = st.floats(-3.0, 3.0)


def panel(world_T_panel: Pose = Pose(), *more: Component) -> BuildingModel:  # noqa: B008 -- a value
    half = WIDE_M / 2.0
    parts = [
        beam("sole", (0.0, 0.0, 0.0225), (WIDE_M, THICK_M, 0.045)),
        beam("head", (0.0, 0.0, HIGH_M - 0.0225), (WIDE_M, THICK_M, 0.045)),
        upright("left", (-half + 0.0225, 0.0, HIGH_M / 2.0), (HIGH_M - 0.09, 0.045, THICK_M)),
        upright("right", (half - 0.0225, 0.0, HIGH_M / 2.0), (HIGH_M - 0.09, 0.045, THICK_M)),
        *more,
    ]
    placed = [replace(c, world_T_component=world_T_panel @ c.world_T_component) for c in parts]
    return BuildingModel(name="panel", component_by_id={c.id: c for c in placed})


def sheathing(y_m: float) -> Component:
    return beam("osb", (0.0, y_m, HIGH_M / 2.0), (WIDE_M, BOARD_M, HIGH_M))


def laid(model: BuildingModel, *, is_turned_over: bool = False) -> BuildingModel:
    found = laid_flat(model, is_turned_over=is_turned_over)
    assert isinstance(found, BuildingModel)
    return found


def in_site(model: BuildingModel, name: str) -> Pose:
    return model.site_T_model @ model.component_by_id[ComponentId(name)].world_T_component


@given(places, turns, st.booleans())
def test_wherever_a_panel_stands_it_lies_on_the_site_with_its_middle_above_the_origin(
    place: Vector,
    turn: float,
    over: bool,  # noqa: FBT001 -- drawn
) -> None:
    drawn = panel(translation(*place) @ rotation((0.0, 0.0, 1.0), turn))
    model = laid(drawn, is_turned_over=over)
    spans = [
        extent_of(shape_of(c), model.site_T_model @ c.world_T_component)
        for c in model.component_by_id.values()
    ]
    low = [min(s.low_m[k] for s in spans) for k in range(3)]
    high = [max(s.high_m[k] for s in spans) for k in range(3)]
    assert low == pytest.approx([-WIDE_M / 2.0, -HIGH_M / 2.0, 0.0], abs=1e-6)
    assert high == pytest.approx([WIDE_M / 2.0, HIGH_M / 2.0, THICK_M], abs=1e-6)
    assert size_as_laid_m(model) == pytest.approx((WIDE_M, HIGH_M, THICK_M), abs=1e-6)
    assert in_site(model, "head").position_m[1] > 0.0 > in_site(model, "sole").position_m[1]


@given(places, turns, st.booleans())
def test_gravity_goes_through_the_panel_and_the_ground_is_its_lower_face(
    place: Vector,
    turn: float,
    over: bool,  # noqa: FBT001 -- drawn
) -> None:
    drawn = panel(translation(*place) @ rotation((0.0, 0.0, 1.0), turn))
    model = laid(drawn, is_turned_over=over)
    assert model.site_T_model.turn(model.gravity) == pytest.approx((0.0, 0.0, -9.81), abs=1e-9)
    up = tuple(-g / 9.81 for g in model.gravity)
    on_ground = tuple(u * model.ground_z_m for u in up)
    level = model.site_T_model.apply((on_ground[0], on_ground[1], on_ground[2]))[2]
    assert level == pytest.approx(0.0, abs=1e-6)
    assert model.component_by_id == drawn.component_by_id, "nothing is moved in the drawing"


def test_turned_over_the_other_face_is_up_and_left_is_right() -> None:
    front, back = laid(panel()), laid(panel(), is_turned_over=True)
    assert front.gravity == pytest.approx(tuple(-g for g in back.gravity))
    assert in_site(front, "left").position_m[0] == pytest.approx(-WIDE_M / 2.0 + 0.0225)
    assert in_site(back, "left").position_m[0] == pytest.approx(WIDE_M / 2.0 - 0.0225)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_sheathing_is_up_whichever_side_it_is_drawn_on(side: float) -> None:
    model = laid(panel(Pose(), sheathing(side * (THICK_M + BOARD_M) / 2.0)))
    assert in_site(model, "osb").position_m[2] == pytest.approx(THICK_M + BOARD_M / 2.0)


def test_what_is_as_deep_as_it_is_wide_is_no_panel() -> None:
    corner = panel()
    other = panel(translation(3.0, 0.0, 0.0) @ rotation((0.0, 0.0, 1.0), math.pi / 2.0))
    moved = [replace(c, id=ComponentId(f"2-{c.id}")) for c in other.component_by_id.values()]
    both = replace(corner, component_by_id={**corner.component_by_id, **{c.id: c for c in moved}})
    found = laid_flat(both)
    assert isinstance(found, NoPanel)
    assert found.size_m[2] == pytest.approx(WIDE_M)
    assert laid_flat(BuildingModel(name="empty", component_by_id={})) == NoPanel(
        size_m=(0.0, 0.0, 0.0)
    )


def test_only_targets_are_laid_and_what_is_drawn_beside_them_does_not_count() -> None:
    roof = replace(beam("roof", (0.0, 3.0, 4.0), (8.0, 8.0, 0.2)), layer=Layer.AS_DESIGNED)
    assert laid(panel(Pose(), roof)).site_T_model == laid(panel()).site_T_model


def test_a_panel_read_with_another_shift_still_lies_where_it_lay() -> None:
    model = laid(panel(translation(7.0, 2.0, 1.0)))
    other = replace(model, origin_shift_m=(5.0, 0.0, 0.0))
    moved = in_coordinates_of(model, other)
    assert in_site(moved, "sole").position_m == pytest.approx(in_site(model, "sole").position_m)
    assert moved.component_by_id[ComponentId("sole")] != model.component_by_id[ComponentId("sole")]
