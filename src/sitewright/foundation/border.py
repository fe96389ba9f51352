"""From a border library's list of errors to problems with a place, for files of all formats."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from sitewright.errors import Problem, did_you_mean
from sitewright.foundation.canonical import Json

SCHEMA_CODE = "K1"
"""A key is missing or unknown, or its value is of the wrong kind."""
NUMBER_CODE = "K3"
"""A number is NaN, infinite or too large."""

_WIDTH = 60
"""Values in messages are cut to so many characters."""
_FIXES = {
    "missing": "Add it.",
    "extra_forbidden": "Remove it, or put it under 'ext' if the file allows that.",
    "finite_number": "Write a finite number.",
}


def problems_from(
    errors: Iterable[Mapping[str, Any]], root: Json, known_keys: Iterable[str] = ()
) -> list[Problem]:
    """Return one problem per error of a validation, placed by ids instead of list numbers.

    Args:
        errors: Entries with ``loc``, ``msg``, ``type`` and ``input``, as pydantic lists them.
        root: The document that was validated.
        known_keys: All keys of the schema, for suggestions at a misspelt one.
    """
    known = frozenset(known_keys)
    return [_problem(error, root, known) for error in errors]


def place_of(loc: Iterable[str | int], root: Json) -> str:
    """Return a place such as ``components[stud-1].operations[2].fastener``."""
    place, here = "", root
    for step in loc:
        here = _child(here, step)
        if isinstance(step, int):
            identity = here.get("id") if isinstance(here, Mapping) else None
            place += f"[{_cut(identity) if isinstance(identity, str) else step + 1}]"
        else:
            place += f".{_cut(step)}" if place else _cut(step)
    return place or "file"


def _child(value: Json, step: str | int) -> Json:
    if isinstance(step, str):
        return value.get(step) if isinstance(value, Mapping) else None
    if isinstance(value, list) and step < len(value):
        child: Json = value[step]
        return child
    return None


def _problem(error: Mapping[str, Any], root: Json, known: frozenset[str]) -> Problem:
    kind = str(error["type"])
    loc = tuple(error["loc"])
    return Problem(
        code=NUMBER_CODE if kind == "finite_number" else SCHEMA_CODE,
        severity="E",
        where=place_of(loc, root),
        message=_sentence(kind, error, known),
        fix=_FIXES.get(kind, "Correct the value."),
    )


def _sentence(kind: str, error: Mapping[str, Any], known: frozenset[str]) -> str:
    if kind == "missing":
        return "The key is missing."
    if kind == "extra_forbidden":
        return f"The key is not known.{did_you_mean(str(error['loc'][-1]), known)}"
    message = str(error["msg"]).removeprefix("Value error, ").rstrip(".")
    return f"{message}; it is {_shortened(error.get('input'))}."


def _shortened(value: object) -> str:
    return _cut(repr(value))


def _cut(text: str) -> str:
    return text if len(text) <= _WIDTH else f"{text[: _WIDTH - 3]}..."
