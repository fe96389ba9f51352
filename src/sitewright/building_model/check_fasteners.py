"""Do nails and screws reach far enough into what they should hold?"""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.building_model.component import Component, Layer, Operation, Process
from sitewright.building_model.convex import inside_length_m, planes_of
from sitewright.building_model.findings import refused, warned
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import shape_of
from sitewright.errors import Problem
from sitewright.foundation.pose import scale, subtract

MIN_PENETRATION_M = 0.030
"""A fastener must reach at least so far into the receiver."""
_FASTENING = frozenset({Process.NAIL, Process.SCREW})
_WITHOUT_SKILL = frozenset({Process.GLUE, Process.WELD, Process.MORTAR})
_START_BACK_M = 0.001
_THROUGH_AND_INTO = 2


def fastener_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield fasteners that are missing or too short, and processes without a skill."""
    for component in model.component_by_id.values():
        yield from _held_too_long(component)
        for operation in component.operations:
            if operation.process in _WITHOUT_SKILL:
                word = operation.process.value
                message = f"Operation {operation.id!r}: {word!r} has no built-in skill."
                yield warned("S1", component, message, "A plug-in can add one.")
            elif operation.process in _FASTENING:
                yield from _fastening(model, component, operation)
            elif operation.process is Process.PAINT and operation.patch is None:
                message = f"Operation {operation.id!r} paints, but states no patch."
                yield refused("C2", component, message, "Add 'patch' with size and stroke.")


def _held_too_long(component: Component) -> Iterator[Problem]:
    """Yield that a component could never be let go of: it has too few fasteners."""
    wanted = component.hold_until_fasteners
    has = sum(o.process in _FASTENING for o in component.operations)
    if component.layer is not Layer.TARGET or wanted <= has:
        return
    what = {0: "no fastener", 1: "1 fastener"}.get(has, f"{has} fasteners")
    message = f"It is to be held until {wanted} fasteners are in, and has {what}."
    fix = "Give it more nails or screws, or a rule for them; or lower 'hold_until_fasteners'"
    yield refused("F5", component, message, f"{fix} to {has}.")


def penetration_m(component: Component, operation: Operation, receiver: Component) -> float:
    """Return how far the operation's fastener reaches into a component."""
    if operation.fastener is None:
        return 0.0
    world_T_operation = component.world_T_component @ operation.component_T_operation
    receiver_T_operation = receiver.world_T_component.inverse() @ world_T_operation
    direction = receiver_T_operation.z_axis
    start = subtract(receiver_T_operation.position_m, scale(direction, _START_BACK_M))
    length_m = operation.fastener.l_m + _START_BACK_M
    return sum(
        inside_length_m(planes_of(part), start, direction, length_m) for part in shape_of(receiver)
    )


def _fastening(
    model: BuildingModel, component: Component, operation: Operation
) -> Iterator[Problem]:
    if operation.fastener is None or len(operation.on) < _THROUGH_AND_INTO:
        lack = "fastener" if operation.fastener is None else "second entry in 'on' (receiver)"
        message = f"Operation {operation.id!r} states no {lack}."
        yield refused("C2", component, message, "State what is driven, and into what.")
        return
    through, into = (model.component_by_id.get(i) for i in operation.on[:_THROUGH_AND_INTO])
    if through is None or into is None:
        return
    held_m = penetration_m(component, operation, into)
    if held_m < MIN_PENETRATION_M - 1e-6:
        passed_m = penetration_m(component, operation, through)
        length, passed, held = (
            round(x * 1000, 1) for x in (operation.fastener.l_m, passed_m, held_m)
        )
        message = (
            f"{length:g} mm {operation.process.value} {operation.id!r} through {passed:g} mm "
            f"leaves {held:g} mm in {into.id} (< {MIN_PENETRATION_M * 1000:.0f})."
        )
        yield refused("C1", component, message, "Use a longer one, or correct its pose.")
