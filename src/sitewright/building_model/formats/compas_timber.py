"""Imports timber frames saved by compas_timber: beams, their saw cuts and their joints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from statistics import median

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sitewright.building_model.component import (
    BoxGeometry,
    Component,
    Layer,
    PlaneCut,
    Source,
)
from sitewright.building_model.formats.detect import (
    MAX_JSON_BYTES,
    FileKind,
    kind_of,
    read_limited,
    refused,
)
from sitewright.building_model.formats.import_process import ChildFailed, Limits, run_reader
from sitewright.building_model.formats.length_unit import METRES_PER_UNIT, unit_problems
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector, norm, scale, subtract, unit

_READER = "sitewright.building_model.formats.compas_timber_reader"
_FAR_M = 1000.0
_MAX_PARTS = 50_000
_ID = r"^[A-Za-z0-9_$.-]{1,64}$"
_XYZ = Field(min_length=3, max_length=3)


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)


class _Part(_Strict):
    guid: str = Field(pattern=_ID)
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


def import_compas_timber(
    path: Path, unit_name: str | None, *, limits: Limits | None = None
) -> tuple[BuildingModel, list[Problem]]:
    """Read a compas_timber JSON file as a building model, with warnings.

    Every beam becomes a Target component whose box is its blank and whose cuts are its
    saw cuts; every joint becomes a relation ``connection`` from the butting beam to the one it
    butts against. Nothing is inferred here.

    Args:
        path: The file.
        unit_name: Length unit of its numbers (``mm``, ``m`` ...); the format states none.
        limits: What the reading process may use.

    Raises:
        ModelRejectedError: It cannot be read as a whole, or parts of it are wrong.
    """
    content = read_limited(path)
    _demand_timber(path, content)
    records = _records(path, limits or Limits())
    if not records.parts:
        raise refused(path, "E3", "read 0 beams.", "Export a model that holds beams.")
    problems = [
        *unit_problems(path.name, unit_name, [max(p.size) for p in records.parts]),
        *_part_problems(records),
    ]
    if any(p.severity == "E" for p in problems):
        raise ModelRejectedError(str(path), problems)
    assert unit_name is not None  # noqa: S101 - else U1 above
    return _model(path, content, records, METRES_PER_UNIT[unit_name]), problems


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


def _records(path: Path, limits: Limits) -> _Records:
    answer = run_reader(_READER, path.resolve(), limits)
    if isinstance(answer, ChildFailed):
        raise refused(path, "E2", f"the reader {answer.reason}.", "Check or export it again.")
    if not isinstance(answer, Mapping):
        raise refused(path, "E2", "the reader gave no records.", "Export it again.")
    no = answer.get("refused")
    if isinstance(no, Mapping):
        raise refused(path, str(no["code"]), str(no["message"]), str(no["fix"]))
    try:
        return _Records.model_validate(answer)
    except ValidationError as error:
        first = error.errors()[0]
        place = ".".join(str(p) for p in first["loc"])
        raise refused(path, "E2", f"{place}: {first['msg']}.", "Repair the model.") from None


def _part_problems(records: _Records) -> list[Problem]:
    count = Counter(p.guid for p in records.parts)
    known = set(count)
    problems = [
        Problem(
            code="D1",
            severity="E",
            where=guid,
            message=f"{n} beams have this id.",
            fix="Give each its own.",
        )
        for guid, n in count.items()
        if n > 1
    ]
    problems += [p for part in records.parts for p in _geometry_problems(part)]
    for joint in records.joints:
        problems += [
            Problem(
                code="P1",
                severity="E",
                where=element,
                message=f"a {joint.type} joins it, but the file holds no such beam.",
                fix="Export the whole model.",
            )
            for element in joint.elements
            if element not in known and element not in {g for g, _ in records.left_out}
        ]
    return problems + _losses(records)


def _geometry_problems(part: _Part) -> list[Problem]:
    wrong = ""
    if min(part.size) <= 0.0:
        wrong = f"its blank has the size {part.size}."
    elif norm(_vector(part.x_axis)) == 0.0 or _are_parallel(part.x_axis, part.y_axis):
        wrong = "its frame has no direction."
    elif any(norm(_vector(normal)) == 0.0 for _, normal in part.cuts):
        wrong = "one of its cuts has no direction."
    if not wrong:
        return []
    fix = "Repair the beam in the model."
    return [Problem(code="G6", severity="E", where=part.guid, message=wrong, fix=fix)]


def _losses(records: _Records) -> list[Problem]:
    losses = [
        (guid, f"a {kind} is no beam and is left out.", "Build it by hand or model it as beams.")
        for guid, kind in records.left_out
    ]
    losses += [
        (guid, f"its {kind} is not read; its wood stays.", "Expect it to overlap its neighbour.")
        for guid, kind in records.unknown_features
    ]
    losses += [("joinery", text, "Repair the joint.") for text in records.joinery_errors]
    return [
        Problem(code="G7", severity="W", where=where, message=message, fix=fix)
        for where, message, fix in losses
    ]


def _model(path: Path, content: bytes, records: _Records, metres: float) -> BuildingModel:
    shift = _shift(records, metres)
    digest = sha256_hex(content)
    labels = _labels(records.parts)
    components = [_component(p, metres, shift, labels[p.guid]) for p in records.parts]
    source = Source(file=path.name, kind=str(FileKind.COMPAS_TIMBER), id="", sha256=digest)
    known = {c.id for c in components}
    relations = [_relation(j, metres, shift) for j in records.joints if len(j.elements) == _PAIR]
    return BuildingModel(
        name=path.stem,
        component_by_id={c.id: c for c in sorted(components, key=lambda c: c.id)},
        relations=tuple(
            sorted(
                (r for r in relations if r.a in known and r.b in known), key=lambda r: (r.a, r.b)
            )
        ),
        sources=(source,),
        origin_shift_m=shift,
    )


_PAIR = 2


def _shift(records: _Records, metres: float) -> Vector:
    """Return what is taken off all coordinates: nothing, unless the model lies far away."""
    middle = scale(_vector([median(p.point[i] for p in records.parts) for i in range(3)]), metres)
    if norm(middle) < _FAR_M:
        return (0.0, 0.0, 0.0)
    return (round(middle[0]), round(middle[1]), round(middle[2]))


def _labels(parts: list[_Part]) -> dict[str, str]:
    count: Counter[str] = Counter()
    labels = {}
    for part in sorted(parts, key=lambda p: p.guid):
        word = part.name or "beam"
        count[word] += 1
        labels[part.guid] = f"{word} {count[word]}"
    return labels


def _component(part: _Part, metres: float, shift: Vector, label: str) -> Component:
    position = subtract(scale(_vector(part.point), metres), shift)
    world_T_component = Pose.from_axes(position, _vector(part.x_axis), _vector(part.y_axis))
    length, width, height = (s * metres for s in part.size)
    return Component(
        id=ComponentId(part.guid),
        layer=Layer.TARGET,
        type=str(part.attributes.get("category") or "beam"),
        name=label,
        geometry=BoxGeometry((length, width, height)),
        world_T_component=world_T_component,
        cuts=tuple(
            _cut(_vector(p), _vector(n), world_T_component.inverse(), metres, shift)
            for p, n in part.cuts
        ),
        source=Source(
            file="", kind=str(FileKind.COMPAS_TIMBER), id=part.guid
        ),  # file: see `sources`
        raw=dict(part.attributes),
    )


def _cut(
    point: Vector, normal: Vector, component_T_world: Pose, metres: float, shift: Vector
) -> PlaneCut:
    at = component_T_world.apply(subtract(scale(point, metres), shift))
    return PlaneCut(point_m=at, normal=component_T_world.turn(unit(normal)))


def _relation(joint: _Joint, metres: float, shift: Vector) -> Relation:
    data: dict[str, str | list[float]] = {"type": joint.type}
    if joint.location is not None:
        data["location_m"] = list(subtract(scale(_vector(joint.location), metres), shift))
    a, b = joint.elements
    return Relation(kind=RelationKind.CONNECTION, a=ComponentId(a), b=ComponentId(b), data=data)


def _vector(values: list[float]) -> Vector:
    return (float(values[0]), float(values[1]), float(values[2]))


def _are_parallel(a: list[float], b: list[float]) -> bool:
    from sitewright.foundation.pose import cross

    length = norm(_vector(a)) * norm(_vector(b))
    return norm(cross(_vector(a), _vector(b))) < 1e-6 * max(length, 1e-12)
