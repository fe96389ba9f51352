"""Solids as a reading child process sends them: JSON that is checked, then neutral records."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from sitewright.building_model.formats.neutral import ExtrusionSolid, FacesSolid, NeutralSolid
from sitewright.foundation.pose import Pose, Vector

Xyz = Annotated[list[float], Field(min_length=3, max_length=3)]
Xy = Annotated[list[float], Field(min_length=2, max_length=2)]
_Outline = Annotated[list[Xy], Field(min_length=3)]


class Record(BaseModel):
    """Base of all records: no foreign keys, no NaN, no guessing of types."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)


class ExtrusionRecord(Record):
    """A profile in the x-y plane of a frame (origin p, axes x and y), pulled along its z."""

    kind: Literal["extrusion"]
    p: Xyz
    x: Xyz
    y: Xyz
    profile: _Outline
    depth: float = Field(gt=0.0)
    holes: list[_Outline]


class FacesRecord(Record):
    """Polygons over shared vertices, seen from outside counter-clockwise."""

    kind: Literal["faces"]
    vertices: list[Xyz]
    faces: list[Annotated[list[int], Field(min_length=3)]]


SolidRecord = Annotated[ExtrusionRecord | FacesRecord, Field(discriminator="kind")]


def solid_of_record(record: ExtrusionRecord | FacesRecord) -> NeutralSolid:
    """Return the neutral solid of a record; a frame without directions is a ValueError."""
    match record:
        case ExtrusionRecord():
            return ExtrusionSolid(
                file_T_profile=Pose.from_axes(_xyz(record.p), _xyz(record.x), _xyz(record.y)),
                profile=_outline(record.profile),
                depth=record.depth,
                holes=tuple(_outline(h) for h in record.holes),
            )
        case FacesRecord():
            return FacesSolid(
                vertices=tuple(_xyz(v) for v in record.vertices),
                faces=tuple(tuple(f) for f in record.faces),
            )


def _outline(points: list[list[float]]) -> tuple[tuple[float, float], ...]:
    return tuple((x, y) for x, y in points)


def _xyz(values: list[float]) -> Vector:
    return (values[0], values[1], values[2])
