"""Asks compas_timber what a timber model holds: records of JSON, numbers in the file's own unit.

Runs in a child process (`foreign_files`), since the library runs what its files name.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from sitewright.building_model.formats.foreign_json import read_json
from sitewright.building_model.formats.unreadable import UnreadableError

_TRUSTED = ("compas.", "compas_timber.", "compas_model.")


def read(path: str) -> dict[str, Any]:
    """Return parts, joints, warnings of a compas_timber model."""
    _demand_trusted(read_json(Path(path)))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the library's own use of what it deprecates
        return _records(_load(path))


def _records(model: Any) -> dict[str, Any]:  # noqa: ANN401 - untyped library
    errors = _said(model.process_joinery, "its joints")
    parts, left_out = [], []
    for element in model.elements():
        if hasattr(element, "blank") and hasattr(element, "centerline"):
            parts.append(_said(partial(_part, element), f"beam {element.guid}"))
        else:
            left_out.append([str(element.guid), type(element).__name__])
    return {
        "parts": [p for p, _ in parts],
        "joints": [_said(partial(_joint, joint), "a joint") for joint in model.joints],
        "left_out": left_out,
        "unknown_features": [f for _, features in parts for f in features],
        "joinery_errors": [str(getattr(e, "debug_info", None) or e)[:300] for e in errors],
    }


def _said(ask: Callable[[], Any], about: str) -> Any:  # noqa: ANN401 - untyped library
    """Return what the library says; whatever it raises is a refusal that names the place."""
    try:
        return ask()
    except MemoryError:
        raise
    except Exception as error:  # noqa: BLE001 - of a bad file
        said = f"{type(error).__name__}: {str(error)[:200]}".rstrip(".")
        message = f"compas_timber cannot work out {about} ({said})."
        raise UnreadableError(
            "E2", message, "Repair it in the model and export it again."
        ) from None


def _demand_trusted(document: Any) -> None:  # noqa: ANN401 - JSON of a stranger
    """Refuse types that would make the library import foreign modules."""
    waiting = [document]
    while waiting:
        value = waiting.pop()
        if isinstance(value, list):
            waiting += value
        if not isinstance(value, dict):
            continue
        waiting += value.values()
        inherited = value.get("inheritance")
        names = [value.get("dtype"), *(inherited if isinstance(inherited, list) else [])]
        strange = [n for n in names if n is not None and not str(n).startswith(_TRUSTED)]
        if strange:
            raise UnreadableError(
                "E2",
                f"it holds objects of type {strange[0]!r}, which is not compas_timber's.",
                "Remove them from the model and export it again.",
            )


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
        model = compas.json_loads(Path(path).read_text(encoding="utf-8-sig"))
    except Exception as error:  # noqa: BLE001 - whatever the library meets in a bad file
        kind = type(error).__name__
        raise UnreadableError(
            "E2", f"compas_timber cannot read it: {kind}: {str(error)[:200]}.", "Export it again."
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
