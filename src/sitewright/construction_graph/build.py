"""Makes the construction graph of a building model in a cell, as the site stands now."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.matching import material_type_of
from sitewright.building_model.model import BuildingModel, RelationKind, Stack
from sitewright.building_model.shapes import size_of
from sitewright.construction_graph.graph import (
    JOBSITE,
    NOWHERE,
    ConstructionGraph,
    MaterialNode,
    Node,
    TargetNode,
)
from sitewright.foundation.ids import ComponentId, StockPlaceId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Cell


@dataclass(frozen=True, slots=True, kw_only=True)
class InstalledPiece:
    """A target that was built in this run.

    Attributes:
        material: The piece that it was made of.
        world_T_component: Measured pose in the world.
    """

    material: ComponentId
    world_T_component: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class MovedPiece:
    """A piece that is not where the design put it.

    Attributes:
        place: Stock place or buffer where it lies now; `NOWHERE` if in a gripper or fallen.
        world_T_component: Sensed pose in the world.
    """

    place: StockPlaceId
    world_T_component: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class SiteChanges:
    """What happened on the site since the design.

    Attributes:
        installed: Targets that stand, fastened and finished.
        consumed: Further pieces that are gone as stock (rejected, cut, taken away).
        moved: Pieces that lie elsewhere; the pieces above one in its stack come down to the
            one below it.
        sensed: Poses in the world of pieces that still lie in their stacks.
    """

    installed: Mapping[ComponentId, InstalledPiece] = field(default_factory=dict)
    consumed: frozenset[ComponentId] = frozenset()
    moved: Mapping[ComponentId, MovedPiece] = field(default_factory=dict)
    sensed: Mapping[ComponentId, Pose] = field(default_factory=dict)

    @property
    def gone(self) -> frozenset[ComponentId]:
        """Pieces that are no stock any more."""
        return self.consumed | {i.material for i in self.installed.values()}


def graph_of(
    model: BuildingModel, cell: Cell, changes: SiteChanges | None = None
) -> ConstructionGraph:
    """Return the graph: targets, what stands, zones and stacks under the jobsite.

    Args:
        model: A checked building model.
        cell: Gives the model's place in the world and the stock places.
        changes: What happened on the site; nothing by default.
    """
    now = changes or SiteChanges()
    stocked = {c.id for c in model.component_by_id.values() if c.layer is Layer.MATERIAL}
    nodes = {
        c.id: _building_node(model, cell, c, now)
        for c in model.component_by_id.values()
        if c.id not in stocked
    }
    for stack in model.stacks:
        nodes |= {n.id: n for n in _stack_nodes(model, cell, stack, now)}
    return ConstructionGraph(
        node_by_id={i: nodes[i] for i in sorted(nodes)}, comes_before=_comes_before(model)
    )


def _building_node(
    model: BuildingModel, cell: Cell, component: Component, changes: SiteChanges
) -> Node:
    pose = cell.world_T_model @ component.world_T_component
    if component.layer is not Layer.TARGET:
        return _standing(model, component, pose)
    target = TargetNode(
        id=component.id,
        label=component.name or component.id,
        layer=Layer.TARGET,
        type=component.type,
        construction_parents=_parents(model, component),
        world_T_component=pose,
        size_m=size_of(component),
        material_type=material_type_of(component),
        operations=component.operations,
        order=component.order,
        hold_until_fasteners=component.hold_until_fasteners,
    )
    installed = changes.installed.get(component.id)
    if installed is None:
        return target
    return built_node(target, installed.material, installed.world_T_component)


def built_node(target: Node, material: ComponentId | None, world_T_component: Pose) -> Node:
    """Return the As-Built node that a target becomes: same id, label and construction parents."""
    return Node(
        id=target.id,
        label=target.label,
        layer=Layer.AS_BUILT,
        type=target.type,
        construction_parents=target.construction_parents,
        world_T_component=world_T_component,
        size_m=target.size_m,
        material_used=material,
    )


def _standing(model: BuildingModel, component: Component, world_T_component: Pose) -> Node:
    record = component.as_built
    measured = record.world_T_component_measured if record else None
    return Node(
        id=component.id,
        label=component.name or component.id,
        layer=component.layer,
        type=component.type,
        construction_parents=_parents(model, component),
        world_T_component=measured or world_T_component,
        size_m=size_of(component),
        material_used=record.material_used if record else None,
    )


def _parents(model: BuildingModel, component: Component) -> tuple[ComponentId, ...]:
    """Return the construction parents in the designer's order, then what else supports it."""
    supports = sorted(
        r.a for r in model.relations if r.kind is RelationKind.SUPPORTS and r.b == component.id
    )
    return tuple(dict.fromkeys((*component.construction_parents, *supports))) or (JOBSITE,)


def _stack_nodes(
    model: BuildingModel, cell: Cell, stack: Stack, changes: SiteChanges
) -> Iterator[MaterialNode]:
    below = JOBSITE
    place = cell.stock_place_by_id.get(stack.place)
    world_T_stock = place.world_T_stock if place else Pose()
    for item in stack.items:
        if item in changes.gone:
            continue
        component = model.component_by_id[item]
        moved = changes.moved.get(item)
        designed = world_T_stock @ component.world_T_component
        yield MaterialNode(
            id=item,
            label=component.name or item,
            layer=Layer.MATERIAL,
            type=component.type,
            construction_parents=(JOBSITE if moved else below,),
            world_T_component=moved.world_T_component
            if moved
            else changes.sensed.get(item, designed),
            size_m=size_of(component),
            place=moved.place if moved else stack.place,
            material=component.material,
        )
        below = below if moved else item


def _comes_before(model: BuildingModel) -> tuple[tuple[ComponentId, ComponentId], ...]:
    """Return (earlier, later): ``a before b``; ``a blocks b`` means that b comes first."""
    pairs = {
        (r.a, r.b) if r.kind is RelationKind.BEFORE else (r.b, r.a)
        for r in model.relations
        if r.kind in (RelationKind.BEFORE, RelationKind.BLOCKS)
    }
    return tuple(sorted(pairs))


__all__ = ["NOWHERE", "InstalledPiece", "MovedPiece", "SiteChanges", "built_node", "graph_of"]
