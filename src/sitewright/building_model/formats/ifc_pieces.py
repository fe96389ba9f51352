"""Counts the bodies of IFC elements before they are made: maps of maps multiply."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sitewright.building_model.formats.ifc_shapes import body_items
from sitewright.building_model.formats.unreadable import UnreadableError

MAX_BODIES = 20_000
MAX_BODIES_IN_ALL = 200_000


def demand_few_bodies(elements: Iterable[Any]) -> None:
    """Refuse elements whose mapped shapes would become more bodies than any building has.

    Args:
        elements: Untyped entities; their shapes go in no circle.

    Raises:
        UnreadableError: One of them, or all together, hold too many (E2).
    """
    known: dict[int, int] = {}
    total = 0
    for element in elements:
        count = sum(_bodies(item, known) for item in body_items(element))
        total += count
        if count > MAX_BODIES:
            name = f"{element.is_a()} {element.GlobalId}"
            message = f"{name} maps to {_about(count)} bodies, more than {MAX_BODIES}."
            raise UnreadableError("E2", message, "Nest its mapped shapes less.")
        if total > MAX_BODIES_IN_ALL:
            message = f"its elements hold more than {MAX_BODIES_IN_ALL} bodies in all."
            raise UnreadableError("E2", message, "Export a part of it.")


def _bodies(item: Any, known: dict[int, int]) -> int:  # noqa: ANN401 - untyped entity
    if not item.is_a("IfcMappedItem"):
        return 1
    source = item.MappingSource.MappedRepresentation
    if source.id() not in known:
        known[source.id()] = sum(_bodies(i, known) for i in source.Items)
    return known[source.id()]


def _about(count: int) -> str:
    return str(count) if count < 10**9 else f"{float(min(count, 10**300)):.0e}"
