"""What an IFC file says about an element besides its shape: class, material, properties, place."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from typing import Any

OWN_SET = "Sitewright"
BUILT_SET = "Sitewright_Construction"
_BUILT = re.compile(rf"{BUILT_SET}(?:_(\d+))?$")
_NO_KIND = {None, "", "NOTDEFINED", "USERDEFINED"}
_MAX_CHARS = 2000


def type_of(element: Any) -> str:  # noqa: ANN401 - untyped entities throughout
    """Return class and predefined type as words: ``member-stud``; else the class: ``member``."""
    from ifcopenshell.util.element import get_type

    word: str = element.is_a().removeprefix("Ifc").removesuffix("StandardCase").lower()
    for owner in (element, get_type(element)):
        kind = getattr(owner, "PredefinedType", None)
        if kind == "USERDEFINED":
            kind = getattr(owner, "ObjectType", None) or getattr(owner, "ElementType", None)
        if kind not in _NO_KIND:
            words = re.sub(r"[^A-Za-z0-9]+", "-", str(kind)).strip("-").lower()
            return f"{word}-{words}" if words else word
    return word


def material_of(element: Any) -> str:  # noqa: ANN401
    """Return the material's name; those of layers, profiles or constituents joined by +."""
    from ifcopenshell.util.element import get_materials

    names = [str(m.Name) for m in get_materials(element) if getattr(m, "Name", None)]
    return " + ".join(dict.fromkeys(names))


def presentation_layer(element: Any) -> str:  # noqa: ANN401
    """Return the CAD layer of the element's shape, if any."""
    from ifcopenshell.util.element import get_layers

    shapes = element.Representation
    if shapes is None:
        return ""
    names = [
        str(a.Name)
        for r in shapes.Representations
        for a in r.LayerAssignments
        if a.Name is not None
    ]
    if not names:
        names = [str(a.Name) for a in get_layers(None, element) if a.Name]
    return names[0] if names else ""


def properties_of(element: Any) -> tuple[dict[str, str], dict[str, Any]]:  # noqa: ANN401
    """Return single values as text by ``Set.Property``, and the other ones by the same key.

    Properties of the set ``Sitewright`` are only found under ``sitewright.key``, the importer's
    own keys; so is the layer of a component that an earlier run has built. What else an export
    wrote is passed over.
    """
    from ifcopenshell.util.element import get_psets

    sets = get_psets(element, should_inherit=True)
    text: dict[str, str] = _plain_attributes(element)
    rest: dict[str, Any] = {}
    for name, values in sorted(sets.items()):
        if name.lower() == OWN_SET.lower() or _BUILT.match(name):
            continue
        for key, value in values.items():
            if key == "id" or value is None:
                continue
            if isinstance(value, str | int | float | bool):
                text[f"{name}.{key}"] = _as_text(value)
            else:
                rest[f"{name}.{key}"] = _clean(value)
    text.update(_own_keys(sets))
    return text, rest


def _plain_attributes(element: Any) -> dict[str, str]:  # noqa: ANN401
    from ifcopenshell.util.element import get_container, get_type

    container, kind = get_container(element), get_type(element)
    values = {
        "Class": element.is_a(),
        "Description": element.Description,
        "ObjectType": getattr(element, "ObjectType", None),
        "Tag": getattr(element, "Tag", None),
        "Container": container.Name if container is not None else None,
        "TypeName": kind.Name if kind is not None else None,
    }
    return {key: _as_text(value) for key, value in values.items() if value}


def _own_keys(sets: Mapping[str, Mapping[str, Any]]) -> dict[str, str]:
    found = {}
    built = sorted((int(m[1] or 1), n) for n in sets if (m := _BUILT.match(n)))
    if built and sets[built[-1][1]].get("Layer"):
        found["sitewright.layer"] = str(sets[built[-1][1]]["Layer"])
    for name, values in sets.items():
        if name.lower() == OWN_SET.lower():
            own = {re.sub(r"(?<=[a-z])(?=[A-Z])", "_", k).lower(): v for k, v in values.items()}
            found = {
                **{f"sitewright.{k}": _as_text(v) for k, v in own.items() if _is_own(k, v)},
                **found,
            }
    return found


def _is_own(key: str, value: object) -> bool:
    return key != "id" and isinstance(value, str | int | float | bool)


def _as_text(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.12g}"
    return str(value)[:_MAX_CHARS]


def _clean(value: Any) -> Any:  # noqa: ANN401
    """Return the value as JSON: entities as text, numbers that are none as text."""
    if isinstance(value, Mapping):
        return {str(k): _clean(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_clean(v) for v in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if value is None or isinstance(value, str | int | float | bool):
        return value
    return str(value)[:_MAX_CHARS]


def wholes_of(element: Any) -> Iterator[Any]:  # noqa: ANN401
    """Yield what the element is part of, nearest first: walls, assemblies.

    A circle ends where it closes.
    """
    seen = {element.id()}
    while True:
        relations = [*element.Decomposes, *getattr(element, "Nests", ())]
        wholes = [r.RelatingObject for r in relations if r.RelatingObject.is_a("IfcElement")]
        if not wholes or wholes[0].id() in seen:
            return
        element = wholes[0]
        seen.add(element.id())
        yield element
