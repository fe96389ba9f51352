"""What is wrong with a building model by itself: all of it, in one list."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from sitewright.building_model.check_fasteners import fastener_problems
from sitewright.building_model.check_geometry import (
    broken_components,
    geometry_problems,
    scale_problems,
)
from sitewright.building_model.check_references import order_problems, reference_problems
from sitewright.building_model.check_stock import stock_problems
from sitewright.building_model.check_support import support_problems
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.spelling import repetition_problems
from sitewright.errors import Problem

STRUCTURE_CODES = frozenset({"D1", "G6", "I2", "M4", "N1", "P1", "P2", "P3"})
"""With one of these a model has no graph or no shapes, so it is not even read."""

_CHECKS: tuple[Callable[[BuildingModel], Iterable[Problem]], ...] = (
    reference_problems,
    repetition_problems,
    order_problems,
    geometry_problems,
    scale_problems,
    stock_problems,
)
_SHAPE_CHECKS: tuple[Callable[[BuildingModel], Iterable[Problem]], ...] = (
    fastener_problems,
    support_problems,
)


def check_model(model: BuildingModel) -> list[Problem]:
    """Return all problems of a model, errors first, each group by component.

    Checks that need every shape wait until no geometry is degenerate.
    """
    checks = _CHECKS if broken_components(model) else (*_CHECKS, *_SHAPE_CHECKS)
    found = [problem for check in checks for problem in check(model)]
    return sorted(found, key=lambda p: (p.severity, p.where, p.code, p.message))
