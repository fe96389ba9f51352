"""Facts that were inferred from geometry that has changed since."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from sitewright.building_model.component import Component, Origin, is_given
from sitewright.building_model.findings import warned
from sitewright.building_model.inference.assembly import NEIGHBOUR_M
from sitewright.building_model.inference.carrying import Bearing
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.errors import Problem

_WORDS: Mapping[RelationKind, str] = {
    RelationKind.SUPPORTS: "rest on",
    RelationKind.CONTACT: "touch",
}
_FIX = "Infer anew: `sitewright infer --write`."


def stale_problems(model: BuildingModel, bearing: Bearing) -> Iterator[Problem]:
    """Yield I3 for each inferred support, contact or ground that the shapes no longer bear out."""
    for relation in model.relations:
        words = _WORDS.get(relation.kind)
        ends = {relation.a, relation.b}
        if words is None or relation.origin is not Origin.INFERRED or ends - bearing.bodies.keys():
            continue
        if not _holds(relation, bearing):
            component = model.component_by_id[relation.b]
            yield _stale(component, f"was inferred to {words} {relation.a}")
    for i in bearing.bodies:
        component = model.component_by_id[i]
        if component.ground and not is_given(component, "ground") and i not in bearing.ground:
            yield _stale(component, "was inferred to stand on the ground")


def _stale(component: Component, what: str) -> Problem:
    problem = warned("I3", component, f"It {what}, but does not any more.", _FIX)
    return replace(problem, is_fixable=True)


def _holds(relation: Relation, bearing: Bearing) -> bool:
    """Whether two components still stand to each other as inferred; near is near enough."""
    one, other = bearing.bodies[relation.a], bearing.bodies[relation.b]
    gap = np.maximum(one.low_m - other.high_m, other.low_m - one.high_m)
    if float(gap.max()) > NEIGHBOUR_M:
        return False
    is_noted_as_near = "gap_m" in relation.data
    if relation.kind is RelationKind.SUPPORTS:
        return relation.a in bearing.carriers[relation.b]
    return is_noted_as_near or relation.b in bearing.touching[relation.a]
