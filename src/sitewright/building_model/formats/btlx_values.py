"""Numbers in BTLx attributes and elements; what is none stays visible as NaN."""

from __future__ import annotations

import math

from sitewright.building_model.formats.xml_tree import XmlNode
from sitewright.foundation.pose import Vector

_LARGEST = 1e12


def number(text: str | None, default: float = math.nan) -> float:
    """Return a number; NaN if the text is none, or `default` if there is no text."""
    if text is None:
        return default
    try:
        value = float(text)
    except ValueError:
        return math.nan
    return value if abs(value) < _LARGEST else math.nan


def whole(text: str | None, default: int) -> int | None:
    """Return a whole number, `default` without a text, None if the text is no such number."""
    try:
        return int(text) if text else default
    except ValueError:
        return None


def element_number(node: XmlNode, tag: str, default: float) -> float:
    """Return the number in a child element; NaN if its text is none."""
    child = node.child(tag)
    return default if child is None else number(child.text.strip())


def point(node: XmlNode | None) -> Vector | None:
    """Return the X, Y, Z of an element; None if one is missing or no number."""
    if node is None:
        return None
    x, y, z = (number(node.attributes.get(key)) for key in ("X", "Y", "Z"))
    return (x, y, z) if all(math.isfinite(v) for v in (x, y, z)) else None
