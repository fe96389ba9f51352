"""What stands already must not change with the design: the check of a new one (I1)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from sitewright.building_model.component import Component, Operation, Origin
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.same_value import is_same
from sitewright.central_controller.cycle_state import CycleState
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose

_FACTS = ("layer", "type", "material", "geometry", "cuts")
_SAME_RAD = 1e-5


def targets_in_work(state: CycleState) -> frozenset[ComponentId]:
    """Return the targets that are installed, placed, or whose piece a robot holds."""
    targets = set(state.site.placed) | set(state.site.installed)
    if state.proposal is not None and _gripped(state):
        targets.add(state.proposal.target)
    return frozenset(targets)


def pieces_in_work(state: CycleState) -> frozenset[ComponentId]:
    """Return the pieces that are built in, or in a gripper."""
    return state.site.consumed | _gripped(state)


def protection_problems(
    old: BuildingModel | None, new: BuildingModel, state: CycleState, fix: str
) -> list[Problem]:
    """Return an error for each component in work that a new design lacks or changes.

    Args:
        old: The design that they were built by; None tells only what is missing.
        new: The design to come.
        state: The folded chain of runs.
        fix: What the user can do about it.
    """
    in_work = sorted(targets_in_work(state) | pieces_in_work(state))
    return [
        Problem(
            code="I1",
            severity="E",
            where=i,
            message=f"It is {_standing(state, i)}, but {what}.",
            fix=fix,
            source_id=_source_id(old, new, i),
        )
        for i in in_work
        if (what := _what_differs(old, new, state, i))
    ]


def _gripped(state: CycleState) -> frozenset[ComponentId]:
    seen = state.site.sensed
    robots = seen.robots.values() if seen is not None else ()
    return frozenset(r.gripped for r in robots if r.gripped is not None)


def _standing(state: CycleState, component: ComponentId) -> str:
    if component in state.site.installed:
        return "installed"
    if component in state.site.placed:
        return "in place and not finished"
    return "built in" if component in state.site.consumed else "in work"


def _what_differs(
    old: BuildingModel | None, new: BuildingModel, state: CycleState, component: ComponentId
) -> str:
    there = new.component_by_id.get(component)
    if there is None:
        return "not in the new design"
    before = old.component_by_id.get(component) if old is not None else None
    if before is None:
        return ""
    is_piece = component in pieces_in_work(state)
    wrong = [f for f in _FACTS if not is_same(getattr(before, f), getattr(there, f))]
    if not is_piece:
        wrong += [*_moved(before.world_T_component, there.world_T_component)]
        wrong += [*_changed_operations(before, there, state.site.done_operations)]
    return f"the new design changes it: {', '.join(wrong)}" if wrong else ""


def _moved(before: Pose, there: Pose) -> Iterator[str]:
    by_m, by_rad = before.distance_to_m(there), before.angle_to_rad(there)
    if not is_same(before.position_m, there.position_m) or by_rad > _SAME_RAD:
        yield f"pose (by {by_m * 1e3:.1f} mm, {math.degrees(by_rad):.2f} deg)"


def _changed_operations(
    before: Component, there: Component, done: frozenset[OperationId]
) -> Iterator[str]:
    """Name the executed operations that are gone or differ; new ones are work still to do."""
    now = {o.id: o for o in there.operations}
    for operation in before.operations:
        if operation.id in done:
            other = now.get(operation.id)
            if other is None or not is_same(_plain(operation), _plain(other)):
                yield f"operation {operation.id} (done already)"


def _plain(operation: Operation) -> Operation:
    """Leave out what says nothing about the hole in the wood."""
    return replace(operation, origin=Origin.GIVEN, params={}, after=(), needs_hold=False)


def _source_id(old: BuildingModel | None, new: BuildingModel, component: ComponentId) -> str:
    for model in (new, old):
        found = model.component_by_id.get(component) if model is not None else None
        if found is not None and found.source is not None:
            return found.source.id
    return ""
