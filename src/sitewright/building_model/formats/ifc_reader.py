"""Asks ifcopenshell what an IFC file holds: records of JSON, numbers in the file's own unit.

Runs in a child process (`foreign_files`), since the library may crash on a bad file.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from sitewright.building_model.formats.unreadable import UnreadableError

_LINEAR = ("IfcMember", "IfcBeam", "IfcColumn", "IfcPile")
_BUILT = ("IfcBuildingElement", "IfcBuiltElement", "IfcElementComponent")
_NOT_BUILT = (
    *("IfcDoor", "IfcWindow", "IfcReinforcingElement", "IfcFastener", "IfcMechanicalFastener"),
    *("IfcDiscreteAccessory", "IfcVibrationIsolator", "IfcSign"),
)
_MAX_PARTS = 50_000
_SHOWN = 300
_SHORTEST_UNIT_M, _LONGEST_UNIT_M = 1e-9, 1e5
WRONG_KIND = (AttributeError, TypeError, ValueError, IndexError, ArithmeticError)
"""What an attribute of a wrong kind looks like: the parser does not check kinds."""


def read(path: str) -> dict[str, Any]:
    """Return parts, relations, unit, survey and notes of an IFC file."""
    from sitewright.building_model.formats.ifc_cycles import circles
    from sitewright.building_model.formats.ifc_pieces import demand_few_bodies
    from sitewright.building_model.formats.ifc_schedule import construction_order

    file, notes = open_file(path)
    for circle in circles(file):
        raise UnreadableError("E2", f"{circle}.", "Repair the model and export it again.")
    metres = _metres_per_unit(file)
    elements, left_out = _elements(file)
    demand_few_bodies(elements)
    order, order_notes = construction_order(file)
    parts = _parts(file, elements, order, metres)
    survey = _survey(file)
    return {
        "metres_per_unit": metres,
        "parts": parts,
        "relations": _relations(file, {p["source_id"] for p in parts}),
        "survey": survey,
        "notes": [*notes, *left_out, *order_notes, *_survey_note(survey)],
    }


def wrong_kind(what: str, error: Exception) -> UnreadableError:
    """Return the refusal of an entity that is not as its schema demands."""
    message = f"{what} is not as its schema demands ({type(error).__name__}: {error})."
    return UnreadableError("E2", message[:_SHOWN], "Repair the model and export it again.")


def open_file(path: str) -> tuple[Any, list[str]]:
    """Return the opened file and what the parser grumbled about.

    Raises:
        UnreadableError: The library is missing, or the file is damaged or of another schema.
    """
    try:
        import ifcopenshell
    except ImportError as error:
        raise UnreadableError(
            "E2", f"ifcopenshell cannot be loaded: {error}.", "Run: pip install 'sitewright[ifc]'"
        ) from None
    ifcopenshell.get_log()  # empties it
    try:
        file = ifcopenshell.open(path)
    except ifcopenshell.SchemaError as error:
        raise UnreadableError("E3", f"{error}.", "Export it as IFC2X3, IFC4 or IFC4X3.") from None
    except Exception as error:  # noqa: BLE001 - whatever the library meets in a bad file
        text = _first_line(ifcopenshell.get_log(), "[error]") or str(error)
        raise UnreadableError("E2", f"it cannot be parsed: {text}.", "Export it again.") from None
    log = ifcopenshell.get_log()
    damage = _first_line(log, "[error]") or _first_line(log, "[warning]", "Overwriting")
    if damage:
        raise UnreadableError("E2", f"it is damaged: {damage}.", "Export it again.")
    odd = _first_line(log, "[warning]")
    return file, [f"The parser warns: {odd}."] if odd else []


def _first_line(log: str, level: str, having: str = "") -> str:
    """Return the first message of a level without its time."""
    for line in log.splitlines():
        if line.startswith(level) and having in line:
            return line.rpartition("] ")[2].strip().rstrip(".")[:_SHOWN]
    return ""


def _metres_per_unit(file: Any) -> float | None:  # noqa: ANN401 - untyped entities throughout
    from ifcopenshell.util.unit import calculate_unit_scale

    assignments = file.by_type("IfcUnitAssignment")
    units = [u for a in assignments for u in a.Units]
    if not any(getattr(u, "UnitType", None) == "LENGTHUNIT" for u in units):
        return None
    metres = float(calculate_unit_scale(file))
    if not _SHORTEST_UNIT_M <= metres <= _LONGEST_UNIT_M:
        message = f"its unit of length is {metres:g} m, in which no building is drawn."
        raise UnreadableError("E2", message, "Correct the unit and export it again.")
    return metres


def _elements(file: Any) -> tuple[list[Any], list[str]]:  # noqa: ANN401
    """Return what may be built, and notes about what is left out."""
    from sitewright.building_model.formats.ifc_attributes import wholes_of
    from sitewright.building_model.formats.ifc_shapes import body_items

    known = [c for c in _BUILT if _has_class(file, c)]
    all_of = {e.id(): e for c in known for e in file.by_type(c)}
    left_out: Counter[str] = Counter()
    shaped: dict[int, Any] = {}
    for number, element in sorted(all_of.items()):
        if any(element.is_a(c) for c in _NOT_BUILT if _has_class(file, c)):
            left_out[f"{element.is_a()}: no piece that is placed by itself"] += 1
        elif not body_items(element):
            left_out[f"{element.is_a()}: no body of its own"] += 1
        else:
            shaped[number] = element
    wholes = {w.id() for e in shaped.values() for w in wholes_of(e)}
    for number in wholes & shaped.keys():
        left_out[f"{shaped[number].is_a()}: its parts stand for it"] += 1
    if len(shaped) > _MAX_PARTS:
        raise UnreadableError(
            "E2",
            f"it holds {len(shaped)} elements, more than {_MAX_PARTS}.",
            "Export a part of it.",
        )
    notes = [f"{count} x {why}; left out." for why, count in sorted(left_out.items())]
    return [e for n, e in shaped.items() if n not in wholes], notes


def _has_class(file: Any, name: str) -> bool:  # noqa: ANN401
    import ifcopenshell

    schema = ifcopenshell.schema_by_name(file.schema_identifier)
    try:
        schema.declaration_by_name(name)
    except RuntimeError:
        return False
    return True


def _parts(
    file: Any,  # noqa: ANN401
    elements: Sequence[Any],
    order: dict[str, int],
    metres: float | None,
) -> list[dict[str, Any]]:
    from sitewright.building_model.formats.ifc_kernel import tessellate
    from sitewright.building_model.formats.ifc_placement import NotAnalyticError, world_pose
    from sitewright.building_model.formats.ifc_shapes import read_solids

    solids: dict[str, list[dict[str, Any]]] = {}
    for_kernel = []
    for element in elements:
        try:
            pose = world_pose(element.ObjectPlacement)
            is_linear = any(element.is_a(c) for c in _LINEAR)
            solids[element.GlobalId] = read_solids(element, pose, is_linear=is_linear)
        except NotAnalyticError:
            for_kernel.append(element)
        except WRONG_KIND as error:
            raise wrong_kind(f"{element.is_a()} {element.GlobalId}", error) from None
    solids.update(tessellate(file, for_kernel, metres or 1.0))
    groups = _group_names(elements)
    return [_part(e, solids.get(e.GlobalId, []), order, groups) for e in elements]


def _group_names(elements: Sequence[Any]) -> dict[int, str]:
    """Return a name for each element's nearest whole: its own, with its id if names repeat."""
    from sitewright.building_model.formats.ifc_attributes import wholes_of

    nearest = {e.id(): w for e in elements if (w := next(wholes_of(e), None)) is not None}
    wholes = {w.id(): w for w in nearest.values()}
    count = Counter(str(w.Name or w.is_a()) for w in wholes.values())
    names = {}
    for element, whole in nearest.items():
        name = str(whole.Name or whole.is_a())
        names[element] = name if count[name] == 1 else f"{name} {whole.GlobalId}"
    return names


def _part(
    element: Any,  # noqa: ANN401
    solids: list[dict[str, Any]],
    order: dict[str, int],
    groups: dict[int, str],
) -> dict[str, Any]:
    from sitewright.building_model.formats import ifc_attributes as attributes

    text, raw = attributes.properties_of(element)
    holders = [element, *attributes.wholes_of(element)]
    orders = [order[h.GlobalId] for h in holders if h.GlobalId in order]
    return {
        "source_id": element.GlobalId,
        "name": str(element.Name or ""),
        "layer_path": attributes.presentation_layer(element),
        "type": attributes.type_of(element),
        "material": attributes.material_of(element),
        "group": groups.get(element.id(), ""),
        "order": orders[0] if orders else None,
        "solids": solids,
        "user_text": text,
        "raw": raw,
    }


def _relations(file: Any, known: set[str]) -> list[dict[str, str]]:  # noqa: ANN401
    found = []
    for relation in file.by_type("IfcRelConnectsElements"):
        a, b = relation.RelatingElement.GlobalId, relation.RelatedElement.GlobalId
        if a in known and b in known and a != b:
            found.append({"a": a, "b": b, "type": relation.is_a()})
    return found


def _survey(file: Any) -> dict[str, Any]:  # noqa: ANN401
    """Return where the file's origin lies on Earth, as it says so."""
    if not _has_class(file, "IfcMapConversion"):
        return {}
    names = ("Eastings", "Northings", "OrthogonalHeight", "XAxisAbscissa", "XAxisOrdinate", "Scale")
    for conversion in file.by_type("IfcMapConversion"):
        target = conversion.TargetCRS
        values = {n: getattr(conversion, n) for n in names if getattr(conversion, n) is not None}
        return {**values, "crs": str(target.Name) if target is not None else ""}
    return {}


def _survey_note(survey: Mapping[str, Any]) -> list[str]:
    if not survey:
        return []
    values = ", ".join(f"{k} {v}" for k, v in survey.items() if v != "")
    return [f"Its survey origin ({values}) is not applied: coordinates are the file's own."]
