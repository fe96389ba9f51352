"""The same facts, spelled as they should be: ids for names, and each relation once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from sitewright.building_model.check_references import Names, meant, named
from sitewright.building_model.component import Component
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId

_MUTUAL = frozenset({RelationKind.CONTACT, RelationKind.CONNECTION})

Ids = tuple[ComponentId, ...]


def spelled_out(model: BuildingModel) -> BuildingModel:
    """Return the model with ids for names that mean one component, and no relation twice.

    Nothing that the author said is altered: it is said in the words that the model asks for.
    """
    names = named(model)
    relations = tuple(_once(model.relations))
    if not _has_names(model):
        return replace(model, relations=relations)
    spelled = {i: _spelled(c, model, names) for i, c in model.component_by_id.items()}
    return replace(model, component_by_id=spelled, relations=relations)


def repetition_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield relations that say only what another one says."""
    kept = {id(r) for r in _once(model.relations)}
    for relation in model.relations:
        if id(relation) not in kept:
            yield Problem(
                code="D2",
                severity="W",
                where=relation.a,
                message=f"Relation '{relation.a} {relation.kind.value} {relation.b}' stands twice.",
                fix="Remove one of them.",
                is_fixable=True,
            )


def _once(relations: Sequence[Relation]) -> list[Relation]:
    """Keep of each relation the most trusted one, and others only if they say something else."""
    kept: dict[tuple[str, str, str], list[Relation]] = {}
    for relation in relations:
        same = kept.setdefault(_ends(relation), [])
        if all(not _says_it(known, relation) for known in same):
            same[:] = [known for known in same if not _says_it(relation, known)]
            same.append(relation)
    chosen = {id(r) for same in kept.values() for r in same}
    return [r for r in relations if id(r) in chosen]


def _ends(relation: Relation) -> tuple[str, str, str]:
    """Return kind and ends; it does not matter who of two touches whom."""
    a, b = relation.a, relation.b
    if relation.kind in _MUTUAL:
        a, b = min(a, b), max(a, b)
    return relation.kind, a, b


def _says_it(one: Relation, other: Relation) -> bool:
    """Whether a relation makes another one superfluous: equal, or given where that was not."""
    ranks = list(type(one.origin))
    if one.origin is not other.origin:
        return ranks.index(one.origin) < ranks.index(other.origin)
    is_ours = one.origin is not ranks[0]
    return is_ours or (one.data, one.confidence) == (other.data, other.confidence)


def _has_names(model: BuildingModel) -> bool:
    known = model.component_by_id
    return any(i not in known for c in known.values() for i in _references(c))


def _references(component: Component) -> list[ComponentId]:
    return [*component.construction_parents, *(i for o in component.operations for i in o.on)]


def _spelled(component: Component, model: BuildingModel, names: Names) -> Component:
    def ids(references: Ids) -> Ids:
        found = []
        for reference in references:
            one = None
            if reference not in model.component_by_id:
                one = meant(reference, component, names)
            found.append(reference if one is None else one.id)
        return tuple(found)

    return replace(
        component,
        construction_parents=tuple(dict.fromkeys(ids(component.construction_parents))),
        operations=tuple(replace(o, on=ids(o.on)) for o in component.operations),
    )
