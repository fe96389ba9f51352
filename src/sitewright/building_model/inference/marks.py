"""Part marks: beams of one type and size are told apart if they are cut differently."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace

from sitewright.building_model.component import Component
from sitewright.building_model.inference.solid import solid_of
from sitewright.building_model.matching import material_type_of
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose

_GRID_M = 1e-4
_Signature = tuple[tuple[int, int, int], ...]


def marked_types(targets: Mapping[ComponentId, Component]) -> dict[ComponentId, str]:
    """Return the type of each target, with a mark where equal blanks are cut differently.

    A piece of stock fits a target of equal type and size, so that two beams that only differ in
    their cuts need different types: ``ceiling-1``, ``ceiling-2``.
    """
    shapes = {(c.geometry, c.cuts): c for c in targets.values()}
    known_shapes = {shape: _signature(c) for shape, c in shapes.items()}
    signatures = {i: known_shapes[c.geometry, c.cuts] for i, c in sorted(targets.items())}
    cuts_of: dict[tuple[object, ...], list[_Signature]] = defaultdict(list)
    for i, component in sorted(targets.items()):
        known = cuts_of[material_type_of(component)]
        if signatures[i] not in known:
            known.append(signatures[i])
    return {
        i: _mark(c.type, signatures[i], cuts_of[material_type_of(c)])
        for i, c in sorted(targets.items())
    }


def _mark(word: str, signature: _Signature, known: list[_Signature]) -> str:
    return word if len(known) == 1 else f"{word}-{known.index(signature) + 1}"


def _signature(component: Component) -> _Signature:
    """Return the corners in the component's own frame, on a grid of 0.1 mm."""
    solid = solid_of(replace(component, world_T_component=Pose()))
    corners = solid.corners_m if solid is not None else ()
    return tuple(sorted({(_snap(x), _snap(y), _snap(z)) for x, y, z in corners}))


def _snap(value_m: float) -> int:
    return round(value_m / _GRID_M)
