"""Asks rhino3dm what a .3dm file holds: records of JSON, numbers in the file's own unit.

Runs in a child process (`foreign_files`), since the library may crash on a bad file.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

from sitewright.building_model.formats.unreadable import UnreadableError

_MAX_PARTS = 50_000
_MAX_OBJECTS = 200_000
_MAX_FACES = 20_000_000
_SOLIDS = ("Extrusion", "Brep", "Mesh")
_MADE_BY_RHINO = "$"
_SMALLEST_TOLERANCE = 1e-7


def open_file(path: str) -> Any:  # noqa: ANN401 - untyped library throughout
    """Return the opened file.

    Raises:
        UnreadableError: The library is missing, or the file is damaged.
    """
    try:
        import rhino3dm
    except ImportError as error:
        fix = "Run: pip install 'sitewright[rhino]'"
        raise UnreadableError("E2", f"rhino3dm cannot be loaded: {error}.", fix) from None
    model = rhino3dm.File3dm.Read(path)  # None, no exception, for whatever it cannot read
    if model is None:
        fix = "Open it in Rhino, run Audit, save it again."
        raise UnreadableError("E2", "rhino3dm cannot read it; it is damaged.", fix)
    return model


def read(path: str) -> dict[str, Any]:
    """Return unit, parts and notes of a .3dm file."""
    model = open_file(path)
    left_out: Counter[str] = Counter()
    _demand_few_objects(model)
    parts: list[dict[str, Any]] = []
    faces = 0
    for thing in model.Objects:
        if not _is_in_the_world(thing):
            continue
        kind = type(thing.Geometry).__name__
        if kind not in (*_SOLIDS, "InstanceReference"):
            left_out[kind] += 1
            continue
        part = _part(model, thing)
        parts.append(part)
        faces += sum(len(s.get("faces", ())) for s in part["solids"])
        _demand_bounds(len(parts), faces)
    return {
        "unit": model.Settings.ModelUnitSystem.name,
        "parts": parts,
        "notes": [f"{n} x {kind}: no solid; left out." for kind, n in sorted(left_out.items())],
    }


def _is_in_the_world(thing: Any) -> bool:  # noqa: ANN401
    import rhino3dm

    attributes = thing.Attributes
    is_on_paper = attributes.ActiveSpace == rhino3dm.ActiveSpace.PageSpace
    return not (attributes.IsInstanceDefinitionObject or is_on_paper)


def _demand_bounds(parts: int, faces: int) -> None:
    for count, most, what in ((parts, _MAX_PARTS, "objects"), (faces, _MAX_FACES, "faces in all")):
        if count > most:
            raise UnreadableError("E2", f"it holds more than {most} {what}.", "Export a part.")


def _demand_few_objects(model: Any) -> None:  # noqa: ANN401
    """Refuse a file whose few blocks would become more solids than any building has."""
    from sitewright.building_model.formats.rhino_blocks import BadBlockError, objects_in

    known: dict[str, int] = {}
    total = 0
    for thing in model.Objects:
        if _is_in_the_world(thing):
            with suppress(BadBlockError):  # told with its part
                total += objects_in(model, thing, known)
    if total > _MAX_OBJECTS:
        message = f"its blocks put {total} objects into the world, more than {_MAX_OBJECTS}."
        raise UnreadableError("E2", message, "Nest blocks less, or export a part of it.")


def _part(model: Any, thing: Any) -> dict[str, Any]:  # noqa: ANN401
    attributes = thing.Attributes
    groups = _groups(model, attributes)
    text = {**_text(thing.Geometry), **_text(attributes)}
    block = _block(model, thing)
    if block is not None:
        text = {**_text(block), **text}
    solids, problems = _solids(model, thing)
    formulas = sorted(key for key, value in text.items() if "%<" in value and ">%" in value)
    if formulas:
        said = ", ".join(repr(k) for k in formulas)
        fix = "Write the value itself where it matters."
        problems.append(["T1", f"{said}: Rhino formulas; they are not evaluated.", fix])
    return {
        "source_id": str(attributes.Id),
        "is_block": block is not None,
        "name": str(attributes.Name or ""),
        "layer_path": _layer_path(model, attributes),
        "type": str(block.Name) if block is not None else "",
        "group": groups[-1] if groups else "",
        "solids": solids,
        "user_text": text,
        "raw": _raw(model, thing, block, groups),
        "problems": problems,
    }


def _solids(model: Any, thing: Any) -> tuple[list[Any], list[list[str]]]:  # noqa: ANN401
    from sitewright.building_model.formats.rhino_blocks import BadBlockError, pieces_of
    from sitewright.building_model.formats.rhino_shapes import (
        CHORDS_PER_TURN,
        NoSolidError,
        is_round,
        solid_of,
    )

    tolerance = max(float(model.Settings.ModelAbsoluteTolerance), _SMALLEST_TOLERANCE)
    solids, problems = [], []
    try:
        pieces = pieces_of(model, thing)
    except BadBlockError as error:
        return [], [error.problem]
    for piece in pieces:
        geometry = piece.thing.Geometry
        if type(geometry).__name__ not in _SOLIDS:
            continue
        try:
            solids.append(solid_of(geometry, piece.place, tolerance))
        except NoSolidError as error:
            problems.append(error.problem)
    if any(is_round(p.thing.Geometry) for p in pieces):
        fix = "Make it a polygon if its tenths of a millimetre matter."
        said = f"its round profile is read as chords, {CHORDS_PER_TURN} per turn."
        problems.append(["G7", said, fix])
    if not solids and not problems:
        problems.append(["G7", "its block holds no solid; it is left out.", "Put solids into it."])
    return solids, problems


def _block(model: Any, thing: Any) -> Any:  # noqa: ANN401
    if type(thing.Geometry).__name__ != "InstanceReference":
        return None
    return model.InstanceDefinitions.FindId(str(thing.Geometry.ParentIdefId))


def _text(holder: Any) -> dict[str, str]:  # noqa: ANN401
    pairs: Any = holder.GetUserStrings()
    return {str(k): str(v) for k, v in pairs if not str(k).startswith(_MADE_BY_RHINO)}


def entry_at(table: Any, index: int) -> Any:  # noqa: ANN401
    """Return the entry of a table by its own index, None without one; rhino3dm may raise."""
    try:
        return table.FindIndex(index)
    except IndexError:
        return None


def _layer_path(model: Any, attributes: Any) -> str:  # noqa: ANN401
    layer = entry_at(model.Layers, attributes.LayerIndex)
    return str(layer.FullPath) if layer is not None else ""


def _groups(model: Any, attributes: Any) -> list[str]:  # noqa: ANN401
    """Return the names of its groups, the innermost first."""
    names = []
    for index in attributes.GetGroupList():
        group = entry_at(model.Groups, index)
        names.append(str(group.Name) if group is not None and group.Name else f"group {index}")
    return names


def _raw(
    model: Any,  # noqa: ANN401
    thing: Any,  # noqa: ANN401
    block: Any,  # noqa: ANN401
    groups: list[str],
) -> Mapping[str, Any]:
    attributes = thing.Attributes
    render_material = ""
    if 0 <= attributes.MaterialIndex < len(model.Materials):
        render_material = str(model.Materials[attributes.MaterialIndex].Name or "")
    facts = {
        "block": str(block.Name) if block is not None else "",
        "groups": groups if len(groups) > 1 else [],
        "hidden": not attributes.Visible,
        "render_material": render_material,
        "url": str(attributes.Url or ""),
    }
    return {key: value for key, value in facts.items() if value}
