"""Does each target stand on something, or does something hold it?"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sitewright.building_model.component import Component, Layer, Process
from sitewright.building_model.findings import refused, warned
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.building_model.shapes import Extent, extent_of, shape_of
from sitewright.errors import Problem
from sitewright.foundation.pose import Pose, dot, scale, unit

DRIVEN = frozenset({Process.NAIL, Process.SCREW})
"""Processes whose fasteners carry a component as soon as they are in."""
_HELD_BY = 2
_GAP_M = 0.005
_HOLDS = frozenset({Process.NAIL, Process.SCREW, Process.GLUE, Process.WELD, Process.MORTAR})


def support_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield targets that nothing carries from below."""
    held = {r.b for r in model.relations if r.kind is RelationKind.HOLD}
    for component in model.component_by_id.values():
        if component.layer is not Layer.TARGET or _is_carried(model, component):
            continue
        if any(o.process in _HOLDS for o in component.operations) or component.id in held:
            yield hanging(component)
        else:
            message = "It has no support below and no operation fastens it."
            fix = "Add falsework ('temporary_support'), an operation, or a rule for fasteners."
            yield refused("F2", component, message, fix)


def hanging(component: Component) -> Problem:
    """Return F1 of a component that only its fasteners or its joints carry."""
    driven = [o for o in component.operations if o.process in DRIVEN]
    count = component.hold_until_fasteners
    if not driven:
        message = "It has no support below: it must be held, and no nail or screw takes over."
        fix = "Give it nails or screws, or a rule for them; or falsework ('temporary_support')."
        return warned("F1", component, message, fix)
    if count:
        what = "fastener is" if count == 1 else "fasteners are"
        message = f"It has no support below: it is held until {count} {what} in."
        fix = f"State another 'hold_until_fasteners' if {count} cannot carry it."
        return warned("F1", component, message, fix)
    message = "It has no support below, and the robot would let go before it is fastened."
    fix = "State 'hold_until_fasteners'."
    return replace(warned("F1", component, message, fix), is_fixable=True)


def fasteners_that_hold(component: Component) -> int:
    """Return how many fasteners must be in before a hanging component is let go: two, or all."""
    return min(_HELD_BY, sum(o.process in DRIVEN for o in component.operations))


def _is_carried(model: BuildingModel, component: Component) -> bool:
    if component.ground or component.temporary_support:
        return True
    up_T_model = _up_frame(model)
    own = extent_of(shape_of(component), up_T_model @ component.world_T_component)
    if own.low_m[2] <= model.ground_z_m + _GAP_M:
        return True
    return any(
        _carries(extent_of(shape_of(below), up_T_model @ below.world_T_component), own)
        for below in _below(model, component)
    )


def _below(model: BuildingModel, component: Component) -> list[Component]:
    names = set(component.construction_parents)
    names |= {
        r.a for r in model.relations if r.kind is RelationKind.SUPPORTS and r.b == component.id
    }
    return [model.component_by_id[n] for n in sorted(names) if n in model.component_by_id]


def _carries(below: Extent, above: Extent) -> bool:
    """Return whether two boxes meet and the first one's middle is the lower one."""
    meet = all(
        below.low_m[i] - _GAP_M <= above.high_m[i] and above.low_m[i] - _GAP_M <= below.high_m[i]
        for i in range(3)
    )
    return meet and below.low_m[2] + below.high_m[2] < above.low_m[2] + above.high_m[2]


def _up_frame(model: BuildingModel) -> Pose:
    """Return the turn that makes gravity point along -z."""
    down = unit(model.gravity) if any(model.gravity) else (0.0, 0.0, -1.0)
    if dot(down, (0.0, 0.0, -1.0)) > 1.0 - 1e-9:
        return Pose()
    return Pose.from_z_axis((0.0, 0.0, 0.0), scale(down, -1.0)).inverse()
