"""Grounder: a domain's actions over the objects of a problem, static conditions worked in."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from itertools import product

from sitewright.errors import BuildingModelError
from sitewright.symbolic_planning.domain import (
    OBJECT,
    Action,
    Atom,
    Domain,
    Fact,
    Guarded,
    Parameter,
)


@dataclass(frozen=True, slots=True, kw_only=True)
class GroundAction:
    """An action with objects for its parameters; static conditions hold and are left out.

    Attributes:
        arguments: PDDL names, the robot first.
        needs: Facts that must be true.
        needs_not: Facts that must be false.
        adds: Facts made true; they win over `deletes`.
        deletes: Facts made false.
        cost: Tenths of a second.
    """

    name: str
    arguments: tuple[str, ...]
    needs: frozenset[Fact]
    needs_not: frozenset[Fact]
    adds: frozenset[Fact]
    deletes: frozenset[Fact]
    cost: int

    @property
    def line(self) -> str:
        """The action as a line of a plan."""
        return f"({' '.join((self.name, *self.arguments))})"


def objects_by_type(domain: Domain, type_by_object: Mapping[str, str]) -> dict[str, list[str]]:
    """Return the objects (and constants) of each type, those of its subtypes included."""
    found: dict[str, list[str]] = defaultdict(list)
    constants = {c.name: c.type for c in domain.constants}
    for name, type_name in {**type_by_object, **constants}.items():
        for above in domain.supertypes(type_name):
            found[above].append(name)
        if domain.supertypes(type_name)[-1] != OBJECT:
            found[OBJECT].append(name)
    return found


def ground(
    domain: Domain,
    members: Mapping[str, Sequence[str]],
    *,
    static: AbstractSet[Fact],
    init: AbstractSet[Fact],
    values: Mapping[Fact, int],
) -> tuple[GroundAction, ...]:
    """Return every action that can ever become applicable, in a fixed order.

    Args:
        domain: Its actions are grounded.
        members: Objects of each type.
        static: True facts that no action changes.
        init: True facts of the present state.
        values: Values of the numeric functions.

    Raises:
        BuildingModelError: A cost has no value; planners would silently drop the action.
    """
    grounder = _Grounder(domain.fluents(), members, static, values)
    candidates = [a for action in domain.actions for a in grounder.instances(action)]
    return tuple(_reachable(candidates, init))


class _Grounder:
    def __init__(
        self,
        fluents: frozenset[str],
        members: Mapping[str, Sequence[str]],
        static: AbstractSet[Fact],
        values: Mapping[Fact, int],
    ) -> None:
        self._fluents = fluents
        self._members = members
        self._static = static
        self._values = values
        self._member_sets = {t: frozenset(names) for t, names in members.items()}
        self._static_by_name: dict[str, list[Fact]] = defaultdict(list)
        for fact in sorted(static):
            self._static_by_name[fact[0]].append(fact)

    def instances(self, action: Action) -> Iterator[GroundAction]:
        tests = _tests_by_depth(action, self._fluents)
        for binding in self._bindings(action.parameters, tests, {}):
            found = self._instance(action, binding)
            if found is not None:
                yield found

    def _bindings(
        self,
        parameters: Sequence[Parameter],
        tests: Sequence[Sequence[tuple[Atom, bool]]],
        binding: dict[str, str],
    ) -> Iterator[dict[str, str]]:
        depth = len(binding)
        if not all((a.ground(binding) in self._static) == wanted for a, wanted in tests[depth]):
            return
        if depth == len(parameters):
            yield dict(binding)
            return
        parameter = parameters[depth]
        for name in self._members.get(parameter.type, ()):
            binding[parameter.name] = name
            yield from self._bindings(parameters, tests, binding)
            del binding[parameter.name]

    def _instance(self, action: Action, binding: dict[str, str]) -> GroundAction | None:
        literals = [(x.atom.ground(binding), x.is_positive) for x in action.preconditions]
        for part in action.guarded:
            literals.extend(self._expanded(part, binding))
        needs: set[Fact] = set()
        needs_not: set[Fact] = set()
        for fact, wanted in literals:
            if fact[0] in self._fluents:
                (needs if wanted else needs_not).add(fact)
            elif (fact in self._static) != wanted:
                return None
        if needs & needs_not:
            return None
        return GroundAction(
            name=action.name,
            arguments=tuple(binding[p.name] for p in action.parameters),
            needs=frozenset(needs),
            needs_not=frozenset(needs_not),
            adds=frozenset(a.ground(binding) for a in action.adds),
            deletes=frozenset(a.ground(binding) for a in action.deletes),
            cost=self._cost(action, binding),
        )

    def _expanded(self, part: Guarded, binding: dict[str, str]) -> Iterator[tuple[Fact, bool]]:
        for inner in self._guard_bindings(part, binding):
            for complete in self._completed(part.parameters, inner):
                if all(g.ground(complete) in self._static for g in part.guards):
                    yield from ((x.atom.ground(complete), x.is_positive) for x in part.consequents)

    def _guard_bindings(
        self, part: Guarded, binding: dict[str, str]
    ) -> Iterator[Mapping[str, str]]:
        """Bind what the first guard mentions from the true static facts: few match."""
        if not part.guards:
            yield binding
            return
        guard = part.guards[0]
        variables = {p.name: p.type for p in part.parameters}
        outer = {k: v for k, v in binding.items() if k not in variables}
        for fact in self._static_by_name.get(guard.name, ()):
            bound = dict(outer)
            for term, name in zip(guard.terms, fact[1:], strict=True):
                free = term in variables and term not in bound
                if free and name in self._member_sets.get(variables[term], ()):
                    bound[term] = name
                elif bound.get(term, term) != name:
                    break
            else:
                yield bound

    def _completed(
        self, parameters: Sequence[Parameter], binding: Mapping[str, str]
    ) -> Iterator[Mapping[str, str]]:
        free = [p for p in parameters if p.name not in binding]
        for names in product(*(self._members.get(p.type, ()) for p in free)):
            yield {**binding, **{p.name: n for p, n in zip(free, names, strict=True)}}

    def _cost(self, action: Action, binding: dict[str, str]) -> int:
        if isinstance(action.cost, int):
            return action.cost
        fact = action.cost.ground(binding)
        if fact not in self._values:
            raise BuildingModelError(
                f"{' '.join(fact)} has no value; without it a planner drops '{action.name}'."
            )
        return self._values[fact]


def _tests_by_depth(action: Action, fluents: frozenset[str]) -> list[list[tuple[Atom, bool]]]:
    """Return the static preconditions, each at the first depth where its variables are bound."""
    position = {p.name: k for k, p in enumerate(action.parameters, start=1)}
    tests: list[list[tuple[Atom, bool]]] = [[] for _ in range(len(action.parameters) + 1)]
    for literal in action.preconditions:
        if literal.atom.name not in fluents:
            depth = max((position.get(t, 0) for t in literal.atom.terms), default=0)
            tests[depth].append((literal.atom, literal.is_positive))
    return tests


def _reachable(
    candidates: Sequence[GroundAction], init: AbstractSet[Fact]
) -> Iterable[GroundAction]:
    usable = relaxed_reachable(candidates, init)[1]
    return (a for k, a in enumerate(candidates) if k in usable)


def relaxed_reachable(
    actions: Sequence[GroundAction], state: AbstractSet[Fact]
) -> tuple[frozenset[Fact], frozenset[int]]:
    """Return facts and action numbers that are reachable if nothing were ever made false.

    A fact outside is proven to be out of reach; one inside may be.
    """
    waiting_for: dict[Fact, list[int]] = defaultdict(list)
    missing = [len(a.needs) for a in actions]
    for k, action in enumerate(actions):
        for fact in action.needs:
            waiting_for[fact].append(k)
    facts = set(state)
    queue = list(state)
    usable = {k for k, count in enumerate(missing) if count == 0}
    fresh = list(usable)
    while queue or fresh:
        for k in fresh:
            queue.extend(actions[k].adds - facts)
            facts |= actions[k].adds
        fresh = []
        if queue:
            for k in waiting_for[queue.pop()]:
                missing[k] -= 1
                if missing[k] == 0:
                    usable.add(k)
                    fresh.append(k)
    return frozenset(facts), frozenset(usable)
