"""Says why a component stands where it does in the order, and where each fact comes from."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from sitewright.app.inferring import Inference, infer_project
from sitewright.building_model.component import Component, Origin
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.errors import BuildingModelError, Problem, did_you_mean
from sitewright.foundation.ids import ComponentId

_FACTS = ("type", "ground", "construction_parents", "order", "hold_until_fasteners", "grasps")


class NothingToExplainError(BuildingModelError):
    """There is no such component."""

    def __init__(self, name: str, model: BuildingModel) -> None:
        hint = did_you_mean(name, model.component_by_id)
        super().__init__(f"There is no component {name!r}.{hint}")


def explain_component(folder: Path, name: str) -> list[str]:
    """Return where each fact of a component comes from, and who touches, carries and holds it."""
    found = infer_project(folder)
    component = _component(found, name)
    lines = [f"{component.id}: {component.name or component.type}, layer {component.layer.value}"]
    if component.source is not None:
        lines.append(f"  source: {component.source.file} {component.source.id}".rstrip())
    lines += [f"  {line}" for line in _facts(component)]
    for relation in found.after.relations:
        if component.id in (relation.a, relation.b) and relation.kind is not RelationKind.BEFORE:
            lines.append(f"  {_related(relation, component.id)}")
    lines += [f"  problem: {p.code} {p.message} {p.fix}" for p in _problems(found, component.id)]
    return lines


def explain_order(folder: Path, name: str) -> list[str]:
    """Return why a component comes when it comes: what must be there first, what waits for it."""
    found = infer_project(folder)
    component = _component(found, name)
    number = "no number" if component.order is None else f"number {component.order}"
    lines = [f"{component.id}: {number} ({_origin(component, 'order')})"]
    lines += [f"  after {line}" for line in _earlier(found.after, component)]
    lines += [f"  before {line}" for line in _later(found.after, component)]
    if "insertion" in component.ext:
        lines.append(f"  way in: {component.ext['insertion']} ({_origin(component, 'insertion')})")
    lines += [
        f"  problem: {p.code} {p.message} {p.fix}"
        for p in _problems(found, component.id)
        if p.code[0] in "FP"
    ]
    return lines


def _component(found: Inference, name: str) -> Component:
    component = found.after.component_by_id.get(ComponentId(name))
    if component is None:
        raise NothingToExplainError(name, found.after)
    return component


def _problems(found: Inference, name: ComponentId) -> Iterator[Problem]:
    return (p for p in found.problems if p.where == name)


def _facts(component: Component) -> Iterator[str]:
    for fact in _FACTS:
        value = getattr(component, fact)
        if fact == "grasps":
            value = len(value)
        elif isinstance(value, tuple):
            value = ", ".join(value)
        if value not in ("", None, 0, False):
            yield f"{fact}: {value} ({_origin(component, fact)})"
    for operation in component.operations:
        rule = operation.params.get("rule")
        source = f"rule {rule}" if operation.origin is Origin.RULE else operation.origin.value
        yield f"operation {operation.id}: {' -> '.join(operation.on)} ({source})"


def _origin(component: Component, fact: str) -> str:
    origin, evidence = component.origins.get(fact, (Origin.GIVEN, ""))
    return f"{origin.value}: {evidence}" if evidence else origin.value


def _related(relation: Relation, own: ComponentId) -> str:
    other = relation.b if relation.a == own else relation.a
    area = relation.data.get("area_m2")
    size = f", {float(str(area)) * 1e4:.0f} cm2" if area is not None else ""
    kind = relation.kind.value
    words = {
        RelationKind.SUPPORTS: f"supports {other}" if relation.a == own else f"rests on {other}",
        RelationKind.HOLD: f"holds {other}" if relation.a == own else f"is held by {other}",
        RelationKind.BLOCKS: f"blocks {other}" if relation.a == own else f"is blocked by {other}",
    }.get(relation.kind, f"{kind} with {other}")
    return f"{words}{size} ({relation.origin.value})"


def _earlier(model: BuildingModel, component: Component) -> Iterator[str]:
    for parent in component.construction_parents:
        yield f"{parent}: construction parent ({_origin(component, 'construction_parents')})"
    for relation in model.relations:
        first, second = _in_order(relation)
        if second == component.id and first not in ("", *component.construction_parents):
            yield f"{first}: {_why(relation)}"


def _later(model: BuildingModel, component: Component) -> Iterator[str]:
    carried = [c for c in model.component_by_id.values() if component.id in c.construction_parents]
    for other in carried:
        yield f"{other.id}: it is its construction parent"
    names = {c.id for c in carried}
    for relation in model.relations:
        first, second = _in_order(relation)
        if first == component.id and second not in names:
            yield f"{second}: {_why(relation)}"


def _in_order(relation: Relation) -> tuple[str, str]:
    """Return which of the two comes first, if the relation says so."""
    match relation.kind:
        case RelationKind.SUPPORTS | RelationKind.BEFORE:
            return relation.a, relation.b
        case RelationKind.BLOCKS:
            return relation.b, relation.a
        case _:
            return "", ""


def _why(relation: Relation) -> str:
    why = relation.data.get("why")
    words = str(why) if why else relation.kind.value
    return f"{words} ({relation.origin.value})"
