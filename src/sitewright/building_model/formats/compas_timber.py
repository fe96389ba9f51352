"""Reads timber frames saved by compas_timber: beams, their saw cuts and their joints.

What the library says (`compas_timber_reader`) is checked here and becomes neutral records.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sitewright.building_model.component import PlaneCut
from sitewright.building_model.formats.compas_timber_reader import read
from sitewright.building_model.formats.detect import (
    MAX_JSON_BYTES,
    FileKind,
    kind_of,
    read_limited,
    refused,
)
from sitewright.building_model.formats.import_map import PREFIX
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    NeutralFile,
    NeutralPart,
    NeutralRelation,
)
from sitewright.building_model.formats.unreadable import UnreadableError
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector, cross, norm, unit

_MAX_PARTS = 50_000
_PAIR = 2
_PARALLEL = 1e-6
_XYZ = Field(min_length=3, max_length=3)


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)


class _Part(_Strict):
    guid: str
    name: str
    attributes: dict[str, str | float | int]
    size: list[float] = _XYZ
    point: list[float] = _XYZ
    x_axis: list[float] = _XYZ
    y_axis: list[float] = _XYZ
    cuts: list[list[list[float]]]


class _Joint(_Strict):
    type: str
    elements: list[str]
    location: list[float] | None


class _Records(_Strict):
    parts: list[_Part] = Field(max_length=_MAX_PARTS)
    joints: list[_Joint]
    left_out: list[list[str]]
    unknown_features: list[list[str]]
    joinery_errors: list[str]


def read_compas_timber(path: Path) -> NeutralFile:
    """Return what a compas_timber JSON file holds; the format states no unit.

    Every beam is a box, its blank, with its saw cuts; every joint a ``connection`` from the
    butting beam to the one it butts against.

    Raises:
        ModelRejectedError: It cannot be read as a whole, or a joint names a beam that is not there.
    """
    _demand_timber(path, read_limited(path))
    records = _records(path)
    if not records.parts:
        raise refused(path, "E3", "read 0 beams.", "Export a model that holds beams.")
    problems = list(_lost_ends(records))
    if problems:
        raise ModelRejectedError(str(path), problems)
    labels = _labels(records.parts)
    return NeutralFile(
        kind=str(FileKind.COMPAS_TIMBER),
        metres_per_unit=None,
        parts=(
            *(_part(p, labels[p.guid], _unread(p, records)) for p in records.parts),
            *(_left_out(guid, kind) for guid, kind in records.left_out),
        ),
        relations=tuple(_relation(j) for j in records.joints if len(j.elements) == _PAIR),
        notes=tuple(f"Joinery: {text}" for text in records.joinery_errors),
    )


def _demand_timber(path: Path, content: bytes) -> None:
    kind = kind_of(content)
    if kind is not FileKind.COMPAS_TIMBER:
        raise refused(
            path,
            "E3",
            f"this is no compas_timber JSON (it looks like: {kind}).",
            "Save the timber model with compas.json_dump.",
        )
    if len(content) > MAX_JSON_BYTES:
        size = f"{len(content) / 1e6:.0f} MB of JSON, more than {MAX_JSON_BYTES / 1e6:.0f}"
        raise refused(path, "E2", size + ".", "Export only the part that is to be built.")


def _records(path: Path) -> _Records:
    try:
        return _Records.model_validate(read(str(path)))
    except UnreadableError as error:
        raise error.of(path) from None
    except ValidationError as error:
        first = error.errors()[0]
        place = ".".join(str(p) for p in first["loc"])
        raise refused(path, "E2", f"{place}: {first['msg']}.", "Repair the model.") from None


def _lost_ends(records: _Records) -> Iterator[Problem]:
    known = {p.guid for p in records.parts} | {guid for guid, _ in records.left_out}
    for joint in records.joints:
        for element in joint.elements:
            if element not in known:
                yield Problem(
                    code="P1",
                    severity="E",
                    where=element or "joint",
                    message=f"a {joint.type} joins it, but the file holds no such beam.",
                    fix="Export the whole model.",
                )


def _labels(parts: Iterable[_Part]) -> dict[str, str]:
    count: Counter[str] = Counter()
    labels = {}
    for part in sorted(parts, key=lambda p: p.guid):
        word = part.name or "beam"
        count[word] += 1
        labels[part.guid] = f"{word} {count[word]}"
    return labels


def _unread(part: _Part, records: _Records) -> list[tuple[str, str, str]]:
    fix = "Expect it to overlap its neighbour."
    kinds = Counter(kind for guid, kind in records.unknown_features if guid == part.guid)
    return [("G7", f"Its {kind} is not read; its wood stays.", fix) for kind in sorted(kinds)]


def _part(part: _Part, label: str, unread: Sequence[tuple[str, str, str]]) -> NeutralPart:
    wrong = _wrong_geometry(part)
    problems = [*unread]
    if wrong:
        problems.append(("G6", wrong, "Repair the beam in the model."))
    solids: tuple[BoxSolid, ...] = ()
    cuts: tuple[PlaneCut, ...] = ()
    if not wrong:
        pose = Pose.from_axes(_vector(part.point), _vector(part.x_axis), _vector(part.y_axis))
        solids = (BoxSolid(file_T_box=pose, size=_vector(part.size), has_grain=True),)
        back = pose.inverse()
        cuts = tuple(
            PlaneCut(back.apply(_vector(point)), back.turn(unit(_vector(normal))))
            for point, normal in part.cuts
        )
    ours = {k: str(v) for k, v in part.attributes.items() if k.lower().startswith(PREFIX)}
    return NeutralPart(
        source_id=part.guid,
        kind=str(FileKind.COMPAS_TIMBER),
        name=label,
        type=str(part.attributes.get("category") or "beam"),
        solids=solids,
        cuts=cuts,
        user_text=ours,
        raw=_others(part.attributes, ours),
        problems=tuple(problems),
    )


def _others(attributes: Mapping[str, str | float], ours: Mapping[str, str]) -> dict[str, Json]:
    return {k: v for k, v in attributes.items() if k not in ours}


def _wrong_geometry(part: _Part) -> str:
    x, y = _vector(part.x_axis), _vector(part.y_axis)
    if min(part.size) <= 0.0:
        return f"Its blank has the size {part.size}."
    if norm(cross(x, y)) <= _PARALLEL * max(norm(x) * norm(y), _PARALLEL):
        return "Its frame has no direction."
    if any(not norm(_vector(normal)) > 0.0 for _, normal in part.cuts):
        return "One of its cuts has no direction."
    return ""


def _left_out(guid: str, kind: str) -> NeutralPart:
    fix = "Build it by hand or model it as beams."
    problem = ("G7", f"A {kind} is no beam and is left out.", fix)
    return NeutralPart(source_id=guid, kind=str(FileKind.COMPAS_TIMBER), problems=(problem,))


def _relation(joint: _Joint) -> NeutralRelation:
    data: dict[str, Json] = {"type": joint.type}
    if joint.location is not None:
        data["location"] = list(joint.location)
    a, b = joint.elements
    return NeutralRelation(kind="connection", a=a, b=b, data=data)


def _vector(values: Sequence[float]) -> Vector:
    x, y, z = values
    return (float(x), float(y), float(z))
