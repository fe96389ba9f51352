"""Stock that was inferred before and still serves stays where it lies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.building_model.component import Component, Layer, is_given
from sitewright.building_model.inference.stock import piece_id
from sitewright.building_model.matching import fits, material_type_of
from sitewright.building_model.model import BuildingModel
from sitewright.foundation.ids import ComponentId


def with_known_stock(before: BuildingModel, after: BuildingModel) -> BuildingModel:
    """Return `after` with the pieces and stacks of `before`, if they serve it as well.

    Piles are laid by rules of thumb that a change of 0.1 um may tip. Pieces lie on a stock place
    already, so they are only laid anew if a target, its size or its place in the order changed.
    """
    old, new = _pieces(before), _pieces(after)
    if old.keys() != new.keys() or not all(_serves(t, before, old) for t in _targets(after)):
        return after
    return replace(after, component_by_id={**after.component_by_id, **old}, stacks=before.stacks)


def _pieces(model: BuildingModel) -> dict[ComponentId, Component]:
    return {
        i: c
        for i, c in model.component_by_id.items()
        if c.layer is Layer.MATERIAL and not is_given(c, "layer")
    }


def _targets(model: BuildingModel) -> list[Component]:
    return [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]


def _serves(
    target: Component, before: BuildingModel, pieces: Mapping[ComponentId, Component]
) -> bool:
    piece, known = pieces.get(piece_id(target.id)), before.component_by_id.get(target.id)
    if piece is None or known is None or known.order != target.order:
        return piece is None and known is not None
    return fits(material_type_of(piece), material_type_of(target))
