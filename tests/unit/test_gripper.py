"""The built-in end effectors as shapes in their mount frame."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sitewright.foundation.shapes import Shape
from sitewright.robot_team.formats.urdf import read_urdf
from sitewright.robot_team.gripper import finger_parts, mount_T_tcp, palm_shape, shape_at
from sitewright.robot_team.models.catalogue import BUILTIN_END_EFFECTORS, builtin_end_effector

GRIPPER = read_urdf(builtin_end_effector("builtin:parallel-gripper"))
NAIL_GUN = read_urdf(builtin_end_effector("builtin:nail-gun"))
TCP_Z_M = mount_T_tcp(GRIPPER).position_m[2]


def extent(shape: Shape, axis: int) -> tuple[float, float]:
    values = [vertex[axis] for part in shape for vertex in part.vertices_m()]
    return min(values), max(values)


@settings(deadline=None, max_examples=20)
@given(aperture_m=st.floats(0.0, 0.17))
def test_the_pads_stand_apart_by_the_aperture(aperture_m: float) -> None:
    fingers = finger_parts(GRIPPER, aperture_m)
    assert set(fingers) == {"left", "right"}
    gap = extent(fingers["left"], 1)[0] - extent(fingers["right"], 1)[1]
    assert gap == pytest.approx(aperture_m, abs=1e-9)


@pytest.mark.parametrize("aperture_m", [-0.001, 0.1701])
def test_an_aperture_beyond_the_travel_is_refused(aperture_m: float) -> None:
    with pytest.raises(ValueError, match=r"opens from 0\.000 to 0\.170 m"):
        finger_parts(GRIPPER, aperture_m)


def test_the_pad_face_is_flat_and_the_tcp_is_in_its_middle() -> None:
    left = finger_parts(GRIPPER, 0.0)["left"]
    face = [v for part in left for v in part.vertices_m() if abs(v[1]) < 1e-12]
    low, high = min(v[2] for v in face), max(v[2] for v in face)
    assert (low + high) / 2.0 == pytest.approx(TCP_Z_M)
    assert high - low == pytest.approx(0.034)
    assert max(v[0] for v in face) - min(v[0] for v in face) == pytest.approx(0.060)


def test_a_stud_of_40_mm_is_held_in_its_middle_with_the_tips_above_the_floor() -> None:
    tip_past_tcp = extent(shape_at(GRIPPER, 0.09), 2)[1] - TCP_Z_M
    assert tip_past_tcp <= 0.040 / 2.0 - 0.002


@pytest.mark.parametrize("pitch_deg", [15.0, 30.0, 45.0])
def test_a_stud_of_40_mm_can_be_held_with_the_gripper_pitched(pitch_deg: float) -> None:
    pitch = math.radians(pitch_deg)
    overhang = max(
        math.cos(pitch) * (z - TCP_Z_M) + math.sin(pitch) * abs(x)
        for part in shape_at(GRIPPER, 0.09)
        for x, _, z in part.vertices_m()
    )
    tcp_above_floor = overhang + 0.002
    assert tcp_above_floor <= 0.040 - 0.005


def test_the_palm_stays_clear_of_a_piece_140_mm_deep_held_in_its_middle() -> None:
    palm_bottom = extent(palm_shape(GRIPPER), 2)[1]
    assert TCP_Z_M - 0.070 - palm_bottom >= 0.060


def test_the_shanks_do_not_touch_what_the_pads_hold() -> None:
    left = finger_parts(GRIPPER, 0.1)["left"]
    above_the_pad = [v for part in left for v in part.vertices_m() if v[2] < TCP_Z_M - 0.0171]
    assert min(v[1] for v in above_the_pad) >= 0.05 + 0.002 - 1e-9


def test_a_tool_has_no_fingers_and_ignores_the_aperture() -> None:
    assert finger_parts(NAIL_GUN, 0.3) == {}
    assert shape_at(NAIL_GUN, 0.3) == palm_shape(NAIL_GUN)


def test_the_whole_gripper_is_palm_and_fingers() -> None:
    parts = [p for shape in finger_parts(GRIPPER, 0.05).values() for p in shape]
    assert set(shape_at(GRIPPER, 0.05)) == {*palm_shape(GRIPPER), *parts}


def test_the_nose_of_the_nail_gun_is_slim_and_ends_at_the_tcp() -> None:
    end = extent(palm_shape(NAIL_GUN), 2)[1]
    nose = [v for p in palm_shape(NAIL_GUN) for v in p.vertices_m() if v[2] > end - 1e-9]
    assert end == pytest.approx(mount_T_tcp(NAIL_GUN).position_m[2])
    assert max(math.hypot(v[0], v[1]) for v in nose) <= 0.012


@pytest.mark.parametrize(
    ("name", "length_m", "mass_kg"),
    [
        ("builtin:parallel-gripper", 0.24, 35.0),
        ("builtin:nail-gun", 0.38, 12.0),
        ("builtin:screwdriver", 0.34, 9.0),
        ("builtin:paint-head", 0.30, 6.0),
    ],
)
def test_an_end_effector_is_as_long_and_heavy_as_stated(
    name: str, length_m: float, mass_kg: float
) -> None:
    assert name in BUILTIN_END_EFFECTORS
    description = read_urdf(builtin_end_effector(name))
    assert (description.root, description.tip) == ("mount", "tcp")
    assert mount_T_tcp(description).position_m == pytest.approx((0.0, 0.0, length_m))
    assert mount_T_tcp(description).z_axis == pytest.approx((0.0, 0.0, 1.0))
    assert sum(link.mass_kg for link in description.links) == pytest.approx(mass_kg)
