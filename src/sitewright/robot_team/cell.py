"""The cell: robots, end effectors, stations, stock places, fixtures and zones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sitewright.foundation.ids import (
    EndEffectorId,
    FixtureId,
    RobotId,
    StationId,
    StockPlaceId,
    ZoneId,
)
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.robot_team.description import Description, Joints


class Capability(StrEnum):
    """What a robot can do with a fitting end effector; constants of the PDDL domain."""

    GRASPING = "grasping"
    POSITIONING = "positioning"
    RELEASING = "releasing"
    RETRACTING = "retracting"
    FASTENING = "fastening"
    FINISHING = "finishing"
    TOOL_CHANGING = "tool-changing"


class RobotSubtype(StrEnum):
    """PDDL subtypes of robot; each brings default capabilities."""

    HANDLER = "handler"
    FINISHER = "finisher"
    ALL_ROUNDER = "all-rounder"


@dataclass(frozen=True, slots=True, kw_only=True)
class Robot:
    """One arm at its place.

    Attributes:
        can: Capabilities; by default those of the subtype.
        home_q_rad: Posture at its preparation station.
        parking_q_rad: Postures out of the others' way, in order of preference.
        waits_along_rails: It may wait and park with its arm like that anywhere along its rails,
            beside the work, instead of driving to where home and parking postures have them.
        max_acceleration_rad_s2: Per joint; our assumption where the maker states none.
        end_effectors: Those that fit its tool changer.
        mounted: Start state; afterwards the journal knows. None is a bare flange.
    """

    id: RobotId
    model: str
    description: Description
    subtype: RobotSubtype
    can: frozenset[Capability]
    world_T_base: Pose
    home_q_rad: Joints
    parking_q_rad: tuple[Joints, ...]
    max_acceleration_rad_s2: Joints
    end_effectors: tuple[EndEffectorId, ...]
    mounted: EndEffectorId | None
    waits_along_rails: bool = False


class EndEffectorKind(StrEnum):
    """What an end effector is for."""

    GRIPPER = "gripper"
    TOOL = "tool"


@dataclass(frozen=True, slots=True, kw_only=True)
class FastenerRange:
    """The fasteners that a tool drives."""

    type: str
    d_m: float
    l_min_m: float
    l_max_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class EndEffector:
    """A gripper or a tool.

    Attributes:
        description: Root ``mount`` sits on the robot's tool0 frame; tip ``tcp``: z is the working
            direction; a gripper's two prismatic joints each run 0 (shut) .. opens_to_m / 2.
        grips_m: Smallest and largest width that it holds.
        opens_to_m: Largest opening.
        processes: Processes that a tool does.
        max_tilt_rad: How far a tool may lean from the operation's axis.
        nose_half_width_m: Half width of a flat tool tip; a tilted tip stands off by
            this times sin(tilt).
        station: Tool station where it docks.
        station_T_mount: Frame of its mount when docked, in the station's frame.
    """

    id: EndEffectorId
    kind: EndEffectorKind
    description: Description
    station: StationId | None
    station_T_mount: Pose = field(default_factory=Pose)
    grips_m: tuple[float, float] | None = None
    opens_to_m: float = 0.0
    processes: tuple[str, ...] = ()
    fasteners: tuple[FastenerRange, ...] = ()
    max_tilt_rad: float = 0.0
    nose_half_width_m: float = 0.0


class StationKind(StrEnum):
    """What a station is for."""

    PREPARATION = "preparation"
    TOOL = "tool"
    BUFFER = "buffer"


@dataclass(frozen=True, slots=True, kw_only=True)
class Station:
    """A named place: where a robot waits, docks tools or sets pieces down.

    Attributes:
        robot: The robot that uses it; None = all.
        world_T_station: For a buffer: centre of the surface that a piece is set down on.
    """

    id: StationId
    kind: StationKind
    world_T_station: Pose
    robot: RobotId | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class StockPlace:
    """Where a stack of the building model stands (its surface, z up)."""

    id: StockPlaceId
    world_T_stock: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class Fixture:
    """A table, pedestal or wall: collides, carries pieces, is never a target."""

    id: FixtureId
    shape: Shape
    world_T_fixture: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class Zone:
    """A volume that robots and pieces stay out of; it has no body."""

    id: ZoneId
    shape: Shape
    world_T_zone: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class Cell:
    """Everything of the cell that does not change during a run.

    Attributes:
        world_T_model: Places the building model in the cell: its site, and how the model lies
            there.
        clearance_m: Distance that every certified motion keeps.
        simulation: Settings of the simulated cell (``seed`` and noise; off unless asked for).
        name_by_id: What people read in place of the id of a robot, end effector, station, stock
            place, fixture or zone; only of those that have a name.
    """

    robot_by_id: Mapping[RobotId, Robot]
    end_effector_by_id: Mapping[EndEffectorId, EndEffector]
    station_by_id: Mapping[StationId, Station] = field(default_factory=dict)
    stock_place_by_id: Mapping[StockPlaceId, StockPlace] = field(default_factory=dict)
    fixture_by_id: Mapping[FixtureId, Fixture] = field(default_factory=dict)
    zone_by_id: Mapping[ZoneId, Zone] = field(default_factory=dict)
    world_T_model: Pose = field(default_factory=Pose)
    clearance_m: float = 0.010
    simulation: Mapping[str, float] = field(default_factory=dict)
    name_by_id: Mapping[str, str] = field(default_factory=dict)
