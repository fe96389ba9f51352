"""Of all that a file draws, what is built here, and whether it is built lying flat."""

from __future__ import annotations

from dataclasses import replace

from sitewright.app.import_options import ImportOptionError
from sitewright.building_model.component import Component, Layer
from sitewright.building_model.laying import NoPanel, laid_flat
from sitewright.building_model.model import BuildingModel
from sitewright.errors import did_you_mean


def only_group(design: BuildingModel, group: str) -> BuildingModel:
    """Return a design in which nothing but one group is built; the rest is drawn only.

    Raises:
        ImportOptionError: No target is of this group.
    """
    known = _groups(design)
    if group not in known:
        there = f"Its groups are: {', '.join(known)}." if known else "Its targets have no groups."
        raise ImportOptionError(
            f"No component to build is of group {group!r}. {there}{did_you_mean(group, known)}"
        )
    return replace(
        design,
        component_by_id={i: _drawn_unless(c, group) for i, c in design.component_by_id.items()},
    )


def built_flat(design: BuildingModel, *, is_turned_over: bool) -> BuildingModel:
    """Return a design that is built lying flat.

    Raises:
        ImportOptionError: What is to be built is no panel.
    """
    laid = laid_flat(design, is_turned_over=is_turned_over)
    if not isinstance(laid, NoPanel):
        return laid
    width, height, thickness = (f"{x:.2f}" for x in laid.size_m)
    groups = _groups(design)
    hint = f" Name one panel with --group: {', '.join(groups)}." if len(groups) > 1 else ""
    raise ImportOptionError(
        f"--lay-flat: what is to be built is {width} m wide, {height} m high and {thickness} m "
        f"thick; that is no panel.{hint}"
    )


def _groups(design: BuildingModel) -> list[str]:
    found = {c.group for c in design.component_by_id.values() if c.layer is Layer.TARGET}
    return sorted(found - {""})


def _drawn_unless(component: Component, group: str) -> Component:
    if component.layer is not Layer.TARGET or component.group == group:
        return component
    return replace(component, layer=Layer.AS_DESIGNED)
