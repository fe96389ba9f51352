"""Shapes, volumes and masses of components."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from builders_building import component
from sitewright.building_model.component import (
    BoxGeometry,
    CompoundGeometry,
    ConvexGeometry,
    ExtrusionGeometry,
    PlaneCut,
)
from sitewright.building_model.convex import inside_length_m, planes_of, volume_m3
from sitewright.building_model.shapes import (
    UnsupportedGeometryError,
    extent_of,
    mass_of,
    shape_of,
    size_of,
    volume_of,
)
from sitewright.building_model.triangles import convex_pieces
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.foundation.shapes import Box, Hull

STUD = component("s", size_m=(2.0, 0.1, 0.1))


def test_a_box_stays_a_box() -> None:
    assert shape_of(STUD) == (Box((2.0, 0.1, 0.1)),)
    assert volume_of(STUD) == pytest.approx(0.02)


def test_a_mitre_takes_half_of_the_end_off() -> None:
    cut = PlaneCut((0.95, 0.0, 0.0), (1.0, 0.0, 1.0))
    mitred = replace(STUD, cuts=(cut,))
    (part,) = shape_of(mitred)
    assert isinstance(part, Hull)
    assert len(part.points_m) == 8
    assert volume_of(mitred) == pytest.approx(0.02 - 0.1 * 0.1 * 0.1 / 2)
    assert size_of(mitred) == (2.0, 0.1, 0.1)


def test_two_cuts_leave_a_wedge() -> None:
    cuts = (PlaneCut((0, 0, 0), (1, 0, 1)), PlaneCut((0, 0, 0), (-1, 0, 1)))
    wedge = replace(component("w", size_m=(0.2, 1.0, 0.2)), cuts=cuts)
    assert volume_of(wedge) == pytest.approx(0.2 * 0.1 * 1.0 - 0.1 * 0.1)
    extent = extent_of(shape_of(wedge))
    assert extent.high_m == pytest.approx((0.1, 0.5, 0.0))


def test_a_cut_that_misses_changes_nothing() -> None:
    assert shape_of(replace(STUD, cuts=(PlaneCut((1.5, 0, 0), (1, 0, 0)),))) == shape_of(STUD)


def test_an_l_profile_becomes_convex_pieces_of_the_same_volume() -> None:
    profile = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0))
    angle = replace(STUD, geometry=ExtrusionGeometry(profile, 0.5))
    assert len(shape_of(angle)) > 1
    assert volume_of(angle) == pytest.approx(1.5)
    clockwise = replace(STUD, geometry=ExtrusionGeometry(profile[::-1], 0.5))
    assert volume_of(clockwise) == pytest.approx(1.5)


def test_a_profile_that_crosses_itself_has_no_pieces() -> None:
    assert convex_pieces(((0, 0), (2, 2), (2, 0), (0, 1))) == []


def test_holes_are_refused_in_words() -> None:
    square = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
    holed = replace(STUD, geometry=ExtrusionGeometry(square, 0.5, (square,)))
    with pytest.raises(UnsupportedGeometryError, match="holes"):
        shape_of(holed)


def test_a_compound_is_its_parts_in_their_places() -> None:
    parts = ((translation(1, 0, 0), BoxGeometry((1, 1, 1))), (Pose(), BoxGeometry((1, 1, 1))))
    pair = replace(STUD, geometry=CompoundGeometry(parts))
    assert size_of(pair) == pytest.approx((2.0, 1.0, 1.0))
    assert volume_of(pair) == pytest.approx(2.0)


def test_the_extent_turns_with_the_frame() -> None:
    turned = extent_of(shape_of(STUD), rotation((0, 0, 1), math.pi / 2))
    assert turned.size_m == pytest.approx((0.1, 2.0, 0.1))


def test_mass_comes_from_the_nearest_statement() -> None:
    assert mass_of(STUD) == pytest.approx(9.0)
    assert mass_of(replace(STUD, material="Steel")) == pytest.approx(157.0)
    materials = {"C24": {"density_kg_m3": 420.0}}
    assert mass_of(replace(STUD, material="C24"), materials) == pytest.approx(8.4)
    assert mass_of(replace(STUD, density_kg_m3=500.0), materials) == pytest.approx(10.0)
    assert mass_of(replace(STUD, mass_kg=7.0), materials) == 7.0


def test_a_segment_is_measured_inside_only() -> None:
    planes = planes_of(Box((1.0, 1.0, 1.0)))
    assert len(planes) == 6
    assert inside_length_m(planes, (0, 0, 2), (0, 0, -1), 10) == pytest.approx(1.0)
    assert inside_length_m(planes, (0, 0, 2), (0, 0, -1), 1.8) == pytest.approx(0.3)
    assert inside_length_m(planes, (0.6, 0, 2), (0, 0, -1), 10) == 0.0
    assert inside_length_m(planes, (0, 0, 2), (0, 0, 1), 10) == 0.0


def test_a_flat_set_of_points_has_no_faces_and_no_volume() -> None:
    flat = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (1.0, 1.0, 0.0))
    assert planes_of(Hull(flat)) == ()
    assert volume_m3(flat) == 0.0


def test_an_octahedron_has_eight_faces() -> None:
    corners = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
    assert len(planes_of(Hull(corners))) == 8
    assert volume_m3(corners) == pytest.approx(4 / 3)
    convex = replace(STUD, geometry=ConvexGeometry(corners))
    assert size_of(convex) == (2.0, 2.0, 2.0)
