"""What became of each object of the imported file, by the file's own ids: what goes back to it."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from sitewright.building_model.as_built import deviation_of, status_of
from sitewright.building_model.component import AsBuilt, Component, Layer, Source
from sitewright.building_model.model import BuildingModel
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector, add

CONSUMED = "consumed"
"""Status of a piece of stock that a component was made of: it is stock no more."""
PARTLY = "partly"
"""Status of an object whose bodies do not all have the same one."""
_SPLIT_BEHIND_A_DOT = frozenset({"ifc", "rhino"})
"""Kinds whose ids hold no dot, so that what stands behind one numbers the bodies of an object."""
_BUILT_LAYER, _USED_LAYER = "As-Built", "Consumed"
"""Layers of a drawing for what was built and for stock that was used."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ObjectState:
    """What became of one object of a file.

    Attributes:
        kind: Kind of the file.
        components: What was made of it: one, or one for each of its bodies.
        status: ``planned``, ``held``, ``placed``, ``fastened``, ``verified``, ``rejected`` of
            a target, ``available`` or ``consumed`` of stock, ``partly``; empty for all else.
        layer: Where it is now; None if its bodies are on several layers.
        record: Of the body that was installed last; None if nothing was.
        used_for: The target that a consumed piece became.
        deviation: How far (m, rad) the sensed pose is from the designed one.
        file_T_component_measured: Sensed pose in the file's coordinates, in metres.
    """

    source_id: str
    kind: str
    components: tuple[ComponentId, ...]
    status: str
    layer: Layer | None
    record: AsBuilt | None = None
    used_for: ComponentId | None = None
    deviation: tuple[float, float] | None = None
    file_T_component_measured: Pose | None = None

    @property
    def is_changed(self) -> bool:
        """Whether anything became of it that its file does not say."""
        return self.record is not None or self.status == CONSUMED

    @property
    def moves_to(self) -> str:
        """Name of the drawing's layer that it goes to; empty if it stays where it is."""
        if self.status == CONSUMED:
            return _USED_LAYER
        return _BUILT_LAYER if self.record is not None and self.layer is Layer.AS_BUILT else ""


def object_states(
    design: BuildingModel, as_built: BuildingModel, world_T_model: Pose
) -> dict[str, ObjectState]:
    """Return the state of every object of the file that components come from, by its id.

    Args:
        design: The design.
        as_built: The same with as-built records folded in; consumed pieces are gone from it.
        world_T_model: Places the model in the cell that measured it.
    """
    bodies: dict[str, list[Component]] = defaultdict(list)
    for component in design.component_by_id.values():
        if component.source is not None and component.source.id:
            bodies[_object_id(component.source)].append(component)
    used_for = {
        c.as_built.material_used: c.id
        for c in as_built.component_by_id.values()
        if c.as_built is not None and c.as_built.material_used is not None
    }
    now = as_built.component_by_id
    return {
        identity: _joined(
            [
                _used(identity, c, used_for.get(c.id))
                if c.id not in now
                else _standing(identity, now[c.id], as_built, world_T_model)
                for c in bodies[identity]
            ]
        )
        for identity in sorted(bodies)
    }


def status_document(states: Mapping[str, ObjectState]) -> dict[str, Json]:
    """Return the content of ``status.json``: all that is known of each object, by its id."""
    return {identity: _entry(state) for identity, state in states.items()}


def keys_of(state: ObjectState) -> dict[str, str]:
    """Return what is written into a drawing's attributes, by key without prefix."""
    if state.status == CONSUMED:
        return {"status": CONSUMED, "used_for": state.used_for or ""}
    if state.record is None:
        return {"status": state.status} if state.status else {}
    off = state.deviation
    return {
        "status": state.status,
        "built_at": state.record.installed_at,
        "robot": state.record.robot,
        "material_used": state.record.material_used or "",
        "deviation_mm": "" if off is None else f"{off[0] * 1000.0:.2f}",
        "deviation_deg": "" if off is None else f"{math.degrees(off[1]):.3f}",
    }


def _object_id(source: Source) -> str:
    return source.id.partition(".")[0] if source.kind in _SPLIT_BEHIND_A_DOT else source.id


def _used(identity: str, piece: Component, target: ComponentId | None) -> ObjectState:
    return ObjectState(
        source_id=identity,
        kind=_kind(piece),
        components=(piece.id,),
        status=CONSUMED,
        layer=Layer.AS_DESIGNED,
        used_for=target,
    )


def _standing(
    identity: str, component: Component, as_built: BuildingModel, world_T_model: Pose
) -> ObjectState:
    record = component.as_built
    measured = record.world_T_component_measured if record else None
    return ObjectState(
        source_id=identity,
        kind=_kind(component),
        components=(component.id,),
        status=status_of(component),
        layer=component.layer,
        record=record,
        deviation=deviation_of(component, world_T_model),
        file_T_component_measured=_in_file(measured, world_T_model, as_built.origin_shift_m),
    )


def _kind(component: Component) -> str:
    return component.source.kind if component.source else ""


def _in_file(world_T: Pose | None, world_T_model: Pose, shift_m: Vector) -> Pose | None:
    if world_T is None:
        return None
    model_T = world_T_model.inverse() @ world_T
    return Pose(add(model_T.position_m, shift_m), model_T.quaternion_wxyz)


def _joined(bodies: Sequence[ObjectState]) -> ObjectState:
    """Return one state of an object for those of its bodies: the one that was built last tells."""
    last = max(bodies, key=lambda s: (s.is_changed, _time(s), s.components))
    statuses, layers = {s.status for s in bodies}, {s.layer for s in bodies}
    return replace(
        last,
        components=tuple(i for s in bodies for i in s.components),
        status=last.status if len(statuses) == 1 else PARTLY,
        layer=last.layer if len(layers) == 1 else None,
    )


def _time(state: ObjectState) -> str:
    return state.record.installed_at if state.record else ""


def _entry(state: ObjectState) -> dict[str, Json]:
    measured = state.file_T_component_measured
    operations = state.record.operations if state.record else {}
    found: dict[str, Json] = {
        "components": list(state.components),
        "changed": state.is_changed,
        "layer": "" if state.layer is None else state.layer.value,
        "moves_to": state.moves_to,
        "keys": dict(keys_of(state)),
    }
    if operations:
        found["operations"] = {str(o): s for o, s in operations.items()}
    if measured is not None:
        found["measured"] = {
            "p_m": [round(v, 7) for v in measured.position_m],
            "q_wxyz": [round(v, 9) for v in measured.quaternion_wxyz],
        }
    return found
