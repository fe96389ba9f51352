"""Reads bar frames: nodes, and elements between two of them (``node_list``, ``element_list``)."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from math import sqrt
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from sitewright.building_model.formats.detect import FileKind, refused
from sitewright.building_model.formats.foreign_json import read_json, validated
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    NeutralFile,
    NeutralPart,
    NeutralRelation,
)
from sitewright.errors import did_you_mean
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector, add, norm, scale, subtract

_METRES: Mapping[str, float] = {
    "millimeter": 0.001,
    "centimeter": 0.01,
    "decimeter": 0.1,
    "meter": 1.0,
    "inch": 0.0254,
    "foot": 0.3048,
}
_SQUARE = "^2"
_PAIR = 2
_MAX_CONTACTS = 200_000
_UP_HINT: Vector = (0.0, 0.0, 1.0)


class _Foreign(BaseModel):
    model_config = ConfigDict(extra="ignore", allow_inf_nan=False)


class _Point(_Foreign):
    X: float
    Y: float
    Z: float


class _Node(_Foreign):
    node_id: int
    point: _Point
    is_grounded: bool = False


class _Element(_Foreign):
    element_id: int
    end_node_ids: Annotated[list[int], Field(min_length=_PAIR, max_length=_PAIR)]
    layer_id: int | None = None


class _Material(_Foreign):
    material_name: str = ""
    cross_sec_area: Annotated[float, Field(gt=0)]
    cross_sec_area_unit: str
    density: float | None = None
    density_unit: str = ""


class _Frame(_Foreign):
    unit: str | None = None
    material_properties: _Material
    node_list: list[_Node]
    element_list: list[_Element]
    base_frame_in_rob_base: dict[str, Any] = {}


def read_bar_frame(path: Path) -> NeutralFile:
    """Return the bars of a frame as square bars of the stated cross-section.

    A bar at a grounded node stands on the ground; bars that share a node are in contact.

    Raises:
        ModelRejectedError: It cannot be read, or lacks a cross-section.
    """
    frame = validated(_Frame, read_json(path), path)
    _demand_few_contacts(path, frame.element_list)
    metres = None if frame.unit is None else _metres(path, frame.unit)
    side = _side(path, frame.material_properties, metres)
    nodes = {n.node_id: n for n in frame.node_list}
    return NeutralFile(
        kind=str(FileKind.BAR_FRAME),
        metres_per_unit=metres,
        parts=tuple(_part(path, e, nodes, side, frame) for e in frame.element_list),
        relations=tuple(_contacts(frame.element_list)),
    )


def _metres(path: Path, unit: str) -> float:
    if unit in _METRES:
        return _METRES[unit]
    message = f"its unit {unit[:40]!r} is not known.{did_you_mean(unit, _METRES)}"
    raise refused(path, "U1", message, f"Use one of {', '.join(_METRES)}.")


def _side(path: Path, material: _Material, metres: float | None) -> float:
    """Return the edge of a square of the stated area, in the file's unit.

    A file that states no unit counts its area in the square of that unit, too.
    """
    unit = material.cross_sec_area_unit
    if not unit.endswith(_SQUARE):
        message = f"the cross-section is in {unit[:40]!r}, which is no squared length."
        raise refused(path, "U1", message, "Write, for example, centimeter^2.")
    side = sqrt(material.cross_sec_area)
    if metres is None:
        return side
    return side * _metres(path, unit.removesuffix(_SQUARE)) / metres


def _part(
    path: Path, element: _Element, nodes: Mapping[int, _Node], side: float, frame: _Frame
) -> NeutralPart:
    ends = [nodes.get(i) for i in element.end_node_ids]
    start, end = ends
    if start is None or end is None:
        message = f"element {element.element_id} ends at a node that is not in the list."
        raise refused(path, "P1", message, "Export the whole frame.")
    return NeutralPart(
        source_id=str(element.element_id),
        kind="element",
        name=f"bar {element.element_id}",
        type="bar",
        material=frame.material_properties.material_name,
        is_ground=start.is_grounded or end.is_grounded,
        raw=_raw(element, frame),
        **_solid(_vector(start.point), _vector(end.point), side),
    )


def _solid(a: Vector, b: Vector, side: float) -> dict[str, Any]:
    along = subtract(b, a)
    length = norm(along)
    if not 0.0 < length < float("inf"):
        return {"problems": (("G6", "Its two ends are one point.", "Remove it."),)}
    across = _UP_HINT if abs(along[2]) < 0.9 * length else (1.0, 0.0, 0.0)
    pose = Pose.from_axes(scale(add(a, b), 0.5), along, across)
    return {"solids": (BoxSolid(file_T_box=pose, size=(length, side, side), has_grain=True),)}


def _raw(element: _Element, frame: _Frame) -> dict[str, Json]:
    material = frame.material_properties
    raw: dict[str, Json] = {"end_node_ids": list(element.end_node_ids)}
    if element.layer_id is not None:
        raw["layer_id"] = element.layer_id
    if material.density is not None:
        raw["density"] = f"{material.density:g} {material.density_unit}"
    if frame.base_frame_in_rob_base:
        raw["base_frame_in_rob_base"] = frame.base_frame_in_rob_base
    return raw


def _demand_few_contacts(path: Path, elements: Sequence[_Element]) -> None:
    """Refuse a node that so many bars share that their pairs fill the memory."""
    bars = Counter(node for e in elements for node in set(e.end_node_ids))
    pairs = sum(n * (n - 1) // 2 for n in bars.values())
    if pairs > _MAX_CONTACTS:
        node, count = bars.most_common(1)[0]
        message = f"its nodes give {pairs} contacts of bars, more than {_MAX_CONTACTS}; "
        most = f"node {node} alone joins {count} bars."
        raise refused(path, "E2", message + most, "Export a part of the frame.")


def _contacts(elements: list[_Element]) -> Iterator[NeutralRelation]:
    at: dict[int, list[int]] = defaultdict(list)
    for element in elements:
        for node in element.end_node_ids:
            at[node].append(element.element_id)
    for node, bars in sorted(at.items()):
        for a, b in combinations(sorted(set(bars)), 2):
            yield NeutralRelation(kind="contact", a=str(a), b=str(b), data={"node": node})


def _vector(point: _Point) -> Vector:
    return (point.X, point.Y, point.Z)
