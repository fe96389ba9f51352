"""Operations that a designer wrote as JSON into an attribute: ``sitewright.ops``."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from pydantic import ValidationError

from sitewright.building_model.component import Operation
from sitewright.building_model.formats.from_file import operation_from
from sitewright.building_model.formats.native_file import OperationFile
from sitewright.building_model.formats.neutral_scale import Scale
from sitewright.building_model.formats.part_names import Directory, Named
from sitewright.building_model.formats.user_text import Attributes
from sitewright.errors import Problem
from sitewright.foundation.border import problems_from
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector, norm, scale, subtract

_AT, _DIRECTION = "at", "direction"
_THREE = 3
_MAX_CHARS = 100_000
_FIX = "Correct 'sitewright.ops'; docs/import.md shows one."


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
    document = _parsed(text)
    if not isinstance(document, list) or not all(isinstance(o, dict) for o in document):
        return (), [_refused(named, "Its operations are no JSON list of objects.")]
    operations: list[Operation] = []
    problems: list[Problem] = []
    for number, entry in enumerate(document, 1):
        try:
            stated = _placed(entry, world_T_component, scaling)
            stated.setdefault("id", f"{named.id[:55]}.op{number}")
            file = OperationFile.model_validate_json(json.dumps(stated, allow_nan=False))
            operation = operation_from(file, named.id)
        except ValidationError as error:
            problems += _schema_problems(named, number, error, stated)
            continue
        except (ValueError, TypeError) as error:
            problems.append(_refused(named, f"Its operation {number}: {error}."))
            continue
        on, said = _resolved(operation, named, directory)
        problems += said
        operations.append(replace(operation, on=on))
    return tuple(operations), problems


def _parsed(text: str) -> Any:  # noqa: ANN401 - JSON of a stranger
    if len(text) > _MAX_CHARS:
        return None
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return None


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
    return (float(value[0]), float(value[1]), float(value[2]))


def _resolved(
    operation: Operation, named: Named, directory: Directory
) -> tuple[tuple[ComponentId, ...], list[Problem]]:
    found = [
        directory.find(name, named, f"Component of operation {operation.id!r}")
        for name in operation.on
    ]
    problems = [f for f in found if isinstance(f, Problem)]
    return tuple(f for f in found if not isinstance(f, Problem)), problems


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
