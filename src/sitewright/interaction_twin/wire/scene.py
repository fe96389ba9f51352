"""The scene document: everything that is drawn."""

from __future__ import annotations

from typing import Literal

from typing_extensions import TypedDict

from sitewright.interaction_twin.wire.basics import Layer, Pose, Triangle, Vec3


class Geometry(TypedDict):
    corners_m: list[Vec3]
    triangles: list[Triangle]


class LinkRecord(TypedDict):
    name: str
    geometry: str | None


class JointRecord(TypedDict):
    name: str
    kind: Literal["revolute", "prismatic", "fixed"]
    parent: str
    child: str
    parent_T_joint: Pose
    axis: Vec3
    lower_rad: float
    upper_rad: float
    velocity_rad_s: float


class Description(TypedDict):
    """Links with their shapes, joints from the root outwards: what certificates are about."""

    root: str
    tip: str
    links: list[LinkRecord]
    joints: list[JointRecord]


class RobotRecord(TypedDict):
    id: str
    name: str
    number: int
    world_T_base: Pose
    description: Description
    mounted: str | None
    q_rad: list[float]
    gripped: str | None


class EndEffectorRecord(TypedDict):
    id: str
    name: str
    kind: str
    description: Description
    opens_to_m: float
    q: list[float]
    on: str | None
    world_T_mount: Pose | None


class BodyRecord(TypedDict):
    id: str
    name: str
    geometry: str | None
    world_T: Pose


class ZoneRecord(BodyRecord):
    """A keep-out zone; `by` is the cell, or who drew it."""

    by: str


class StationRecord(TypedDict):
    id: str
    name: str
    kind: str
    robot: str | None
    world_T: Pose


class StockPlaceRecord(TypedDict):
    id: str
    name: str
    world_T: Pose


class OperationRecord(TypedDict):
    id: str
    name: str
    process: str
    done: bool


class Deviation(TypedDict):
    mm: float
    deg: float
    words: str


class ComponentRecord(TypedDict):
    id: str
    name: str
    layer: Layer
    status: str
    type: str
    material: str
    group: str
    order: int | None
    geometry: str | None
    world_T: Pose | None
    parents: list[str]
    waits_for: list[str]
    accessible: bool
    operations: list[OperationRecord]
    made_of: str | None
    stack: str | None
    deviation: Deviation | None
    note: str


class FrameJoint(TypedDict):
    of: str
    joint: str


class Scene(TypedDict):
    """All that is drawn; `joints` is the order of the binary frames."""

    schema: Literal["sitewright.page-scene/1"]
    hash: str
    epoch: int
    project: str
    run: str
    is_simulation: bool
    ground_z_m: float
    clearance_m: float
    geometries: dict[str, Geometry]
    robots: list[RobotRecord]
    end_effectors: list[EndEffectorRecord]
    joints: list[FrameJoint]
    components: list[ComponentRecord]
    zones: list[ZoneRecord]
    fixtures: list[BodyRecord]
    stations: list[StationRecord]
    stock_places: list[StockPlaceRecord]
