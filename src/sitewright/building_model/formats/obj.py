"""Reads Wavefront OBJ text: one part per object or group, nothing merged."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from sitewright.building_model.formats.detect import FileKind, read_limited, refused
from sitewright.building_model.formats.neutral import FacesSolid, NeutralFile, NeutralPart
from sitewright.errors import ModelRejectedError
from sitewright.foundation.pose import Vector

MAX_BYTES = 100_000_000
_TRIANGLE = 3
_UNNAMED = "object"


@dataclass(slots=True)
class _Group:
    """Faces under one name, as they are met."""

    name: str
    faces: list[list[int]] = field(default_factory=list)
    material: str = ""


def read_obj(path: Path) -> NeutralFile:
    """Return the objects of an OBJ file; the format states no unit.

    Objects (``o``) are parts; in a file without any, groups (``g``) are. Lines, points,
    textures and normals are passed over.

    Raises:
        ModelRejectedError: It cannot be read; the message names the line.
    """
    content = read_limited(path)
    if len(content) > MAX_BYTES:
        message = f"the file has {len(content) / 1e6:.0f} MB, more than {MAX_BYTES / 1e6:.0f}."
        raise refused(path, "E2", message, "Simplify its meshes.")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        message = f"Byte {error.start} is not UTF-8."
        raise refused(path, "E5", message, "Save the file as UTF-8.") from None
    vertices, groups = _Scan(path).read(text)
    return NeutralFile(
        kind=str(FileKind.OBJ),
        metres_per_unit=None,
        parts=tuple(_parts(groups, vertices)),
    )


class _Scan:
    """Goes through the lines and remembers where it is, for messages."""

    def __init__(self, path: Path) -> None:
        self._path, self._number = path, 0

    def read(self, text: str) -> tuple[list[Vector], list[_Group]]:
        """Return all vertices and the groups with their faces."""
        lines = text.replace("\\\r\n", "  ").replace("\\\n", " ").splitlines()
        by = "o" if any(line.lstrip().startswith("o ") for line in lines) else "g"
        vertices: list[Vector] = []
        current = _Group(_UNNAMED)
        groups = [current]
        known = {_UNNAMED: current}
        for self._number, line in enumerate(lines, 1):
            word, _, rest = line.split("#", 1)[0].strip().partition(" ")
            if word == "v":
                vertices.append(self._vertex(rest))
            elif word == "f":
                current.faces.append(self._face(rest, len(vertices)))
            elif word == by:
                name = rest.strip() or _UNNAMED
                if by == "o" or name not in known:  # a group goes on where its name comes again
                    known[name] = _Group(name)
                    groups.append(known[name])
                current = known[name]
            elif word == "usemtl":
                current.material = current.material or rest.strip()
        return vertices, groups

    def _vertex(self, text: str) -> Vector:
        try:
            x, y, z = (float(word) for word in text.split()[:3])
        except ValueError:
            raise self._wrong("a vertex needs three numbers") from None
        return (x, y, z)

    def _face(self, text: str, vertices_total: int) -> list[int]:
        try:
            stated = [int(corner.split("/", 1)[0]) for corner in text.split()]
        except ValueError:
            raise self._wrong("a face needs whole numbers") from None
        indices = [i - 1 if i > 0 else vertices_total + i for i in stated]
        if len(indices) < _TRIANGLE:
            raise self._wrong("a face needs three corners")
        if not all(0 <= i < vertices_total for i in indices) or 0 in stated:
            raise self._wrong("a face names a vertex that does not stand above it")
        return indices

    def _wrong(self, what: str) -> ModelRejectedError:
        return refused(self._path, "E5", f"Line {self._number}: {what}.", "Export it again.")


def _parts(groups: Sequence[_Group], vertices: Sequence[Vector]) -> Iterator[NeutralPart]:
    seen: Counter[str] = Counter()
    for group in groups:
        if not group.faces:
            continue
        seen[group.name] += 1
        number = seen[group.name]
        used = sorted({i for face in group.faces for i in face})
        index = {old: new for new, old in enumerate(used)}
        yield NeutralPart(
            source_id=group.name if number == 1 else f"{group.name}.{number}",
            kind="object",
            name=group.name,
            material=group.material,
            solids=(
                FacesSolid(
                    vertices=tuple(vertices[i] for i in used),
                    faces=tuple(tuple(index[i] for i in face) for face in group.faces),
                ),
            ),
        )
