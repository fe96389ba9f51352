"""What kind of building file lies there, told by its first bytes and not by its name."""

from __future__ import annotations

import stat
from enum import StrEnum
from pathlib import Path

from sitewright.errors import ModelRejectedError, Problem

MAX_FILE_BYTES = 200_000_000
MAX_JSON_BYTES = 100_000_000
_LFS = b"version https://git-lfs.github.com/spec/"
_OBJ_WORDS = frozenset(
    {b"v", b"vn", b"vt", b"vp", b"f", b"l", b"p", b"o", b"g", b"s", b"mtllib", b"usemtl"}
)

_MARKS = (
    (b"PK\x03\x04", "a ZIP archive, which must be unpacked first"),
    (b"\x1f\x8b", "a gzip archive, which must be unpacked first"),
    (b"BZh", "a bzip2 archive, which must be unpacked first"),
    (b"\xfd7zXZ", "an xz archive, which must be unpacked first"),
    (b"7z\xbc\xaf", "a 7-Zip archive, which must be unpacked first"),
    (b"\xff\xfe", "UTF-16 text, which must be saved as UTF-8"),
    (b"\xfe\xff", "UTF-16 text, which must be saved as UTF-8"),
)


class FileKind(StrEnum):
    """The kinds that are told apart; ``json`` and ``unknown`` have no reader."""

    NATIVE = "native"
    COMPAS_TIMBER = "compas_timber"
    COMPAS_ASSEMBLY = "compas_assembly"
    BAR_FRAME = "bar_frame"
    JSON = "json"
    RHINO = "rhino"
    IFC = "ifc"
    BTLX = "btlx"
    OBJ = "obj"
    UNKNOWN = "unknown"


def read_limited(path: Path) -> bytes:
    """Return the bytes of a file that may be a building.

    Raises:
        ModelRejectedError: It is missing, no file, empty, too large or a Git LFS pointer.
    """
    size = _size(path)
    if size == 0:
        raise refused(path, "E2", "the file is empty.", "Export it again.")
    if size > MAX_FILE_BYTES:
        raise refused(
            path,
            "E2",
            f"the file has {size / 1e6:.0f} MB, more than {MAX_FILE_BYTES / 1e6:.0f}.",
            "Export only the part that is to be built.",
        )
    try:
        content = path.read_bytes()
    except OSError as error:
        raise _unreadable(path, error) from None
    if content.startswith(_LFS):
        raise refused(path, "E2", "the file is a Git LFS pointer.", "Run: git lfs pull")
    return content


def _size(path: Path) -> int:
    try:
        status = path.stat()
    except FileNotFoundError:
        raise refused(path, "E2", "there is no such file.", "Check the path.") from None
    except OSError as error:
        raise _unreadable(path, error) from None
    if not stat.S_ISREG(status.st_mode):
        raise refused(path, "E2", "it is no ordinary file.", "Name the file of the design itself.")
    return status.st_size


def _unreadable(path: Path, error: OSError) -> ModelRejectedError:
    reason = error.strerror or str(error)
    return refused(path, "E2", f"it cannot be read: {reason}.", "Check the path and its rights.")


def kind_of(content: bytes) -> FileKind:
    """Return the kind of a file by its content."""
    head = content[:4096].removeprefix(b"\xef\xbb\xbf").lstrip()
    if head.startswith(b"3D Geometry File Format"):
        return FileKind.RHINO
    if head.startswith(b"ISO-10303-21"):
        return FileKind.IFC
    if head.startswith(b"<"):
        return FileKind.BTLX if b"design2machine" in content else FileKind.UNKNOWN
    if head.startswith(b"{"):
        return _json_kind(content)
    return FileKind.OBJ if _looks_like_obj(head) else FileKind.UNKNOWN


def looks_like(content: bytes) -> str:
    """Return what a file without a reader is, in words."""
    for mark, words in _MARKS:
        if content.startswith(mark):
            return words
    return str(kind_of(content))


def refused(path: Path, code: str, message: str, fix: str) -> ModelRejectedError:
    """Return the error of a file that has one problem as a whole."""
    problem = Problem(code=code, severity="E", where=path.name, message=message, fix=fix)
    return ModelRejectedError(str(path), [problem])


def _json_kind(content: bytes) -> FileKind:
    if b'"sitewright.building/' in content:
        return FileKind.NATIVE
    if b'"compas_timber.' in content:
        return FileKind.COMPAS_TIMBER
    if b'"compas_assembly.' in content:
        return FileKind.COMPAS_ASSEMBLY
    if b'"node_list"' in content and b'"element_list"' in content:
        return FileKind.BAR_FRAME
    return FileKind.JSON


def _looks_like_obj(head: bytes) -> bool:
    """Whether the first lines, comments aside, begin with words of that format."""
    lines = [line.split(b"#", 1)[0].split() for line in head.splitlines()[:-1]]
    words = [line[0] for line in lines if line]
    return bool(words) and all(word in _OBJ_WORDS for word in words)
