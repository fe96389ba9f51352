"""Solids of cut boxes, their contacts, how far they are apart, and the way out."""

from __future__ import annotations

import math

import pytest

from builders_frame import Z, beam
from sitewright.building_model.component import ConvexGeometry, PlaneCut
from sitewright.building_model.inference.contact import contact_between
from sitewright.building_model.inference.insertion import way_out
from sitewright.building_model.inference.separation import Separation, edged, separation_of
from sitewright.building_model.inference.solid import Solid, solid_of
from sitewright.building_model.shapes import shape_of
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector

A, B = ComponentId("a"), ComponentId("b")


def box(centre: Vector, size: Vector = (1.0, 1.0, 1.0)) -> Solid:
    solid = solid_of(beam("x", centre, size))
    assert solid is not None
    return solid


def apart(one: Solid, other: Solid) -> Separation:
    return separation_of(edged(one), edged(other))


def test_a_box_has_six_faces_and_eight_corners() -> None:
    solid = box((0.0, 0.0, 0.0))
    assert len(solid.faces) == 6
    assert len({tuple(round(x, 9) for x in c) for c in solid.corners_m}) == 8


def test_a_slanting_cut_gives_the_corners_that_the_shape_has() -> None:
    cut = PlaneCut((0.5, 0.0, 0.0), (math.sqrt(0.5), 0.0, math.sqrt(0.5)))
    component = beam("x", (0.0, 0.0, 0.0), (2.0, 0.2, 0.2), cuts=[cut])
    solid = solid_of(component)
    assert solid is not None
    (part,) = shape_of(component)
    corners = {tuple(round(x, 7) + 0.0 for x in c) for c in solid.corners_m}
    assert corners == {tuple(round(x, 7) + 0.0 for x in c) for c in part.vertices_m()}


def test_a_cut_that_takes_nothing_changes_nothing() -> None:
    cut = PlaneCut((3.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    solid = solid_of(beam("x", (0.0, 0.0, 0.0), (2.0, 0.2, 0.2), cuts=[cut]))
    assert solid is not None
    assert len(solid.faces) == 6


def test_what_is_cut_away_as_a_whole_has_no_solid() -> None:
    cut = PlaneCut((-3.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    assert solid_of(beam("x", (0.0, 0.0, 0.0), (2.0, 0.2, 0.2), cuts=[cut])) is None


def test_other_geometry_than_a_box_is_not_looked_at() -> None:
    from dataclasses import replace

    hull = ConvexGeometry(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), Z))
    assert solid_of(replace(beam("x", (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)), geometry=hull)) is None


def test_stacked_boxes_touch_with_the_shared_area_and_the_normal_upwards() -> None:
    contact = contact_between(A, box((0.0, 0.0, 0.0)), B, box((0.75, 0.5, 1.0)))
    assert contact is not None
    assert contact.normal == pytest.approx((0.0, 0.0, 1.0))
    assert contact.area_m2 == pytest.approx(0.25 * 0.5)


@pytest.mark.parametrize(
    "centre",
    [(0.0, 0.0, 1.002), (1.0, 0.0, 1.0), (0.9999, 0.0, 1.0)],
    ids=["2 mm apart", "only an edge", "a sliver of 1 cm2"],
)
def test_gaps_edges_and_slivers_are_no_contact(centre: Vector) -> None:
    assert contact_between(A, box((0.0, 0.0, 0.0)), B, box(centre)) is None


@pytest.mark.parametrize(
    ("centre", "gap_m"),
    [((1.5, 0.0, 0.0), 0.5), ((0.0, 0.0, 1.0), 0.0), ((0.9, 0.2, 0.0), -0.1)],
)
def test_the_gap_between_boxes_is_exact_face_to_face(centre: Vector, gap_m: float) -> None:
    separation = apart(box((0.0, 0.0, 0.0)), box(centre))
    assert separation.gap_m() == pytest.approx(gap_m, abs=1e-9)
    assert separation.reversed().gap_m() == pytest.approx(gap_m, abs=1e-9)
    assert separation.gap_m((-0.25, 0.0, 0.0)) == pytest.approx(
        apart(box((-0.25, 0.0, 0.0)), box(centre)).gap_m(), abs=1e-9
    )


def test_crossing_beams_are_told_apart_by_their_edges() -> None:
    turned = solid_of(
        beam("x", (0.0, 0.0, 0.2), (3.0, 0.1, 0.1), x_axis=(0.0, 1.0, 0.0), y_axis=(1.0, 0.0, 1.0))
    )
    assert turned is not None
    gap_m = apart(box((0.0, 0.0, 0.0), (3.0, 0.1, 0.1)), turned).gap_m()
    assert gap_m == pytest.approx(0.2 - 0.05 - 0.05 * math.sqrt(2.0))


def test_a_box_on_another_leaves_upwards_without_sliding() -> None:
    way = way_out([apart(box((0.0, 0.0, 1.0)), box((0.0, 0.0, 0.0)))], Z, 1.0)
    assert way is not None
    assert way.direction == pytest.approx(Z)
    assert way.slide_m == 0.0


def test_a_box_in_a_corner_leaves_away_from_both_walls() -> None:
    middle = box((0.0, 0.0, 0.0))
    walls = [apart(middle, box(c)) for c in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))]
    way = way_out(walls, Z, 0.0)
    assert way is not None
    assert way.direction[0] < -0.3
    assert way.direction[1] < -0.3
    assert way.slide_m == 0.0


def test_a_box_between_two_walls_slides_out_along_them() -> None:
    middle = box((0.0, 0.0, 0.0))
    walls = [apart(middle, box((x, 0.0, 0.0))) for x in (1.0, -1.0)]
    way = way_out(walls, Z, 0.0)
    assert way is not None
    assert way.direction == pytest.approx(Z)
    assert way.slide_m == pytest.approx(1.0, abs=0.03)


def test_a_box_that_is_walled_in_has_no_way_out() -> None:
    middle = box((0.0, 0.0, 0.0))
    around = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    walls = [
        apart(middle, box((s * x, s * y, s * z), (1.0, 1.0, 1.0)))
        for x, y, z in around
        for s in (1.0, -1.0)
    ]
    assert way_out(walls, Z, 5.0) is None
