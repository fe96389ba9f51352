"""Who carries whom: ground, contacts from below, joints; and whether a piece stands by itself."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from sitewright.building_model.component import Layer, Origin
from sitewright.building_model.inference.bodies import Body, Points
from sitewright.building_model.inference.interfaces import Interface
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.foundation.ids import ComponentId

CARRIES = 0.7
"""A contact carries if its normal points up by more than this (45 degrees)."""
GROUND_M = 0.005
"""Components that end this near to the ground stand on it."""
_SLENDER = 5.0
"""What is this many times higher above its base than the base is wide topples easily."""
_INSIDE_M = 0.005

Edge = tuple[ComponentId, ComponentId]


@dataclass(frozen=True, slots=True, kw_only=True)
class Bearing:
    """How the components of a model bear on each other once all stand.

    Attributes:
        up: Unit vector against gravity.
        roots: Components that stand by themselves: on the ground, existing, or on falsework.
        ground: Those of them that the ground carries.
        carriers: Components that carry one from below, by contact.
        touching: Contacts of each component, by neighbour.
        joined: Components that a joint or a fastener holds together.
    """

    up: Points
    ground_m: float
    bodies: Mapping[ComponentId, Body]
    roots: frozenset[ComponentId]
    ground: frozenset[ComponentId]
    carriers: Mapping[ComponentId, frozenset[ComponentId]]
    touching: Mapping[ComponentId, Mapping[ComponentId, Interface]]
    joined: Mapping[ComponentId, frozenset[ComponentId]]

    def is_carried(self, component: ComponentId) -> bool:
        """Whether it stands by itself or something carries it from below."""
        return component in self.roots or bool(self.carriers[component])

    def holders(
        self, component: ComponentId, among: Iterable[ComponentId]
    ) -> frozenset[ComponentId]:
        """Return what it is joined to among some, less what rests on it."""
        return frozenset(
            j for j in self.joined[component] & set(among) if component not in self.carriers[j]
        )

    def anchored(self, present: frozenset[ComponentId]) -> frozenset[ComponentId]:
        """Return those that lead down to a root: by what carries them, else by a joint."""
        found: set[ComponentId] = set()
        waiting = sorted(present & self.roots)
        while waiting:
            component = waiting.pop()
            if component in found:
                continue
            found.add(component)
            near = self.joined[component] | self.touching[component].keys()
            waiting += [j for j in near if j in present and self._leans_on(j, component)]
        return frozenset(found)

    def _leans_on(self, component: ComponentId, on: ComponentId) -> bool:
        carriers = self.carriers[component]
        if carriers:
            return on in carriers
        return on in self.joined[component] and component not in self.carriers[on]

    def topples(self, component: ComponentId, there: Iterable[ComponentId]) -> str:
        """Return why a carried component would fall over among some others, or nothing."""
        base = self._base(component, there)
        if len(base) == 0:
            return ""
        body = self.bodies[component]
        u, v = _across(self.up)
        centre = np.array([body.centre_m @ u, body.centre_m @ v])
        span_m, margin_m = _base_span(base @ np.array([u, v]).T, centre)
        if margin_m < _INSIDE_M:
            return "its centre of mass is not above what carries it"
        rises_m = float(body.centre_m @ self.up - (base @ self.up).min())
        if rises_m > _SLENDER * span_m:
            return f"it stands {2 * rises_m / span_m:.0f} times as high as its base is wide"
        return ""

    def _base(self, component: ComponentId, there: Iterable[ComponentId]) -> Points:
        """Return corners of the contacts from below; on the ground, its lowest corners."""
        body, around = self.bodies[component], set(there)
        rows = [
            np.array(p.corners_m)
            for i in self.carriers[component] & around
            for p in self.touching[component][i].patches
            if abs(float(np.array(p.normal) @ self.up)) > CARRIES
        ]
        if component in self.ground:
            heights = body.corners_m @ self.up
            rows.append(body.corners_m[heights < self.ground_m + GROUND_M])
        return np.vstack(rows) if rows else np.empty((0, 3))


def bearing_of(
    model: BuildingModel,
    bodies: Mapping[ComponentId, Body],
    interfaces: Iterable[Interface],
    fastened: Iterable[Edge] = (),
) -> Bearing:
    """Return who carries whom, from gravity, contacts and what the model states.

    Args:
        model: Gravity, ground, joints and operations.
        bodies: Its components.
        interfaces: Their contacts.
        fastened: Pairs that rules will fasten.
    """
    gravity = np.array(model.gravity)
    size = float(np.linalg.norm(gravity))
    up = -gravity / size if size > 0.0 else np.array([0.0, 0.0, 1.0])
    touching: dict[ComponentId, dict[ComponentId, Interface]] = {i: {} for i in bodies}
    carriers: dict[ComponentId, set[ComponentId]] = {i: set() for i in bodies}
    for interface in interfaces:
        a, b = interface.a, interface.b
        touching[a][b] = touching[b][a] = interface
        rises = [float(np.array(p.normal) @ up) for p in interface.patches]
        if max(rises) > CARRIES:
            carriers[b].add(a)
        if min(rises) < -CARRIES:
            carriers[a].add(b)
    ground_m, ground = _ground(model, bodies, up)
    return Bearing(
        up=up,
        ground_m=ground_m,
        bodies=bodies,
        roots=ground | _self_standing(model, bodies),
        ground=ground,
        carriers={i: frozenset(c) for i, c in carriers.items()},
        touching=touching,
        joined=_joined(bodies, [*_connections(model), *_fastened(model), *fastened]),
    )


def lowest_m(body: Body, up: Points) -> float:
    """Return the height of a body's lowest point."""
    return float((body.corners_m @ up).min())


def _ground(
    model: BuildingModel, bodies: Mapping[ComponentId, Body], up: Points
) -> tuple[float, frozenset[ComponentId]]:
    """Return the height of the ground and who stands on it.

    The height is the stated one if something stands there, else that of the lowest point.
    """
    heights = {i: lowest_m(b, up) for i, b in bodies.items()}
    level_m = model.ground_z_m
    if heights and all(abs(h - level_m) > GROUND_M for h in heights.values()):
        level_m = min(heights.values())
    stated = {i for i in bodies if _states_ground(model, i)}
    return level_m, frozenset(stated | {i for i, h in heights.items() if h <= level_m + GROUND_M})


def _states_ground(model: BuildingModel, component: ComponentId) -> bool:
    found = model.component_by_id[component]
    origin, _ = found.origins.get("ground", (Origin.GIVEN, ""))
    return found.ground and origin is Origin.GIVEN


def _self_standing(
    model: BuildingModel, bodies: Mapping[ComponentId, Body]
) -> frozenset[ComponentId]:
    components = [model.component_by_id[i] for i in bodies]
    return frozenset(c.id for c in components if c.temporary_support or c.layer is not Layer.TARGET)


def _joined(
    bodies: Mapping[ComponentId, Body], edges: Iterable[Edge]
) -> dict[ComponentId, frozenset[ComponentId]]:
    joined: dict[ComponentId, set[ComponentId]] = {i: set() for i in bodies}
    for a, b in edges:
        if a in joined and b in joined and a != b:
            joined[a].add(b)
            joined[b].add(a)
    return {i: frozenset(others) for i, others in joined.items()}


def _connections(model: BuildingModel) -> list[Edge]:
    kinds = (RelationKind.CONNECTION, RelationKind.HOLD)
    return [(r.a, r.b) for r in model.relations if r.kind in kinds]


def _fastened(model: BuildingModel) -> list[Edge]:
    return [
        (a, b)
        for c in model.component_by_id.values()
        for o in c.operations
        for a in o.on
        for b in o.on
        if a < b
    ]


def _across(up: Points) -> tuple[Points, Points]:
    helper = np.eye(3)[int(np.argmin(np.abs(up)))]
    u = np.cross(up, helper)
    u /= np.linalg.norm(u)
    return u, np.cross(up, u)


def _base_span(base: Points, centre: Points) -> tuple[float, float]:
    """Return the narrowest width of flat points, and how far inside them a point lies.

    Looked at in 24 directions, which is exact enough for a warning.
    """
    angles = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    directions = np.column_stack([np.cos(angles), np.sin(angles)])
    reach = (base @ directions.T).max(axis=0)
    width_m = float((reach + np.roll(reach, 12)).min())
    return max(width_m, 1e-6), float((reach - directions @ centre).min())
