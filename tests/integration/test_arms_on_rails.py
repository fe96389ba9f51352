"""An arm on a track in every engine: frames, travel bounds, search, timing, second opinion."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import mujoco
import numpy as np
import pinocchio
import pytest

from builders_arms import urdf_text
from motion_scenes import A, box, gripper, kr120
from sitewright.foundation.mjcf.text import mjcf_text
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.backends.arm_model import CarriedPart, swing_radii
from sitewright.planning_twin.backends.kinematic_chain import Array, chain_of, matrix_of
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.twin import make_backends
from sitewright.planning_twin.free_motion import plan_free_motion
from sitewright.planning_twin.motion import (
    Agreement,
    Certificate,
    JointLimits,
    JointPath,
    PathSegment,
)
from sitewright.planning_twin.refusal import NoIk, NotClear
from sitewright.planning_twin.scene import RobotInScene, SceneSnapshot
from sitewright.robot_team.cell import Robot, RobotSubtype
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.drivers.mujoco.scene import robot_alone
from sitewright.robot_team.kinematics import tip_pose
from sitewright.robot_team.rails import Rail, on_rails

HOME: Joints = (0.0, 0.0, -1.9, 1.9, 0.0, 1.3, 0.0)
CARRIAGE = (Box((1.2, 1.2, 0.2), translation(0.0, 0.0, -0.12)),)


def rail(axis: tuple[float, float, float]) -> Rail:
    return Rail(axis=axis, travel_m=(-2.0, 2.0), speed_m_s=1.5, carriage=CARRIAGE)


def track() -> Description:
    return on_rails(kr120(), [rail((0.0, 1.0, 0.0))], rotation((0.0, 0.0, 1.0), 0.3))


def gantry() -> Description:
    """Three rails; the arm hangs head down from the last carriage."""
    hanging = rotation((1.0, 0.0, 0.0), math.pi)
    return on_rails(kr120(), [rail((1.0, 0.0, 0.0)), rail((0.0, 0.8, 0.6)), rail((0.0, 0.0, 1.0))],
                    hanging)  # fmt: skip


ARMS = [pytest.param(track, id="track"), pytest.param(gantry, id="gantry")]


def postures(arm: Description, count: int, seed: int = 1) -> Array:
    chain = chain_of(arm)
    return np.random.default_rng(seed).uniform(chain.lower, chain.upper, (count, chain.joints))


def scene_of(arm: Description, q: Joints) -> SceneSnapshot:
    bodies = {b.id: b for b in gripper(A)}
    robot = RobotInScene(description=arm, world_T_base=translation(0.2, 0.1, 0.5), q_rad=q)
    return SceneSnapshot(robots={A: robot}, bodies=bodies, clearance_m=0.010)


@pytest.mark.parametrize("make", ARMS)
def test_frames_equal_those_of_pinocchio_and_of_the_simulation(make: object) -> None:
    assert callable(make)
    arm: Description = make()
    chain = chain_of(arm)
    pin = pinocchio.buildModelFromXML(urdf_text(arm))
    data = pin.createData()
    robot = Robot(
        id=A, model="", description=arm, subtype=RobotSubtype.HANDLER, can=frozenset(),
        world_T_base=Pose(), home_q_rad=HOME, parking_q_rad=(), max_acceleration_rad_s2=(),
        end_effectors=(), mounted=None,
    )  # fmt: skip
    model = mujoco.MjModel.from_xml_string(mjcf_text(robot_alone(robot, None)))
    sim = mujoco.MjData(model)
    address = [model.joint(f"a:{j.name}").qposadr[0] for j in arm.movable_joints]
    for q in postures(arm, 10):
        ours = chain.tips(q[None])[0]
        pinocchio.framesForwardKinematics(pin, data, q)
        assert np.abs(data.oMf[pin.getFrameId("tool0")].homogeneous - ours).max() < 1e-9
        assert np.abs(matrix_of(tip_pose(arm, tuple(q.tolist()))) - ours).max() < 1e-9
        sim.qpos[address] = q
        mujoco.mj_kinematics(model, sim)
        assert np.abs(sim.body("a/tool0").xpos - ours[:3, 3]).max() < 1e-9


@pytest.mark.parametrize("make", ARMS)
def test_no_point_travels_further_than_its_radii_allow(make: object) -> None:
    assert callable(make)
    arm: Description = make()
    proof = ProofScenes().of(scene_of(arm, (0.0,) * len(arm.movable_joints)))
    layout, chain = proof.layout, chain_of(arm)
    start = postures(arm, 1500)
    change = np.random.default_rng(2).uniform(-0.3, 0.3, start.shape)
    rows = layout.rows_of[A]
    before, after = (proof.placed(A, q).in_every_posture(rows) for q in (start, start + change))
    rails = int(chain.is_prismatic.sum())
    for k, row in enumerate(rows):
        part = layout.parts[row]
        points = np.concatenate((part.vertices_m.T, np.ones((1, len(part.vertices_m)))))
        travel = np.linalg.norm(((after[:, k] - before[:, k]) @ points)[:, :3], axis=1).max(axis=1)
        joint = layout.joints_of[A][k]
        carried = CarriedPart(part=part, joint=joint, joint_T_part=layout.joint_T_part_of[A][k])
        radii = swing_radii(chain, carried)
        assert (travel <= np.abs(change) @ radii + 1e-12).all()
        if joint >= rails:
            assert radii[:rails].tolist() == [1.0] * rails, "a metre of rail is a metre of travel"


def test_a_path_along_the_rail_is_certified_until_something_stands_in_the_way() -> None:
    certifier = make_backends().certifier
    scene = scene_of(track(), HOME)
    path = JointPath(robot=A, segments=(PathSegment(waypoints_rad=(HOME, (1.8, *HOME[1:]))),))
    proven = certifier.certify(scene, path)
    assert isinstance(proven, Certificate)
    tip = (scene.robots[A].world_T_base @ tip_pose(track(), (1.0, *HOME[1:]))).position_m
    for number in range(20):
        x, y, z = tip
        at = translation(x, y + 0.031 * number, z - 0.1)
        refused = certifier.certify(scene.with_body(box("fin", (0.3, 0.001, 0.3), at)), path)
        assert isinstance(refused, NotClear)
        assert "fin" in refused.pair


def test_search_timing_and_second_opinion_take_a_rail() -> None:
    backends, arm = make_backends(), track()
    goal: Joints = (1.7, 1.2, -1.5, 1.6, 0.4, 0.9, 0.2)
    wall = box("wall", (2.2, 0.1, 0.8), translation(2.4, 1.0, 0.9))
    scene = scene_of(arm, HOME).with_body(wall)
    found = plan_free_motion(backends, scene, A, goal, {}, seed=0)
    assert isinstance(found, PathSegment), found
    path = JointPath(robot=A, segments=(found,))
    assert isinstance(backends.certifier.certify(scene, path), Certificate)
    speeds = tuple(j.velocity_rad_s for j in arm.movable_joints)
    accelerations = (2.0, *(2.0 * v for v in speeds[1:]))
    limits = JointLimits(
        velocity_rad_s=speeds,
        acceleration_rad_s2=accelerations,
        jerk_rad_s3=tuple(10.0 * a for a in accelerations),
    )
    timed = backends.timer.time(path, limits)
    step_s = timed.trajectory.duration_s / 2000
    rows = [timed.trajectory.at(k * step_s)[0] for k in range(2001)]
    fastest = np.abs(np.diff(np.array(rows), axis=0)).max(axis=0) / step_s
    assert (fastest <= np.array(speeds) * 1.001).all()
    assert isinstance(backends.cross_check.check(scene, timed), Agreement)
    assert all(len(a) == len(b) == 7 for a, b in pairwise(found.waypoints_rad))


def test_postures_on_a_long_track_are_found_wherever_the_rail_would_have_to_be() -> None:
    """From its far end an arm finds what it reached somewhere along 30 m."""
    long = on_rails(kr120(), [replace(rail((0.0, 1.0, 0.0)), travel_m=(-15.0, 15.0))], Pose())
    kinematics, places = make_backends().kinematics, list[int]()
    for q in postures(long, 60, seed=4):
        wanted = tip_pose(long, tuple(q.tolist()))
        found = kinematics.solve(long, wanted, (-15.0, *HOME[1:]))
        assert not isinstance(found, NoIk)
        rails_m = {round(f[0], 6) for f in found}
        places.append(len(rails_m))
        assert all(abs(at_m - q[0]) < 6.0 for at_m in rails_m)
        assert max(tip_pose(long, f).distance_to_m(wanted) for f in found) < 1e-6
    assert sorted(places)[len(places) // 2] > 4, "a wrist is within reach from several places"
