"""What differs between two models as documents, and the author's file with only that changed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

from sitewright.building_model.component import Component, Layer, Origin
from sitewright.building_model.formats.to_file import document_of
from sitewright.building_model.model import BuildingModel
from sitewright.foundation.canonical import Json, canonical_json
from sitewright.foundation.ids import ComponentId

Document = dict[str, Any]

_LISTS = ("components", "stacks")
_EVIDENCE = "origins"


@dataclass(frozen=True, slots=True, kw_only=True)
class Change:
    """One fact that differs.

    Attributes:
        where: Component, stack or relation; empty for the whole model.
        key: Which fact of it; empty if all of it is new or gone.
        old: Its value before; None if there was none.
        new: Its value now; None if it is gone.
        why: Origin and evidence, if they are known.
    """

    where: str
    key: str
    old: Json
    new: Json
    why: str = ""


def changes_between(before: BuildingModel, after: BuildingModel) -> list[Change]:
    """Return every fact that differs, components first."""
    old, new = document_of(before), document_of(after)
    found: list[Change] = []
    for name in _LISTS:
        one, other = _by_id(old.get(name, ())), _by_id(new.get(name, ()))
        for i in sorted(one.keys() | other.keys()):
            why = _origins(after.component_by_id.get(ComponentId(i)))
            found += _entry(i, one.get(i), other.get(i), why)
    found += _relations(old.get("relations", []), new.get("relations", []))
    for key in sorted((old.keys() | new.keys()) - {*_LISTS, "relations"}):
        if old.get(key) != new.get(key):
            found.append(Change(where="", key=key, old=old.get(key), new=new.get(key)))
    return found


def plain_value(value: object) -> Any:  # noqa: ANN401 - any JSON value
    """Return a fact of a model as JSON, as far as a reader of a conflict needs it."""
    match value:
        case None | bool() | int() | float() | str():
            return value
        case Mapping():
            return {str(k): plain_value(v) for k, v in value.items()}
        case Sequence():
            return [plain_value(v) for v in value]
        case _ if is_dataclass(value):
            return {f.name: plain_value(getattr(value, f.name)) for f in fields(value)}
        case _:
            return str(value)


def given_facts_changed(changes: Sequence[Change], before: BuildingModel) -> list[str]:
    """Return the stated facts that a list of changes would alter; none, unless there is a bug.

    Ground level, rules and evidence are no facts of a component. Operations may be added to.
    """
    wrong = []
    for change in changes:
        component = before.component_by_id.get(ComponentId(change.where))
        if component is None or change.old is None or change.key == _EVIDENCE:
            continue
        is_own = component.layer is Layer.MATERIAL and "layer" in component.origins
        if not is_own and not _may_change(component, change):
            wrong.append(f"{change.where}.{change.key}".rstrip("."))
    return wrong


def patched(raw: Mapping[str, Any], before: BuildingModel, after: BuildingModel) -> Document:
    """Return the author's document with only the differing facts changed.

    Args:
        raw: What the author's file holds; `before` was read from it.
        before: The model before.
        after: The model to be written.
    """
    old, new = document_of(before), document_of(after)
    result = dict(raw)
    for name in _LISTS:
        if old.get(name) != new.get(name):
            result[name] = _merged_list(raw.get(name, []), old.get(name, []), new.get(name, []))
    if old.get("relations") != new.get("relations"):
        pairs = zip(old.get("relations", []), raw.get("relations", []))  # noqa: B905 - equal if there are any
        kept = {canonical_json(o): r for o, r in pairs}
        result["relations"] = [kept.get(canonical_json(n), n) for n in new.get("relations", [])]
    for key in sorted((old.keys() | new.keys()) - {*_LISTS, "relations"}):
        if old.get(key) != new.get(key):
            result[key] = new.get(key, [])
    return {k: result[k] for k in [*new, *result] if k in result and result[k] != []}


def _merged_list(raw: Sequence[Any], old: Sequence[Any], new: Sequence[Any]) -> list[Document]:
    old_by_id, new_by_id, kept = _by_id(old), _by_id(new), []
    for entry in raw:
        i = entry["id"]
        if i in new_by_id:
            kept.append(_merged(entry, old_by_id.get(i, {}), new_by_id[i]))
    known = {entry["id"] for entry in raw}
    return [*kept, *(n for n in new if n["id"] not in known | old_by_id.keys())]


def _merged(raw: Document, old: Document, new: Document) -> Document:
    changed = {k for k in old.keys() | new.keys() if old.get(k) != new.get(k)}
    merged = {k: new[k] if k in changed else raw[k] for k in new if k in changed or k in raw}
    return {**merged, **{k: v for k, v in raw.items() if k not in merged and k not in changed}}


def _entry(
    where: str, old: Document | None, new: Document | None, why: Mapping[str, str]
) -> list[Change]:
    if old is None or new is None:
        reason = why.get("layer", "")
        return [Change(where=where, key="", old=old, new=new, why=reason)]
    keys = [k for k in [*new, *(k for k in old if k not in new)] if old.get(k) != new.get(k)]
    return [
        Change(where=where, key=k, old=old.get(k), new=new.get(k), why=why.get(k, "")) for k in keys
    ]


def _relations(old: Sequence[Document], new: Sequence[Document]) -> list[Change]:
    one, other = _by_key(old), _by_key(new)
    return [
        Change(
            where=f"{k[1]} {k[0]} {k[2]}",
            key="",
            old=_single(one.get(k)),
            new=_single(other.get(k)),
        )
        for k in sorted(one.keys() | other.keys())
        if one.get(k) != other.get(k)
    ]


def _by_key(relations: Sequence[Document]) -> dict[tuple[str, str, str], list[Document]]:
    found: dict[tuple[str, str, str], list[Document]] = {}
    for relation in relations:
        found.setdefault(_key(relation), []).append(relation)
    return found


def _single(relations: list[Document] | None) -> Json:
    """Return what stands of one kind between two components: as a rule one relation."""
    return relations[0] if relations is not None and len(relations) == 1 else relations


def _key(relation: Mapping[str, Any]) -> tuple[str, str, str]:
    return (str(relation["kind"]), str(relation["a"]), str(relation["b"]))


def _by_id(entries: Sequence[Document]) -> dict[str, Document]:
    return {e["id"]: e for e in entries}


def _origins(component: Component | None) -> dict[str, str]:
    if component is None:
        return {}
    words = {k: f"{o.value}: {why}" for k, (o, why) in component.origins.items()}
    rules = {str(o.params.get("rule")) for o in component.operations if o.origin is Origin.RULE}
    if rules:
        words["operations"] = f"rule: {', '.join(sorted(rules))}"
    if "insertion" in words:
        words["ext"] = words["insertion"]
    return words


def _may_change(component: Component, change: Change) -> bool:
    match change.key:
        case "operations":
            new = change.new if isinstance(change.new, list) else []
            old = change.old if isinstance(change.old, list) else []
            return all(o in new for o in old if isinstance(o, Mapping) and "origin" not in o)
        case "ext":
            new_ext = change.new if isinstance(change.new, Mapping) else {}
            old_ext = change.old if isinstance(change.old, Mapping) else {}
            own = {k: v for k, v in old_ext.items() if k != "insertion"}
            return all(new_ext.get(k) == v for k, v in own.items()) and (
                "insertion" not in old_ext
                or "insertion" in component.origins
                or new_ext.get("insertion") == old_ext["insertion"]
            )
        case "":
            return False
        case _:
            return change.key in component.origins
