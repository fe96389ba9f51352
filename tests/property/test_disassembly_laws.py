"""Laws of inference: the exact sweep agrees with samples, and every order can really be built."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from builders_frame import beam
from sitewright.building_model.component import Component
from sitewright.building_model.inference.bodies import Body, body_of
from sitewright.building_model.inference.completion import complete
from sitewright.building_model.inference.separation import edged, separation_of
from sitewright.building_model.inference.solid import Solid, solid_of
from sitewright.building_model.inference.sweeping import TOLERANCE_M, overlaps
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector, add, scale, unit

_REACH_M = 3.0

whole = st.integers(-4, 4)
steps = st.tuples(whole, whole, whole)
sizes = st.tuples(*[st.integers(1, 4)] * 3)
directions = steps.filter(any)


@st.composite
def turned_boxes(draw: st.DrawFn, name: str) -> Component:
    x_axis = draw(directions)
    y_axis = draw(directions.filter(lambda d: bool(np.any(np.cross(d, x_axis)))))
    a, b, c = draw(steps)
    size = scale(_vector(draw(sizes)), 0.1)
    return beam(name, scale((a, b, c), 0.25), size, x_axis=_vector(x_axis), y_axis=_vector(y_axis))


def _vector(v: tuple[int, int, int]) -> Vector:
    return (float(v[0]), float(v[1]), float(v[2]))


def _solid(component: Component) -> Solid:
    found = solid_of(component)
    assert found is not None
    return found


@settings(max_examples=60)
@given(turned_boxes("a"), turned_boxes("b"), directions)
def test_the_exact_sweep_agrees_with_samples(
    one: Component, other: Component, along: tuple[int, int, int]
) -> None:
    """Where samples overlap clearly the sweep says so, and where it says so samples do, nearly."""
    direction = unit(_vector(along))
    apart = separation_of(edged(_solid(one)), edged(_solid(other)))
    travels = np.linspace(0.0, _REACH_M, 301)
    gaps = [apart.gap_m(scale(direction, float(t))) for t in travels]
    found = overlaps([body_of(one), body_of(other)], np.array([direction]))
    enters = min((float(f.enters_m.min()) for f in found), default=np.inf)
    leaves = max((float(f.leaves_m.max()) for f in found), default=-np.inf)
    depth = max(0.0, -gaps[0])
    for travel, gap in zip(travels, gaps, strict=True):
        if gap < -(depth + 2 * TOLERANCE_M):
            assert enters <= travel <= leaves
        if enters < travel < leaves:
            assert gap < 0.0


def _grid(cells: set[tuple[int, int, int]]) -> BuildingModel:
    parts = [
        beam(f"c{x}{y}{z}", (0.2 * x, 0.2 * y, 0.2 * z + 0.1), (0.2, 0.2, 0.2))
        for x, y, z in sorted(cells)
    ]
    return BuildingModel(name="grid", component_by_id={c.id: c for c in parts})


cells = st.sets(st.tuples(*[st.integers(0, 2)] * 3), min_size=1, max_size=14)


@settings(max_examples=25)
@given(cells)
def test_every_linear_order_that_keeps_the_edges_can_be_built_straight(
    chosen: set[tuple[int, int, int]],
) -> None:
    """Built in reversed ties, each block still comes in along its way past all that is there."""
    model, problems = complete(_grid(chosen))
    before: dict[ComponentId, set[ComponentId]] = {i: set() for i in model.component_by_id}
    for relation in model.relations:
        if relation.kind in (RelationKind.SUPPORTS, RelationKind.BEFORE):
            before[relation.b].add(relation.a)
    locked = {p.where for p in problems if p.code == "F3"}
    assert not locked
    there: list[ComponentId] = []
    while len(there) < len(before):
        ready = [i for i, needs in before.items() if i not in there and needs <= set(there)]
        assert ready, "the edges form a cycle"
        coming = max(ready)
        _assert_comes_in(model, coming, there)
        there.append(coming)


def _assert_comes_in(model: BuildingModel, coming: ComponentId, there: list[ComponentId]) -> None:
    way = model.component_by_id[coming].ext["insertion"]
    assert isinstance(way, dict)
    x, y, z = way["from"]
    bodies: list[Body] = [body_of(model.component_by_id[i]) for i in (coming, *there)]
    for other in bodies[1:]:
        for travel in np.arange(0.0, 1.5, 0.02):
            shift = add((0.0, 0.0, 0.0), scale((x, y, z), float(travel)))
            low, high = bodies[0].low_m + shift, bodies[0].high_m + shift
            inside = np.minimum(high, other.high_m) - np.maximum(low, other.low_m)
            assert float(inside.min()) < 2 * TOLERANCE_M


@given(cells)
@settings(max_examples=25)
def test_contacts_of_a_grid_are_its_neighbours(chosen: set[tuple[int, int, int]]) -> None:
    model, _ = complete(_grid(chosen))
    neighbours = {
        (f"c{''.join(map(str, a))}", f"c{''.join(map(str, b))}")
        for a, b in combinations(sorted(chosen), 2)
        if sum(abs(p - q) for p, q in zip(a, b, strict=True)) == 1
    }
    found = {(r.a, r.b) for r in model.relations if r.kind is RelationKind.CONTACT}
    assert found == neighbours
