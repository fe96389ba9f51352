from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sitewright.foundation.canonical import canonical_json, sha256_hex
from sitewright.foundation.pose import (
    Matrix4,
    Pose,
    Vector,
    cross,
    distance,
    dot,
    from_axis_angle,
    norm,
    rotation,
    translation,
    unit,
)
from sitewright.foundation.shapes import Box, Hull, Shape, moved

NEAR = 1e-9

metres = st.floats(-20.0, 20.0, allow_subnormal=False)
vectors = st.tuples(metres, metres, metres)
directions = vectors.filter(lambda v: norm(v) > 1e-3)
angles = st.one_of(
    st.floats(-math.pi, math.pi), st.sampled_from([0.0, math.pi, -math.pi, math.pi / 2])
)


@st.composite
def poses(draw: st.DrawFn) -> Pose:
    return Pose(draw(vectors), from_axis_angle(draw(directions), draw(angles)))


def is_same(a: Pose, b: Pose, tolerance: float = 1e-8) -> bool:
    return a.distance_to_m(b) < tolerance and a.angle_to_rad(b) < tolerance


@given(poses(), poses(), poses())
def test_chaining_is_associative(a: Pose, b: Pose, c: Pose) -> None:
    assert is_same((a @ b) @ c, a @ (b @ c))


@given(poses())
def test_a_pose_and_its_inverse_cancel_on_both_sides(a: Pose) -> None:
    assert is_same(a @ a.inverse(), Pose())
    assert is_same(a.inverse() @ a, Pose())
    assert is_same(a @ Pose(), a)
    assert is_same(Pose() @ a, a)


@given(poses(), poses(), vectors)
def test_chained_poses_move_a_point_one_after_the_other(a: Pose, b: Pose, p: Vector) -> None:
    assert distance((a @ b).apply(p), a.apply(b.apply(p))) < 1e-8


@given(poses(), vectors, vectors)
def test_a_pose_keeps_distances_angles_and_handedness(a: Pose, p: Vector, q: Vector) -> None:
    assert distance(a.apply(p), a.apply(q)) == pytest.approx(distance(p, q), abs=1e-8)
    assert dot(a.turn(p), a.turn(q)) == pytest.approx(dot(p, q), abs=1e-6)
    assert distance(cross(a.x_axis, a.y_axis), a.z_axis) < NEAR


@given(poses())
def test_a_matrix_gives_back_its_pose(a: Pose) -> None:
    assert is_same(Pose.from_matrix(a.matrix()), a)


@given(poses(), st.floats(0.9, 1.1).filter(lambda f: abs(f - 1.0) > 1e-5))
def test_a_scaled_matrix_is_no_pose(a: Pose, factor: float) -> None:
    rows: Matrix4 = tuple((*(factor * v for v in row[:3]), row[3]) for row in a.matrix()[:3])
    with pytest.raises(ValueError, match="no rotation"):
        Pose.from_matrix((*rows, (0.0, 0.0, 0.0, 1.0)))


@pytest.mark.parametrize("diagonal", [(1.0, 1.0, -1.0), (math.nan, 1.0, 1.0)])
def test_a_mirror_or_nan_is_no_pose(diagonal: Vector) -> None:
    rows = tuple(tuple(diagonal[i] if i == j else 0.0 for j in range(4)) for i in range(3))
    with pytest.raises(ValueError, match="no rotation"):
        Pose.from_matrix((*rows, (0.0, 0.0, 0.0, 1.0)))


@given(poses())
def test_two_axes_give_back_their_pose(a: Pose) -> None:
    assert is_same(Pose.from_axes(a.position_m, a.x_axis, a.y_axis), a)


@given(directions, directions)
def test_a_pose_of_two_directions_has_its_x_along_the_first(x: Vector, y: Vector) -> None:
    if norm(cross(unit(x), unit(y))) < 1e-3:
        return
    pose = Pose.from_axes((0.0, 0.0, 0.0), x, y)
    assert distance(pose.x_axis, unit(x)) < 1e-7
    assert dot(pose.y_axis, y) > 0.0


@given(directions, directions)
def test_a_pose_of_a_z_axis_has_just_this_z_axis_whatever_the_hint(z: Vector, hint: Vector) -> None:
    for x_hint in (hint, z, (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)):
        assert distance(Pose.from_z_axis((1.0, 2.0, 3.0), z, x_hint).z_axis, unit(z)) < 1e-7


@given(vectors, angles, st.floats(-1.5, 1.5), angles)
def test_roll_pitch_and_yaw_turn_about_fixed_axes(
    p: Vector, roll: float, pitch: float, yaw: float
) -> None:
    chained = (
        translation(*p)
        @ rotation((0.0, 0.0, 1.0), yaw)
        @ rotation((0.0, 1.0, 0.0), pitch)
        @ rotation((1.0, 0.0, 0.0), roll)
    )
    assert is_same(Pose.from_rpy(p, (roll, pitch, yaw)), chained)


@given(directions, st.floats(0.0, math.pi))
def test_the_angle_between_poses_is_the_turn_between_them(axis: Vector, angle: float) -> None:
    assert rotation(axis, angle).angle_to_rad(Pose()) == pytest.approx(angle, abs=1e-7)


@given(poses(), poses())
def test_the_angle_between_poses_does_not_see_the_sign_of_a_quaternion(a: Pose, b: Pose) -> None:
    w, x, y, z = b.quaternion_wxyz
    other = replace(b, quaternion_wxyz=(-w, -x, -y, -z))
    assert a.angle_to_rad(b) == pytest.approx(a.angle_to_rad(other), abs=1e-9)
    assert 0.0 <= a.angle_to_rad(b) <= math.pi + 1e-12


@pytest.mark.parametrize(
    ("position", "quaternion"),
    [
        ((math.nan, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)),
        ((0.0, math.inf, 0.0), (1.0, 0.0, 0.0, 0.0)),
        ((0.0, 0.0, 0.0), (1.0, 0.1, 0.0, 0.0)),
        ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)),
    ],
)
def test_numbers_that_are_no_rigid_transform_are_refused(
    position: Vector, quaternion: tuple[float, float, float, float]
) -> None:
    with pytest.raises(ValueError, match=r"pose must be finite|has length"):
        Pose(position, quaternion)


def test_a_zero_vector_has_no_direction() -> None:
    with pytest.raises(ValueError, match="no direction"):
        rotation((0.0, 0.0, 0.0), 1.0)


@settings(max_examples=30)
@given(poses(), poses(), st.tuples(*[st.floats(0.01, 3.0)] * 3))
def test_a_moved_shape_is_its_points_moved(a: Pose, b: Pose, size: Vector) -> None:
    box = Box(size, b)
    shape: Shape = (box, Hull(box.vertices_m()))
    for part, original in zip(moved(shape, a), shape, strict=True):
        for vertex, before in zip(part.vertices_m(), original.vertices_m(), strict=True):
            assert distance(vertex, a.apply(before)) < 1e-8


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=12,
)  # fmt: skip


@given(st.dictionaries(st.text(), json_values, min_size=1, max_size=5))
def test_canonical_json_does_not_depend_on_the_order_of_keys(value: dict[str, object]) -> None:
    shuffled = dict(reversed(value.items()))
    assert canonical_json(value) == canonical_json(shuffled)  # type: ignore[arg-type]


@pytest.mark.parametrize("value", [math.nan, math.inf, [-math.inf]])
def test_canonical_json_refuses_what_json_cannot_say(value: float) -> None:
    with pytest.raises(ValueError, match="not JSON compliant"):
        canonical_json(value)


def test_a_text_and_its_bytes_have_the_same_hash() -> None:
    assert sha256_hex("Ständer") == sha256_hex("Ständer".encode())
    assert sha256_hex("a") != sha256_hex("b")
