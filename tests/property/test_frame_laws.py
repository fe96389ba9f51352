"""Large frames are looked at in short cuts: each agrees with looking at everything."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from builders_frame import beam
from sitewright.building_model.component import PlaneCut
from sitewright.building_model.inference.blocking import Obstacles, samples
from sitewright.building_model.inference.insertion import way_out
from sitewright.building_model.inference.nearness import near_pairs
from sitewright.building_model.inference.order import arrivals
from sitewright.building_model.inference.solid import Solid, solid_of
from sitewright.building_model.inference.standing import Standing
from sitewright.building_model.inference.statics import Statics, statics_of
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector, add, dot, rotation, scale, unit

_WITHIN_M = 0.1
coordinates = st.integers(-8, 8).map(lambda n: n * 0.21)
places = st.tuples(coordinates, coordinates, coordinates)
lines = st.tuples(*(st.integers(-3, 3),) * 3).filter(any).map(unit)


@st.composite
def solids(draw: st.DrawFn) -> Solid:
    size = tuple(draw(st.sampled_from((0.1, 0.3, 1.5))) for _ in range(3))
    component = beam("x", draw(places), size)  # type: ignore[arg-type]
    turn = rotation(draw(lines), draw(st.sampled_from((0.0, 0.4, 1.2))))
    cuts = (PlaneCut((size[0] * 0.4, 0.0, 0.0), unit((1.0, 0.0, draw(coordinates)))),)
    pose = Pose(component.world_T_component.position_m) @ turn
    made = solid_of(
        replace(component, world_T_component=pose, cuts=cuts if draw(st.booleans()) else ())
    )
    assert made is not None
    return made


def named(many: list[Solid]) -> dict[ComponentId, Solid]:
    return {ComponentId(f"s{k}"): s for k, s in enumerate(many)}


@given(st.lists(solids(), max_size=8), st.sampled_from((0.0, 0.001, 0.5)))
def test_near_pairs_are_those_of_all_pairs_that_come_near(many: list[Solid], by: float) -> None:
    by_id = named(many)
    brute = [p for p in combinations(sorted(by_id), 2) if by_id[p[0]].may_be_near(by_id[p[1]], by)]
    assert near_pairs(by_id, by) == brute


def holds(solid: Solid, point: Vector) -> bool:
    return all(dot(f.plane.normal, point) <= f.plane.offset_m + _WITHIN_M for f in solid.faces)


@settings(max_examples=200)
@given(st.lists(solids(), max_size=6), places, lines, st.sampled_from((0.0, 0.6, 3.0)), st.data())
def test_a_line_is_hidden_if_a_sample_of_it_lies_in_a_thicker_solid(
    many: list[Solid], start: Vector, direction: Vector, length_m: float, data: st.DataObject
) -> None:
    obstacles = Obstacles(many, _WITHIN_M)
    first = data.draw(st.integers(0, len(many)))
    but = data.draw(st.sets(st.integers(0, 5)))
    points = [add(start, scale(direction, k * 0.05)) for k in range(1, int(length_m / 0.05) + 1)]
    there = [s for k, s in enumerate(many[:first]) if k not in but]
    expected = any(holds(s, p) for s in there for p in points)
    assert obstacles.hide(start, direction, length_m, first, but) == expected
    if points:
        taken = samples(np.array([start]), np.array([direction]), length_m)
        held = obstacles.held(taken, obstacles.near(taken, first).tolist())
        assert held.tolist() == [any(holds(s, p) for s in many[:first]) for p in points]


@st.composite
def frames(draw: st.DrawFn) -> BuildingModel:
    """Return blocks on a grid, some joined to neighbours."""
    cells = sorted(draw(st.sets(st.tuples(*(st.integers(0, 2),) * 3), min_size=1, max_size=9)))
    blocks = {c: beam("b{}{}{}".format(*c), scale(c, 0.2), (0.2, 0.2, 0.2)) for c in cells}
    beside = [p for p in combinations(cells, 2) if np.abs(np.subtract(*p)).sum() == 1]
    joints = draw(st.sets(st.sampled_from(beside))) if beside else set()
    return BuildingModel(
        name="blocks",
        component_by_id={c.id: c for c in blocks.values()},
        relations=tuple(
            Relation(kind=RelationKind.CONNECTION, a=blocks[a].id, b=blocks[b].id)
            for a, b in sorted(joints)
        ),
    )


def may_leave(statics: Statics, present: frozenset[ComponentId]) -> set[ComponentId]:
    carrying = {c for i in present for c in statics.carriers_of(i)}
    rests = {i: present - {i} for i in present - carrying}
    return {i for i, rest in rests.items() if statics.anchored(rest) == rest}


@settings(max_examples=150)
@given(frames(), st.data())
def test_what_may_leave_is_what_lets_all_others_lead_down(
    model: BuildingModel, data: st.DataObject
) -> None:
    """Whatever is taken away, also what should have stayed: the remembered holds stay right."""
    statics = statics_of(model)
    standing = Standing(statics, statics.anchored(frozenset(statics.solid_by_id)))
    while standing.present:
        present = frozenset(standing.present)
        assert standing.lost == present - statics.anchored(present)
        if not standing.lost:
            free = {i for i in present if standing.kept_by(i) is None}
            assert free == may_leave(statics, present)
        standing.take(data.draw(st.sampled_from(sorted(present))))


def rank(
    statics: Statics, component: ComponentId, present: frozenset[ComponentId]
) -> tuple[int, float, str]:
    there = [s for other, s in statics.around[component].items() if other in present]
    height_m = statics.solid_by_id[component].lowest_m(statics.up)
    way = way_out(there, statics.up, height_m - statics.ground_m)
    trouble = 2 if way is None else int(way.slide_m > 0.0)
    return trouble, -round(height_m, 4), component


@settings(max_examples=80)
@given(frames())
def test_a_frame_comes_apart_from_the_end_as_if_each_step_looked_at_everything(
    model: BuildingModel,
) -> None:
    statics = statics_of(model)
    coming = arrivals(statics)
    present = statics.anchored(frozenset(statics.solid_by_id))
    assert {a.id for a in coming} == present
    for arrival in reversed(coming):
        free = may_leave(statics, present) or present
        assert arrival.id == min(free, key=lambda i: rank(statics, i, present))
        present -= {arrival.id}
