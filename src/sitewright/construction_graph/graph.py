"""The construction relationship graph: a DAG under the jobsite, as a value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sitewright.building_model.component import Layer, Operation
from sitewright.foundation.ids import ComponentId, StockPlaceId
from sitewright.foundation.pose import Pose, Vector

JOBSITE = ComponentId("jobsite")
"""Root of every graph; everything that stands on the ground has it as construction parent."""

NOWHERE = StockPlaceId("")
"""Place of a piece that lies at no stock place: in a gripper, at its target, or fallen."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Node:
    """One component in the graph.

    Attributes:
        label: Name that people see; falls back to the id.
        construction_parents: What it rests on; (JOBSITE,) if it stands on the ground.
        world_T_component: Pose in the world (not the model) frame.
        size_m: Box of the component in its own frame.
        material_used: Piece that an As-Built node was made of.
    """

    id: ComponentId
    label: str
    layer: Layer
    type: str
    construction_parents: tuple[ComponentId, ...]
    world_T_component: Pose
    size_m: Vector
    material_used: ComponentId | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetNode(Node):
    """A component still to be built.

    Attributes:
        material_type: Type, section (m, sorted) and length (m) that a piece must have, and the
            material if the designer states one.
        operations: What is done to it once it is in place, in order.
        order: Construction order.
        hold_until_fasteners: How many fasteners before the robot lets go.
    """

    material_type: tuple[str, tuple[float, float], float, str]
    operations: tuple[Operation, ...] = ()
    order: int | None = None
    hold_until_fasteners: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class MaterialNode(Node):
    """A piece of stock; its construction parent is the piece below it, or the jobsite.

    Attributes:
        place: Stock place (or buffer) that it lies at; `NOWHERE` if it lies at none.
        material: Designer's word for what it is made of; empty if not stated.
    """

    place: StockPlaceId
    material: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class ConstructionGraph:
    """All nodes by id, the jobsite left out; edges are the construction parents.

    Attributes:
        comes_before: Pairs (earlier, later) of components that do not carry each other but
            must be installed in this order.
    """

    node_by_id: Mapping[ComponentId, Node]
    comes_before: tuple[tuple[ComponentId, ComponentId], ...] = ()
