"""Hulls with few vertices still hold every point."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sitewright.robot_team.formats.hulls import MAX_VERTICES, few_vertices, hull_facets


def cube_with_points_inside() -> np.ndarray:
    corners = np.array(list(product((-0.5, 0.5), repeat=3)))
    inside = np.random.default_rng(1).uniform(-0.5, 0.5, (500, 3))
    return np.vstack([corners, inside])


def ball(seed: int, count: int, radius_m: float) -> np.ndarray:
    points = np.random.default_rng(seed).normal(size=(count, 3))
    lengths = np.sqrt((points**2).sum(axis=1, keepdims=True))
    return np.asarray(radius_m * points / lengths)


def test_a_cube_full_of_points_keeps_its_eight_corners_exactly() -> None:
    corners = few_vertices(cube_with_points_inside())
    assert sorted(map(tuple, corners.tolist())) == sorted(product((-0.5, 0.5), repeat=3))


def test_the_facets_of_a_cube_enclose_its_volume() -> None:
    assert hull_facets(cube_with_points_inside()).volume_m3() == pytest.approx(1.0)


@settings(deadline=None, max_examples=6)
@given(seed=st.integers(0, 1000), radius_m=st.floats(0.05, 1.0))
def test_a_body_with_many_corners_is_replaced_by_a_slightly_larger_one(
    seed: int, radius_m: float
) -> None:
    points = ball(seed, 800, radius_m)
    corners = few_vertices(points)
    assert len(corners) <= 2 * MAX_VERTICES
    assert hull_facets(corners).excess_m(points).max() <= 0.0
    assert np.linalg.norm(corners, axis=1).max() <= radius_m * 1.08 + 0.008


@pytest.mark.parametrize("points", [np.zeros((5, 3)), np.eye(4, 3), ball(1, 50, 1.0) * (1, 1, 0)])
def test_points_in_one_plane_are_no_body(points: np.ndarray) -> None:
    with pytest.raises(ValueError, match="one plane"):
        few_vertices(points if len(points) > 4 else points[:3])
