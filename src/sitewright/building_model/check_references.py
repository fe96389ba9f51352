"""Who refers to whom: unknown ids, names instead of ids, cycles, order against parents."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from sitewright.building_model.component import Component, Layer, Operation, is_given
from sitewright.building_model.findings import refused
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.errors import Problem, did_you_mean
from sitewright.foundation.ids import ComponentId, OperationId

_CARRIES = frozenset({Layer.TARGET, Layer.AS_BUILT})

Node = TypeVar("Node", bound=str)
Names = Mapping[str, Sequence[Component]]
"""Who bears a name."""


def named(model: BuildingModel) -> Names:
    """Return who bears each name."""
    found: dict[str, list[Component]] = {}
    for component in model.component_by_id.values():
        if component.name:
            found.setdefault(component.name, []).append(component)
    return found


def meant(name: str, asked_by: Component, names: Names) -> Component | None:
    """Return the only other component of a name, in the model or else in the group."""
    others = [c for c in names.get(name, ()) if c.id != asked_by.id]
    if len(others) > 1 and asked_by.group:
        others = [c for c in others if c.group == asked_by.group]
    return others[0] if len(others) == 1 else None


def reference_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield unknown references, parents on wrong layers, and cycles."""
    names = named(model)
    operations = {o.id for c in model.component_by_id.values() for o in c.operations}
    for component in model.component_by_id.values():
        yield from _parents(model, component, names)
        for operation in component.operations:
            yield from _receivers(model, component, operation, names)
            yield from _earlier_operations(component, operation, operations)
    yield from _relation_ends(model)
    yield from _cycles(model)


def order_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield components that come before something that carries them."""
    for component in model.component_by_id.values():
        for name in component.construction_parents:
            parent = model.component_by_id.get(name)
            if parent is None or component.order is None or parent.order is None:
                continue
            if component.order < parent.order:
                problem = refused(
                    "P4",
                    component,
                    f"It (order {component.order}) rests on {name} (order {parent.order}).",
                    "Give what carries it a lower order.",
                )
                is_stated = is_given(component, "order") and is_given(parent, "order")
                yield replace(problem, is_fixable=not is_stated)


def cycle_in(parents_of: Mapping[Node, Sequence[Node]]) -> tuple[Node, ...]:
    """Return one cycle, closed, starting at its smallest member; empty if there is none."""
    done: set[Node] = set()
    for start in sorted(parents_of):
        path: list[Node] = []
        stack: list[tuple[Node, bool]] = [(start, False)]
        while stack:
            node, is_left = stack.pop()
            if is_left:
                done.add(path.pop())
            elif node in path:
                return _from_smallest(path[path.index(node) :])
            elif node not in done:
                path.append(node)
                stack.append((node, True))
                known = (p for p in parents_of.get(node, ()) if p in parents_of)
                stack += [(p, False) for p in known]
    return ()


def _from_smallest(cycle: Sequence[Node]) -> tuple[Node, ...]:
    first = cycle.index(min(cycle))
    turned = (*cycle[first:], *cycle[:first])
    return (*turned, turned[0])


def _parents(model: BuildingModel, component: Component, names: Names) -> Iterator[Problem]:
    for name in component.construction_parents:
        parent = model.component_by_id.get(name)
        if parent is None:
            yield _unknown(model, component, f"construction parent {name!r}", name, names)
        elif component.layer is not Layer.MATERIAL and parent.layer not in _CARRIES:
            yield refused(
                "P3",
                component,
                f"Its construction parent {name!r} is on layer {parent.layer.value}.",
                "Name a component on layer target or as_built.",
            )


def _receivers(
    model: BuildingModel, component: Component, operation: Operation, names: Names
) -> Iterator[Problem]:
    for name in operation.on:
        if name not in model.component_by_id:
            what = f"component {name!r} of operation {operation.id!r}"
            yield _unknown(model, component, what, name, names)


def _earlier_operations(
    component: Component, operation: Operation, known: Collection[str]
) -> Iterator[Problem]:
    for earlier in operation.after:
        if earlier not in known:
            message = f"Operation {operation.id!r} comes after {earlier!r}, which does not exist."
            fix = f"Correct the id.{did_you_mean(earlier, known)}"
            yield refused("P1", component, message, fix)


def _unknown(
    model: BuildingModel, component: Component, what: str, name: str, names: Names
) -> Problem:
    if matching := names.get(name, ()):
        objects = "object" if len(matching) == 1 else "objects"
        message = f"The {what} is a name that matches {len(matching)} {objects}."
        one = meant(name, component, names)
        fix = "Use ids." if one is None else f"Use its id {one.id}."
        return replace(refused("N1", component, message, fix), is_fixable=one is not None)
    hint = did_you_mean(name, model.component_by_id)
    return refused("P1", component, f"The {what} does not exist.{hint}", "Correct the id.")


def _relation_ends(model: BuildingModel) -> Iterator[Problem]:
    for relation in model.relations:
        for end in (relation.a, relation.b):
            if end not in model.component_by_id:
                yield Problem(
                    code="P1",
                    severity="E",
                    where=end,
                    message=(
                        f"Relation '{relation.a} {relation.kind.value} {relation.b}' names a "
                        f"component that does not exist.{did_you_mean(end, model.component_by_id)}"
                    ),
                    fix="Correct the id.",
                )


def _cycles(model: BuildingModel) -> Iterator[Problem]:
    rests_on: dict[ComponentId, list[ComponentId]] = {
        c.id: list(c.construction_parents) for c in model.component_by_id.values()
    }
    for relation in model.relations:
        if relation.kind in (RelationKind.SUPPORTS, RelationKind.BEFORE):
            rests_on.setdefault(relation.b, []).append(relation.a)
        elif relation.kind is RelationKind.BLOCKS:
            rests_on.setdefault(relation.a, []).append(relation.b)
    if cycle := cycle_in(rests_on):
        component = model.component_by_id[cycle[0]]
        message = f"Cycle: {' -> '.join(cycle)}."
        yield refused("P2", component, message, "Remove one of these construction parents.")
    yield from _operation_cycles(model)


def _operation_cycles(model: BuildingModel) -> Iterator[Problem]:
    owner = {o.id: c for c in model.component_by_id.values() for o in c.operations}
    after: dict[OperationId, tuple[OperationId, ...]] = {
        o.id: o.after for c in model.component_by_id.values() for o in c.operations
    }
    if cycle := cycle_in(after):
        message = f"Operations wait for each other: {' -> '.join(cycle)}."
        yield refused("P2", owner[cycle[0]], message, "Remove one 'after'.")
