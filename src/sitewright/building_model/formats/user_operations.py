"""Operations that a designer wrote as JSON into an attribute: ``sitewright.ops``."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from sitewright.building_model.component import Operation
from sitewright.building_model.formats.from_file import operation_from
from sitewright.building_model.formats.json_text import parse
from sitewright.building_model.formats.native_file import OperationFile
from sitewright.building_model.formats.neutral_scale import Scale
from sitewright.building_model.formats.part_names import Directory, Named
from sitewright.building_model.formats.user_text import Attributes
from sitewright.errors import Problem
from sitewright.foundation.border import problems_from
from sitewright.foundation.pose import Pose, Vector, norm, scale, subtract

_AT, _DIRECTION = "at", "direction"
_THREE = 3
_LARGEST = 1e12
_MAX_CHARS = 100_000
_KEY = "sitewright.ops"
_FIX = f"Correct {_KEY!r}; docs/import.md shows one."


def operations_of(
    named: Named,
    attributes: Attributes,
    world_T_component: Pose,
    scaling: Scale,
    directory: Directory,
) -> tuple[tuple[Operation, ...], list[Problem]]:
    """Return the operations that an attribute states, and what is wrong with them.

    The text is a JSON list of operations as in ``building.json``. Instead of
    ``component_T_operation`` an operation may state ``at`` (a point) and ``direction``, both in
    the drawing's own coordinates; without an ``id`` it gets one; ``on`` takes ids or names.
    """
    text = attributes.get("ops")
    if not text:
        return (), []
    entries, problems = _entries(text, named)
    operations: list[Operation] = []
    for number, entry in enumerate(entries, 1):
        stated, said = _resolved(entry, number, named, directory)
        operation, wrong = _operation(stated, number, named, world_T_component, scaling)
        problems += [*said, *wrong]
        operations += operation
    return tuple(operations), problems


def _entries(text: str, named: Named) -> tuple[list[dict[str, Any]], list[Problem]]:
    if len(text) > _MAX_CHARS:
        message = f"Its operations are longer than {_MAX_CHARS} characters."
        return [], [_refused(named, message)]
    document, wrong = parse(text, Path(_KEY))
    if wrong:
        return [], [_refused(named, f"Its operations: {p.message}", p.code) for p in wrong]
    if not isinstance(document, list) or not all(isinstance(o, dict) for o in document):
        return [], [_refused(named, "Its operations are no JSON list of objects.")]
    return document, []


def _resolved(
    entry: Mapping[str, Any], number: int, named: Named, directory: Directory
) -> tuple[dict[str, Any], list[Problem]]:
    """Return an operation with ids instead of names, and the names that nobody knows."""
    on = entry.get("on")
    if not isinstance(on, list) or not all(isinstance(name, str) for name in on):
        return dict(entry), []
    found = [directory.find(n, named, f"Component of operation {number}") for n in on]
    ids = [f for f in found if not isinstance(f, Problem)]
    return {**entry, "on": ids}, [f for f in found if isinstance(f, Problem)]


def _operation(
    entry: Mapping[str, Any], number: int, named: Named, pose: Pose, scaling: Scale
) -> tuple[list[Operation], list[Problem]]:
    try:
        stated = _placed(entry, pose, scaling)
        stated.setdefault("id", f"{named.id[:55]}.op{number}")
        file = OperationFile.model_validate_json(json.dumps(stated))
    except ValidationError as error:
        return [], list(_schema_problems(named, number, error, stated))
    except ValueError as error:
        return [], [_refused(named, f"Its operation {number}: {error}.")]
    return [operation_from(file, named.id)], []


def _placed(entry: Mapping[str, Any], pose: Pose, scaling: Scale) -> dict[str, Any]:
    stated = dict(entry)
    if _AT not in stated and _DIRECTION not in stated:
        return stated
    if "component_T_operation" in stated:
        raise ValueError(f"state either {_AT!r} or 'component_T_operation'")
    at, direction = (_vector(stated.pop(key, None), key) for key in (_AT, _DIRECTION))
    if not norm(direction) > 0.0:
        raise ValueError(f"its {_DIRECTION!r} has no length")
    point = subtract(scale(at, scaling.metres), scaling.shift_m)
    world_T_operation = Pose.from_z_axis(point, direction)
    here = pose.inverse() @ world_T_operation
    stated["component_T_operation"] = {
        "p_m": list(here.position_m),
        "q_wxyz": list(here.quaternion_wxyz),
    }
    return stated


def _vector(value: object, key: str) -> Vector:
    if not isinstance(value, list) or len(value) != _THREE:
        raise ValueError(f"its {key!r} is no list of three numbers")
    if not all(isinstance(v, int | float) and not isinstance(v, bool) for v in value):
        raise ValueError(f"its {key!r} is no list of three numbers")
    if max(map(abs, value)) > _LARGEST:
        raise ValueError(f"its {key!r} is no place in a building")
    return (float(value[0]), float(value[1]), float(value[2]))


def _schema_problems(
    named: Named, number: int, error: ValidationError, stated: Mapping[str, Any]
) -> Iterator[Problem]:
    known = OperationFile.model_fields
    for problem in problems_from(error.errors(), dict(stated), known):
        message = f"Its operation {number}, {problem.where}: {problem.message}"
        yield _refused(named, message, problem.code)


def _refused(named: Named, message: str, code: str = "K1") -> Problem:
    return Problem(
        code=code,
        severity="E",
        where=named.id,
        message=message,
        fix=_FIX,
        source_id=named.source_id,
    )
