"""The first rule for frames that state neither supports nor order nor stock."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.building_model.check_support import hanging
from sitewright.building_model.component import Component, Layer, Origin
from sitewright.building_model.findings import refused, warned
from sitewright.building_model.inference.facing import surroundings_of
from sitewright.building_model.inference.marks import marked_types
from sitewright.building_model.inference.order import Arrival, arrivals, floating
from sitewright.building_model.inference.statics import Statics, statics_of
from sitewright.building_model.inference.stock import StockLayout, stock_for
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.errors import Problem
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId

INSERTION = "insertion"
"""Key of `Component.ext` that tells the way in: ``{"from": [x, y, z], "slide_m": s}``."""
NEIGHBOUR_M = 0.015
"""Components that come this near are noted as contacts: no usual clearance fits between."""


def infer_assembly(
    model: BuildingModel, layout: StockLayout | None = None
) -> tuple[BuildingModel, list[Problem]]:
    """Return the model with inferred ground, parents, order, ways in, holds and stock.

    Everything added is marked `inferred` with its evidence. Facts that the model states are
    kept. A target that would stand on nothing keeps no parent and gets no piece: F2.

    Args:
        model: Box-shaped targets and their `connection` relations.
        layout: Stock places to use; by default two at each long side of the building.
    """
    targets = {i: c for i, c in model.component_by_id.items() if c.layer is Layer.TARGET}
    types = marked_types(targets)
    statics = statics_of(model)
    coming = arrivals(statics)
    placed = {a.id: _arriving(targets[a.id], a, statics, types[a.id]) for a in coming}
    pieces, stacks = stock_for(
        placed, statics, coming, surroundings_of(statics), layout or StockLayout()
    )
    components = {**model.component_by_id, **placed, **{p.id: p for p in pieces}}
    relations = _new_relations(model, statics, coming)
    return replace(
        model,
        component_by_id={i: components[i] for i in sorted(components)},
        relations=(*model.relations, *relations),
        stacks=(*model.stacks, *stacks),
        ground_z_m=round(statics.ground_m, 7),
    ), _problems(targets, statics, coming)


def _arriving(target: Component, arrival: Arrival, statics: Statics, word: str) -> Component:
    origins = dict(target.origins)
    is_grounded = arrival.id in statics.ground
    if target.order is None:
        origins["order"] = (Origin.INFERRED, _why_now(arrival))
    if not target.construction_parents:
        origins["construction_parents"] = (Origin.INFERRED, _why_these(arrival, is_grounded))
    if is_grounded and not target.ground:
        origins["ground"] = (
            Origin.INFERRED,
            f"its lowest point is within 5 mm of the lowest of all ({statics.ground_m:.3f} m)",
        )
    if arrival.way is not None and INSERTION not in target.ext:
        origins["insertion"] = (Origin.INFERRED, "the way out of the finished frame, reversed")
    if word != target.type:
        origins["type"] = (Origin.INFERRED, f"{target.type!r}, marked: others are cut differently")
    return replace(
        target,
        type=word,
        order=arrival.number if target.order is None else target.order,
        construction_parents=target.construction_parents or arrival.parents,
        ground=target.ground or is_grounded,
        ext={**_way_in(arrival), **target.ext},
        origins=origins,
    )


def _way_in(arrival: Arrival) -> dict[str, Json]:
    if arrival.way is None:
        return {}
    direction = [round(x, 6) for x in arrival.way.direction]
    return {INSERTION: {"from": direction, "slide_m": round(arrival.way.slide_m, 4)}}


def _why_now(arrival: Arrival) -> str:
    if arrival.way is None:
        return f"{arrival.number}. in reverse of taking apart; its neighbours lock it"
    x, y, z = (round(v, 2) + 0.0 for v in arrival.way.direction)
    sliding = f", sliding {arrival.way.slide_m:.3f} m" if arrival.way.slide_m > 0.0 else ""
    return (
        f"{arrival.number}. in reverse of taking apart: it carries nothing later and "
        f"leaves towards ({x:.2f}, {y:.2f}, {z:.2f}){sliding}"
    )


def _why_these(arrival: Arrival, is_grounded: bool) -> str:  # noqa: FBT001 - one caller
    if is_grounded:
        return "the ground carries it"
    if arrival.is_hanging:
        return "nothing carries it from below; joined to these, it needs hold until fastened"
    return "joined and touching from below (contact normal within 45 degrees of up)"


def _new_relations(model: BuildingModel, statics: Statics, coming: list[Arrival]) -> list[Relation]:
    known = {(r.kind, r.a, r.b) for r in model.relations}
    found = [
        Relation(
            kind=RelationKind.SUPPORTS,
            a=contact.a,
            b=arrival.id,
            origin=Origin.INFERRED,
            data={"area_m2": round(contact.area_m2, 6), "normal": _rounded(contact.normal)},
        )
        for arrival in coming
        for contact in statics.carriers[arrival.id]
    ]
    found += [
        Relation(
            kind=RelationKind.HOLD,
            a=parent,
            b=arrival.id,
            origin=Origin.INFERRED,
            data={"why": "nothing carries it from below"},
        )
        for arrival in coming
        if arrival.is_hanging
        for parent in arrival.parents
    ]
    found += [
        Relation(
            kind=RelationKind.CONTACT,
            a=a,
            b=b,
            origin=Origin.INFERRED,
            data={"gap_m": round(max(0.0, gap_m), 6)},
        )
        for a, others in statics.around.items()
        for b, separation in others.items()
        if a < b and (gap_m := separation.gap_m()) < NEIGHBOUR_M
    ]
    return sorted(
        (r for r in found if (r.kind, r.a, r.b) not in known), key=lambda r: (r.kind, r.a, r.b)
    )


def _rounded(vector: tuple[float, float, float]) -> list[float]:
    return [round(x, 6) + 0.0 for x in vector]


def _problems(
    targets: Mapping[ComponentId, Component], statics: Statics, coming: list[Arrival]
) -> list[Problem]:
    nowhere = "It would stand on nothing: no joined beam leads down to the ground."
    falsework = "Join it, or add falsework ('temporary_support'); it is not placed."
    locked = "The beams built before it leave it no straight way in."
    unseen = "It is no box and was not looked at."
    return [
        *(refused("F2", targets[i], nowhere, falsework) for i in floating(statics)),
        *(hanging(targets[a.id]) for a in coming if a.is_hanging),
        *(
            warned("F3", targets[a.id], locked, "Give 'order' so that it comes earlier.")
            for a in coming
            if a.way is None
        ),
        *(
            warned("G7", c, unseen, "State its parents and order.")
            for i, c in targets.items()
            if i not in statics.solid_by_id
        ),
    ]
