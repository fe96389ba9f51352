"""The points of a mesh file (.obj, .stl): all that its convex hull needs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]
"""One point per row."""

_STL_HEADER = 84
_STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def read_points(path: Path) -> Points:
    """Return the different points of a mesh in the file's own unit.

    A file that cannot be read is an OSError; one that is no such mesh, a ValueError.
    """
    readers = {".obj": _read_obj, ".stl": _read_stl}
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise ValueError(f"meshes of type {path.suffix or 'without suffix'} are not read")
    points = reader(path.read_bytes())
    if len(points) == 0:
        raise ValueError("the mesh has no points")
    if not np.isfinite(points).all():
        raise ValueError("the mesh has points that are not finite")
    return np.unique(points, axis=0)


def _read_obj(data: bytes) -> Points:
    return _words_after("v", data)


def _read_stl(data: bytes) -> Points:
    count = int.from_bytes(data[_STL_HEADER - 4 : _STL_HEADER], "little")
    if len(data) == _STL_HEADER + count * _STL_TRIANGLE.itemsize:
        triangles = np.frombuffer(data, dtype=_STL_TRIANGLE, offset=_STL_HEADER)
        return triangles["corners"].reshape(-1, 3).astype(np.float64)
    if not data.lstrip().startswith(b"solid"):
        raise ValueError("the .stl file is cut off, or no .stl at all")
    return _words_after("vertex", data)


def _words_after(keyword: str, data: bytes) -> Points:
    rows = [line.split() for line in data.decode("utf-8", errors="replace").splitlines()]
    points = [row[1:4] for row in rows if row and row[0] == keyword]
    if any(len(point) != 3 for point in points):  # noqa: PLR2004
        raise ValueError(f"a {keyword!r} line has fewer than three numbers")
    return np.array(points, dtype=np.float64).reshape(-1, 3)
