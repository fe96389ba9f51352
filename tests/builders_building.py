"""Building models and files for tests: an argument that is not named is irrelevant."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sitewright.building_model.component import (
    BoxGeometry,
    Component,
    FastenerSpec,
    Layer,
    Operation,
    Process,
)
from sitewright.building_model.model import BuildingModel, Relation, Stack
from sitewright.building_model.piling import piled
from sitewright.foundation.ids import ComponentId, OperationId, StackId, StockPlaceId
from sitewright.foundation.pose import Pose, Vector, rotation, translation

EXAMPLES = Path(__file__).parent.parent / "examples"
DOWN = rotation((1.0, 0.0, 0.0), 3.141592653589793)
STUD_M: Vector = (1.8, 0.09, 0.04)
PLACE = StockPlaceId("pallet")


def ids(*names: str) -> tuple[ComponentId, ...]:
    return tuple(ComponentId(n) for n in names)


def component(
    identity: str,
    *,
    layer: Layer = Layer.TARGET,
    kind: str = "stud",
    size_m: Vector = STUD_M,
    at_m: Vector = (0.0, 0.0, 0.02),
    on: Sequence[str] = (),
    **more: Any,
) -> Component:
    return Component(
        id=ComponentId(identity),
        layer=layer,
        type=kind,
        geometry=BoxGeometry(size_m),
        world_T_component=translation(*at_m),
        construction_parents=ids(*on),
        **more,
    )


def piece(identity: str, *, kind: str = "stud", size_m: Vector = STUD_M, **more: Any) -> Component:
    return component(identity, layer=Layer.MATERIAL, kind=kind, size_m=size_m, **more)


def nail(name: str, *, on: Sequence[str], at_m: Vector, length_m: float = 0.09) -> Operation:
    return Operation(
        id=OperationId(name),
        process=Process.NAIL,
        on=ids(*on),
        component_T_operation=Pose(at_m, DOWN.quaternion_wxyz),
        fastener=FastenerSpec(type="nail", d_m=0.0031, l_m=length_m),
    )


def model(
    *components: Component,
    stacks: Sequence[Sequence[Component]] = (),
    relations: Sequence[Relation] = (),
    **more: Any,
) -> BuildingModel:
    """Return a model; each stack is given by its pieces, bottom first, and piled up."""
    piles = []
    pieces: list[Component] = []
    for number, items in enumerate(stacks, start=1):
        pile = Stack(id=StackId(f"stack-{number}"), place=PLACE, items=tuple(p.id for p in items))
        piles.append(pile)
        pieces += piled(pile, items)
    everything = sorted((*components, *pieces), key=lambda c: c.id)
    return BuildingModel(
        name="test",
        component_by_id={c.id: c for c in everything},
        relations=tuple(relations),
        stacks=tuple(piles),
        **more,
    )


def stock(count: int, **more: Any) -> list[Component]:
    return [piece(f"piece-{n}", **more) for n in range(1, count + 1)]


def document(**changes: Any) -> dict[str, Any]:
    """Return the case study's `building.json` with top keys replaced."""
    text = (EXAMPLES / "wooden_frame" / "building.json").read_text(encoding="utf-8")
    return {**json.loads(text), **changes}


def codes(problems: Sequence[Any], severity: str = "E") -> list[str]:
    return [p.code for p in problems if p.severity == severity]
