"""A small cell for tests of the simulation: a handler, a nailer, two supports and a stack."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from itertools import pairwise
from typing import Any

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import (
    CommandId,
    ComponentId,
    EndEffectorId,
    FixtureId,
    RobotId,
    StationId,
)
from sitewright.foundation.pose import Pose, from_axis_angle, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.robot_team.cell import (
    Capability,
    Cell,
    EndEffector,
    EndEffectorKind,
    FastenerRange,
    Fixture,
    Robot,
    RobotSubtype,
    Station,
    StationKind,
)
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.formats.urdf import read_urdf
from sitewright.robot_team.gripper import mount_T_tcp
from sitewright.robot_team.kinematics import tip_pose
from sitewright.robot_team.models.catalogue import builtin_end_effector, builtin_robot
from sitewright.robot_team.piece import Piece
from sitewright.robot_team.skill import SkillCommand
from sitewright.robot_team.trajectory import Trajectory

A, B = RobotId("kr120-a"), RobotId("kr120-b")
GRIPPER, NAILER, PAINTER = (EndEffectorId(n) for n in ("gripper-s", "nail-gun", "paint-head"))
HOME: Joints = tuple(math.radians(v) for v in (0, -110, 110, 0, 80, 0))
DOWN = Pose(quaternion_wxyz=(0.0, 1.0, 0.0, 0.0))
"""Tool z straight down, tool x along the world's x."""
TURN_90 = rotation((0.0, 0.0, 1.0), math.pi / 2)
TABLE_TOP_M = 0.40
STACK_TOP_M = 0.30
THIN = (1.80, 0.09, 0.04)
THICK = (2.40, 0.09, 0.14)
TARGET = translation(0.0, 0.0, TABLE_TOP_M + THICK[2] + THIN[2] / 2)
"""Where a thin stud lies across both supports."""


@cache
def arm() -> Description:
    return read_urdf(builtin_robot("kuka-kr120-r2500-pro"))


@cache
def tool(name: str) -> Description:
    return read_urdf(builtin_end_effector(f"builtin:{name}"))


def robot(robot_id: RobotId, base: Pose, *mounted: EndEffectorId) -> Robot:
    return Robot(
        id=robot_id,
        model="kuka-kr120-r2500-pro",
        description=arm(),
        subtype=RobotSubtype.ALL_ROUNDER,
        can=frozenset(Capability),
        world_T_base=base,
        home_q_rad=HOME,
        parking_q_rad=(),
        max_acceleration_rad_s2=(5.4, 5.4, 5.4, 11.5, 11.5, 21.4),
        end_effectors=mounted,
        mounted=mounted[0],
    )


def cell(**simulation: float) -> Cell:
    tools = (
        EndEffector(
            id=GRIPPER,
            kind=EndEffectorKind.GRIPPER,
            description=tool("parallel-gripper"),
            station=None,
            grips_m=(0.03, 0.14),
            opens_to_m=0.17,
        ),
        EndEffector(
            id=NAILER,
            kind=EndEffectorKind.TOOL,
            description=tool("nail-gun"),
            station=StationId("tools-b"),
            station_T_mount=Pose((-0.3, 0.0, 0.0), DOWN.quaternion_wxyz),
            processes=("nail",),
            fasteners=(FastenerRange(type="nail", d_m=0.0031, l_min_m=0.05, l_max_m=0.09),),
        ),
        EndEffector(
            id=PAINTER,
            kind=EndEffectorKind.TOOL,
            description=tool("paint-head"),
            station=StationId("tools-b"),
            station_T_mount=Pose((0.3, 0.0, 0.0), DOWN.quaternion_wxyz),
            processes=("paint",),
        ),
    )
    boxes = {
        "assembly-table": ((1.50, 2.60, 0.42), translation(0.0, 0.0, 0.19)),
        "pallet": ((2.00, 0.30, 0.32), translation(-1.6, -1.55, 0.14)),
    }
    station = Station(
        id=StationId("tools-b"), kind=StationKind.TOOL, world_T_station=translation(2.3, 1.5, 0.9)
    )
    return Cell(
        robot_by_id={
            A: robot(A, translation(-1.6, 0.0, 0.0), GRIPPER),
            B: robot(
                B, Pose((1.6, 0.0, 0.0), from_axis_angle((0, 0, 1), math.pi)), NAILER, PAINTER
            ),
        },
        end_effector_by_id={t.id: t for t in tools},
        station_by_id={station.id: station},
        fixture_by_id={
            FixtureId(name): Fixture(id=FixtureId(name), shape=(Box(size),), world_T_fixture=pose)
            for name, (size, pose) in boxes.items()
        },
        simulation=simulation,
    )


def piece(name: str, size: tuple[float, float, float], pose: Pose) -> Piece:
    volume = size[0] * size[1] * size[2]
    return Piece(
        id=ComponentId(name), shape=(Box(size),), world_T_piece=pose, mass_kg=480.0 * volume
    )


def pieces() -> tuple[Piece, ...]:
    """Two supports on the table, and a stack of four thin studs on the pallet."""
    high = TABLE_TOP_M + THICK[2] / 2
    supports = [
        piece(name, THICK, Pose((x, 0.0, high), TURN_90.quaternion_wxyz))
        for name, x in (("support-1", -0.6), ("support-2", 0.6))
    ]
    stack = [
        piece(f"thin-{k}", THIN, translation(-1.6, -1.55, STACK_TOP_M + (k - 0.5) * THIN[2]))
        for k in range(1, 5)
    ]
    return (*supports, *stack)


class Mover:
    """Plans without looking: straight lines in joint space between tip poses."""

    def __init__(self, site: Cell) -> None:
        self.site = site
        self.q: dict[RobotId, Joints] = dict.fromkeys(site.robot_by_id, HOME)
        self.kinematics = OpwKinematics()

    def to_tcp(
        self, robot_id: RobotId, end_effector: EndEffectorId | None, *world_T_tcp: Pose
    ) -> Trajectory:
        """Return a motion of the end effector's tcp through some poses, each a rest."""
        base_T_world = self.site.robot_by_id[robot_id].world_T_base.inverse()
        tcp_T_tip = Pose()
        if end_effector is not None:
            description = self.site.end_effector_by_id[end_effector].description
            tcp_T_tip = mount_T_tcp(description).inverse()
        ways = []
        near = self.q[robot_id]
        for pose in world_T_tcp:
            solutions = self.kinematics.solve(arm(), base_T_world @ pose @ tcp_T_tip, near)
            assert isinstance(solutions, tuple), f"{robot_id} does not reach {pose}"
            near = solutions[0]
            ways.append(near)
        return self.through(robot_id, *ways)

    def through(self, robot_id: RobotId, *ways: Joints) -> Trajectory:
        """Return a motion through some postures."""
        trajectory = lines(self.site.robot_by_id[robot_id], (self.q[robot_id], *ways))
        self.q[robot_id] = trajectory.end_rad
        return trajectory

    def tip(self, robot_id: RobotId) -> Pose:
        """Return the world pose of the flange where the last motion ends."""
        base = self.site.robot_by_id[robot_id].world_T_base
        return base @ tip_pose(arm(), self.q[robot_id])


def lines(mover: Robot, ways: Iterable[Joints]) -> Trajectory:
    """Return a rest-to-rest motion along straight lines, each of four pieces of constant jerk."""
    stops = list(ways)
    times, rows = [0.0], []
    for start, end in pairwise(stops):
        way = [b - a for a, b in zip(start, end, strict=True)]
        quarter = _duration_s(mover, way) / 4.0
        jerk = 0.5 / quarter**3
        s = v = a = 0.0
        for j in (jerk, -jerk, -jerk, jerk):
            rows.append((start, way, s, v, a, j))
            times.append(times[-1] + quarter)
            s += quarter * (v + quarter * (a / 2 + quarter * j / 6))
            v += quarter * (a + quarter * j / 2)
            a += quarter * j
    rest = (0.0,) * len(stops[0])
    return Trajectory(
        robot=mover.id,
        times_s=tuple(times),
        positions_rad=(
            *(tuple(q + s * d for q, d in zip(q0, way, strict=True)) for q0, way, s, *_ in rows),
            stops[-1],
        ),
        velocities_rad_s=(*(tuple(v * d for d in way) for _, way, _, v, _, _ in rows), rest),
        accelerations_rad_s2=(*(tuple(a * d for d in way) for _, way, *_, a, _ in rows), rest),
        jerks_rad_s3=(*(tuple(j * d for d in way) for _, way, *_, j in rows), rest),
    )


def _duration_s(mover: Robot, way: list[float]) -> float:
    """The largest speed is 2 d / T, the largest acceleration 8 d / T^2."""
    limits = zip(way, mover.description.movable_joints, mover.max_acceleration_rad_s2, strict=True)
    return max(
        0.2,
        *(
            max(2 * abs(d) / joint.velocity_rad_s, math.sqrt(8 * abs(d) / acceleration))
            for d, joint, acceleration in limits
        ),
    )


_count = iter(range(1, 1_000_000))


def command(
    skill: str, robot_id: RobotId, *trajectories: Trajectory, epoch: int = 1, **params: Any
) -> SkillCommand:
    number = next(_count)
    return SkillCommand(
        command_id=CommandId(f"{number:06d}-{skill}"),
        epoch=epoch,
        skill=skill,
        robot=robot_id,
        trajectories=trajectories,
        params={k: pose_json(v) if isinstance(v, Pose) else v for k, v in params.items()},
    )


def pose_json(pose: Pose) -> Json:
    return {"p_m": list(pose.position_m), "q_wxyz": list(pose.quaternion_wxyz)}


def grasp_pose(world_T_piece: Pose) -> Pose:
    """Tcp over the middle of a thin stud that lies flat along the world's x."""
    above = translation(0.0, 0.0, 0.0) @ Pose(world_T_piece.position_m)
    return above @ DOWN


def over(pose: Pose, height_m: float) -> Pose:
    """Return the pose shifted up in the world."""
    return translation(0.0, 0.0, height_m) @ pose


def with_simulation(site: Cell, **simulation: float) -> Cell:
    return replace(site, simulation=simulation)
