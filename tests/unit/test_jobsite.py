from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import pytest

from builders_planning import EXAMPLES, A, B
from sitewright.app.planning import start_of
from sitewright.app.project import open_project
from sitewright.building_model.component import FastenerSpec, Process
from sitewright.central_controller.design import Design
from sitewright.central_controller.situation import jobsite_of, piece_shapes
from sitewright.foundation.ids import BodyId, ComponentId, EndEffectorId, OperationId
from sitewright.foundation.pose import Pose, translation
from sitewright.foundation.shapes import Shape, moved
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.jobsite import (
    ArmState,
    Jobsite,
    bodies_of_tool,
    drives,
    end_effector_bodies,
    scene_of,
    tool_for,
    with_aperture,
    with_tool,
    world_T_dock,
)
from sitewright.planning_twin.scene import Attachment, SceneSnapshot

GUN, DRIVER, GRIPPER = (EndEffectorId(e) for e in ("nail-gun", "screwdriver", "gripper-s"))
PIECE = ComponentId("thin.5")


@lru_cache(maxsize=1)
def site() -> Jobsite:
    project = open_project(EXAMPLES / "wooden_frame")
    seen = start_of(project).observation
    return Jobsite(
        cell=project.cell,
        pieces=piece_shapes(project.model),
        world_T_piece=seen.world_T_piece,
        arms={
            r: ArmState(q_rad=s.q_rad, mounted=s.mounted, aperture_m=s.aperture_m)
            for r, s in seen.robots.items()
        },
        docked=seen.docked,
    )


def holding(piece: ComponentId) -> Jobsite:
    arm = replace(site().arms[A], held=piece, tip_T_held=translation(0.0, 0.0, 0.24))
    return replace(site(), arms={**site().arms, A: arm})


def spot(fastener: FastenerSpec | None, process: Process = Process.NAIL) -> Spot:
    return Spot(
        operation=OperationId("op"),
        process=process,
        target=PIECE,
        world_T_operation=Pose(),
        fastener=fastener,
    )


NAIL = FastenerSpec(type="nail", d_m=0.0031, l_m=0.09)
SCREW = FastenerSpec(type="screw", d_m=0.006, l_m=0.08)


def test_a_scene_has_everything_that_collides_once() -> None:
    scene, cell = scene_of(site()), site().cell
    assert set(scene.robots) == {A, B}
    expected = {
        *cell.fixture_by_id,
        *cell.zone_by_id,
        *site().world_T_piece,
        *cell.end_effector_by_id,
        f"{GRIPPER}/left",
        f"{GRIPPER}/right",
    }
    assert set(scene.bodies) == {BodyId(b) for b in expected}
    assert scene.clearance_m == cell.clearance_m


def test_mounted_tools_move_with_their_robot_and_docked_ones_stand() -> None:
    scene, cell = scene_of(site()), site().cell
    assert scene.bodies[BodyId(GUN)].placement == Attachment(B, Pose())
    dock = world_T_dock(cell, cell.end_effector_by_id[DRIVER])
    assert scene.bodies[BodyId(DRIVER)].placement == dock


def test_a_held_piece_moves_with_the_robot_until_it_is_steadied_at_its_target() -> None:
    held = scene_of(holding(PIECE)).bodies[BodyId(PIECE)]
    assert held.placement == Attachment(A, translation(0.0, 0.0, 0.24))
    steadied = replace(holding(PIECE), steadied={PIECE: A})
    assert scene_of(steadied).bodies[BodyId(PIECE)].placement == site().world_T_piece[PIECE]


def test_changing_a_tool_docks_the_old_one_and_takes_the_new_one() -> None:
    tool = site().cell.end_effector_by_id[DRIVER]
    changed = with_tool(site(), B, tool)
    assert changed.arms[B].mounted == DRIVER
    assert set(changed.docked) == (set(site().docked) - {DRIVER}) | {GUN}
    scene = scene_of(changed)
    assert scene.bodies[BodyId(DRIVER)].placement == Attachment(B, Pose())
    assert isinstance(scene.bodies[BodyId(GUN)].placement, Pose)
    assert with_tool(changed, B, tool) is changed


def test_a_gripper_without_a_station_is_not_left_anywhere() -> None:
    with pytest.raises(ValueError, match="no tool station"):
        world_T_dock(site().cell, site().cell.end_effector_by_id[GRIPPER])


def in_tip_frame(scene: SceneSnapshot, body: BodyId) -> Shape:
    placement = scene.bodies[body].placement
    assert isinstance(placement, Attachment)
    return moved(scene.bodies[body].shape, placement.tip_T_body)


def test_an_opened_gripper_has_its_fingers_further_apart() -> None:
    tool = site().cell.end_effector_by_id[GRIPPER]
    scene = scene_of(site())
    shut, wide = (with_aperture(scene, tool, a) for a in (0.04, 0.16))
    for finger in bodies_of_tool(tool)[1:]:
        assert shut.bodies[finger].shape == wide.bodies[finger].shape
        near, far = (
            max(abs(v[1]) for part in in_tip_frame(s, finger) for v in part.vertices_m())
            for s in (shut, wide)
        )
        assert far - near == pytest.approx(0.06, abs=1e-9)
    palm = BodyId(GRIPPER)
    assert shut.bodies[palm].shape == wide.bodies[palm].shape


def test_an_aperture_beyond_the_travel_is_the_end_of_the_travel() -> None:
    tool = site().cell.end_effector_by_id[GRIPPER]
    assert end_effector_bodies(tool, Pose(), 9.0) == end_effector_bodies(tool, Pose(), 0.170)
    assert end_effector_bodies(tool, Pose(), -1.0) == end_effector_bodies(tool, Pose(), 0.0)


@pytest.mark.parametrize(
    ("fastener", "fits"),
    [
        (NAIL, True),
        (replace(NAIL, l_m=0.10), False),
        (replace(NAIL, l_m=0.04), False),
        (replace(NAIL, d_m=0.0034), False),
        (replace(NAIL, type="staple"), False),
        (SCREW, False),
    ],
)
def test_a_tool_drives_what_is_in_its_range(fastener: FastenerSpec, *, fits: bool) -> None:
    assert drives(site().cell.end_effector_by_id[GUN], spot(fastener)) is fits


def test_the_mounted_tool_is_used_if_it_fits_and_a_docked_one_otherwise() -> None:
    robot = site().cell.robot_by_id[B]
    nailing, screwing = (tool_for(site(), robot, spot(f, p)) for f, p in
                         ((NAIL, Process.NAIL), (SCREW, Process.SCREW)))  # fmt: skip
    assert (nailing and nailing.id, screwing and screwing.id) == (GUN, DRIVER)


def test_a_tool_that_is_neither_mounted_nor_docked_is_not_used() -> None:
    robot = site().cell.robot_by_id[B]
    lost = replace(site(), docked={})
    assert tool_for(lost, robot, spot(SCREW, Process.SCREW)) is None
    assert tool_for(site(), site().cell.robot_by_id[A], spot(NAIL)) is None


def test_an_aperture_that_is_sensed_a_little_too_wide_is_as_wide_as_the_gripper_opens() -> None:
    project = open_project(EXAMPLES / "wooden_frame")
    start = start_of(project)
    wide = replace(start.observation.robots[A], aperture_m=0.1712)
    seen = replace(start.observation, robots={**start.observation.robots, A: wide})
    design = Design(model=project.model, cell=project.cell)
    context = replace(start, observation=seen)
    found = jobsite_of(design, piece_shapes(project.model), context, OpwKinematics())
    assert found.arms[A].aperture_m == project.cell.end_effector_by_id[GRIPPER].opens_to_m
