"""Writes solids as one binary glTF 2.0 file (.glb): self-contained, in metres, y up.

All nodes hang below one that turns the site's z up into glTF's y up, so that their own poses are
those of the site. Faces carry no normals: a reader then shades them flat, which solids of planks
are. Equal shapes are stored once.
"""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector

_MAGIC, _VERSION = b"glTF", 2
_JSON, _BIN = b"JSON", b"BIN\x00"
_ALIGNED = 4
_FLOAT, _UNSIGNED_INT = 5126, 5125
_VERTICES, _INDICES = 34962, 34963
_HALF = math.sqrt(0.5)
_Z_UP_TO_Y_UP = [-_HALF, 0.0, 0.0, _HALF]
"""A turn by -90 degrees about x, as glTF writes quaternions: x, y, z, w."""
_MATT = {"metallicFactor": 0.0, "roughnessFactor": 0.9}


@dataclass(frozen=True, slots=True)
class Surface:
    """A closed surface of triangles, counter-clockwise seen from outside."""

    corners_m: tuple[Vector, ...]
    triangles: tuple[tuple[int, int, int], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Look:
    """A colour with a name; less than opaque is seen through."""

    name: str
    rgb: Vector
    opacity: float = 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawn:
    """One node of the scene.

    Attributes:
        facts: What a viewer is told of it (``extras``).
    """

    name: str
    site_T_drawn: Pose
    surface: Surface
    look: Look
    facts: Mapping[str, Json] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """What is drawn, in the site's coordinates: metres, z up.

    Attributes:
        facts: What a viewer is told of the whole (``extras``).
    """

    name: str
    drawn: tuple[Drawn, ...]
    facts: Mapping[str, Json] = field(default_factory=dict)


def glb_of(scene: Scene) -> bytes:
    """Return the content of a .glb file; the same scene gives the same bytes."""
    document, binary = _Writer(scene).parts()
    text = json.dumps(document, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    chunks = _chunk(_JSON, text, b" ") + (_chunk(_BIN, binary, b"\x00") if binary else b"")
    return struct.pack("<4sII", _MAGIC, _VERSION, 12 + len(chunks)) + chunks


def _chunk(kind: bytes, content: bytes, filler: bytes) -> bytes:
    content += filler * (-len(content) % _ALIGNED)
    return struct.pack("<I4s", len(content), kind) + content


class _Writer:
    """Collects the tables of one file."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._binary = bytearray()
        self._views: list[Json] = []
        self._accessors: list[Json] = []
        self._materials: dict[Look, int] = {}
        self._surfaces: dict[Surface, dict[str, Json]] = {}
        self._meshes: dict[tuple[Surface, Look], int] = {}

    def parts(self) -> tuple[dict[str, Json], bytes]:
        """Return the document and what stands in its buffer."""
        scene = self._scene
        nodes: list[Json] = [self._node(drawn) for drawn in scene.drawn]
        root: dict[str, Json] = {"name": "site, z up", "rotation": list(_Z_UP_TO_Y_UP)}
        if nodes:
            root["children"] = list(range(1, len(nodes) + 1))
        told: dict[str, Json] = {"nodes": [0], "extras": dict(scene.facts)}
        document: dict[str, Json] = {
            "asset": {"version": "2.0", "generator": "Sitewright"},
            "scene": 0,
            "scenes": [{"name": scene.name, **told} if scene.name else told],
            "nodes": [root, *nodes],
        }
        tables: dict[str, list[Json]] = {
            "meshes": [self._mesh(surface, look) for surface, look in self._meshes],
            "materials": [_material(look) for look in self._materials],
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": len(self._binary)}] if self._binary else [],
        }
        return {**document, **{k: t for k, t in tables.items() if t}}, bytes(self._binary)

    def _node(self, drawn: Drawn) -> dict[str, Json]:
        w, x, y, z = drawn.site_T_drawn.quaternion_wxyz
        self._materials.setdefault(drawn.look, len(self._materials))
        self._primitive(drawn.surface)
        key = (drawn.surface, drawn.look)
        return {
            "name": drawn.name,
            "mesh": self._meshes.setdefault(key, len(self._meshes)),
            "translation": [round(v, 7) for v in drawn.site_T_drawn.position_m],
            "rotation": [round(v, 9) for v in (x, y, z, w)],
            "extras": dict(drawn.facts),
        }

    def _mesh(self, surface: Surface, look: Look) -> dict[str, Json]:
        primitive = {**self._surfaces[surface], "material": self._materials[look]}
        return {"primitives": [primitive]}

    def _primitive(self, surface: Surface) -> None:
        if surface in self._surfaces:
            return
        corners = np.array(surface.corners_m, dtype="<f4")
        corner = self._accessor(corners, _FLOAT, "VEC3", _VERTICES)
        low, high = corners.min(axis=0), corners.max(axis=0)
        bounds = {"min": [float(v) for v in low], "max": [float(v) for v in high]}
        index = np.array(surface.triangles, dtype="<u4").reshape(-1)
        self._accessors[corner] = {**dict(self._accessors[corner]), **bounds}  # type: ignore[arg-type]
        self._surfaces[surface] = {
            "attributes": {"POSITION": corner},
            "indices": self._accessor(index, _UNSIGNED_INT, "SCALAR", _INDICES),
        }

    def _accessor(
        self, rows: npt.NDArray[np.generic], component: int, kind: str, target: int
    ) -> int:
        data = rows.tobytes()
        view: dict[str, Json] = {"buffer": 0, "byteOffset": len(self._binary), "target": target}
        self._views.append({**view, "byteLength": len(data)})
        self._binary += data  # numbers of four bytes, so the next one is aligned too
        self._accessors.append(
            {
                "bufferView": len(self._views) - 1,
                "componentType": component,
                "count": len(rows),
                "type": kind,
            }
        )
        return len(self._accessors) - 1


def _material(look: Look) -> dict[str, Json]:
    colour = [*look.rgb, look.opacity]
    found: dict[str, Json] = {
        "name": look.name,
        "pbrMetallicRoughness": {"baseColorFactor": list[Json](colour), **_MATT},
    }
    return found if look.opacity >= 1.0 else {**found, "alphaMode": "BLEND"}


def joined(surfaces: Sequence[Surface]) -> Surface:
    """Return several surfaces as one."""
    corners: list[Vector] = []
    triangles: list[tuple[int, int, int]] = []
    for surface in surfaces:
        first = len(corners)
        corners += surface.corners_m
        triangles += [(a + first, b + first, c + first) for a, b, c in surface.triangles]
    return Surface(tuple(corners), tuple(triangles))
