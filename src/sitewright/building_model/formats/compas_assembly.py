"""Reads block assemblies saved by compas_assembly: blocks, supports, stored interfaces."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from sitewright.building_model.formats.detect import FileKind, refused
from sitewright.building_model.formats.foreign_json import read_json, validated
from sitewright.building_model.formats.neutral import (
    FacesSolid,
    NeutralFile,
    NeutralPart,
    NeutralRelation,
)
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import cross

Corner = Annotated[int, Field(ge=0)]


class _Foreign(BaseModel):
    """Someone else's keys: unknown ones are passed over, numbers must be numbers."""

    model_config = ConfigDict(extra="ignore", allow_inf_nan=False, coerce_numbers_to_str=True)


class _Vertex(_Foreign):
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0


class _Mesh(_Foreign):
    attributes: dict[str, Any] = {}
    vertex: dict[str, _Vertex]
    face: dict[str, list[str]]


class _Block(_Foreign):
    data: _Mesh
    name: str = ""


class _Node(_Foreign):
    block: _Block
    is_support: bool = False
    name: str = ""


class _FrameData(_Foreign):
    point: tuple[float, float, float]
    xaxis: tuple[float, float, float]
    yaxis: tuple[float, float, float]


class _Frame(_Foreign):
    data: _FrameData


class _InterfaceData(_Foreign):
    size: float | None = None
    frame: _Frame | None = None


class _Interface(_Foreign):
    data: _InterfaceData


class _Edge(_Foreign):
    interfaces: list[_Interface] | None = None


class _GraphData(_Foreign):
    node: dict[str, _Node]
    edge: dict[str, dict[str, _Edge]] = {}


class _Graph(_Foreign):
    data: _GraphData


class _AssemblyData(_Foreign):
    graph: _Graph


class _Assembly(_Foreign):
    data: _AssemblyData


def read_compas_assembly(path: Path) -> NeutralFile:
    """Return the blocks of an assembly; the format states no unit.

    A support stands on the ground. A stored interface becomes a relation ``contact``.

    Raises:
        ModelRejectedError: It cannot be read, or lacks what makes an assembly.
    """
    graph = validated(_Assembly, read_json(path), path).data.graph.data
    names = Counter(node.name or node.block.name for node in graph.node.values())
    return NeutralFile(
        kind=str(FileKind.COMPAS_ASSEMBLY),
        metres_per_unit=None,
        parts=tuple(_part(path, key, node, names) for key, node in graph.node.items()),
        relations=tuple(_contacts(graph)),
    )


def _part(path: Path, key: str, node: _Node, names: Mapping[str, int]) -> NeutralPart:
    mesh = node.block.data
    index = {name: place for place, name in enumerate(mesh.vertex)}
    strange = {c for face in mesh.face.values() for c in face} - set(index)
    if strange:
        message = f"Block {key[:60]}: a face names vertex {min(strange)[:60]!r}, which is missing."
        raise refused(path, "E5", message, "Save the assembly again.")
    name = node.name or node.block.name  # the library names all alike, after their class
    return NeutralPart(
        source_id=key,
        kind="part",
        name=name if name and names[name] == 1 else f"block {key}",
        type="block",
        is_ground=node.is_support,
        solids=(
            FacesSolid(
                vertices=tuple((v.x, v.y, v.z) for v in mesh.vertex.values()),
                faces=tuple(tuple(index[c] for c in face) for face in mesh.face.values()),
            ),
        ),
        raw=_raw(mesh.attributes),
    )


def _raw(attributes: Mapping[str, Any]) -> dict[str, Json]:
    return {k: v for k, v in attributes.items() if isinstance(v, str | int | float | bool)}


def _contacts(graph: _GraphData) -> Iterator[NeutralRelation]:
    for a, ends in graph.edge.items():
        for b, edge in ends.items():
            if edge.interfaces:
                yield NeutralRelation(
                    kind="contact", a=a, b=b, data=_measured([i.data for i in edge.interfaces])
                )


def _measured(interfaces: list[_InterfaceData]) -> dict[str, Json]:
    """Return the area of all interfaces, and place and normal of the largest."""
    data: dict[str, Json] = {"type": "interface"}
    if all(i.size is not None for i in interfaces):
        data["area"] = sum(i.size or 0.0 for i in interfaces)
    largest = max(interfaces, key=lambda i: i.size or 0.0)
    if largest.frame is not None:
        frame = largest.frame.data
        data["location"] = list(frame.point)
        data["plane_normal"] = [round(c, 9) for c in cross(frame.xaxis, frame.yaxis)]
    return data
