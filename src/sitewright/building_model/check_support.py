"""Does each target stand on something, or does something hold it?"""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.building_model.component import Component, Layer, Process
from sitewright.building_model.findings import refused, warned
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.building_model.shapes import Extent, extent_of, shape_of
from sitewright.errors import Problem
from sitewright.foundation.pose import Pose, dot, scale, unit

_GAP_M = 0.005
_HOLDS = frozenset({Process.NAIL, Process.SCREW, Process.GLUE, Process.WELD, Process.MORTAR})


def support_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield targets that nothing carries from below."""
    held = {r.b for r in model.relations if r.kind is RelationKind.HOLD}
    for component in model.component_by_id.values():
        if component.layer is not Layer.TARGET or _is_carried(model, component):
            continue
        if any(o.process in _HOLDS for o in component.operations) or component.id in held:
            message = "It has no support below: hold until fastened."
            yield warned("F1", component, message, "Check 'hold_until_fasteners'.")
        else:
            message = "It has no support below and no operation fastens it."
            fix = "Add falsework ('temporary_support') or an operation."
            yield refused("F2", component, message, fix)


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
