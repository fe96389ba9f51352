"""Small frames of boxes for the inference tests; an argument not named is irrelevant."""

from __future__ import annotations

from collections.abc import Sequence

from sitewright.building_model.component import BoxGeometry, Component, Layer, PlaneCut
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector

Z: Vector = (0.0, 0.0, 1.0)


def beam(  # noqa: PLR0913 - each names one thing that a test is about
    name: str,
    centre: Vector,
    size: Vector,
    *,
    x_axis: Vector = (1.0, 0.0, 0.0),
    y_axis: Vector = (0.0, 1.0, 0.0),
    cuts: Sequence[PlaneCut] = (),
    word: str = "beam",
) -> Component:
    """Return a box-shaped target; `size` is along its own axes."""
    return Component(
        id=ComponentId(name),
        layer=Layer.TARGET,
        type=word,
        geometry=BoxGeometry(size),
        world_T_component=Pose.from_axes(centre, x_axis, y_axis),
        cuts=tuple(cuts),
    )


def upright(name: str, centre: Vector, size: Vector) -> Component:
    """Return a beam that stands: its x axis points up."""
    return beam(name, centre, size, x_axis=Z, y_axis=(1.0, 0.0, 0.0))


def frame(components: Sequence[Component], *joints: str) -> BuildingModel:
    """Return a model; a joint is written ``stud-sill``: the first butts against the second."""
    return BuildingModel(
        name="frame",
        component_by_id={c.id: c for c in sorted(components, key=lambda c: c.id)},
        relations=tuple(
            Relation(kind=RelationKind.CONNECTION, a=ComponentId(a), b=ComponentId(b))
            for a, b in (joint.split("-") for joint in joints)
        ),
    )


def portal() -> BuildingModel:
    """Return a sill, two studs on it, a plate on these, and a rail between the studs."""
    return frame(
        [
            beam("sill", (0.0, 0.0, 0.05), (2.0, 0.1, 0.1)),
            upright("left", (-0.9, 0.0, 1.1), (2.0, 0.1, 0.1)),
            upright("right", (0.9, 0.0, 1.1), (2.0, 0.1, 0.1)),
            beam("rail", (0.0, 0.0, 1.2), (1.7, 0.1, 0.1)),
            beam("plate", (0.0, 0.0, 2.15), (2.0, 0.1, 0.1)),
        ],
        "left-sill",
        "right-sill",
        "left-plate",
        "right-plate",
        "rail-left",
        "rail-right",
    )
