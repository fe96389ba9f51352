"""A file that carries what an export wrote, taken as the design that it was.

The author goes on designing in the drawing that the as-built state was written into. There, what
the project's runs have built lies on layer As-Built, and the stock that they used is stock no more;
in the design these are targets and stock, and the runs say the rest.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from sitewright.building_model.component import Layer
from sitewright.building_model.model import BuildingModel, Stack
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.ids import ComponentId, StackId


def as_designed(read: BuildingModel, design: BuildingModel, site: SiteState) -> BuildingModel:
    """Return what was read with the marks taken off that the project's own runs account for.

    Args:
        read: What was read of the file.
        design: The project's design.
        site: What its runs have built.
    """
    built = _on_layer(read, design, site.installed, Layer.AS_BUILT)
    used = _on_layer(read, design, site.consumed, Layer.AS_DESIGNED)
    components = dict(read.component_by_id)
    for name in (*built, *used):
        components[name] = replace(components[name], layer=design.component_by_id[name].layer)
    for name in used:  # drawn where it lay, but the design has it in the frame of its stock place
        pose = design.component_by_id[name].world_T_component
        components[name] = replace(components[name], world_T_component=pose)
    return replace(read, component_by_id=components, stacks=_piled(read, design, used))


def _on_layer(
    read: BuildingModel, design: BuildingModel, names: Collection[ComponentId], layer: Layer
) -> frozenset[ComponentId]:
    found = (n for n in names if n in read.component_by_id and n in design.component_by_id)
    return frozenset(n for n in found if read.component_by_id[n].layer is layer)


def _piled(
    read: BuildingModel, design: BuildingModel, used: frozenset[ComponentId]
) -> tuple[Stack, ...]:
    """Return the stacks with used pieces back in their places."""
    stacks: dict[StackId, Stack] = {s.id: s for s in read.stacks}
    for stack in design.stacks:
        if used.isdisjoint(stack.items):
            continue
        drawn = stacks[stack.id].items if stack.id in stacks else ()
        known = [i for i in stack.items if i in used or i in drawn]
        new = [i for i in drawn if i not in stack.items]
        stacks[stack.id] = replace(stacks.get(stack.id, stack), items=(*known, *new))
    return tuple(stacks[i] for i in sorted(stacks))
