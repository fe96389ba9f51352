"""Scenes of the case study's size for tests of the motion backends."""

from __future__ import annotations

import math
from functools import lru_cache

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.scene import Attachment, Body, RobotInScene, SceneSnapshot
from sitewright.planning_twin.straight import straight_line
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.formats.urdf import read_urdf
from sitewright.robot_team.gripper import finger_parts, palm_shape, shape_at
from sitewright.robot_team.kinematics import tip_pose
from sitewright.robot_team.models.catalogue import builtin_end_effector, builtin_robot

A = RobotId("a")
B = RobotId("b")
HOME: Joints = tuple(math.radians(v) for v in (0.0, -110.0, 110.0, 0.0, 80.0, 0.0))
STUD = (1.80, 0.09, 0.04)
SUPPORT = (2.40, 0.09, 0.14)
QUARTER = rotation((0.0, 0.0, 1.0), math.pi / 2.0)
TABLE_TOP_M = 0.40


@lru_cache(maxsize=1)
def kr120() -> Description:
    return read_urdf(builtin_robot("kuka-kr120-r2500-pro"))


@lru_cache(maxsize=4)
def tool(name: str) -> Description:
    return read_urdf(builtin_end_effector(name))


def box(name: str, size: tuple[float, float, float], placement: Pose | Attachment) -> Body:
    return Body(id=BodyId(name), shape=(Box(size),), placement=placement)


def one_arm(*bodies: Body, clearance_m: float = 0.010, q_rad: Joints = HOME) -> SceneSnapshot:
    """One arm at the origin and some bodies."""
    arm = RobotInScene(description=kr120(), world_T_base=Pose(), q_rad=q_rad)
    return SceneSnapshot(robots={A: arm}, bodies={b.id: b for b in bodies}, clearance_m=clearance_m)


def gripper(robot: RobotId, aperture_m: float = 0.12) -> list[Body]:
    description = tool("builtin:parallel-gripper")
    held = Attachment(robot, Pose())
    fingers = finger_parts(description, aperture_m).items()
    return [
        Body(id=BodyId("gripper"), shape=palm_shape(description), placement=held),
        *(Body(id=BodyId(f"gripper/{n}"), shape=s, placement=held) for n, s in fingers),
    ]


def nailer(robot: RobotId) -> Body:
    shape = shape_at(tool("builtin:nail-gun"), 0.0)
    return Body(id=BodyId("nailer"), shape=shape, placement=Attachment(robot, Pose()))


def two_arms(*more: Body, q_a: Joints = HOME, q_b: Joints = HOME) -> SceneSnapshot:
    """The case study's cell: table, supports, two placed studs, two stacks, two arms with tools."""
    lying = TABLE_TOP_M + 0.07
    on_top = TABLE_TOP_M + 0.14 + 0.02
    bodies = [
        box("table", (1.6, 2.6, TABLE_TOP_M), translation(0.0, 0.0, TABLE_TOP_M / 2.0)),
        box("support-1", SUPPORT, translation(-0.6, 0.0, lying) @ QUARTER),
        box("support-2", SUPPORT, translation(0.6, 0.0, lying) @ QUARTER),
        box("stud-1", STUD, translation(0.0, -0.8, on_top)),
        box("stud-2", STUD, translation(0.0, 0.0, on_top)),
        box("pedestal-1", (2.0, 0.3, 0.28), translation(-1.6, 1.55, 0.14)),
        box("pedestal-2", (2.0, 0.3, 0.28), translation(-1.6, -1.55, 0.14)),
        box("zone", (0.8, 0.8, 2.0), translation(0.0, 2.4, 1.0)),
        *(box(f"stock-{k}", STUD, translation(-1.6, 1.55, 0.30 + 0.04 * k)) for k in range(4)),
        *(box(f"spare-{k}", STUD, translation(-1.6, -1.55, 0.30 + 0.04 * k)) for k in range(3)),
        *gripper(A),
        nailer(B),
        *more,
    ]
    arms = {
        A: RobotInScene(description=kr120(), world_T_base=translation(-1.6, 0.0, 0.0), q_rad=q_a),
        B: RobotInScene(
            description=kr120(),
            world_T_base=translation(1.6, 0.0, 0.0) @ rotation((0.0, 0.0, 1.0), math.pi),
            q_rad=q_b,
        ),
    }
    return SceneSnapshot(robots=arms, bodies={b.id: b for b in bodies})


def held_stud(robot: RobotId = A) -> Body:
    """A stud held across the gripper at its middle."""
    tip_T_stud = translation(0.0, 0.0, 0.24) @ QUARTER
    return box("held", STUD, Attachment(robot, tip_T_stud))


def lowering(by_m: float) -> tuple[SceneSnapshot, tuple[Joints, ...], tuple[Joints, ...]]:
    """A held stud that is set down on a table: the scene, the way to 3 cm above, the last 3 cm."""
    scene = one_arm(held_stud())
    tip = tip_pose(kr120(), HOME)
    level = Pose.from_z_axis(tip.position_m, (0.0, 0.0, -1.0), tip.x_axis)
    down = translation(0.0, 0.0, -by_m) @ level
    near = translation(0.0, 0.0, 0.03) @ down
    kinematics = OpwKinematics()
    approach = straight_line(kinematics, scene.robots[A], level, near, HOME)
    assert isinstance(approach, tuple)
    last = straight_line(kinematics, scene.robots[A], near, down, approach[-1])
    assert isinstance(last, tuple)
    top_m = down.apply((0.0, 0.0, 0.24 + STUD[2] / 2.0))[2]
    table = box("table", (1.0, 2.0, 0.2), translation(1.4, 0.0, top_m - 0.1))
    return scene.with_body(table), approach, last
