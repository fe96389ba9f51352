"""From the order of building to facts of components and relations, each with its evidence."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from sitewright.building_model.component import Component, Origin
from sitewright.building_model.inference.bare import INSERTION
from sitewright.building_model.inference.carrying import Bearing, Edge
from sitewright.building_model.inference.disassembly import Step
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Vector

_TOGETHER = "they carry each other: hold it, or put falsework, until the other one is there"


@dataclass(frozen=True, slots=True, kw_only=True)
class Assembling:
    """How the components come, with what each needs before it.

    Attributes:
        place: Position of each in the order of building; those that exist before are at -1.
        parents: What each rests on or is fixed to when it comes.
        before: What must be there first: parents, and those whose way it would block.
        hanging: Components that nothing carries from below, but a joint or fastener will hold.
        floating: Components that nothing carries and nothing holds.
        mutual: Pairs (later, earlier) in which the later one also carries the earlier one.
    """

    steps: Mapping[ComponentId, Step]
    place: Mapping[ComponentId, int]
    parents: Mapping[ComponentId, tuple[ComponentId, ...]]
    before: Mapping[ComponentId, frozenset[ComponentId]]
    hanging: frozenset[ComponentId]
    floating: frozenset[ComponentId]
    mutual: tuple[Edge, ...]


def sequence_of(
    bearing: Bearing, steps: Sequence[Step], stated: Mapping[ComponentId, frozenset[ComponentId]]
) -> Assembling:
    """Return who needs whom, from the order in which the components come.

    Args:
        bearing: Who carries and touches whom.
        steps: First to last.
        stated: What the author says must be there first, by component.
    """
    place = dict.fromkeys(bearing.bodies, -1) | {s.id: n for n, s in enumerate(steps)}
    parents: dict[ComponentId, tuple[ComponentId, ...]] = {}
    hanging: set[ComponentId] = set()
    floating: set[ComponentId] = set()
    mutual: list[Edge] = []
    for step in steps:
        i = step.id
        there = [j for j in bearing.bodies if place[j] < place[i]]
        carried = bearing.carriers[i]
        parents[i] = tuple(sorted(carried & frozenset(there)))
        mutual += [(j, i) for j in sorted(carried) if place[j] > place[i]]
        if i in bearing.roots or parents[i]:
            continue
        parents[i] = tuple(sorted(bearing.holders(i, there)))
        (hanging if parents[i] or carried else floating).add(i)
    before = {s.id: frozenset(parents[s.id]) | stated.get(s.id, frozenset()) for s in steps}
    for step in steps:
        for j in step.blockers:
            before[j] |= {step.id}
    return Assembling(
        steps={s.id: s for s in steps},
        place=place,
        parents=parents,
        before=before,
        hanging=frozenset(hanging),
        floating=frozenset(floating),
        mutual=tuple(mutual),
    )


def stated_joints(components: Iterable[Component]) -> list[Edge]:
    """Return (other, owner) for what stated operations fasten their owners to."""
    return [
        (other, c.id)
        for c in components
        for operation in c.operations
        if operation.fastener
        for other in operation.on
        if other != c.id
    ]


def with_joints(sequence: Assembling, joined: Iterable[Edge]) -> Assembling:
    """Return the sequence with what must be there for others (earlier, later) to be fastened."""
    before = dict(sequence.before)
    for earlier, later in joined:
        if later in before:
            before[later] |= {earlier}
    return replace(sequence, before=before)


def levels(sequence: Assembling, stated: Mapping[ComponentId, int]) -> dict[ComponentId, int]:
    """Return order numbers: one more than all that come before; stated numbers stay.

    Where numbers are stated, others keep between those of what comes before and after them.
    """
    by_place = sorted(sequence.steps, key=lambda i: sequence.place[i])
    latest: dict[ComponentId, int] = {}
    for i in reversed(by_place):
        bound = stated.get(i, latest.get(i))
        for j in sequence.before[i]:
            if bound is not None:
                latest[j] = min(bound, latest.get(j, bound))
    numbers: dict[ComponentId, int] = {}
    for i in by_place:
        earlier = [numbers[j] for j in sequence.before[i] if j in numbers]
        number = max(earlier, default=0) + 1
        if i in latest:
            number = max(max(earlier, default=number), min(number, latest[i]))
        numbers[i] = stated.get(i, number)
    return numbers


def completed(
    component: Component, bearing: Bearing, sequence: Assembling, number: int
) -> Component:
    """Return a target with ground, parents, order and way in, where it does not state them."""
    i, step = component.id, sequence.steps[component.id]
    origins = dict(component.origins)
    changes: dict[str, object] = {}
    if i in bearing.ground and not component.ground:
        changes["ground"] = True
        why = f"its lowest point is within 5 mm of the ground ({bearing.ground_m:.3f} m)"
        origins["ground"] = (Origin.INFERRED, why)
    if not component.construction_parents and sequence.parents[i]:
        changes["construction_parents"] = sequence.parents[i]
        origins["construction_parents"] = (Origin.INFERRED, _why_parents(i, sequence))
    if component.order is None:
        changes["order"] = number
        origins["order"] = (Origin.INFERRED, _why_order(step, sequence))
    if step.direction is not None and INSERTION not in component.ext:
        x, y, z = (round(v, 6) + 0.0 for v in step.direction)
        way: dict[str, Json] = {"from": [x, y, z], "slide_m": round(step.slide_m, 4)}
        changes["ext"] = {**component.ext, INSERTION: way}
        origins[INSERTION] = (Origin.INFERRED, _why_way(step))
    return replace(component, **changes, origins=origins)  # type: ignore[arg-type]


def new_relations(
    model: BuildingModel, bearing: Bearing, sequence: Assembling
) -> tuple[Relation, ...]:
    """Return contacts, supports, holds and orders that the model does not state."""
    known = {(r.kind, r.a, r.b) for r in model.relations}
    known |= {(r.kind, r.b, r.a) for r in model.relations if r.kind is RelationKind.CONTACT}
    found = [
        *_contacts(bearing),
        *_supports(bearing, sequence),
        *_holds(sequence),
        *_orders(bearing, sequence),
    ]
    fresh = [r for r in found if (r.kind, r.a, r.b) not in known]
    return tuple(sorted(fresh, key=lambda r: (r.kind, r.a, r.b)))


def _contacts(bearing: Bearing) -> Iterator[Relation]:
    for i, around in bearing.touching.items():
        for j, face in around.items():
            if i < j:
                data: dict[str, Json] = {
                    "area_m2": round(face.area_m2, 6),
                    "normal": _rounded(face.largest.normal),
                }
                if len(face.patches) > 1:
                    data["patches"] = len(face.patches)
                yield _relation(RelationKind.CONTACT, i, j, data)


def _supports(bearing: Bearing, sequence: Assembling) -> Iterator[Relation]:
    for i in sequence.steps:
        for j in bearing.carriers[i]:
            if sequence.place[j] < sequence.place[i]:
                face = bearing.touching[i][j]
                sign = 1.0 if face.a == j else -1.0
                x, y, z = face.largest.normal
                data: dict[str, Json] = {
                    "area_m2": round(face.area_m2, 6),
                    "normal": _rounded((sign * x, sign * y, sign * z)),
                }
                yield _relation(RelationKind.SUPPORTS, j, i, data)


def _holds(sequence: Assembling) -> Iterator[Relation]:
    for i in sequence.hanging:
        for j in sequence.parents[i]:
            yield _relation(RelationKind.HOLD, j, i, {"why": "nothing carries it from below"})
    for later, earlier in sequence.mutual:
        yield _relation(RelationKind.HOLD, later, earlier, {"why": _TOGETHER})


def _orders(bearing: Bearing, sequence: Assembling) -> Iterator[Relation]:
    """Yield ``before`` where nothing else implies it: ways in that would be blocked."""
    by_place = sorted(sequence.steps, key=lambda i: sequence.place[i])
    bit = {i: 1 << n for n, i in enumerate(by_place)}
    reached: dict[ComponentId, int] = {}
    for i in by_place:
        parents = frozenset(sequence.parents[i]) | bearing.carriers[i]
        earlier = [j for j in sequence.before[i] | parents if bit.get(j, bit[i]) < bit[i]]
        mask = 0
        for j in sorted(earlier, key=lambda j: (j not in parents, -bit[j])):
            if not mask & bit[j] and j not in parents:
                why = "else it would be in its way"
                yield _relation(RelationKind.BEFORE, j, i, {"why": why})
            mask |= bit[j] | reached[j]
        reached[i] = mask


def _relation(
    kind: RelationKind, a: ComponentId, b: ComponentId, data: Mapping[str, Json]
) -> Relation:
    return Relation(kind=kind, a=a, b=b, origin=Origin.INFERRED, data=data)


def _why_parents(component: ComponentId, sequence: Assembling) -> str:
    if component in sequence.hanging:
        return "nothing carries it from below; joined to these, it needs hold until fastened"
    return "touching from below (contact normal within 45 degrees of up)"


def _why_order(step: Step, sequence: Assembling) -> str:
    place = f"{sequence.place[step.id] + 1}. of {len(sequence.steps)} in reverse of taking apart"
    if step.direction is None:
        return f"{place}; its neighbours lock it"
    later = sorted(step.blockers)
    way = f"; in its way stand {', '.join(later[:3])}" if later else ""
    more = f" and {len(later) - 3} more" if len(later) > 3 else ""  # noqa: PLR2004 - a few names
    return f"{place}{way}{more}" + (", so they come later" if later else "")


def _why_way(step: Step) -> str:
    far = "only its first 150 mm are" if step.is_short else "the whole straight way out is"
    return f"{far} free once what comes later is gone"


def _rounded(vector: Vector) -> list[Json]:
    return [round(x, 6) + 0.0 for x in vector]
