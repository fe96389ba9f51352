"""What only the shapes tell: overlaps, near misses, and facts that do not follow from them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from sitewright.building_model.component import Component, is_given
from sitewright.building_model.inference.bodies import bodies_of
from sitewright.building_model.inference.carrying import Bearing, bearing_of
from sitewright.building_model.inference.contradictions import stated_contradictions
from sitewright.building_model.inference.fit import fit_problems
from sitewright.building_model.inference.interfaces import interfaces_of
from sitewright.building_model.inference.staleness import stale_problems
from sitewright.building_model.model import BuildingModel
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId

_UNSUPPORTED = frozenset({"F1", "F2"})
_NAMED = 3


def with_geometry(model: BuildingModel, found: Sequence[Problem]) -> list[Problem]:
    """Return the problems of a model with those that its shapes add, and corrected by them.

    A component that states nothing below it (F1, F2) may well touch what would carry it: then it
    is the statement that is missing (F4), not the support.

    Args:
        model: One without degenerate geometry or unknown references.
        found: What `check_model` found.
    """
    bodies, problems = bodies_of(model)
    components = {i: model.component_by_id[i] for i in bodies}
    interfaces = interfaces_of(bodies)
    bearing = bearing_of(model, bodies, interfaces)
    problems += fit_problems(components, bodies, interfaces)
    problems += stated_contradictions(model, bearing)
    problems += stale_problems(model, bearing)
    return [*_supported(model, bearing, found), *problems]


def _supported(
    model: BuildingModel, bearing: Bearing, found: Iterable[Problem]
) -> Iterator[Problem]:
    anchored = bearing.anchored(frozenset(bearing.bodies))
    for problem in found:
        component = ComponentId(problem.where)
        if problem.code in _UNSUPPORTED and component in anchored:
            yield _unstated(model.component_by_id[component], bearing, problem)
        else:
            yield problem


def _unstated(component: Component, bearing: Bearing, problem: Problem) -> Problem:
    """Return F4, or the problem itself if its fasteners are what holds the component."""
    i = component.id
    carriers = bearing.carriers[i]
    fix = "Let `sitewright infer --write` state it."
    if i in bearing.roots:
        message = f"It stands on the ground ({bearing.ground_m:.3f} m), but nothing says so."
    elif carriers and component.construction_parents:
        message = f"It rests on {_listed(carriers)}, not on its construction parents."
        fix = "Name those that carry it, or correct the poses."
    elif carriers:
        message = f"It states no construction parents, but rests on {_listed(carriers)}."
    elif problem.code == "F2":
        joined = bearing.holders(i, bearing.bodies)
        message = f"It states no construction parents, but is joined to {_listed(joined)}."
    else:
        return problem
    states_parents = component.construction_parents and is_given(component, "construction_parents")
    return replace(
        problem,
        code="F4",
        message=message,
        fix=fix,
        is_fixable=i in bearing.roots or not states_parents,
    )


def _listed(names: Iterable[ComponentId]) -> str:
    these = sorted(names)
    more = f" and {len(these) - _NAMED} more" if len(these) > _NAMED else ""
    return ", ".join(these[:_NAMED]) + more
