"""Neutral records as a reading child process sends them: nothing in them is taken on trust."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, JsonValue, ValidationError, model_validator

from sitewright.building_model.component import PlaneCut
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    ExtrusionSolid,
    FacesSolid,
    NeutralFile,
    NeutralPart,
    NeutralRelation,
    NeutralSolid,
)
from sitewright.building_model.formats.neutral_scale import MAX_PARTS
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector

_SHOWN = 200

_Xyz = Annotated[list[float], Field(min_length=3, max_length=3)]
_Xy = Annotated[list[float], Field(min_length=2, max_length=2)]
_Index = Annotated[int, Field(ge=0)]


class BadRecordsError(ValueError):
    """The records are not what a reader hands over; the text names the place."""


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)


class _Pose(_Strict):
    p: _Xyz
    q: Annotated[list[float], Field(min_length=4, max_length=4)]

    @model_validator(mode="after")
    def _is_unit(self) -> Self:
        _pose(self)  # a ValueError of its own if it is none
        return self


class _Box(_Strict):
    kind: Literal["box"]
    pose: _Pose
    size: _Xyz
    has_grain: bool


class _Extrusion(_Strict):
    kind: Literal["extrusion"]
    pose: _Pose
    profile: list[_Xy]
    depth: float
    holes: list[list[_Xy]]


class _Faces(_Strict):
    kind: Literal["faces"]
    vertices: list[_Xyz]
    faces: list[list[_Index]]

    @model_validator(mode="after")
    def _names_its_vertices(self) -> Self:
        count = len(self.vertices)
        if any(i >= count for face in self.faces for i in face):
            raise ValueError("a face names a vertex that is not there")
        return self


class _Cut(_Strict):
    point: _Xyz
    normal: _Xyz


class _Part(_Strict):
    source_id: str
    kind: str
    name: str
    layer_path: str
    type: str
    material: str
    group: str
    order: int | None
    parents: list[str]
    is_ground: bool
    solids: list[Annotated[_Box | _Extrusion | _Faces, Field(discriminator="kind")]]
    cuts: list[_Cut]
    user_text: dict[str, str]
    raw: dict[str, JsonValue]
    problems: list[Annotated[list[str], Field(min_length=3, max_length=3)]]


class _Relation(_Strict):
    kind: str
    a: str
    b: str
    data: dict[str, JsonValue]


class _File(_Strict):
    kind: str
    metres_per_unit: Annotated[float, Field(gt=0.0)] | None
    parts: Annotated[list[_Part], Field(max_length=MAX_PARTS)]
    relations: list[_Relation]
    notes: list[str]
    raw: dict[str, JsonValue]


def neutral_of(document: Json) -> NeutralFile:
    """Return the neutral file of what `neutral_json.document_of` made.

    Raises:
        BadRecordsError: It is something else.
    """
    try:
        file = _File.model_validate(document)
    except ValidationError as error:
        first = error.errors()[0]
        place = ".".join(str(p) for p in first["loc"])
        said = first["msg"].removeprefix("Value error, ").rstrip(".")
        raise BadRecordsError(f"{place}: {said}"[:_SHOWN]) from None
    return NeutralFile(
        kind=file.kind,
        metres_per_unit=file.metres_per_unit,
        parts=tuple(_part(p) for p in file.parts),
        relations=tuple(
            NeutralRelation(kind=r.kind, a=r.a, b=r.b, data=r.data) for r in file.relations
        ),
        notes=tuple(file.notes),
        raw=file.raw,
    )


def _part(part: _Part) -> NeutralPart:
    return NeutralPart(
        source_id=part.source_id,
        kind=part.kind,
        name=part.name,
        layer_path=part.layer_path,
        type=part.type,
        material=part.material,
        group=part.group,
        order=part.order,
        parents=tuple(part.parents),
        is_ground=part.is_ground,
        solids=tuple(_solid(s) for s in part.solids),
        cuts=tuple(PlaneCut(point_m=_xyz(c.point), normal=_xyz(c.normal)) for c in part.cuts),
        user_text=part.user_text,
        raw=part.raw,
        problems=tuple((code, said, fix) for code, said, fix in part.problems),
    )


def _solid(solid: _Box | _Extrusion | _Faces) -> NeutralSolid:
    match solid:
        case _Box():
            pose = _pose(solid.pose)
            return BoxSolid(file_T_box=pose, size=_xyz(solid.size), has_grain=solid.has_grain)
        case _Extrusion():
            return ExtrusionSolid(
                file_T_profile=_pose(solid.pose),
                profile=_outline(solid.profile),
                depth=solid.depth,
                holes=tuple(_outline(h) for h in solid.holes),
            )
        case _Faces():
            return FacesSolid(
                vertices=tuple(_xyz(v) for v in solid.vertices),
                faces=tuple(tuple(f) for f in solid.faces),
            )


def _pose(pose: _Pose) -> Pose:
    w, x, y, z = pose.q
    return Pose(_xyz(pose.p), (w, x, y, z))


def _outline(points: list[list[float]]) -> tuple[tuple[float, float], ...]:
    return tuple((x, y) for x, y in points)


def _xyz(values: list[float]) -> Vector:
    return (values[0], values[1], values[2])
