"""Typed lists of PDDL: ``?a ?b - type``."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.symbolic_planning.domain import OBJECT, Parameter
from sitewright.symbolic_planning.pddl_syntax import Group, PddlError, Symbol


def typed_list(items: Iterable[Symbol | Group], file: str) -> list[Parameter]:
    """Return ``a b - t c`` as parameters; without a type it is ``object``."""
    found: list[Parameter] = []
    waiting: list[Symbol] = []
    words = iter(items)
    for item in words:
        if isinstance(item, Group):
            raise PddlError(file, item.line, f"'{item.head or '('}' is not supported here")
        if item.text != "-":
            waiting.append(item)
            continue
        type_item = next(words, None)
        if not isinstance(type_item, Symbol):
            named = type_item.head if isinstance(type_item, Group) else "-"
            raise PddlError(file, item.line, f"'{named}' is not supported as a type")
        found.extend(Parameter(word.text, type_item.text, word.line) for word in waiting)
        waiting = []
    return [*found, *(Parameter(word.text, OBJECT, word.line) for word in waiting)]


def check_types(
    parameters: Iterable[Parameter], known: Iterable[str], file: str, line: int
) -> None:
    """Refuse a parameter whose type was not declared.

    Raises:
        PddlError: Naming the type and the known ones.
    """
    names = {*known, OBJECT}
    for parameter in parameters:
        if parameter.type not in names:
            listed = ", ".join(sorted(names))
            raise PddlError(file, line, f"type '{parameter.type}' is not declared; known: {listed}")
