"""Everything that can be inferred for any model: contacts, supports, order, fasteners, stock."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from sitewright.building_model.check_support import fasteners_that_hold, hanging
from sitewright.building_model.component import BoxGeometry, Component, Layer, Origin
from sitewright.building_model.findings import refused, warned
from sitewright.building_model.inference.assembly import infer_assembly
from sitewright.building_model.inference.bare import without_inferred
from sitewright.building_model.inference.bodies import bodies_of
from sitewright.building_model.inference.carrying import Bearing, Edge, bearing_of
from sitewright.building_model.inference.contradictions import contradictions
from sitewright.building_model.inference.disassembly import Given, Step, build_order
from sitewright.building_model.inference.fastening import Fastening, fasten, joints_of
from sitewright.building_model.inference.fit import fit_problems
from sitewright.building_model.inference.gripping import grasps_of
from sitewright.building_model.inference.interfaces import Interface, interfaces_of
from sitewright.building_model.inference.known_stock import with_known_stock
from sitewright.building_model.inference.order_facts import (
    Assembling,
    completed,
    levels,
    new_relations,
    sequence_of,
    stated_joints,
    with_joints,
)
from sitewright.building_model.inference.rules import Rules, rules_from
from sitewright.building_model.inference.ways import ways_of
from sitewright.building_model.inference.yard import yard_for
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId, StockPlaceId
from sitewright.foundation.pose import Vector

GRIPS_M = ((0.03, 0.20),)
"""Grip range if no gripper is known."""
_COVERED = "its fasteners go in where the other one will cover them"
_JOINED = "the other one is fastened to it"


@dataclass(frozen=True, slots=True, kw_only=True)
class Surroundings:
    """What the cell offers.

    Attributes:
        places: Stock places, in order of use; without any no stock is inferred.
        grips_m: Narrowest and widest grip of each gripper.
    """

    places: tuple[StockPlaceId, ...] = ()
    grips_m: tuple[tuple[float, float], ...] = field(default=GRIPS_M)


def complete(
    model: BuildingModel, surroundings: Surroundings | None = None
) -> tuple[BuildingModel, list[Problem]]:
    """Return the model with all that can be inferred, and what is open or contradictory.

    What was inferred before is inferred anew; what is given stays as it is. A frame whose file
    lists its joints and no stock is handled by the rule for such frames (`infer_assembly`).
    Rules of the model (`rules`) add fasteners and stock lengths.
    """
    around = surroundings or Surroundings()
    given = without_inferred(model)
    rules = rules_from(given.rules)
    if is_jointed_frame(given):
        inferred, problems = infer_assembly(given)
        return _nailed(with_known_stock(model, inferred), rules, problems)
    return _completed(given, around, rules)


def is_jointed_frame(model: BuildingModel) -> bool:
    """Whether a file lists the joints of all its box-shaped beams, and no stock."""
    joined = {
        end for r in model.relations if r.kind is RelationKind.CONNECTION for end in (r.a, r.b)
    }
    targets = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    has_stock = any(c.layer is Layer.MATERIAL for c in model.component_by_id.values())
    return (
        bool(targets)
        and not has_stock
        and all(c.id in joined and isinstance(c.geometry, BoxGeometry) for c in targets)
    )


def _completed(
    given: BuildingModel, around: Surroundings, rules: Rules
) -> tuple[BuildingModel, list[Problem]]:
    bodies, problems = bodies_of(given)
    if not bodies:
        return given, problems
    components = {i: given.component_by_id[i] for i in bodies}
    interfaces = interfaces_of(bodies)
    joints = joints_of(components, interfaces, rules)
    bearing = bearing_of(given, bodies, interfaces, [(j.through, j.into) for j in joints])
    stated = stated_order(given, components)
    steps = build_order(bearing, ways_of(bearing), _with_joints_first(stated, components))
    sequence = sequence_of(bearing, steps, stated.before)
    ground = (bearing.up, bearing.ground_m)
    fastening = fasten(components, bodies, joints, sequence.place, ground)
    joined = [*stated_joints(components.values()), *fastening.joined]
    place = sequence.place
    joined = [(a, b) for a, b in joined if a in place and place[a] < place[b]]
    sequence = with_joints(sequence, joined)
    numbers = levels(sequence, stated.order)
    made = {
        s.id: _held(
            completed(_fastened(components[s.id], fastening), bearing, sequence, numbers[s.id]),
            bearing,
            sequence,
        )
        for s in steps
    }
    made = {i: _gripped(c, bearing, around) for i, c in made.items()}
    in_order = [made[s.id] for s in steps]
    x, y, z = bearing.up
    yard = yard_for(given, in_order, around.places, rules, (float(x), float(y), float(z)))
    merged = {**given.component_by_id, **made, **{p.id: p for p in yard.pieces}}
    relations = new_relations(given, bearing, sequence)
    known = (*given.relations, *relations)
    relations = (*relations, *_before(known, fastening.before, joined, sequence.parents))
    problems += [*fastening.problems, *yard.problems]
    problems += fit_problems(components, bodies, interfaces)
    problems += contradictions(given, bearing, sequence)
    problems += _open_points(components, made, sequence, steps)
    return replace(
        given,
        component_by_id={i: merged[i] for i in sorted(merged)},
        relations=(*given.relations, *relations),
        stacks=(*given.stacks, *yard.stacks),
        ground_z_m=given.ground_z_m or round(bearing.ground_m, 7),
    ), problems


def _nailed(
    frame: BuildingModel, rules: Rules, problems: list[Problem]
) -> tuple[BuildingModel, list[Problem]]:
    """Add fasteners by rules to a frame whose order is known."""
    bodies, _ = bodies_of(frame)
    components = {i: frame.component_by_id[i] for i in bodies}
    joints = joints_of(components, interfaces_of(bodies), rules) if rules.fasten else []
    if not joints:
        return frame, problems
    place = {i: c.order if c.order is not None else -1 for i, c in components.items()}
    up = np.array(frame.gravity) / -np.linalg.norm(frame.gravity)
    fastening = fasten(components, bodies, joints, place, (up, frame.ground_z_m))
    held = {r.b for r in frame.relations if r.kind is RelationKind.HOLD}
    made = {i: _fastened(components[i], fastening) for i in fastening.operations}
    made = {i: _hanging(c) if i in held else c for i, c in made.items()}
    problems = [_with_fasteners(p, made) for p in problems]
    parents = {i: c.construction_parents for i, c in components.items()}
    relations = _before(frame.relations, fastening.before, fastening.joined, parents)
    return replace(
        frame,
        component_by_id={**frame.component_by_id, **made},
        relations=(*frame.relations, *relations),
    ), [*problems, *fastening.problems]


def _with_fasteners(problem: Problem, made: Mapping[ComponentId, Component]) -> Problem:
    """Return what is still to be said of a hanging beam once rules have fastened it."""
    component = made.get(ComponentId(problem.where))
    return hanging(component) if component is not None and problem.code == "F1" else problem


def _hanging(component: Component) -> Component:
    return _held_for(component, "nothing carries it from below")


def stated_order(model: BuildingModel, components: Mapping[ComponentId, Component]) -> Given:
    """Return what the author states about the order."""
    before: dict[ComponentId, set[ComponentId]] = {i: set() for i in components}
    for i, component in components.items():
        before[i] |= set(component.construction_parents)
    for relation in model.relations:
        match relation.kind:
            case RelationKind.SUPPORTS | RelationKind.BEFORE:
                before.setdefault(relation.b, set()).add(relation.a)
            case RelationKind.BLOCKS:
                before.setdefault(relation.a, set()).add(relation.b)
            case _:
                pass
    return Given(
        before={i: frozenset(b & components.keys()) for i, b in before.items()},
        order={i: c.order for i, c in components.items() if c.order is not None},
        existing=frozenset(i for i, c in components.items() if c.layer is not Layer.TARGET),
    )


def _with_joints_first(given: Given, components: Mapping[ComponentId, Component]) -> Given:
    """Return the order as stated with what stated operations go into before their owners."""
    before = dict(given.before)
    for other, owner in stated_joints(components.values()):
        if other in before and owner not in before[other]:
            before[owner] |= {other}
    return replace(given, before=before)


def _fastened(component: Component, fastening: Fastening) -> Component:
    added = fastening.operations.get(component.id, ())
    return replace(component, operations=(*component.operations, *added))


def _held(component: Component, bearing: Bearing, sequence: Assembling) -> Component:
    """State how many fasteners hold it before the robot lets go, if it would not stand."""
    if component.id in sequence.hanging:
        return _hanging(component)
    place = sequence.place
    there = [i for i in bearing.bodies if place[i] < place[component.id]]
    why = bearing.topples(component.id, there)
    return _held_for(component, why) if why and not component.temporary_support else component


def _held_for(component: Component, why: str) -> Component:
    count = fasteners_that_hold(component)
    if component.hold_until_fasteners or not count:
        return component
    return replace(
        component,
        hold_until_fasteners=count,
        origins={**component.origins, "hold_until_fasteners": (Origin.INFERRED, why)},
    )


def _gripped(component: Component, bearing: Bearing, around: Surroundings) -> Component:
    if component.grasps:
        return component
    turn = component.world_T_component.inverse()
    covered: list[Vector] = []
    for face in bearing.touching[component.id].values():
        sign = 1.0 if face.a == component.id else -1.0
        covered += [turn.turn((sign * x, sign * y, sign * z)) for x, y, z in _normals(face)]
    grasps = grasps_of(component, around.grips_m, covered)
    if not grasps:
        return component
    why = "opposite faces within a gripper's opening, not in contact once it is placed"
    origins = {**component.origins, "grasps": (Origin.INFERRED, why)}
    return replace(component, grasps=grasps, origins=origins)


def _normals(face: Interface) -> list[Vector]:
    return [p.normal for p in face.patches]


def _before(
    relations: Iterable[Relation],
    covered: Iterable[Edge],
    joined: Iterable[Edge],
    parents: Mapping[ComponentId, Sequence[ComponentId]],
) -> list[Relation]:
    """Return which order fasteners ask for, where nothing says so yet."""
    known = {(r.a, r.b) for r in relations if r.kind is RelationKind.BEFORE}
    why = dict.fromkeys(joined, _JOINED) | dict.fromkeys(covered, _COVERED)
    return [
        Relation(kind=RelationKind.BEFORE, a=a, b=b, origin=Origin.INFERRED, data={"why": words})
        for (a, b), words in sorted(why.items())
        if (a, b) not in known and a not in parents.get(b, ())
    ]


def _open_points(
    components: Mapping[ComponentId, Component],
    made: Mapping[ComponentId, Component],
    sequence: Assembling,
    steps: Sequence[Step],
) -> list[Problem]:
    problems = []
    for step in steps:
        component = components[step.id]
        if step.id in sequence.floating:
            message = "Nothing carries it from below and nothing fastens it."
            fix = "Add falsework ('temporary_support'), a rule or an operation."
            problems.append(refused("F2", component, message, fix))
        elif step.id in sequence.hanging:
            problems.append(hanging(made[step.id]))
        if step.direction is None:
            message = "What is built before it leaves it no straight way in."
            problems.append(
                warned("F3", component, message, "Give 'order' so that it comes earlier.")
            )
    return problems
