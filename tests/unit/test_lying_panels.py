"""Panels that are built lying flat: order, fasteners and stock follow gravity, not the drawing."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from builders_frame import Z, beam, upright
from sitewright.building_model.component import BoxGeometry, Component, Layer, Origin
from sitewright.building_model.inference.bodies import bodies_of
from sitewright.building_model.inference.completion import Surroundings, complete
from sitewright.building_model.inference.interfaces import interfaces_of
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.building_model.shapes import extent_of, shape_of
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, OperationId, StockPlaceId
from sitewright.foundation.pose import Pose, Vector, dot, rotation, translation

ENDS: Mapping[str, Json] = {
    "id": "ends",
    "kind": "fasten",
    "contact": "end-grain",
    "fastener": {"type": "nail", "d_m": 0.0031, "l_m": 0.09},
}
PARTS = ("sole", "stud-1", "stud-2", "stud-3", "sill", "head")
FACE_UP: Mapping[str, Vector] = {"front": (0.0, 9.81, 0.0), "back": (0.0, -9.81, 0.0)}


def window_panel(names: Sequence[str] = PARTS, face: str = "front") -> BuildingModel:
    """Return a wall as drawn, standing; gravity says on which face it is built."""
    studs = zip(names[1:4], (0.0, 0.6, 1.2), strict=True)
    parts = [
        beam(names[0], (0.6, 0.0, 0.0225), (1.245, 0.095, 0.045)),
        *(upright(name, (x, 0.0, 1.245), (2.4, 0.045, 0.095)) for name, x in studs),
        beam(names[4], (0.3, 0.0, 0.9), (0.555, 0.095, 0.045)),
        beam(names[5], (0.6, 0.0, 2.4675), (1.245, 0.095, 0.045)),
    ]
    return BuildingModel(
        name="panel",
        component_by_id={c.id: c for c in sorted(parts, key=lambda c: c.id)},
        gravity=FACE_UP[face],
        rules=(ENDS,),
    )


def built_order(model: BuildingModel) -> dict[ComponentId, set[ComponentId]]:
    """Return what must come before each target, by relations and parents, transitively."""
    before = {
        i: set(c.construction_parents)
        for i, c in model.component_by_id.items()
        if c.layer is Layer.TARGET
    }
    for r in model.relations:
        if r.kind in (RelationKind.BEFORE, RelationKind.SUPPORTS):
            before[r.b].add(r.a)
    for _ in range(len(before)):
        for earlier in before.values():
            earlier |= {k for j in earlier for k in before[j]}
    return before


@settings(max_examples=25)
@given(st.permutations(PARTS))
def test_whatever_the_names_nothing_is_squeezed_between_two_and_all_has_something_to_be_nailed_to(
    names: list[str],
) -> None:
    model, problems = complete(window_panel(names))
    assert not [p for p in problems if p.severity == "E"]
    before = built_order(model)
    assert all(i not in b for i, b in before.items())
    bodies, _ = bodies_of(model)
    normals: dict[ComponentId, dict[ComponentId, Vector]] = {i: {} for i in bodies}
    for face in interfaces_of({i: bodies[i] for i in before}):
        x, y, z = face.largest.normal
        normals[face.a][face.b], normals[face.b][face.a] = (x, y, z), (-x, -y, -z)
    assert sum(not earlier for earlier in before.values()) == 1, "it grows from one piece"
    for i, earlier in before.items():
        around = normals[i]
        assert all(j in earlier or i in before[j] for j in around), "who comes first is settled"
        there = [n for j, n in around.items() if j in earlier]
        assert all(dot(m, n) > -0.99 for m, n in combinations(there, 2)), f"{i} is squeezed"
        assert there or not earlier, f"{i} has nothing to be nailed to"


def test_what_a_fastener_goes_into_is_there_before_the_one_that_owns_it() -> None:
    model, _ = complete(window_panel())
    before = built_order(model)
    owned = [(c.id, o) for c in model.component_by_id.values() for o in c.operations]
    assert len(owned) == 2 * 8, "three studs at both plates, the sill at two studs"
    assert all(set(o.on) - {i} <= before[i] for i, o in owned)


def test_what_a_stated_nail_goes_into_is_there_first_too() -> None:
    drawn = window_panel()
    done, _ = complete(drawn)
    first = next(i for i, b in built_order(done).items() if not b)
    owners = [c for c in done.component_by_id.values() if c.operations]
    other = next(c for c in owners if first in c.operations[0].on)
    nail = replace(other.operations[0], id=OperationId("own"), origin=Origin.GIVEN)
    into = other.world_T_component @ nail.component_T_operation
    plate = drawn.component_by_id[first]
    nail = replace(nail, component_T_operation=plate.world_T_component.inverse() @ into)
    stated = replace(
        drawn, component_by_id={**drawn.component_by_id, first: replace(plate, operations=(nail,))}
    )
    model, problems = complete(stated)
    assert other.id in built_order(model)[first], "the nail is the first one's: it comes later now"
    assert not [p for p in problems if p.severity == "E"]
    assert complete(model)[0] == model


@pytest.mark.parametrize("face", FACE_UP)
def test_a_piece_lies_in_stock_with_the_face_up_that_is_up_once_it_is_placed(face: str) -> None:
    given_model = window_panel(face=face)
    model, _ = complete(given_model, Surroundings(places=(StockPlaceId("yard"),)))
    up = Pose.from_z_axis((0.0, 0.0, 0.0), tuple(-g for g in given_model.gravity))  # type: ignore[arg-type]
    pieces = [c for c in model.component_by_id.values() if c.layer is Layer.MATERIAL]
    assert len(pieces) == len(PARTS)
    for piece in pieces:
        target = model.component_by_id[ComponentId(piece.id.removeprefix("piece."))]
        inwards = target.world_T_component.inverse().turn(up.z_axis)
        assert piece.world_T_component.turn(inwards) == pytest.approx(Z, abs=1e-9)


@given(st.lists(st.sampled_from([0.0, 0.5, 1.0, -0.5]), min_size=1, max_size=5), st.booleans())
def test_a_pile_of_pieces_has_no_gap_and_no_overlap_however_they_are_turned(
    quarters: list[float],
    stands: bool,  # noqa: FBT001 -- drawn
) -> None:
    size = (2.0, 0.045, 0.095)
    turns = [rotation((1.0, 0.0, 0.0), q * math.pi) for q in quarters]
    aside = translation(0.0, 0.0, 0.5) @ rotation((0.0, 1.0, 0.0), -math.pi / 2.0)
    targets = [
        Component(
            id=ComponentId(f"t{n}"),
            layer=Layer.TARGET,
            type="stud",
            geometry=BoxGeometry(size),
            world_T_component=translation(0.0, 3.0 * n, 1.0) @ (aside if stands else turn),
        )
        for n, turn in enumerate(turns)
    ]
    model = BuildingModel(name="studs", component_by_id={t.id: t for t in targets})
    after, _ = complete(model, Surroundings(places=(StockPlaceId("yard"),)))
    assert after.stacks
    for stack in after.stacks:
        heights = [
            extent_of(shape_of(c), c.world_T_component)
            for c in (after.component_by_id[i] for i in stack.items)
        ]
        tops = [0.0, *(h.high_m[2] for h in heights)]
        assert np.allclose([h.low_m[2] for h in heights], tops[:-1], atol=1e-9)
