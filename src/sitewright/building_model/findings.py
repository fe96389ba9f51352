"""One way to state a problem of a component."""

from __future__ import annotations

from sitewright.building_model.component import Component
from sitewright.errors import Problem


def refused(code: str, component: Component, message: str, fix: str) -> Problem:
    """Return a problem that refuses the model."""
    return _problem("E", code, component, message, fix)


def warned(code: str, component: Component, message: str, fix: str) -> Problem:
    """Return a problem that a person should know of."""
    return _problem("W", code, component, message, fix)


def _problem(severity: str, code: str, component: Component, message: str, fix: str) -> Problem:
    return Problem(
        code=code,
        severity=severity,
        where=component.id,
        message=message,
        fix=fix,
        source_id=component.source.id if component.source else "",
    )
