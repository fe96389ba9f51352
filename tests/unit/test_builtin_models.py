"""The built-in KR 120: figures of the arm, tightness of its envelopes, the catalogue."""

from __future__ import annotations

import math
import os
from pathlib import Path

import coal
import numpy as np
import pytest

from sitewright.foundation.shapes import Hull
from sitewright.planning_twin.backends.kinematic_chain import chain_of
from sitewright.planning_twin.backends.opw_geometry import OpwGeometry, opw_geometry
from sitewright.robot_team.formats.hulls import hull_facets
from sitewright.robot_team.formats.mesh_points import read_points
from sitewright.robot_team.formats.urdf import read_urdf
from sitewright.robot_team.models.catalogue import (
    BUILTIN_END_EFFECTORS,
    BUILTIN_ROBOTS,
    UnknownModelError,
    builtin_end_effector,
    builtin_robot,
)

KR120 = read_urdf(builtin_robot("kuka-kr120-r2500-pro"))
VERTEX_LIMIT = 95
CONVEX_VOLUME_M3 = {
    "base_link": 0.167,
    "link_1": 0.169,
    "link_2": 0.170,
    "link_3": 0.125,
    "link_4": 0.007,
    "link_5": 0.013,
    "link_6": 0.0004,
}
needs_measured_meshes = pytest.mark.skipif(
    "SITEWRIGHT_DATA" not in os.environ, reason="SITEWRIGHT_DATA names no folder of shared data"
)


def envelope(link_name: str) -> np.ndarray:
    (link,) = (link for link in KR120.links if link.name == link_name)
    (hull,) = link.shape
    assert isinstance(hull, Hull)
    return np.array(hull.points_m)


def measured(link_name: str) -> np.ndarray:
    folder = Path(os.environ["SITEWRIGHT_DATA"]) / "kuka_kr120" / "collision"
    return read_points(folder / f"{link_name}.stl")


def distance_outside_m(points: np.ndarray, corners: np.ndarray) -> float:
    """Return the largest distance of a point to a hull, by coal."""
    rows = coal.StdVec_Vec3s()
    rows.extend(list(corners))
    hull = coal.ConvexBase.convexHull(rows, True, "Qt")  # noqa: FBT003
    probe, request, worst = coal.Sphere(1e-9), coal.DistanceRequest(), 0.0
    outside = points[hull_facets(corners).excess_m(points).max(axis=1) > 0.0]
    for point in outside:
        at = coal.Transform3s(np.eye(3), point)
        result = coal.DistanceResult()
        distance = coal.distance(hull, coal.Transform3s(), probe, at, request, result)
        worst = max(worst, distance)
    return worst


@needs_measured_meshes
@pytest.mark.parametrize("link", CONVEX_VOLUME_M3)
def test_the_real_link_is_at_most_5_mm_outside_its_envelope(link: str) -> None:
    assert 0.0 < distance_outside_m(measured(link), envelope(link)) <= 0.005


@needs_measured_meshes
@pytest.mark.parametrize("link", CONVEX_VOLUME_M3)
def test_no_vertex_of_the_real_mesh_is_in_the_envelope(link: str) -> None:
    gaps = np.linalg.norm(envelope(link)[:, None] - measured(link)[None], axis=2).min(axis=1)
    assert gaps.min() > 2e-4


@needs_measured_meshes
@pytest.mark.parametrize("link", CONVEX_VOLUME_M3)
def test_no_corner_of_an_envelope_stands_out_far(link: str) -> None:
    assert distance_outside_m(envelope(link), measured(link)) <= 0.015


@pytest.mark.parametrize(("link", "convex_m3"), CONVEX_VOLUME_M3.items())
def test_an_envelope_is_tight_and_has_few_vertices(link: str, convex_m3: float) -> None:
    corners = envelope(link)
    assert hull_facets(corners).volume_m3() <= 1.25 * convex_m3
    assert len(corners) <= VERTEX_LIMIT


def test_limits_and_speeds_are_those_of_the_data_sheet() -> None:
    rows = [
        (math.degrees(j.lower_rad), math.degrees(j.upper_rad), math.degrees(j.velocity_rad_s))
        for j in KR120.movable_joints
    ]
    expected = [
        (-185, 185, 156), (-155, 35, 156), (-130, 154, 156),
        (-350, 350, 330), (-130, 130, 330), (-350, 350, 615),
    ]  # fmt: skip
    assert [pytest.approx(row, abs=1e-6) for row in expected] == rows


def test_the_arm_weighs_about_1050_kg_and_carries_120() -> None:
    assert sum(link.mass_kg for link in KR120.links) == pytest.approx(1050.0, abs=30.0)
    assert KR120.payload_kg == 120.0


def test_the_irb_6700_has_the_lengths_limits_and_speeds_of_its_data_sheet() -> None:
    arm = read_urdf(builtin_robot("abb-irb6700-200-260"))
    geometry = opw_geometry(chain_of(arm))
    assert isinstance(geometry, OpwGeometry)
    assert geometry.lengths_m == pytest.approx((0.32, -0.2, 0.0, 0.78, 1.125, 1.1425, 0.2))
    rows = [
        (math.degrees(j.lower_rad), math.degrees(j.upper_rad), math.degrees(j.velocity_rad_s))
        for j in arm.movable_joints
    ]
    expected = [
        (-170, 170, 110), (-65, 85, 110), (-180, 70, 110),
        (-300, 300, 190), (-130, 130, 150), (-360, 360, 210),
    ]  # fmt: skip
    assert [pytest.approx(row, abs=1e-6) for row in expected] == rows
    assert arm.payload_kg == 200.0
    assert sum(link.mass_kg for link in arm.links) == pytest.approx(1250.0, abs=25.0)
    a1, a2, _, _, c2, c3, _ = geometry.lengths_m
    assert a1 + c2 + math.hypot(a2, c3) == pytest.approx(2.60, abs=0.01)


@pytest.mark.parametrize(
    ("folder", "name"),
    [(builtin_robot, name) for name in BUILTIN_ROBOTS]
    + [(builtin_end_effector, name) for name in BUILTIN_END_EFFECTORS],
)
def test_every_model_of_the_catalogue_can_be_read(folder: object, name: str) -> None:
    assert callable(folder)
    description = read_urdf(folder(name))
    bodies = [link for link in description.links if link.shape]
    assert bodies
    assert all(link.mass_kg > 0.0 for link in bodies)


def test_an_unknown_model_lists_the_known_ones() -> None:
    with pytest.raises(UnknownModelError, match=r"known: abb-irb6700-200-260, kuka.*Did you mean"):
        builtin_robot("kuka-kr120-r2700")
    with pytest.raises(UnknownModelError, match=r"known: builtin:nail-gun, .*screwdriver"):
        builtin_end_effector("builtin:glue-gun")
