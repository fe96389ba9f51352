"""The shape of `building.json`, key by key (schema ``sitewright.building/1``)."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from sitewright.building_model.component import Layer, Origin, Process
from sitewright.building_model.model import RelationKind

SCHEMA = "sitewright.building/1"

MAX_COMPONENTS = 50_000
"""Of one building, the generated pieces of its stacks included."""
_UNIT_TOLERANCE = 1e-3

Id = Annotated[str, Field(pattern=r"^[A-Za-z0-9_$.\-]{1,64}$")]
Word = Annotated[
    str,
    Field(
        max_length=256,
        pattern=r"^[^\x00-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2066-\u2069\ufeff]*$",
    ),
]
Coordinate = Annotated[float, Field(ge=-1e7, le=1e7)]
Length = Annotated[float, Field(gt=0, le=1e4)]
Point = tuple[Coordinate, Coordinate, Coordinate]
Point2 = tuple[Coordinate, Coordinate]
Free = dict[str, Any]


class FileModel(BaseModel):
    """Strict: no unknown key, no NaN, no text for a number."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)


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
    """A box centred on the component frame, x along the grain."""

    size_m: Point


class ExtrusionFile(FileModel):
    """A profile in x-y pulled along +z."""

    profile_m: list[Point2] = Field(min_length=3)
    depth_m: Coordinate
    holes_m: list[list[Point2]] = []


class ConvexFile(FileModel):
    """The convex hull of points."""

    points_m: list[Point]


class MeshFile(FileModel):
    """A mesh kept beside the model."""

    uri: Word
    sha256: Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]


class SolidFile(FileModel):
    """One solid; exactly one of the keys."""

    box: BoxFile | None = None
    extrusion: ExtrusionFile | None = None
    convex: ConvexFile | None = None
    mesh: MeshFile | None = None

    @model_validator(mode="after")
    def _is_one(self) -> Self:
        if len(self.model_fields_set - {"component_T_part"}) != 1:
            raise ValueError("state exactly one kind of geometry")
        return self


class PartFile(SolidFile):
    """One solid of a compound, placed in the component frame."""

    component_T_part: PoseFile = PoseFile()


class CompoundFile(FileModel):
    """Several solids that move as one."""

    parts: list[PartFile] = Field(min_length=1)


class GeometryFile(SolidFile):
    """The shape of a component; exactly one of the keys."""

    compound: CompoundFile | None = None


class PlaneFile(FileModel):
    """A plane; what lies on the side of its normal is cut off."""

    point_m: Point
    normal: Point


class CutFile(FileModel):
    """A saw cut."""

    plane: PlaneFile


class FastenerFile(FileModel):
    """A nail or screw."""

    type: Word
    d_m: Length
    l_m: Length


class PatchFile(FileModel):
    """A rectangle to be painted, about the operation's origin."""

    size_m: tuple[Length, Length]
    standoff_m: Length
    width_m: Length
    speed_m_s: Length


class OperationFile(FileModel):
    """One thing that a tool does to a placed component."""

    id: Id
    process: Process
    on: list[Id] = []
    component_T_operation: PoseFile = PoseFile()
    method: Word = ""
    fastener: FastenerFile | None = None
    patch: PatchFile | None = None
    after: list[Id] = []
    needs_hold: bool = False
    params: Free = {}
    origin: Origin = Origin.GIVEN


class SourceFile(FileModel):
    """Where something came from."""

    file: Word
    kind: Word
    id: Word = ""
    sha256: Word = ""
    import_sha256: Annotated[str, Field(pattern=r"^([0-9a-f]{64})?$")] = ""
    options: Free = {}


class AsBuiltFile(FileModel):
    """What happened to a component; only in exported states."""

    status: Word
    material_used: Id | None = None
    installed_at: Word = ""
    robot: Word = ""
    world_T_component_measured: PoseFile | None = None
    operations: dict[str, Word] = {}


class EvidenceFile(FileModel):
    """Origin of one fact of a component."""

    origin: Origin
    evidence: Word = ""


class ComponentFile(FileModel):
    """One piece of the building, or one piece of material.

    A piece of a stack may leave out `world_T_component`: it lies where the pile puts it.
    """

    id: Id
    name: Word = ""
    layer: Layer = Layer.TARGET
    type: Word
    material: Word = ""
    group: Word = ""
    order: int | None = None
    construction_parents: list[Id] = []
    ground: bool = False
    temporary_support: bool = False
    geometry: GeometryFile
    cuts: list[CutFile] = []
    grain: Literal["x"] = "x"
    world_T_component: PoseFile | None = None
    mass_kg: Annotated[float, Field(gt=0)] | None = None
    density_kg_m3: Annotated[float, Field(gt=0)] | None = None
    com_m: Point | None = None
    hold_until_fasteners: Annotated[int, Field(ge=0)] = 0
    operations: list[OperationFile] = []
    grasps: list[PoseFile] = []
    source: SourceFile | None = None
    raw: Free = {}
    ext: Free = {}
    origins: dict[str, EvidenceFile] = {}
    as_built: AsBuiltFile | None = None


class RelationFile(FileModel):
    """A fact about two components, read ``a kind b``."""

    kind: RelationKind
    a: Id
    b: Id
    origin: Origin = Origin.GIVEN
    confidence: Annotated[float, Field(ge=0, le=1)] = 1.0
    data: Free = {}


class GeneratedFile(FileModel):
    """Equal box pieces, `section_m` = width (y) and height (z) as they lie in the pile."""

    type: Word
    section_m: tuple[Length, Length]
    length_m: Length
    count: Annotated[int, Field(ge=1, le=1000)]
    material: Word = ""


class StackFile(FileModel):
    """A pile of material, bottom first; either named pieces or generated ones."""

    id: Id
    place: Id
    stock_T_stack: PoseFile = PoseFile()
    spacer_m: Annotated[float, Field(ge=0, le=1)] = 0.0
    items: list[Id] | None = None
    generated: GeneratedFile | None = None

    @model_validator(mode="after")
    def _is_one(self) -> Self:
        if (self.items is None) == (self.generated is None):
            raise ValueError("state either items or generated")
        return self


class BuildFile(FileModel):
    """How it is built."""

    gravity: Point = (0.0, 0.0, -9.81)
    ground_z_m: Coordinate = 0.0
    site_T_model: PoseFile = PoseFile()


class MaterialFile(FileModel):
    """Properties of a material by name."""

    density_kg_m3: Annotated[float, Field(gt=0)]
    ext: Free = {}


class BuildingFile(FileModel):
    """A whole building model."""

    schema_: Literal["sitewright.building/1"] = Field(alias="schema")
    name: Word = ""
    sources: list[SourceFile] = []
    origin_shift_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    raw: Free = {}
    build: BuildFile = BuildFile()
    materials: dict[str, MaterialFile] = {}
    component_types: dict[str, Free] = {}
    components: Annotated[list[ComponentFile], Field(max_length=MAX_COMPONENTS)] = []
    relations: list[RelationFile] = []
    stacks: list[StackFile] = []
    rules: list[Free] = []
