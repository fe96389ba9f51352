"""Collision elements of a URDF as convex pieces in the link's frame."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np

from sitewright.foundation.pose import Vector
from sitewright.foundation.shapes import Box, ConvexPart, Hull, Shape, moved
from sitewright.robot_team.formats.hulls import few_vertices
from sitewright.robot_team.formats.mesh_points import read_points
from sitewright.robot_team.formats.urdf_xml import Findings

_SIDES = 16
_PACKAGE = "package://"
_FILE = "file://"


def read_shape(link: ET.Element, folder: Path, findings: Findings) -> Shape:
    """Return the pieces of all <collision> elements of a link.

    A cylinder becomes a prism of 16 sides around it; a mesh becomes its convex hull, so a concave
    body needs several meshes. Hulls of more than 100 vertices are replaced by slightly larger ones.
    """
    where = f"link {link.get('name', '')}"
    collisions = link.findall("collision")
    if not collisions and link.find("visual") is not None:
        findings.add(
            "R5",
            where,
            "It can be seen but has no collision shape, so no motion would keep clear of it.",
            "Add a <collision> with a box, a cylinder or a mesh.",
        )
    pieces: list[ConvexPart] = []
    for collision in collisions:
        piece = _read_piece(collision, folder, where, findings)
        if piece is not None:
            pieces += moved((piece,), findings.origin(collision, where))
    return tuple(pieces)


def _read_piece(
    collision: ET.Element, folder: Path, where: str, findings: Findings
) -> ConvexPart | None:
    geometry = collision.find("geometry")
    shape = None if geometry is None else next(iter(geometry), None)
    if shape is not None:
        match shape.tag:
            case "box":
                return _box(shape, where, findings)
            case "cylinder":
                return _prism(shape, where, findings)
            case "mesh":
                return _hull(shape, folder, where, findings)
            case _:
                pass
    findings.add(
        "R5",
        where,
        f"Collision geometry {'without a shape' if shape is None else shape.tag} is not read.",
        "Use box, cylinder or mesh (.obj, .stl).",
    )
    return None


def _box(element: ET.Element, where: str, findings: Findings) -> Box | None:
    size = findings.vector(element, "size", where)
    return Box(size) if _is_positive(size, element, where, findings) else None


def _prism(element: ET.Element, where: str, findings: Findings) -> Hull | None:
    radius_m = findings.number(element, "radius", where)
    length_m = findings.number(element, "length", where)
    if not _is_positive((radius_m, length_m), element, where, findings):
        return None
    corner_m = radius_m / math.cos(math.pi / _SIDES)
    angles = [2.0 * math.pi * (k + 0.5) / _SIDES for k in range(_SIDES)]
    return Hull(
        tuple(
            (corner_m * math.cos(a), corner_m * math.sin(a), z)
            for z in (-length_m / 2.0, length_m / 2.0)
            for a in angles
        )
    )


def _is_positive(
    values: tuple[float, ...], element: ET.Element, where: str, findings: Findings
) -> bool:
    if min(values) > 0.0:
        return True
    findings.add("R5", where, f"Its {element.tag} has no volume.", "Give positive lengths.")
    return False


def _hull(element: ET.Element, folder: Path, where: str, findings: Findings) -> Hull | None:
    name = element.get("filename", "")
    scale = findings.vector(element, "scale", where, default=(1.0, 1.0, 1.0))
    path = next((p for p in _candidates(name, folder) if p.is_file()), None)
    if path is None:
        fix = f"Put it there, or correct the name (searched from {folder})."
        findings.add("R5", where, f"Mesh {name!r} is not there.", fix)
        return None
    try:
        corners = few_vertices(read_points(path) * np.array(scale))
    except (OSError, ValueError) as error:
        fix = "Save it as .obj or binary .stl of a solid body, in metres."
        findings.add("R5", where, f"Mesh {name!r} cannot be used: {error}.", fix)
        return None
    return Hull(tuple(_vector(row.tolist()) for row in corners))


def _candidates(name: str, folder: Path) -> Iterator[Path]:
    """Yield where a mesh may lie: the package's folder is looked for upwards from the URDF."""
    if not name.startswith(_PACKAGE):
        yield folder / name.removeprefix(_FILE)
        return
    package, _, inside = name.removeprefix(_PACKAGE).partition("/")
    for above in (folder, *folder.parents):
        if above.name == package:
            yield above / inside
        yield above / package / inside


def _vector(row: list[float]) -> Vector:
    return (row[0], row[1], row[2])
