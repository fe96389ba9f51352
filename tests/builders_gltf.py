"""Binary glTF files as another library reads them, turned back to the site's z up."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

_Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)
"""glTF's y is the site's z; glTF's z points against the site's y."""


@dataclass(frozen=True)
class Body:
    """One node: its volume (negative if turned inside out) and its box in the site."""

    volume_m3: float
    is_closed: bool
    low_m: tuple[float, ...]
    high_m: tuple[float, ...]


def bodies_in(path: Path) -> dict[str, Body]:
    """Return what is drawn, by the name of its node."""
    scene: Any = trimesh.load_scene(path, process=False)
    found = {}
    for name in scene.graph.nodes_geometry:
        matrix, geometry = scene.graph[name]
        mesh = scene.geometry[geometry].copy()
        mesh.apply_transform(_Z_UP @ matrix)
        closed = all(part.is_watertight for part in mesh.split(only_watertight=False))
        low, high = (tuple(float(v) for v in row) for row in mesh.bounds)
        found[str(name)] = Body(float(mesh.volume), closed, low, high)
    return found


def document_in(path: Path) -> dict[str, Any]:
    """Return the JSON of a .glb file."""
    content = path.read_bytes()
    (size,) = struct.unpack_from("<I", content, 12)
    found: dict[str, Any] = json.loads(content[20 : 20 + size])
    return found


def facts_in(path: Path) -> dict[str, dict[str, Any]]:
    """Return the extras of each node that is drawn, by its name."""
    nodes = document_in(path)["nodes"]
    return {n["name"]: n["extras"] for n in nodes if "mesh" in n}


def colour_of(path: Path, name: str) -> str:
    """Return the name of the material that a node is drawn with."""
    document = document_in(path)
    node = next(n for n in document["nodes"] if n["name"] == name)
    (primitive,) = document["meshes"][node["mesh"]]["primitives"]
    return str(document["materials"][primitive["material"]]["name"])
