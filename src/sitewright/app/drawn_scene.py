"""A state of the building as a scene to look at: shapes, poses in the site, colours, facts."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping

from sitewright.app.built_state import BuiltState
from sitewright.building_model.as_built import deviation_of, status_of
from sitewright.building_model.component import Component, Geometry, Layer, PlaneCut
from sitewright.building_model.formats.gltf import Drawn, Look, Scene, Surface, joined
from sitewright.building_model.inference.bodies import Part, part_of
from sitewright.building_model.shapes import UnsupportedGeometryError, shape_of
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape

SCHEMA = "sitewright.scene/1"
_LOOK_BY_LAYER: Mapping[Layer, Look] = {
    Layer.TARGET: Look(name="target", rgb=(0.25, 0.50, 0.85), opacity=0.35),
    Layer.MATERIAL: Look(name="material", rgb=(0.70, 0.55, 0.35)),
    Layer.AS_BUILT: Look(name="as_built", rgb=(0.35, 0.60, 0.25)),
    Layer.AS_DESIGNED: Look(name="as_designed", rgb=(0.60, 0.60, 0.60), opacity=0.25),
    Layer.VIRTUAL_COLLISION: Look(name="virtual_collision", rgb=(0.85, 0.20, 0.20), opacity=0.25),
}
_UNDER_WAY = Look(name="in work", rgb=(0.95, 0.65, 0.10))
_REJECTED = Look(name="rejected", rgb=(0.80, 0.10, 0.10))
_LOOK_BY_STATUS: Mapping[str, Look] = {
    **dict.fromkeys(("held", "placed", "fastened"), _UNDER_WAY),
    "rejected": _REJECTED,
}
"""Looks of targets that have their piece but are not installed."""


def drawn_scene(state: BuiltState) -> tuple[Scene, list[str]]:
    """Return everything of a state that has a shape and a place, and what is left out and why."""
    artist = _Artist(state)
    drawn = [d for c in state.as_built.component_by_id.values() for d in artist.drawn(c)]
    facts: dict[str, Json] = {
        "schema": SCHEMA,
        "state": state.name,
        "installed": state.installed,
        "frame": "model" if state.cell is None else "cell",
    }
    if any(state.as_built.origin_shift_m):
        facts["origin_shift_m"] = list(state.as_built.origin_shift_m)
    return Scene(name=state.as_built.name, drawn=tuple(drawn), facts=facts), artist.left_out


class _Artist:
    """Draws components one by one; equal shapes are worked out once."""

    def __init__(self, state: BuiltState) -> None:
        self._state = state
        self._stack_by_piece = {i: s for s in state.as_built.stacks for i in s.items}
        self._surfaces: dict[tuple[Geometry, tuple[PlaneCut, ...]], Surface] = {}
        self._shapeless: list[str] = []
        self._placeless: Counter[str] = Counter()

    @property
    def left_out(self) -> list[str]:
        """What was not drawn, and why."""
        lost = [
            f"Stock is not drawn (pieces: {count}): the cell has no stock place {place!r}."
            for place, count in sorted(self._placeless.items())
        ]
        return [*self._shapeless, *lost]

    def drawn(self, component: Component) -> Iterator[Drawn]:
        """Yield the component's node; none if it has no shape or nobody knows where it is."""
        pose = self._pose(component)
        if pose is None:
            self._placeless[self._stack_by_piece[component.id].place] += 1
            return
        try:
            surface = self._surface(component)
        except (UnsupportedGeometryError, ValueError) as error:
            self._shapeless.append(f"{component.id} is not drawn: {error}")
            return
        yield Drawn(
            name=component.id,
            site_T_drawn=pose,
            surface=surface,
            look=_LOOK_BY_STATUS.get(status_of(component), _LOOK_BY_LAYER[component.layer]),
            facts=_facts(component, self._state.world_T_model),
        )

    def _pose(self, component: Component) -> Pose | None:
        """Return where a component is, as sensed if it was; None for stock at an unknown place."""
        record, seen = component.as_built, self._state.site.sensed
        if record is not None and record.world_T_component_measured is not None:
            return record.world_T_component_measured
        if seen is not None and component.id in seen.world_T_piece:
            return seen.world_T_piece[component.id]
        stack = self._stack_by_piece.get(component.id)
        if stack is None:
            return self._state.world_T_model @ component.world_T_component
        places = {} if self._state.cell is None else self._state.cell.stock_place_by_id
        if stack.place not in places:
            return None
        return places[stack.place].world_T_stock @ component.world_T_component

    def _surface(self, component: Component) -> Surface:
        key = (component.geometry, component.cuts)
        if key not in self._surfaces:
            self._surfaces[key] = surface_of(shape_of(component))
        return self._surfaces[key]


def surface_of(shape: Shape) -> Surface:
    """Return the faces of all convex pieces of a shape, in its body's frame."""
    return joined([_surface_of(part_of(piece, Pose())) for piece in shape])


def _surface_of(part: Part) -> Surface:
    """Return a convex piece's faces as fans of triangles, over the corners that they use."""
    used = sorted({i for polygon in part.polygons for i in polygon})
    new = {old: i for i, old in enumerate(used)}
    fans = (
        (new[polygon[0]], new[polygon[k]], new[polygon[k + 1]])
        for polygon in part.polygons
        for k in range(1, len(polygon) - 1)
    )
    corners = ((float(x), float(y), float(z)) for x, y, z in part.corners_m[used])
    return Surface(tuple(corners), tuple(fans))


def _facts(component: Component, world_T_model: Pose) -> dict[str, Json]:
    record, source = component.as_built, component.source
    off = deviation_of(component, world_T_model)
    facts: dict[str, Json] = {
        "label": component.name,
        "layer": component.layer.value,
        "type": component.type,
        "status": status_of(component),
        "material": component.material,
        "group": component.group,
        "order": component.order,
        "source_id": source.id if source else "",
        "material_used": record.material_used if record else None,
        "robot": record.robot if record else "",
        "installed_at": record.installed_at if record else "",
        "operations": {str(o): s for o, s in record.operations.items()} if record else None,
        "deviation_mm": None if off is None else round(off[0] * 1000.0, 3),
        "deviation_deg": None if off is None else round(math.degrees(off[1]), 4),
    }
    return {k: v for k, v in facts.items() if v not in (None, "", {})}
