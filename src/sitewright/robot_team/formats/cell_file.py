"""The shape of `cell.toml`, key by key (schema ``sitewright.cell/1``)."""

from __future__ import annotations

import math
from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from sitewright.robot_team.cell import Capability, EndEffectorKind, RobotSubtype, StationKind

SCHEMA = "sitewright.cell/1"

_UNIT_TOLERANCE = 1e-3

Id = Annotated[str, Field(pattern=r"^[A-Za-z0-9_$.\-]{1,64}$")]
Coordinate = Annotated[float, Field(ge=-1e5, le=1e5)]
Length = Annotated[float, Field(gt=0, le=1e3)]
Positive = Annotated[float, Field(gt=0)]
Point = tuple[Coordinate, Coordinate, Coordinate]


class FileModel(BaseModel):
    """Strict: no unknown key, no NaN, no text for a number."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)


class NamedFile(FileModel):
    """Anything of the cell that has an id; people read its `name` where it has one."""

    id: Id
    name: Annotated[str, Field(max_length=60)] = ""


class PoseFile(FileModel):
    """A rigid transform: turn, then shift."""

    p_m: Point = (0.0, 0.0, 0.0)
    q_wxyz: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)

    @model_validator(mode="after")
    def _is_unit(self) -> Self:
        length = math.hypot(*self.q_wxyz)
        if abs(length - 1.0) > _UNIT_TOLERANCE:
            raise ValueError(f"the quaternion has length {length:.4f}, not 1")
        return self


class BoxFile(FileModel):
    """A box centred on its frame."""

    size_m: tuple[Length, Length, Length]


class ConvexFile(FileModel):
    """The convex hull of points."""

    points_m: list[Point] = Field(min_length=4)


class SolidFile(FileModel):
    """One convex solid, placed in the frame of its body; exactly one of box and convex."""

    box: BoxFile | None = None
    convex: ConvexFile | None = None
    body_T_part: PoseFile = PoseFile()

    @model_validator(mode="after")
    def _is_one(self) -> Self:
        if (self.box is None) == (self.convex is None):
            raise ValueError("state either box or convex")
        return self


class CompoundFile(FileModel):
    """Several solids that are one body."""

    parts: list[SolidFile] = Field(min_length=1)


class GeometryFile(FileModel):
    """The shape of a fixture or zone; exactly one of the keys."""

    box: BoxFile | None = None
    convex: ConvexFile | None = None
    compound: CompoundFile | None = None

    @model_validator(mode="after")
    def _is_one(self) -> Self:
        if sum(g is not None for g in (self.box, self.convex, self.compound)) != 1:
            raise ValueError("state exactly one kind of geometry")
        return self


class SiteFile(FileModel):
    """Where the building model stands in the cell, and the distance that motions keep."""

    world_T_model: PoseFile = PoseFile()
    clearance_m: Annotated[float, Field(gt=0, le=0.2)] = 0.010


class FixtureFile(NamedFile):
    """A table, pedestal or wall."""

    geometry: GeometryFile
    world_T_fixture: PoseFile = PoseFile()


class ZoneFile(NamedFile):
    """A volume that robots and pieces stay out of."""

    geometry: GeometryFile
    world_T_zone: PoseFile = PoseFile()


class RailFile(FileModel):
    """A rail of a track or gantry under an arm; the shape of its carriage is in its own frame."""

    axis: Point
    travel_m: tuple[Coordinate, Coordinate]
    speed_m_s: Positive
    carriage: GeometryFile | None = None
    mass_kg: Positive = 400.0

    @model_validator(mode="after")
    def _leads_somewhere(self) -> Self:
        if math.hypot(*self.axis) == 0.0:
            raise ValueError("the axis has no direction")
        if not self.travel_m[0] < self.travel_m[1]:
            raise ValueError("travel_m must rise")
        return self


class RobotFile(NamedFile):
    """One arm: a built-in `model` or an own `urdf`; joint values in degrees or in radians.

    Sliding joints, rails among them, have their values in metres in both kinds of list.
    """

    model: str | None = None
    urdf: str | None = None
    payload_kg: Positive | None = None
    rail: list[RailFile] = Field(default=[], max_length=3)
    carriage_T_base: PoseFile | None = None
    subtype: RobotSubtype
    can: list[Capability] | None = None
    world_T_base: PoseFile
    home_q_deg: list[float] | None = None
    home_q_rad: list[float] | None = None
    parking_q_deg: list[list[float]] | None = None
    parking_q_rad: list[list[float]] | None = None
    waits_along_rails: bool = False
    max_acceleration_deg_s2: list[Positive] | None = None
    max_acceleration_rad_s2: list[Positive] | None = None
    end_effectors: list[Id] = []
    mounted: Id | None = None

    @model_validator(mode="after")
    def _has_one_of_each(self) -> Self:
        if (self.model is None) == (self.urdf is None):
            raise ValueError("state either model (built in) or urdf (a path)")
        if (self.home_q_deg is None) == (self.home_q_rad is None):
            raise ValueError("state either home_q_deg or home_q_rad")
        if None not in (self.parking_q_deg, self.parking_q_rad):
            raise ValueError("state either parking_q_deg or parking_q_rad")
        if None not in (self.max_acceleration_deg_s2, self.max_acceleration_rad_s2):
            raise ValueError("state accelerations in one unit")
        if self.carriage_T_base is not None and not self.rail:
            raise ValueError("carriage_T_base needs a rail")
        return self


class FastenerFile(FileModel):
    """Fasteners that a tool drives: one diameter, a range of lengths."""

    type: str
    d_m: Length
    l_m: tuple[Length, Length]

    @model_validator(mode="after")
    def _rises(self) -> Self:
        if self.l_m[0] > self.l_m[1]:
            raise ValueError("the range of lengths must rise")
        return self


class EndEffectorFile(NamedFile):
    """A gripper or a tool: `urdf` is a path or ``builtin:<name>``."""

    kind: EndEffectorKind
    urdf: str
    station: Id | None = None
    station_T_mount: PoseFile | None = None
    grips_m: tuple[Length, Length] | None = None
    opens_to_m: Annotated[float, Field(ge=0, le=10)] = 0.0
    processes: list[str] = []
    fasteners: list[FastenerFile] = []
    max_tilt_deg: Annotated[float, Field(ge=0, le=90)] | None = None
    max_tilt_rad: Annotated[float, Field(ge=0, le=math.pi / 2)] | None = None
    nose_half_width_m: Annotated[float, Field(ge=0, le=1)] = 0.0

    @model_validator(mode="after")
    def _fits_its_kind(self) -> Self:
        if self.kind is EndEffectorKind.GRIPPER and (self.grips_m is None or not self.opens_to_m):
            raise ValueError("a gripper states grips_m and opens_to_m")
        if self.grips_m and not self.grips_m[0] <= self.grips_m[1] <= self.opens_to_m:
            raise ValueError("grips_m must rise and stay within opens_to_m")
        if None not in (self.max_tilt_deg, self.max_tilt_rad):
            raise ValueError("state either max_tilt_deg or max_tilt_rad")
        return self


class StationFile(NamedFile):
    """A named place; a preparation station without a pose stands at its robot's home."""

    kind: StationKind
    robot: Id | None = None
    world_T_station: PoseFile | None = None

    @model_validator(mode="after")
    def _has_a_place(self) -> Self:
        is_preparation = self.kind is StationKind.PREPARATION
        if self.world_T_station is None and not is_preparation:
            raise ValueError(f"a {self.kind.value} station states world_T_station")
        if is_preparation and self.robot is None:
            raise ValueError("a preparation station names its robot")
        return self


class StockPlaceFile(NamedFile):
    """Where a stack of the building model stands: its surface, z up."""

    world_T_stock: PoseFile


class CellFile(FileModel):
    """A whole cell."""

    schema_: Literal["sitewright.cell/1"] = Field(alias="schema")
    name: str = ""
    site: SiteFile = SiteFile()
    fixture: list[FixtureFile] = []
    robot: list[RobotFile] = Field(min_length=1)
    end_effector: list[EndEffectorFile] = []
    station: list[StationFile] = []
    stock_place: list[StockPlaceFile] = []
    zone: list[ZoneFile] = []
    simulation: dict[str, float] = {}
