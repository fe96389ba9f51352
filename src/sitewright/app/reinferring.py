"""Infers a merged design anew, and leaves what stands and what lies on the site as it is."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from sitewright.building_model.component import Component, Layer, Origin, is_given
from sitewright.building_model.inference.bare import without_inferred
from sitewright.building_model.inference.completion import (
    Surroundings,
    complete,
    is_jointed_frame,
)
from sitewright.building_model.model import BuildingModel
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId

_TYPE = "type"


def stated_facts(design: BuildingModel, base: BuildingModel) -> BuildingModel:
    """Return what file and user stated: nothing inferred, no marks on types, no inferred ground."""
    bare = without_inferred(design)
    components = {
        i: _unmarked(c, base.component_by_id.get(i)) for i, c in bare.component_by_id.items()
    }
    bare = replace(bare, component_by_id=components)
    if bare.ground_z_m == base.ground_z_m or not is_inferred(design):
        return bare
    as_read = replace(bare, ground_z_m=base.ground_z_m)
    return as_read if complete(as_read)[0].ground_z_m == bare.ground_z_m else bare


def is_inferred(design: BuildingModel) -> bool:
    """Whether anything of a design was inferred, joints of the importer left out."""
    return without_inferred(design) != design


def stock_of(design: BuildingModel) -> dict[ComponentId, Component]:
    """Return the inferred pieces of a design."""
    return {i: c for i, c in design.component_by_id.items() if _is_made(c)}


def with_stock_of(design: BuildingModel, old: BuildingModel) -> BuildingModel:
    """Return a design with the inferred pieces and piles of another one."""
    pieces = stock_of(old)
    if not pieces:
        return design
    kept = {s.id: s for s in old.stacks if any(i in pieces for i in s.items)}
    components = {**design.component_by_id, **pieces}
    return replace(
        design,
        component_by_id={i: components[i] for i in sorted(components)},
        stacks=(*(s for s in design.stacks if s.id not in kept), *kept.values()),
    )


def inferred_anew(
    merged: BuildingModel,
    old: BuildingModel,
    standing: Collection[ComponentId],
    around: Surroundings,
    *,
    has_history: bool,
) -> tuple[BuildingModel, list[Problem]]:
    """Return the merged design completed as the old one was.

    Args:
        merged: What file and user state now.
        old: The design before, with what was inferred.
        standing: Targets in work; their facts stay, and inference adds no operations to them.
        around: What the cell offers.
        has_history: The inferred stock lies on the site, so it stays where it is.
    """
    known = old.component_by_id
    frozen = {i: _frozen(merged.component_by_id[i], known[i]) for i in standing}
    start = replace(merged, component_by_id={**merged.component_by_id, **frozen})
    start = with_stock_of(start, old)
    lies = set(stock_of(old)) if has_history and not is_jointed_frame(merged) else set()
    laid = {i: replace(start.component_by_id[i], origins={}) for i in lies}
    start = replace(start, component_by_id={**start.component_by_id, **laid})
    after, problems = complete(start, around)
    restored = {
        i: _thawed(c, frozen.get(i), known[i])
        for i, c in after.component_by_id.items()
        if i in frozen or i in lies
    }
    return replace(after, component_by_id={**after.component_by_id, **restored}), problems


def _is_made(component: Component) -> bool:
    return component.layer is Layer.MATERIAL and not is_given(component, "layer")


def _unmarked(component: Component, read: Component | None) -> Component:
    if read is None or is_given(component, _TYPE):
        return component
    origins = {k: v for k, v in component.origins.items() if k != _TYPE}
    return replace(component, type=read.type, origins=origins)


def _frozen(merged: Component, old: Component) -> Component:
    """Return what stands with its facts stated; words and new operations are the merged ones."""
    kept = {o.id: o for o in (*old.operations, *merged.operations) if _is_stated(o.id, merged, old)}
    return replace(
        old,
        name=merged.name,
        group=merged.group,
        source=merged.source,
        raw=merged.raw,
        ext={**old.ext, **merged.ext},
        operations=tuple(replace(o, origin=Origin.GIVEN) for o in kept.values()),
        origins={},
    )


def _is_stated(operation: str, merged: Component, old: Component) -> bool:
    """Whether an operation was inferred for what stands, or is still stated."""
    if operation in {o.id for o in merged.operations}:
        return True
    return any(o.id == operation and o.origin is not Origin.GIVEN for o in old.operations)


def _thawed(component: Component, frozen: Component | None, old: Component) -> Component:
    """Return a component with the evidence it had; what inference added to it is left out."""
    if frozen is None:
        return replace(component, origins=old.origins)
    origin_by_id: Mapping[str, Origin] = {o.id: o.origin for o in old.operations}
    operations = tuple(
        replace(o, origin=origin_by_id.get(o.id, Origin.GIVEN)) for o in frozen.operations
    )
    return replace(frozen, operations=operations, origins=old.origins)
