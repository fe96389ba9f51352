"""Child side of the compas_timber importer: file in, neutral records out as JSON.

Runs as ``python -m`` under `import_process`; numbers stay in the file's own unit.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from typing import Any

from sitewright.building_model.formats.import_process import limit_own_resources

_MAX_DEPTH = 32
_TRUSTED = ("compas.", "compas_timber.", "compas_model.")


class UnreadableError(Exception):
    """The file as a whole cannot be used; carries code, message and fix."""

    def __init__(self, code: str, message: str, fix: str) -> None:
        super().__init__(message)
        self.answer = {"code": code, "message": message, "fix": fix}


def main(limits: str, path: str) -> None:
    """Print the records of `path`, or why there are none, as one JSON document."""
    limit_own_resources(limits)
    answer_to = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # what libraries print is no part of the answer
    try:
        answer: dict[str, Any] = read(path)
    except UnreadableError as error:
        answer = {"refused": error.answer}
    with answer_to:
        json.dump(answer, answer_to, allow_nan=False)


def read(path: str) -> dict[str, Any]:
    """Return parts, joints, warnings of a compas_timber model."""
    _demand_trusted(_parse(path))
    model = _load(path)
    errors = model.process_joinery()
    parts, left_out = [], []
    for element in model.elements():
        if hasattr(element, "blank") and hasattr(element, "centerline"):
            parts.append(_part(element))
        else:
            left_out.append([str(element.guid), type(element).__name__])
    return {
        "parts": [p for p, _ in parts],
        "joints": [_joint(j) for j in model.joints],
        "left_out": left_out,
        "unknown_features": [f for _, features in parts for f in features],
        "joinery_errors": [str(getattr(e, "debug_info", None) or e)[:300] for e in errors],
    }


def _parse(path: str) -> Any:  # noqa: ANN401 - JSON of a stranger
    with open(path, encoding="utf-8-sig") as file:  # noqa: PTH123 - kept small: no pathlib here
        try:
            text = file.read()
            document = json.loads(text, parse_constant=_no_constant)
        except UnicodeDecodeError as error:
            raise UnreadableError("E5", f"it is no UTF-8 text: {error}.", "Export again.") from None
        except RecursionError:
            raise UnreadableError("E2", "it is nested too deeply.", "Export it again.") from None
        except json.JSONDecodeError as error:
            raise _broken(error, text) from None
    return document


def _no_constant(name: str) -> float:
    raise UnreadableError("E2", f"it holds the number {name}.", "Repair the model, export again.")


def _broken(error: json.JSONDecodeError, text: str) -> UnreadableError:
    place = f"line {error.lineno}, column {error.colno}"
    if error.pos >= len(text.rstrip()) or error.msg.startswith("Unterminated"):
        return UnreadableError(
            "E4", f"it is cut off at {place} (the JSON does not end).", "Copy or export it again."
        )
    return UnreadableError("E5", f"it is no JSON at {place}: {error.msg}.", "Export it again.")


def _demand_trusted(document: Any) -> None:  # noqa: ANN401 - JSON of a stranger
    """Refuse types that would make the library import foreign modules, and deep nesting."""
    for depth, value in _values(document):
        if depth > _MAX_DEPTH:
            raise UnreadableError("E2", f"nested deeper than {_MAX_DEPTH}.", "Export it again.")
        if not isinstance(value, dict):
            continue
        names = [value.get("dtype"), *(value.get("inheritance") or [])]
        strange = [n for n in names if n is not None and not str(n).startswith(_TRUSTED)]
        if strange:
            raise UnreadableError(
                "E2",
                f"it holds objects of type {strange[0]!r}, which is not compas_timber's.",
                "Remove them from the model and export it again.",
            )


def _values(document: Any) -> Iterator[tuple[int, Any]]:  # noqa: ANN401
    waiting = [(1, document)]
    while waiting:
        depth, value = waiting.pop()
        yield depth, value
        if isinstance(value, dict):
            waiting += [(depth + 1, v) for v in value.values()]
        elif isinstance(value, list):
            waiting += [(depth + 1, v) for v in value]


def _load(path: str) -> Any:  # noqa: ANN401 - untyped library
    if find_spec("compas_timber") is None:
        raise UnreadableError(
            "E2", "compas_timber is not installed.", "Run: pip install 'sitewright[timber]'"
        )
    try:
        import compas
        from compas_timber.model import TimberModel
    except ImportError as error:  # also what little memory looks like
        raise UnreadableError(
            "E2", f"the reader cannot load compas_timber: {error}.", "Reinstall it, or free memory."
        ) from None
    try:
        model = compas.json_load(path)
    except Exception as error:  # noqa: BLE001 - whatever the library meets in a bad file
        kind = type(error).__name__
        raise UnreadableError(
            "E2", f"compas_timber cannot read it: {kind}: {error}.", "Export it again."
        ) from None
    if not isinstance(model, TimberModel):
        raise UnreadableError(
            "E3",
            f"it holds a {type(model).__name__}, expected a TimberModel.",
            "Export the whole timber model.",
        )
    return model


def _part(element: Any) -> tuple[dict[str, Any], list[list[str]]]:  # noqa: ANN401
    blank = element.blank
    cuts, unknown = [], []
    for feature in element.features:
        if hasattr(feature, "plane_from_params_and_beam"):
            plane = feature.plane_from_params_and_beam(element)
            cuts.append([list(plane.point), list(plane.normal)])
        else:
            unknown.append([str(element.guid), type(feature).__name__])
    attributes = {k: v for k, v in element.attributes.items() if isinstance(v, str | float | int)}
    part = {
        "guid": str(element.guid),
        "name": str(element.name or ""),
        "attributes": attributes,
        "size": [blank.xsize, blank.ysize, blank.zsize],
        "point": list(blank.frame.point),
        "x_axis": list(blank.frame.xaxis),
        "y_axis": list(blank.frame.yaxis),
        "cuts": cuts,
    }
    return part, unknown


def _joint(joint: Any) -> dict[str, Any]:  # noqa: ANN401
    location = getattr(joint, "location", None)
    return {
        "type": type(joint).__name__,
        "elements": [str(e.guid) for e in joint.elements],
        "location": list(location) if location is not None else None,
    }


if __name__ == "__main__":
    main(*sys.argv[1:])
