from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motion_scenes import A, B, kr120, tool, two_arms
from sitewright.building_model.component import (
    FastenerSpec,
    Process,
    SurfacePatch,
)
from sitewright.foundation.ids import BodyId, ComponentId, EndEffectorId, OperationId
from sitewright.foundation.pose import Pose, Vector, add, dot, rotation, scale, translation
from sitewright.foundation.shapes import Box, Hull
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.grasps import Grasp, grasps_of
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.scene import Attachment, Body
from sitewright.planning_twin.skill_motions.finish import stroke_points
from sitewright.robot_team.cell import EndEffector, EndEffectorKind
from sitewright.robot_team.description import Link
from sitewright.robot_team.gripper import mount_T_tcp, shape_at

GRIPPER = EndEffector(
    id=EndEffectorId("gripper"),
    kind=EndEffectorKind.GRIPPER,
    description=tool("builtin:parallel-gripper"),
    station=None,
    grips_m=(0.030, 0.140),
    opens_to_m=0.170,
)
GUN = EndEffector(
    id=EndEffectorId("gun"),
    kind=EndEffectorKind.TOOL,
    description=tool("builtin:nail-gun"),
    station=None,
    processes=("nail",),
    max_tilt_rad=math.radians(10.0),
    nose_half_width_m=0.012,
)
DOWN = rotation((1.0, 0.0, 0.0), math.pi)

sizes = st.tuples(st.floats(0.2, 3.0), st.floats(0.02, 0.2), st.floats(0.02, 0.2))
headings = st.floats(-math.pi, math.pi)
sides = st.sampled_from([0.0, math.pi / 2, math.pi, -math.pi / 2])


@st.composite
def lying(draw: st.DrawFn) -> tuple[PieceShape, Pose, float]:
    """A piece that lies flat on one of its sides, and the level of what it lies on."""
    size, side, floor_m = draw(sizes), draw(sides), draw(st.floats(0.0, 1.0))
    rolled = rotation((0.0, 0.0, 1.0), draw(headings)) @ rotation((1.0, 0.0, 0.0), side)
    height_m = sum(abs(axis[2]) * s for axis, s in zip(axes(rolled), size, strict=True))
    pose = translation(0.4, -0.3, floor_m + height_m / 2.0) @ rolled
    return PieceShape(shape=(Box(size),), size_m=size, mass_kg=1.0), pose, floor_m


def axes(pose: Pose) -> tuple[Vector, Vector, Vector]:
    return pose.x_axis, pose.y_axis, pose.z_axis


def lowest_m(grasp: Grasp, world_T_piece: Pose, aperture_m: float) -> float:
    world_T_mount = world_T_piece @ grasp.piece_T_tcp @ mount_T_tcp(GRIPPER.description).inverse()
    parts = shape_at(GRIPPER.description, aperture_m)
    return min(world_T_mount.apply(v)[2] for part in parts for v in part.vertices_m())


@settings(max_examples=40)
@given(lying())
def test_every_grasp_stays_off_the_ground_with_the_piece_between_its_fingers(
    case: tuple[PieceShape, Pose, float],
) -> None:
    piece, pose, floor_m = case
    low, high = GRIPPER.grips_m or (0.0, 0.0)
    found = grasps_of(piece, GRIPPER, pose)
    across_m = min(
        (s for s, axis in zip(piece.size_m[1:], axes(pose)[1:], strict=True) if abs(axis[2]) < 0.5),
    )
    assert bool(found) <= (low <= across_m <= high)
    for grasp in found[:: max(1, len(found) // 12)]:
        x, y, z = grasp.piece_T_tcp.position_m
        assert abs(x) < piece.size_m[0] / 2
        assert abs(y) < piece.size_m[1] / 2
        assert abs(z) < piece.size_m[2] / 2
        assert grasp.width_m == pytest.approx(across_m)
        assert grasp.width_m < grasp.open_m <= GRIPPER.opens_to_m
        for aperture_m in (grasp.width_m, grasp.open_m):
            assert lowest_m(grasp, pose, aperture_m) >= floor_m + 0.002 - 1e-9


@settings(max_examples=40)
@given(lying())
def test_grasps_come_from_above_and_the_cheapest_first(
    case: tuple[PieceShape, Pose, float],
) -> None:
    piece, pose, _ = case
    found = grasps_of(piece, GRIPPER, pose)
    costs = [g.cost for g in found]
    assert costs == sorted(costs)
    assert all((pose @ g.piece_T_tcp).z_axis[2] < 0.0 for g in found)


def test_the_case_study_pieces_can_be_taken_and_the_straight_middle_grasp_is_first() -> None:
    for size in ((1.8, 0.09, 0.04), (2.4, 0.09, 0.14)):
        piece = PieceShape(shape=(Box(size),), size_m=size, mass_kg=3.0)
        found = grasps_of(piece, GRIPPER, translation(0.0, 0.0, size[2] / 2.0))
        assert len(found) > 100
        assert found[0].piece_T_tcp.position_m[0] == 0.0
        assert found[0].piece_T_tcp.z_axis == pytest.approx((0.0, 0.0, -1.0))


@settings(max_examples=40)
@given(
    st.tuples(*[st.floats(-2.0, 2.0)] * 3),
    headings,
    st.floats(0.0, math.radians(15.0)),
    st.floats(0.0, 0.03),
)
def test_a_leaning_tool_touches_the_wood_and_does_not_enter_it(
    at: Vector, heading: float, max_tilt: float, half_width_m: float
) -> None:
    gun = replace(GUN, max_tilt_rad=max_tilt, nose_half_width_m=half_width_m)
    world_T_operation = translation(*at) @ rotation((0.0, 0.0, 1.0), heading) @ DOWN
    found = list(tool_poses(nail_at(world_T_operation), gun))
    assert found
    surface, drive = world_T_operation.position_m, world_T_operation.z_axis
    for pose in found:
        world_T_tcp = pose.world_T_tip @ mount_T_tcp(gun.description)
        tilt = math.acos(min(1.0, dot(world_T_tcp.z_axis, drive)))
        assert tilt <= max_tilt + 1e-6
        assert dot(pose.back_off, world_T_tcp.z_axis) == pytest.approx(-1.0)
        depths = [
            dot(add(edge, scale(surface, -1.0)), drive)
            for edge in nose_edge(world_T_tcp, half_width_m)
        ]
        assert max(depths) <= 1e-9
        assert max(depths) >= -half_width_m * (1.0 - math.cos(math.radians(22.5))) - 1e-9


def nail_at(world_T_operation: Pose) -> Spot:
    return Spot(
        operation=OperationId("nail"),
        process=Process.NAIL,
        target=ComponentId("stud"),
        world_T_operation=world_T_operation,
        fastener=FastenerSpec(type="nail", d_m=0.003, l_m=0.09),
    )


def nose_edge(world_T_tcp: Pose, half_width_m: float) -> list[Vector]:
    turns = (2.0 * math.pi * k / 32 for k in range(32))
    return [
        world_T_tcp.apply((half_width_m * math.cos(t), half_width_m * math.sin(t), 0.0))
        for t in turns
    ]


def test_a_tool_stands_upright_first_and_leans_no_further_than_it_may() -> None:
    labels = [p.label for p in tool_poses(nail_at(DOWN), GUN, has_yaw=False)]
    assert labels[0] == "upright"
    assert len(labels) == 1 + 3 * 8
    stiff = replace(GUN, max_tilt_rad=0.0)
    assert [p.label for p in tool_poses(nail_at(DOWN), stiff, has_yaw=False)] == ["upright"]


@settings(max_examples=60)
@given(st.floats(0.02, 3.0), st.floats(0.02, 2.0), st.floats(0.01, 0.4), st.data())
def test_strokes_cover_the_whole_patch(
    length_m: float, breadth_m: float, width_m: float, data: st.DataObject
) -> None:
    patch = SurfacePatch(
        size_m=(length_m, breadth_m), standoff_m=0.1, width_m=width_m, speed_m_s=0.1
    )
    spot = replace(nail_at(DOWN), process=Process.PAINT, fastener=None, patch=patch)
    points = stroke_points(spot)
    strokes = list(zip(points[::2], points[1::2], strict=True))
    x = data.draw(st.floats(-length_m / 2, length_m / 2))
    y = data.draw(st.floats(-breadth_m / 2, breadth_m / 2))
    assert any(
        min(a[0], b[0]) - 1e-9 <= x <= max(a[0], b[0]) + 1e-9
        and abs(y - a[1]) <= width_m / 2 + 1e-9
        for a, b in strokes
    )
    for (_, end), (start, _) in pairwise(strokes):
        assert end[0] == start[0]
        assert abs(end[1] - start[1]) <= width_m + 1e-9


changes = st.sampled_from(["posture", "base", "body", "shape", "carrier", "link", "clearance"])


@settings(max_examples=30)
@given(changes, st.floats(1e-6, 0.5))
def test_any_change_of_a_scene_changes_its_revision(what: str, by: float) -> None:
    scene = two_arms()
    body = scene.bodies[BodyId("support-1")]
    arm = scene.robots[A]
    assert isinstance(body.placement, Pose)
    match what:
        case "posture":
            other = scene.with_joints(A, (arm.q_rad[0] + by, *arm.q_rad[1:]))
        case "base":
            moved = replace(arm, world_T_base=translation(by, 0.0, 0.0) @ arm.world_T_base)
            other = replace(scene, robots={**scene.robots, A: moved})
        case "body":
            other = scene.placed(body.id, translation(0.0, by, 0.0) @ body.placement)
        case "shape":
            other = scene.with_body(replace(body, shape=(Box((2.4 + by, 0.09, 0.14)),)))
        case "carrier":
            other = scene.placed(body.id, Attachment(B, body.placement))
        case "link":
            first = kr120().links[0]
            bigger = Link(name=first.name, shape=(Box((1.0, 1.0, 1.0 + by)),))
            description = replace(kr120(), links=(bigger, *kr120().links[1:]))
            other = replace(
                scene, robots={**scene.robots, A: replace(arm, description=description)}
            )
        case _:
            other = replace(scene, clearance_m=scene.clearance_m + by)
    assert other.revision() != scene.revision()


def test_adding_and_taking_away_a_body_changes_the_revision_and_back() -> None:
    scene = two_arms()
    more = scene.with_body(Body(id=BodyId("box"), shape=(Box((1.0, 1.0, 1.0)),), placement=Pose()))
    assert more.revision() != scene.revision()
    assert more.without(BodyId("box"), BodyId("unknown")).revision() == scene.revision()


def test_what_does_not_change_a_scene_does_not_change_its_revision() -> None:
    scene = two_arms()
    shuffled = replace(
        scene,
        robots=dict(sorted(scene.robots.items(), reverse=True)),
        bodies=dict(sorted(scene.bodies.items(), key=lambda i: i[0][::-1])),
    )
    assert shuffled.revision() == scene.revision() == two_arms().revision()


@given(st.sampled_from([0, 0.0, -0.0]), st.sampled_from([1, 1.0]))
def test_equal_numbers_give_equal_revisions_however_they_are_written(
    zero: float, one: float
) -> None:
    """Shapes are hashed once and remembered: the first spelling must not decide."""
    scene = two_arms()
    pose = Pose((zero, zero, zero), (one, zero, zero, zero))
    points = ((zero, zero, zero), (one, zero, zero), (zero, one, zero), (zero, zero, one))
    for shape in ((Box((one, one, one), pose),), (Hull(points),)):
        other = scene.with_body(Body(id=BodyId("box"), shape=shape, placement=pose))
        plain = Pose((0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))
        hull = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        same = (Box((1.0, 1.0, 1.0), plain),) if isinstance(shape[0], Box) else (Hull(hull),)
        known = scene.with_body(Body(id=BodyId("box"), shape=same, placement=plain))
        assert other.revision() == known.revision()
