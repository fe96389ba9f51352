"""Stacks of material as a designer draws them: pieces in the model, with stack and index."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.formats.part_names import usable_id
from sitewright.building_model.formats.user_text import Attributes
from sitewright.building_model.model import Stack
from sitewright.foundation.ids import ComponentId, StackId, StockPlaceId
from sitewright.foundation.pose import Pose, cross, norm


def drawn_stacks(
    components: Mapping[ComponentId, Component], attributes: Mapping[ComponentId, Attributes]
) -> tuple[tuple[Stack, ...], dict[ComponentId, Component]]:
    """Return the stacks, and their pieces in the frame of the stock place.

    A stack is bound to the stock place of its own name. The place's frame is taken at the
    middle of the lowest piece's underside, x along that piece and z up.
    """
    piles: dict[str, list[tuple[float, float, ComponentId]]] = defaultdict(list)
    for name, component in components.items():
        stack = attributes[name].get("stack")
        if stack and component.layer is Layer.MATERIAL:
            height = component.world_T_component.position_m[2]
            piles[stack].append((_index(attributes[name]), height, name))
    stacks, moved = [], {}
    for stack, entries in sorted(piles.items()):
        items = tuple(name for _, _, name in sorted(entries))
        place_T_world = _foot(components[items[0]]).inverse()
        for name in items:
            piece = components[name]
            moved[name] = replace(piece, world_T_component=place_T_world @ piece.world_T_component)
        word = usable_id(stack)
        stacks.append(Stack(id=StackId(word), place=StockPlaceId(word), items=items))
    return tuple(stacks), moved


def _index(attributes: Attributes) -> float:
    """Return the place in the pile from below; without one the height decides."""
    try:
        return float(attributes.get("stack_index") or 0.0)
    except ValueError:
        return 0.0


def _foot(piece: Component) -> Pose:
    from sitewright.building_model.shapes import extent_of, shape_of

    pose = piece.world_T_component
    low_m = extent_of(shape_of(piece), pose).low_m[2]
    x, y, _ = pose.position_m
    up = (0.0, 0.0, 1.0)
    along = pose.x_axis if norm(cross(pose.x_axis, up)) > 1e-6 else pose.y_axis  # noqa: PLR2004
    return Pose.from_z_axis((x, y, low_m), up, along)
