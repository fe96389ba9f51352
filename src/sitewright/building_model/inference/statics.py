"""Who stands on what: ground, carriers from below, neighbours that a beam is joined to."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from sitewright.building_model.component import Layer
from sitewright.building_model.inference.contact import Contact, contacts_of
from sitewright.building_model.inference.insertion import AROUND_M
from sitewright.building_model.inference.nearness import near_pairs
from sitewright.building_model.inference.separation import Separation, edged, separation_of
from sitewright.building_model.inference.solid import Solid, solid_of
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector, dot, scale, unit

CARRIES = 0.7
"""A contact carries if its normal points up by at least this (45 degrees)."""
GROUND_M = 0.005
"""Components that end this near to the lowest point of all stand on the ground."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Touching:
    """A neighbour, seen from one component.

    Attributes:
        normal: Unit vector in the model frame, out of the component into the neighbour.
    """

    other: ComponentId
    normal: Vector
    area_m2: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Statics:
    """How the targets of a model stand, hang and touch.

    Attributes:
        up: Unit vector against gravity.
        ground_m: Height of the ground.
        ground: Components that stand on it.
        carriers: Joined components that carry a component from below.
        joined: Components that are connected with it.
        touching: Face contacts of each component.
        around: Separations of each component from what stands near it when all is built.
    """

    up: Vector
    solid_by_id: Mapping[ComponentId, Solid]
    ground_m: float
    ground: frozenset[ComponentId]
    carriers: Mapping[ComponentId, tuple[Contact, ...]]
    joined: Mapping[ComponentId, frozenset[ComponentId]]
    touching: Mapping[ComponentId, tuple[Touching, ...]]
    around: Mapping[ComponentId, Mapping[ComponentId, Separation]]

    def carriers_of(self, component: ComponentId) -> frozenset[ComponentId]:
        """Return the joined components that carry it from below."""
        return frozenset(c.a for c in self.carriers[component])

    def is_carried(self, component: ComponentId) -> bool:
        """Whether the ground or a joined component carries it from below."""
        return component in self.ground or bool(self.carriers[component])

    def holders(
        self, component: ComponentId, among: AbstractSet[ComponentId]
    ) -> frozenset[ComponentId]:
        """Return the joined components among some that do not rest on it themselves."""
        return frozenset(
            j for j in self.joined[component] & among if component not in self.carriers_of(j)
        )

    def stays_on(self, component: ComponentId) -> frozenset[ComponentId]:
        """Return what it may lead down by: its carriers, else what it is joined to."""
        return self.carriers_of(component) or self.holders(component, self.joined[component])

    def anchored(self, present: frozenset[ComponentId]) -> frozenset[ComponentId]:
        """Return those that lead down to the ground: by carriers, else by a joined neighbour."""
        found: set[ComponentId] = set()
        waiting = sorted(present & self.ground)
        while waiting:
            component = waiting.pop()
            if component in found:
                continue
            found.add(component)
            waiting += sorted(
                j
                for j in self.joined[component]
                if j in present and j not in found and component in self.stays_on(j)
            )
        return frozenset(found)


def statics_of(model: BuildingModel) -> Statics:
    """Look at the box-shaped targets of a model; others are not looked at."""
    up = unit(scale(model.gravity, -1.0))
    targets = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    solids = {c.id: s for c in targets if (s := solid_of(c)) is not None}
    joined = _joined(model, solids)
    towards = _towards(solids, contacts_of(solids))
    lowest_m = min((s.lowest_m(up) for s in solids.values()), default=0.0)
    return Statics(
        up=up,
        solid_by_id=solids,
        ground_m=lowest_m,
        ground=frozenset(i for i, s in solids.items() if s.lowest_m(up) <= lowest_m + GROUND_M),
        carriers={
            i: tuple(c for c in towards[i] if dot(c.normal, up) > CARRIES and c.a in joined[i])
            for i in solids
        },
        joined=joined,
        touching={
            i: tuple(
                Touching(other=c.a, normal=scale(c.normal, -1.0), area_m2=c.area_m2)
                for c in towards[i]
            )
            for i in solids
        },
        around=_around(solids),
    )


def _around(
    solids: Mapping[ComponentId, Solid],
) -> dict[ComponentId, dict[ComponentId, Separation]]:
    found: dict[ComponentId, dict[ComponentId, Separation]] = {i: {} for i in solids}
    compared = {i: edged(s) for i, s in solids.items()}
    for a, b in near_pairs(solids, AROUND_M):
        separation = separation_of(compared[a], compared[b])
        if separation.gap_m() < AROUND_M:
            found[a][b] = separation
            found[b][a] = separation.reversed()
    return found


def _joined(
    model: BuildingModel, solids: Mapping[ComponentId, Solid]
) -> dict[ComponentId, frozenset[ComponentId]]:
    joined: dict[ComponentId, set[ComponentId]] = {i: set() for i in solids}
    for relation in model.relations:
        if relation.kind is RelationKind.CONNECTION and {relation.a, relation.b} <= solids.keys():
            joined[relation.a].add(relation.b)
            joined[relation.b].add(relation.a)
    return {i: frozenset(others) for i, others in joined.items()}


def _towards(
    solids: Iterable[ComponentId], contacts: Iterable[Contact]
) -> dict[ComponentId, list[Contact]]:
    """Return each component's contacts, turned so that the normal points into it."""
    found: dict[ComponentId, list[Contact]] = {i: [] for i in solids}
    for contact in contacts:
        a, b, away = contact.a, contact.b, scale(contact.normal, -1.0)
        found[b].append(contact)
        found[a].append(Contact(a=b, b=a, normal=away, area_m2=contact.area_m2))
    return found
