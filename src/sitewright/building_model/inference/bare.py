"""A model without what was inferred for it before: the facts that its author stated."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.building_model.component import Component, Layer, Origin, is_given
from sitewright.building_model.model import BuildingModel, Relation, RelationKind, Stack
from sitewright.foundation.ids import ComponentId

INSERTION = "insertion"
"""Key of `Component.ext` that tells the way in; its origin stands under the same word."""
_RESET: Mapping[str, object] = {
    "order": None,
    "construction_parents": (),
    "ground": False,
    "hold_until_fasteners": 0,
    "grasps": (),
}


def without_inferred(model: BuildingModel) -> BuildingModel:
    """Return only what was given: no inferred field, relation, operation, piece or stack."""
    made = {i for i, c in model.component_by_id.items() if _is_made(c)}
    return replace(
        model,
        component_by_id={i: _stated(c) for i, c in model.component_by_id.items() if i not in made},
        relations=tuple(r for r in model.relations if _is_kept(r)),
        stacks=tuple(_stacks(model, made)),
    )


def _is_kept(relation: Relation) -> bool:
    """Whether a relation is not ours to infer again: joints come from the importer only."""
    return relation.origin is Origin.GIVEN or relation.kind is RelationKind.CONNECTION


def _is_made(component: Component) -> bool:
    return component.layer is Layer.MATERIAL and not is_given(component, "layer")


def _stated(component: Component) -> Component:
    guessed = {f for f in component.origins if not is_given(component, f)}
    fields = {f: value for f, value in _RESET.items() if f in guessed}
    hidden = {INSERTION} & guessed
    return replace(
        component,
        **fields,  # type: ignore[arg-type]
        operations=tuple(o for o in component.operations if o.origin is Origin.GIVEN),
        ext={k: v for k, v in component.ext.items() if k not in hidden},
        origins={k: v for k, v in component.origins.items() if k not in fields and k not in hidden},
    )


def _stacks(model: BuildingModel, made: set[ComponentId]) -> list[Stack]:
    kept = []
    for stack in model.stacks:
        items = tuple(i for i in stack.items if i not in made)
        if items or not stack.items:
            kept.append(replace(stack, items=items))
    return kept
