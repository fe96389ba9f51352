"""Reads IFC files: elements with a body, their attributes, tasks and connections.

What the library says (`ifc_reader`) is checked here and becomes neutral records.
"""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, JsonValue, ValidationError

from sitewright.building_model.component import PlaneCut
from sitewright.building_model.formats.detect import FileKind, kind_of, read_limited, refused
from sitewright.building_model.formats.ifc_reader import WRONG_KIND, read, wrong_kind
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    ExtrusionSolid,
    FacesSolid,
    NeutralFile,
    NeutralPart,
    NeutralRelation,
    NeutralSolid,
)
from sitewright.building_model.formats.unreadable import UnreadableError
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.pose import Pose, Vector

_END = b"END-ISO-10303-21;"
_TAIL = 4096
_ID = r"^[A-Za-z0-9_$]{1,64}$"
_NO_SHAPE = "the geometry kernel finds no solid in it"

_Xyz = Annotated[list[float], Field(min_length=3, max_length=3)]
_Xy = Annotated[list[float], Field(min_length=2, max_length=2)]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)


class _Box(_Strict):
    kind: Literal["box"]
    p: _Xyz
    x: _Xyz
    y: _Xyz
    size: _Xyz
    has_grain: bool
    cuts: list[tuple[_Xyz, _Xyz]]


class _Extrusion(_Strict):
    kind: Literal["extrusion"]
    p: _Xyz
    x: _Xyz
    y: _Xyz
    profile: list[_Xy]
    depth: float
    holes: list[list[_Xy]]
    cuts: list[tuple[_Xyz, _Xyz]]


class _Faces(_Strict):
    kind: Literal["faces"]
    vertices: list[_Xyz]
    faces: list[list[int]]


class _Part(_Strict):
    source_id: str = Field(pattern=_ID)
    name: str
    layer_path: str
    type: str
    material: str
    group: str
    order: int | None
    solids: list[Annotated[_Box | _Extrusion | _Faces, Field(discriminator="kind")]]
    user_text: dict[str, str]
    raw: dict[str, JsonValue]


class _Relation(_Strict):
    a: str
    b: str
    type: str


class _Records(_Strict):
    metres_per_unit: float | None = Field(gt=0.0)
    parts: list[_Part]
    relations: list[_Relation]
    survey: dict[str, float | str]
    notes: list[str]


def read_ifc(path: Path) -> NeutralFile:
    """Return what an IFC file holds, in its own unit, nothing decided yet.

    Args:
        path: An IFC file in STEP format (IFC2X3, IFC4, IFC4X3).

    Raises:
        ModelRejectedError: It cannot be read as a whole (E2), holds nothing to build (E3), is cut
            off (E4), or two elements share an id (D1).
    """
    content = read_limited(path)
    if kind_of(content) is not FileKind.IFC:
        message = f"this is no IFC file in STEP format (it looks like: {kind_of(content)})."
        raise refused(path, "E3", message, "Export it as .ifc; unpack .ifczip first.")
    if _END not in content[-_TAIL:]:
        message = f"it is cut off (no {_END.decode()} at its end)."
        raise refused(path, "E4", message, "Copy or export it again.")
    records = _records(path)
    if not records.parts:
        said = " ".join(records.notes) or "It holds no building elements."
        raise refused(path, "E3", f"read 0 parts. {said}", "Export elements with their bodies.")
    _demand_own_ids(path, records)
    return NeutralFile(
        kind=str(FileKind.IFC),
        metres_per_unit=records.metres_per_unit,
        parts=tuple(_part(p) for p in records.parts),
        relations=tuple(
            NeutralRelation(kind="connection", a=r.a, b=r.b, data={"type": r.type})
            for r in records.relations
        ),
        notes=tuple(records.notes),
        raw={"survey": dict(records.survey)} if records.survey else {},
    )


def _records(path: Path) -> _Records:
    try:
        answer = json.dumps(read(str(path)), allow_nan=False)
    except UnreadableError as error:
        raise error.of(path) from None
    except WRONG_KIND as error:
        raise wrong_kind("an entity", error).of(path) from None
    try:
        return _Records.model_validate_json(answer)
    except ValidationError as error:
        first = error.errors()[0]
        place = ".".join(str(p) for p in first["loc"])
        raise refused(path, "E2", f"{place}: {first['msg']}.", "Repair the model.") from None


def _demand_own_ids(path: Path, records: _Records) -> None:
    count = Counter(p.source_id for p in records.parts)
    problems = [
        Problem(
            code="D1",
            severity="E",
            where=identity,
            message=f"{n} elements have this GlobalId.",
            fix="Give each its own; copies keep the old one in some programs.",
            source_id=identity,
        )
        for identity, n in sorted(count.items())
        if n > 1
    ]
    if problems:
        raise ModelRejectedError(str(path), problems)


def _part(part: _Part) -> NeutralPart:
    problems = []
    if not part.solids:
        fix = "Model it as extrusion or closed solid, or leave it out."
        problems.append(("G7", f"{_NO_SHAPE}; it is left out.", fix))
    return NeutralPart(
        source_id=part.source_id,
        kind=str(FileKind.IFC),
        name=part.name,
        layer_path=part.layer_path,
        type=part.type,
        material=part.material,
        group=part.group,
        order=part.order,
        solids=tuple(_solid(s) for s in part.solids),
        cuts=tuple(
            PlaneCut(point_m=_vector(p), normal=_vector(n))
            for s in part.solids
            if not isinstance(s, _Faces)
            for p, n in s.cuts
        ),
        user_text=part.user_text,
        raw=part.raw,
        problems=tuple(problems),
    )


def _solid(solid: _Box | _Extrusion | _Faces) -> NeutralSolid:
    match solid:
        case _Box():
            pose = Pose.from_axes(_vector(solid.p), _vector(solid.x), _vector(solid.y))
            return BoxSolid(file_T_box=pose, size=_vector(solid.size), has_grain=solid.has_grain)
        case _Extrusion():
            pose = Pose.from_axes(_vector(solid.p), _vector(solid.x), _vector(solid.y))
            return ExtrusionSolid(
                file_T_profile=pose,
                profile=_outline(solid.profile),
                depth=solid.depth,
                holes=tuple(_outline(h) for h in solid.holes),
            )
        case _Faces():
            return FacesSolid(
                vertices=tuple(_vector(v) for v in solid.vertices),
                faces=tuple(tuple(f) for f in solid.faces),
            )


def _outline(points: list[list[float]]) -> tuple[tuple[float, float], ...]:
    return tuple((x, y) for x, y in points)


def _vector(values: list[float]) -> Vector:
    return (values[0], values[1], values[2])
