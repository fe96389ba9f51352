"""Which piece of stock may become which target."""

from __future__ import annotations

from sitewright.building_model.component import Component
from sitewright.building_model.shapes import size_of

LENGTH_TOLERANCE_M = 0.002
SECTION_TOLERANCE_M = 0.0005

MaterialType = tuple[str, tuple[float, float], float, str]
"""Type, section (m, sorted), length (m) and material, which may be empty."""


def material_type_of(component: Component) -> MaterialType:
    """Return what a piece is, or what a target needs: the length runs along x."""
    length, width, height = (round(s, 7) for s in size_of(component))
    section = (min(width, height), max(width, height))
    return (component.type, section, length, component.material)


def fits(piece: MaterialType, wanted: MaterialType) -> bool:
    """Return whether a piece may become a target; an empty wanted material takes any."""
    return (
        piece[0] == wanted[0]
        and is_section_equal(piece[1], wanted[1])
        and abs(piece[2] - wanted[2]) <= LENGTH_TOLERANCE_M
        and wanted[3] in ("", piece[3])
    )


def is_section_equal(a: tuple[float, float], b: tuple[float, float]) -> bool:
    """Return whether two sorted sections are equal within tolerance."""
    return all(abs(x - y) <= SECTION_TOLERANCE_M for x, y in zip(a, b, strict=True))
