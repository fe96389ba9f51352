"""Child side of the Rhino export: writes status and layers into a copy, tells what it lost.

Runs in a child process (`import_process`); its argument is a request: ``original``, ``copy``,
``status`` (the entries of ``status.json`` to write, by object id), ``role_by_name`` (the user's
names of our layers).
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from sitewright.building_model.component import Layer
from sitewright.building_model.formats.import_map import PREFIX
from sitewright.building_model.formats.layer_rules import LayerNames
from sitewright.building_model.formats.unreadable import UnreadableError

USED_LAYER = "Consumed"
"""Layer of stock that was used."""
_BETWEEN = "::"
_TABLES = (
    *("Views", "NamedViews", "Materials", "Linetypes", "DimStyles", "Groups", "Layers"),
    *("InstanceDefinitions", "Strings", "Bitmaps", "RenderContent", "EmbeddedFiles", "PlugInData"),
)
_WIDE = 50
"""Rhino 5 and newer write their version times ten."""


def patch_as_asked(request: str) -> dict[str, Any]:
    """Write the copy that a request file asks for; what the child process runs.

    Raises:
        ModelRejectedError: The original cannot be read, or the copy cannot be written.
    """
    question = json.loads(Path(request).read_text(encoding="utf-8"))
    try:
        return patch(question)
    except UnreadableError as error:
        raise error.of(Path(question["original"])) from None


def patch(request: Mapping[str, Any]) -> dict[str, Any]:
    """Write the copy and return ids written, ids not found, and losses as sentences."""
    from sitewright.building_model.formats.rhino_reader import open_file

    model = open_file(request["original"])
    names = LayerNames(
        role_by_name={word: Layer(role) for word, role in request["role_by_name"].items()}
    )
    before = _Contents(model)
    thing_by_id = {str(o.Attributes.Id): o for o in model.Objects}
    written, missing = [], []
    for identity, state in sorted(request["status"].items()):
        if identity not in thing_by_id:
            missing.append(identity)
            continue
        _mark(model, thing_by_id[identity], state, names)
        written.append(identity)
    tables = dict(before.tables)
    tables["Layers"] = len(model.Layers)  # new ones are no difference
    version = model.ArchiveVersion // 10 if model.ArchiveVersion >= _WIDE else model.ArchiveVersion
    if not model.Write(request["copy"], version):
        raise UnreadableError("E2", "rhino3dm cannot write the copy.", "Use apply_status.py.")
    after = _Contents(open_file(request["copy"]))
    return {
        "written": written,
        "missing": missing,
        "losses": [*_losses(before, after, tables), *_unmarked(after, request, written)],
    }


def new_path(path: str, label: str, names: LayerNames) -> str:
    """Return the layer path of an object whose role changed; type and group layers stay.

    Args:
        path: Its layer path now.
        label: Name of the layer of its new role; a layer of the user's with that role is kept,
            but for stock that was used, which no layer of a design is for.
        names: The user's own names of our layers.
    """
    segments = path.split(_BETWEEN) if path else []
    for index in reversed(range(len(segments))):
        found = names.role_of(segments[index].partition("[")[0].strip())
        if found is not None:
            is_there = found is names.role_of(label) and label != USED_LAYER
            kept = segments[index] if is_there else label
            return _BETWEEN.join([*segments[:index], kept, *segments[index + 1 :]])
    return _BETWEEN.join([label, *segments])


def _mark(model: Any, thing: Any, state: Mapping[str, Any], names: LayerNames) -> None:  # noqa: ANN401
    from sitewright.building_model.formats.rhino_reader import entry_at

    attributes, label = thing.Attributes, state["moves_to"]
    for key, value in state["keys"].items():
        attributes.SetUserString(PREFIX + key, str(value))
    if not label:
        return
    if attributes.GetUserString(f"{PREFIX}layer"):  # it would outvote the layer
        attributes.SetUserString(f"{PREFIX}layer", state["layer"])
    old = entry_at(model.Layers, attributes.LayerIndex)
    path = new_path(str(old.FullPath) if old is not None else "", label, names)
    attributes.LayerIndex = _layer_at(model, path, old)


def _layer_at(model: Any, path: str, like: Any) -> int:  # noqa: ANN401
    """Return the index of a layer by its path; what is missing is made, in the old colour.

    A new layer for stock that was used is off, and so is what is made below it.
    """
    import rhino3dm

    by_path = {str(layer.FullPath): layer for layer in model.Layers}
    parent, walked = None, ""
    for name in path.split(_BETWEEN):
        walked = f"{walked}{_BETWEEN}{name}" if walked else name
        found = by_path.get(walked)
        if found is None:
            layer = rhino3dm.Layer()
            layer.Name = name
            if like is not None:
                layer.Color = like.Color
            if parent is not None:
                layer.ParentLayerId = parent.Id
            layer.Visible = name != USED_LAYER and (parent is None or bool(parent.Visible))
            found = model.Layers.FindIndex(model.Layers.Add(layer))
        parent = found
    return int(parent.Index) if parent is not None else 0


class _Contents:
    """What a file holds, for comparing: tables, and each object's geometry and text.

    Attributes:
        tables: Entries of each table.
        shapes: Encoded geometry by object id.
        text: User text by object id.
        meshes: Saved meshes of all breps.
    """

    def __init__(self, model: Any) -> None:  # noqa: ANN401
        self.tables = {name: len(getattr(model, name)) for name in _TABLES}
        self.shapes = {str(o.Attributes.Id): _shape(o.Geometry) for o in model.Objects}
        self.text = {
            str(o.Attributes.Id): {str(k): str(v) for k, v in o.Attributes.GetUserStrings()}
            for o in model.Objects
        }
        self.meshes = sum(_saved_meshes(o.Geometry) for o in model.Objects)


def _shape(geometry: Any) -> str:  # noqa: ANN401
    return json.dumps(geometry.Encode(), sort_keys=True) if geometry is not None else ""


def _saved_meshes(geometry: Any) -> int:  # noqa: ANN401
    import rhino3dm

    if not isinstance(geometry, rhino3dm.Brep):
        return 0
    faces = (geometry.Faces[i] for i in range(len(geometry.Faces)))
    return sum(f.GetMesh(rhino3dm.MeshType.Any) is not None for f in faces)


def _losses(before: _Contents, after: _Contents, tables: Mapping[str, int]) -> Iterator[str]:
    for name, count in tables.items():
        if after.tables[name] != count:
            yield f"{name}: {count} before, {after.tables[name]} in the copy."
    yield from _object_losses(before, after)
    if after.meshes != before.meshes:
        yield f"Saved meshes: {before.meshes} before, {after.meshes} in the copy."


def _object_losses(before: _Contents, after: _Contents) -> Iterator[str]:
    for identity, shape in before.shapes.items():
        if identity not in after.shapes:
            yield f"Object {identity} is not in the copy."
        elif after.shapes[identity] != shape:
            yield f"Object {identity}: its geometry is encoded differently in the copy."
    for identity, text in before.text.items():
        kept = after.text.get(identity, {})
        lost = sorted(k for k, v in text.items() if kept.get(k) != v and not k.startswith(PREFIX))
        if lost:
            yield f"Object {identity}: user text lost: {', '.join(lost)}."


def _unmarked(after: _Contents, request: Mapping[str, Any], written: list[str]) -> Iterator[str]:
    for identity in written:
        wanted = {PREFIX + k: str(v) for k, v in request["status"][identity]["keys"].items() if v}
        if not wanted.items() <= after.text.get(identity, {}).items():
            yield f"Object {identity}: its status did not reach the copy."
