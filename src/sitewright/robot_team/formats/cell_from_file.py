"""From the keys of `cell.toml` to the cell, robots and end effectors with their models."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

from sitewright.errors import CellRejectedError, Problem, TeamError
from sitewright.foundation.ids import (
    EndEffectorId,
    FixtureId,
    RobotId,
    StationId,
    StockPlaceId,
    ZoneId,
)
from sitewright.foundation.pose import Pose, unit
from sitewright.foundation.shapes import Box, ConvexPart, Hull, Shape
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
    StockPlace,
    Zone,
)
from sitewright.robot_team.description import Description, JointKind
from sitewright.robot_team.formats.cell_check import problem
from sitewright.robot_team.formats.cell_file import (
    BoxFile,
    CellFile,
    ConvexFile,
    EndEffectorFile,
    GeometryFile,
    PoseFile,
    RailFile,
    RobotFile,
    SolidFile,
    StationFile,
)
from sitewright.robot_team.formats.posture_file import joint_values, posture_faults
from sitewright.robot_team.formats.urdf import read_urdf
from sitewright.robot_team.kinematics import tip_pose
from sitewright.robot_team.models.catalogue import builtin_end_effector, builtin_robot
from sitewright.robot_team.rails import Rail, on_rails
from sitewright.robot_team.waiting import rails_of

_ALWAYS = frozenset({Capability.RETRACTING, Capability.RELEASING})
_HANDLING = frozenset({Capability.GRASPING, Capability.POSITIONING})
_FINISHING = frozenset({Capability.FASTENING, Capability.FINISHING})
DEFAULT_CAN = {
    RobotSubtype.HANDLER: _HANDLING,
    RobotSubtype.FINISHER: _FINISHING,
    RobotSubtype.ALL_ROUNDER: _HANDLING | _FINISHING | {Capability.TOOL_CHANGING},
}
"""What a robot can do when the cell does not say; every robot can retract and release."""
_ACCELERATION_PER_SPEED = 2.0
"""Default acceleration limit: this times the largest speed, per second (our assumption)."""


_FINGERS = 2


class CellBuilder:
    """Builds one cell and collects what is wrong with its models."""

    def __init__(self, file: CellFile, folder: Path) -> None:
        self._file, self._folder = file, folder
        self._read: dict[Path, Description] = {}
        self.problems: list[Problem] = []

    def build(self) -> Cell | None:
        """Return the cell; None if a model could not be read or does not fit."""
        robots = [self._robot(r) for r in self._file.robot]
        tools = [self._end_effector(e) for e in self._file.end_effector]
        if self.problems:
            return None
        known = {r.id: r for r in robots if r is not None}
        stations = [s for f in self._file.station if (s := _station(f, known)) is not None]
        prepared = {s.robot for s in stations if s.kind is StationKind.PREPARATION}
        stations += [_preparation(r) for r in known.values() if r.id not in prepared]
        return Cell(
            robot_by_id=known,
            end_effector_by_id={t.id: t for t in tools if t is not None},
            station_by_id={s.id: s for s in stations},
            stock_place_by_id={
                StockPlaceId(s.id): StockPlace(
                    id=StockPlaceId(s.id), world_T_stock=_pose(s.world_T_stock)
                )
                for s in self._file.stock_place
            },
            fixture_by_id={
                FixtureId(f.id): Fixture(
                    id=FixtureId(f.id),
                    shape=_shape(f.geometry),
                    world_T_fixture=_pose(f.world_T_fixture),
                )
                for f in self._file.fixture
            },
            zone_by_id={
                ZoneId(z.id): Zone(
                    id=ZoneId(z.id), shape=_shape(z.geometry), world_T_zone=_pose(z.world_T_zone)
                )
                for z in self._file.zone
            },
            world_T_model=_pose(self._file.site.world_T_model),
            clearance_m=self._file.site.clearance_m,
            simulation=dict(sorted(self._file.simulation.items())),
            name_by_id=_names(self._file),
        )

    def _robot(self, file: RobotFile) -> Robot | None:
        where = f"robot[{file.id}]"
        description = self._description(file.model, file.urdf, where, file.payload_kg)
        if description is None:
            return None
        if file.rail:
            rails = [_rail(r) for r in file.rail]
            try:
                description = on_rails(description, rails, _pose(file.carriage_T_base))
            except TeamError as error:
                self.problems.append(problem("L2", where, f"{error}", "Change one of the two."))
                return None
        if description.payload_kg <= 0.0:
            fix = "State payload_kg."
            self.problems.append(problem("L2", where, "Its payload is not known.", fix))
        robot = _arm(file, description)
        self._check_postures(where, description, robot)
        return robot

    def _check_postures(self, where: str, description: Description, robot: Robot) -> None:
        rows = [("home_q", robot.home_q_rad), *(("parking_q", q) for q in robot.parking_q_rad)]
        for name, q in rows:
            for message, fix in posture_faults(description, name, q):
                self.problems.append(problem("L2", where, message, fix))
        if robot.waits_along_rails and not rails_of(description):
            message, fix = "waits_along_rails is set, and it has no rails.", "Leave it out."
            self.problems.append(problem("L2", where, message, fix))
        limits, joints = robot.max_acceleration_rad_s2, description.movable_joints
        if len(limits) != len(joints):
            message = f"max_acceleration has {len(limits)} values for {len(joints)} joints."
            self.problems.append(problem("L2", where, message, "State one per joint."))

    def _end_effector(self, file: EndEffectorFile) -> EndEffector | None:
        where = f"end_effector[{file.id}]"
        description = self._description(None, file.urdf, where, None)
        if description is None:
            return None
        if file.kind is EndEffectorKind.GRIPPER:
            self._check_fingers(file, description)
        return EndEffector(
            id=EndEffectorId(file.id),
            kind=file.kind,
            description=description,
            station=None if file.station is None else StationId(file.station),
            station_T_mount=_pose(file.station_T_mount),
            grips_m=file.grips_m,
            opens_to_m=file.opens_to_m,
            processes=tuple(file.processes),
            fasteners=tuple(
                FastenerRange(type=f.type, d_m=f.d_m, l_min_m=f.l_m[0], l_max_m=f.l_m[1])
                for f in file.fasteners
            ),
            max_tilt_rad=math.radians(file.max_tilt_deg or 0.0) or file.max_tilt_rad or 0.0,
            nose_half_width_m=file.nose_half_width_m,
        )

    def _check_fingers(self, file: EndEffectorFile, description: Description) -> None:
        fingers = [j for j in description.movable_joints if j.kind is JointKind.PRISMATIC]
        travel_m = sum(j.upper_rad for j in fingers)
        if len(fingers) != _FINGERS or travel_m < file.opens_to_m - 1e-6:
            message = f"It opens to {file.opens_to_m:g} m, its fingers travel {travel_m:g} m."
            where = f"end_effector[{file.id}]"
            self.problems.append(problem("L2", where, message, "Correct opens_to_m or the URDF."))

    def _description(
        self, model: str | None, urdf: str | None, where: str, payload_kg: float | None
    ) -> Description | None:
        try:
            path = self._path(model, urdf)
            if payload_kg is not None:
                return read_urdf(path, payload_kg=payload_kg)
            if path not in self._read:
                self._read[path] = read_urdf(path)
            return self._read[path]
        except CellRejectedError as error:
            self.problems += [replace(p, where=f"{where}: {p.where}") for p in error.problems]
        except (TeamError, OSError) as error:
            fix = "Correct the name or the path."
            self.problems.append(problem("L3", where, f"{error}", fix))
        return None

    def _path(self, model: str | None, urdf: str | None) -> Path:
        if model is not None:
            return builtin_robot(model)
        if urdf is not None and urdf.startswith("builtin:"):
            return builtin_end_effector(urdf)
        return self._folder / (urdf or "")


def _arm(file: RobotFile, description: Description) -> Robot:
    home = joint_values(description, file.home_q_deg, file.home_q_rad)
    in_deg, in_rad = file.parking_q_deg or (), file.parking_q_rad or ()
    parking = [joint_values(description, q, None) for q in in_deg]
    parking += [joint_values(description, None, q) for q in in_rad]
    acceleration = joint_values(
        description, file.max_acceleration_deg_s2, file.max_acceleration_rad_s2
    ) or tuple(_ACCELERATION_PER_SPEED * j.velocity_rad_s for j in description.movable_joints)
    can = DEFAULT_CAN[file.subtype] if file.can is None else frozenset(file.can)
    return Robot(
        id=RobotId(file.id),
        model=file.model or file.urdf or "",
        description=description,
        subtype=file.subtype,
        can=can | _ALWAYS,
        world_T_base=_pose(file.world_T_base),
        home_q_rad=home,
        parking_q_rad=tuple(parking) or (home,),
        max_acceleration_rad_s2=acceleration,
        end_effectors=tuple(EndEffectorId(e) for e in file.end_effectors),
        mounted=None if file.mounted is None else EndEffectorId(file.mounted),
        waits_along_rails=file.waits_along_rails,
    )


def _rail(file: RailFile) -> Rail:
    return Rail(
        axis=unit(file.axis),
        travel_m=file.travel_m,
        speed_m_s=file.speed_m_s,
        carriage=() if file.carriage is None else _shape(file.carriage),
        mass_kg=file.mass_kg,
    )


def _names(file: CellFile) -> dict[str, str]:
    named = (
        file.robot + file.end_effector + file.station + file.stock_place + file.fixture + file.zone
    )
    return {n.id: n.name for n in named if n.name}


def _station(file: StationFile, robots: dict[RobotId, Robot]) -> Station | None:
    robot = None if file.robot is None else robots.get(RobotId(file.robot))
    if file.robot is not None and robot is None:
        return None
    if file.world_T_station is None and robot is not None:
        return _preparation(robot, StationId(file.id))
    return Station(
        id=StationId(file.id),
        kind=file.kind,
        world_T_station=_pose(file.world_T_station),
        robot=None if robot is None else robot.id,
    )


def _preparation(robot: Robot, name: StationId | None = None) -> Station:
    """Return the station at a robot's home posture."""
    return Station(
        id=name or StationId(f"ready-{robot.id}"),
        kind=StationKind.PREPARATION,
        world_T_station=robot.world_T_base @ tip_pose(robot.description, robot.home_q_rad),
        robot=robot.id,
    )


def _pose(file: PoseFile | None) -> Pose:
    if file is None:
        return Pose()
    length = math.hypot(*file.q_wxyz) * (-1.0 if file.q_wxyz[0] < 0.0 else 1.0)
    w, x, y, z = (part / length for part in file.q_wxyz)
    return Pose(file.p_m, (w, x, y, z))


def _shape(file: GeometryFile) -> Shape:
    if file.compound is not None:
        return tuple(_part(p) for p in file.compound.parts)
    return (_solid(file.box, file.convex, Pose()),)


def _part(file: SolidFile) -> ConvexPart:
    return _solid(file.box, file.convex, _pose(file.body_T_part))


def _solid(box: BoxFile | None, convex: ConvexFile | None, body_T_part: Pose) -> ConvexPart:
    if box is not None:
        return Box(box.size_m, body_T_part)
    points = convex.points_m if convex is not None else []
    return Hull(tuple(body_T_part.apply(p) for p in points))
