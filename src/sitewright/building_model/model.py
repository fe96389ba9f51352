"""The building model: components, relations and stacks of one project."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sitewright.building_model.component import Component, Origin, Source
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, StackId, StockPlaceId
from sitewright.foundation.pose import Pose, Vector


class RelationKind(StrEnum):
    """How two components stand to each other: read ``a <kind> b``."""

    SUPPORTS = "supports"
    CONTACT = "contact"
    CONNECTION = "connection"
    BLOCKS = "blocks"
    BEFORE = "before"
    HOLD = "hold"


@dataclass(frozen=True, slots=True, kw_only=True)
class Relation:
    """A fact about two components, with where it comes from."""

    kind: RelationKind
    a: ComponentId
    b: ComponentId
    origin: Origin = Origin.GIVEN
    confidence: float = 1.0
    data: Mapping[str, Json] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class Stack:
    """A pile of material, from bottom to top; only the top is accessible.

    Attributes:
        place: Stock place of the cell that it stands on.
        stock_T_stack: Pose of the pile's frame at that place.
        items: Components on layer Material, bottom first.
    """

    id: StackId
    place: StockPlaceId
    items: tuple[ComponentId, ...]
    stock_T_stack: Pose = field(default_factory=Pose)
    spacer_m: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class BuildingModel:
    """A design, as its author wrote it.

    Attributes:
        component_by_id: All components, in order of id. Material pieces of stacks are among
            them; their `world_T_component` is in the frame of the stock place.
        origin_shift_m: Shift taken off the source coordinates, restored on export.
        raw: Facts of the source file as a whole, verbatim, e.g. ``survey``: where it lies on Earth.
        gravity: Direction and size of gravity in the model frame while it is built, m/s2.
        ground_z_m: Height of the ground or table along up, against gravity, in the model frame.
        site_T_model: How it lies in the site of the cell while it is built: a wall drawn standing
            and nailed flat is turned. Gravity must point down there.
    """

    name: str
    component_by_id: Mapping[ComponentId, Component]
    relations: tuple[Relation, ...] = ()
    stacks: tuple[Stack, ...] = ()
    sources: tuple[Source, ...] = ()
    materials: Mapping[str, Json] = field(default_factory=dict)
    component_types: Mapping[str, Json] = field(default_factory=dict)
    rules: tuple[Mapping[str, Json], ...] = ()
    origin_shift_m: Vector = (0.0, 0.0, 0.0)
    raw: Mapping[str, Json] = field(default_factory=dict)
    gravity: Vector = (0.0, 0.0, -9.81)
    ground_z_m: float = 0.0
    site_T_model: Pose = field(default_factory=Pose)
