"""Components of the building, and the operations that secure or finish them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose, Vector


class Layer(StrEnum):
    """The paper's layers: what role a component plays on the site."""

    TARGET = "target"
    """Still to be built, at its final pose."""
    MATERIAL = "material"
    """A piece of stock that lies on the site."""
    AS_BUILT = "as_built"
    """Installed by the team, or existing before."""
    AS_DESIGNED = "as_designed"
    """Drawn only; neither built nor in the way."""
    VIRTUAL_COLLISION = "virtual_collision"
    """A volume that robots and pieces must stay out of."""


class Origin(StrEnum):
    """Where a fact comes from; earlier members win over later ones."""

    GIVEN = "given"
    RULE = "rule"
    INFERRED = "inferred"


class Process(StrEnum):
    """What an operation does to its component."""

    PLACE = "place"
    NAIL = "nail"
    SCREW = "screw"
    GLUE = "glue"
    DRILL = "drill"
    PAINT = "paint"
    WELD = "weld"
    MORTAR = "mortar"


@dataclass(frozen=True, slots=True)
class BoxGeometry:
    """A box centred on the component frame; x runs along the longest edge or the grain."""

    size_m: Vector


@dataclass(frozen=True, slots=True)
class ExtrusionGeometry:
    """A profile in the x-y plane pulled along +z from 0 to `depth_m`."""

    profile_m: tuple[tuple[float, float], ...]
    depth_m: float
    holes_m: tuple[tuple[tuple[float, float], ...], ...] = ()


@dataclass(frozen=True, slots=True)
class ConvexGeometry:
    """The convex hull of points in the component frame."""

    points_m: tuple[Vector, ...]


@dataclass(frozen=True, slots=True)
class MeshGeometry:
    """A closed triangle mesh kept beside the model under its own hash."""

    uri: str
    sha256: str


@dataclass(frozen=True, slots=True)
class CompoundGeometry:
    """Several solids that move as one."""

    parts: tuple[tuple[Pose, BoxGeometry | ExtrusionGeometry | ConvexGeometry | MeshGeometry], ...]


Geometry = BoxGeometry | ExtrusionGeometry | ConvexGeometry | MeshGeometry | CompoundGeometry


@dataclass(frozen=True, slots=True)
class PlaneCut:
    """A saw cut: what lies on the side of the normal is gone (component frame)."""

    point_m: Vector
    normal: Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class FastenerSpec:
    """A nail or screw: its type, diameter and length."""

    type: str
    d_m: float
    l_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfacePatch:
    """A rectangle to be treated: paint and its kin.

    Attributes:
        size_m: Extent along the operation's x and y, about its origin; strokes run along x.
        standoff_m: Distance of the tool tip from the surface.
        width_m: Width of one stroke.
        speed_m_s: Speed of the tip along a stroke.
    """

    size_m: tuple[float, float]
    standoff_m: float
    width_m: float
    speed_m_s: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Operation:
    """One thing that a tool does to a placed component.

    Attributes:
        on: What it goes through and into, in order; its own component is one of them.
        component_T_operation: z is the driving direction, or points into the painted face.
        after: Operations of the same model that must be done before this one.
        needs_hold: The handler must still hold the component while this is done.
        patch: Only for surface processes.
    """

    id: OperationId
    process: Process
    on: tuple[ComponentId, ...]
    component_T_operation: Pose = field(default_factory=Pose)
    method: str = ""
    fastener: FastenerSpec | None = None
    after: tuple[OperationId, ...] = ()
    needs_hold: bool = False
    patch: SurfacePatch | None = None
    params: Mapping[str, Json] = field(default_factory=dict)
    origin: Origin = Origin.GIVEN


@dataclass(frozen=True, slots=True, kw_only=True)
class Source:
    """Where a component came from, for writing back.

    Attributes:
        sha256: Of the file.
        import_sha256: Of what was read of the file, kept under ``imports/`` of the project; this
            and `options` stand only in the model's own list of sources.
        options: How the file was taken, by name of the option.
    """

    file: str
    kind: str
    id: str
    sha256: str = ""
    import_sha256: str = ""
    options: Mapping[str, Json] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class AsBuilt:
    """What happened to a component; only in exported states, never in a design.

    Attributes:
        world_T_component_measured: Sensed pose in the world.
        operations: Status of each operation: ``done`` or what went wrong.
    """

    status: str
    material_used: ComponentId | None = None
    installed_at: str = ""
    robot: str = ""
    world_T_component_measured: Pose | None = None
    operations: Mapping[OperationId, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class Component:
    """One piece of the building, or one piece of material for it.

    Attributes:
        type: Words of the designer, e.g. ``transverse-stud``; targets take pieces of their type.
        order: Construction order; breaks ties only, equal numbers may go parallel.
        construction_parents: What it rests on or is fixed to; empty is the jobsite.
        ground: It stands on the ground or table by itself.
        temporary_support: It is falsework, or is carried by some.
        geometry: Shape in the component's own frame before `cuts`.
        world_T_component: Pose in the model's world.
        hold_until_fasteners: So many fasteners must be driven before the robot lets go.
        origins: For facts that were not given: field name -> origin and evidence.
    """

    id: ComponentId
    layer: Layer
    type: str
    geometry: Geometry
    world_T_component: Pose = field(default_factory=Pose)
    name: str = ""
    material: str = ""
    group: str = ""
    order: int | None = None
    construction_parents: tuple[ComponentId, ...] = ()
    ground: bool = False
    temporary_support: bool = False
    cuts: tuple[PlaneCut, ...] = ()
    mass_kg: float | None = None
    density_kg_m3: float | None = None
    com_m: Vector | None = None
    hold_until_fasteners: int = 0
    operations: tuple[Operation, ...] = ()
    grasps: tuple[Pose, ...] = ()
    source: Source | None = None
    raw: Mapping[str, Json] = field(default_factory=dict)
    ext: Mapping[str, Json] = field(default_factory=dict)
    origins: Mapping[str, tuple[Origin, str]] = field(default_factory=dict)
    as_built: AsBuilt | None = None


def is_given(component: Component, fact: str) -> bool:
    """Whether a field was stated by the author."""
    return component.origins.get(fact, (Origin.GIVEN, ""))[0] is Origin.GIVEN
