"""Where stated facts and geometry do not agree: the stated ones win, but are reported."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.building_model.component import Component, Layer, is_given
from sitewright.building_model.findings import warned
from sitewright.building_model.inference.carrying import GROUND_M, Bearing, lowest_m
from sitewright.building_model.inference.order_facts import Assembling
from sitewright.building_model.model import BuildingModel
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId

CODE = "P6"


def contradictions(
    model: BuildingModel, bearing: Bearing, sequence: Assembling
) -> Iterator[Problem]:
    """Yield one problem for each stated fact that the geometry speaks against."""
    yield from stated_contradictions(model, bearing)
    for i in sequence.steps:
        yield from _order(model, model.component_by_id[i], bearing, sequence)


def stated_contradictions(model: BuildingModel, bearing: Bearing) -> Iterator[Problem]:
    """Yield the contradictions that show without an order: parents and ground."""
    if model.ground_z_m and abs(model.ground_z_m - bearing.ground_m) > GROUND_M:
        message = f"Nothing stands on the stated ground; the lowest is at {bearing.ground_m:.3f} m."
        fix = "Correct 'ground_z_m', or move the model."
        yield Problem(code=CODE, severity="W", where="build", message=message, fix=fix)
    for i in bearing.bodies:
        component = model.component_by_id[i]
        if component.layer is Layer.TARGET:
            yield from _parents(component, bearing)
            yield from _ground(component, bearing)


def _parents(component: Component, bearing: Bearing) -> Iterator[Problem]:
    if not is_given(component, "construction_parents"):
        return
    near = bearing.touching[component.id].keys() | bearing.joined[component.id]
    for parent in component.construction_parents:
        if parent in bearing.bodies and parent not in near:
            message = f"It is said to rest on {parent}, but does not touch it (gap over 1 mm)."
            yield warned(CODE, component, message, "Check both poses, or name another parent.")


def _ground(component: Component, bearing: Bearing) -> Iterator[Problem]:
    above_m = lowest_m(bearing.bodies[component.id], bearing.up) - bearing.ground_m
    if component.ground and is_given(component, "ground") and above_m > GROUND_M:
        message = f"It is said to stand on the ground, but ends {above_m * 1000:.0f} mm above it."
        yield warned(CODE, component, message, "Check its pose, or remove 'ground'.")


def _order(
    model: BuildingModel, component: Component, bearing: Bearing, sequence: Assembling
) -> Iterator[Problem]:
    """Yield carriers that come later, though what they carry does not carry them in turn."""
    i = component.id
    for carrier in sorted(bearing.carriers[i]):
        if sequence.place[carrier] > sequence.place[i] and not _is_mutual(bearing, i, carrier):
            message = f"It comes before {carrier}, which carries it."
            yield warned(CODE, component, message, _order_fix(model, i, carrier))


def _is_mutual(bearing: Bearing, one: ComponentId, other: ComponentId) -> bool:
    """Whether `one` carries `other` too, by itself or through others."""
    seen, waiting = set[ComponentId](), [other]
    while waiting:
        component = waiting.pop()
        if component == one:
            return True
        if component not in seen:
            seen.add(component)
            waiting += bearing.carriers[component]
    return False


def _order_fix(model: BuildingModel, one: ComponentId, other: ComponentId) -> str:
    first, second = (model.component_by_id[i].order for i in (one, other))
    if first is not None and second is not None:
        return f"Orders are {first} and {second}: turn them round, or hold it."
    return "Check the stated parents and relations between them."
