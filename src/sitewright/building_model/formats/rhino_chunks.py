"""The tables of a .3dm file by their size, read from its outermost chunks without any library."""

from __future__ import annotations

from collections.abc import Mapping

_HEADER = 32
_VERSION = slice(24, _HEADER)
_WIDE_SINCE = 50
"""Archives of this version on write lengths in eight bytes instead of four."""
_NO_BODY = 0x80000000
_END_OF_FILE = 0x00007FFF
_NAMES: Mapping[int, str] = {
    0x00000001: "comments",
    0x10000010: "materials",
    0x10000011: "layers",
    0x10000012: "lights",
    0x10000013: "objects",
    0x10000014: "file properties (preview image, notes, revision)",
    0x10000015: "settings (views, grids, render settings)",
    0x10000016: "bitmaps",
    0x10000017: "plug-in data",
    0x10000018: "groups",
    0x10000019: "fonts",
    0x10000020: "dimension styles",
    0x10000021: "block definitions",
    0x10000022: "hatch patterns",
    0x10000023: "linetypes",
    0x10000025: "texture mappings",
    0x10000026: "construction history",
}


class CutOffError(ValueError):
    """The file does not reach its own end mark."""


def table_sizes(content: bytes) -> dict[str, int]:
    """Return the bytes of each table of a .3dm file, in file order.

    Raises:
        CutOffError: The chunks do not lead to the end mark.
    """
    sizes: dict[str, int] = {}
    try:
        wide = 8 if int(content[_VERSION]) >= _WIDE_SINCE else 4
    except ValueError:
        raise CutOffError("the header names no version") from None
    position = _HEADER
    while position + 4 + wide <= len(content):
        code = int.from_bytes(content[position : position + 4], "little")
        position += 4
        length = int.from_bytes(content[position : position + wide], "little", signed=True)
        position += wide
        if code == _END_OF_FILE and position + length <= len(content):
            return sizes
        if code & _NO_BODY:
            continue
        if length < 0:
            break
        name = _NAMES.get(code, f"table {code:#x}")
        sizes[name] = sizes.get(name, 0) + length
        position += length
    raise CutOffError(f"{len(content)} bytes, no end mark")
