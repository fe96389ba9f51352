"""Flat faces of solids: welded corners, loops of edges, concave faces in triangles."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sitewright.building_model.formats.flat_faces import (
    Corners,
    Face,
    NoLoopError,
    area_vector,
    faces_of_loops,
    loops_of,
    outward,
)
from sitewright.foundation.pose import Vector, distance, norm

Z = (0.0, 0.0, 1.0)
NEAR = st.floats(-0.9e-3, 0.9e-3).map(lambda v: v / 3**0.5)
COORDINATE = st.floats(-1e6, 1e6)


@given(COORDINATE, COORDINATE, COORDINATE, NEAR, NEAR, NEAR)
def test_points_nearer_than_the_tolerance_are_one_corner(
    x: float, y: float, z: float, dx: float, dy: float, dz: float
) -> None:
    corners = Corners(1e-3)
    first = corners.index_of((x, y, z))
    assert corners.index_of((x + dx, y + dy, z + dz)) == first
    assert corners.index_of((x + 0.01, y, z)) != first


@given(st.lists(st.tuples(*[st.integers(-3, 3).map(float)] * 3), min_size=1, max_size=30))
def test_points_further_apart_stay_apart(points: list[Vector]) -> None:
    corners = Corners(1e-3)
    found = [corners.index_of(p) for p in points]
    assert len(corners.points) == len(set(points))
    assert all(distance(corners.points[i], p) == 0.0 for i, p in zip(found, points, strict=True))


def test_edges_in_any_order_and_direction_form_their_loops() -> None:
    loops = loops_of([(2, 3), (1, 0), (0, 3), (2, 1), (7, 8), (9, 8), (9, 7)])
    assert sorted(len(loop) for loop in loops) == [3, 4]
    for loop in loops:
        steps = {frozenset(e) for e in pairwise([*loop, loop[0]])}
        assert steps <= {
            *(frozenset({2, 3}), frozenset({1, 0}), frozenset({0, 3}), frozenset({2, 1})),
            *(frozenset({7, 8}), frozenset({9, 8}), frozenset({9, 7})),
        }


@pytest.mark.parametrize("edges", [[(0, 1), (1, 2)], [(0, 1), (1, 2), (2, 0), (0, 3)]])
def test_edges_that_do_not_close_are_no_face(edges: list[tuple[int, int]]) -> None:
    with pytest.raises(NoLoopError, match="do not close"):
        loops_of(edges)


def test_a_convex_face_stays_whole_and_turns_to_its_normal() -> None:
    points = [(0.0, 0.0, 0.0), (0.0, 2.0, 0.0), (2.0, 2.0, 0.0), (2.0, 0.0, 0.0)]
    (face,) = faces_of_loops(points, [[0, 1, 2, 3]], Z)
    assert face == (3, 2, 1, 0)


def test_a_face_with_a_hole_becomes_triangles_of_the_same_area() -> None:
    pytest.importorskip("shapely", reason="needs the extra [rhino]: make all-env")
    outer = [(0.0, 0.0, 0.0), (9.0, 0.0, 0.0), (9.0, 9.0, 0.0), (4.0, 5.0, 0.0), (0.0, 9.0, 0.0)]
    hole = [(1.0, 1.0, 0.0), (2.0, 1.0, 0.0), (2.0, 3.0, 0.0)]
    points = [*outer, *hole]
    faces = faces_of_loops(points, [[5, 6, 7], [0, 1, 2, 3, 4]], Z)
    areas = [area_vector([points[i] for i in f]) for f in faces]
    assert all(a[2] > 0.0 for a in areas)
    wanted = norm(area_vector(outer)) - norm(area_vector(hole))
    assert sum(norm(a) for a in areas) == pytest.approx(wanted)
    assert {i for f in faces for i in f} == set(range(8))


def test_a_face_that_crosses_itself_is_refused() -> None:
    pytest.importorskip("shapely", reason="needs the extra [rhino]: make all-env")
    points = [(0.0, 0.0, 0.0), (3.0, 1.0, 0.0), (0.0, 1.0, 0.0), (2.0, 0.0, 0.0)]
    with pytest.raises(NoLoopError, match="cross"):
        faces_of_loops(points, [[0, 1, 2, 3]], Z)


def test_a_solid_turned_inside_out_is_turned_back() -> None:
    points = [(5.0, 5.0, 5.0), (6.0, 5.0, 5.0), (5.0, 6.0, 5.0), (5.0, 5.0, 6.0)]
    good: list[Face] = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
    assert outward(points, [f[::-1] for f in good]) == good
    assert outward(points, good) == good
