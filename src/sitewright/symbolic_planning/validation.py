"""Independent validation: a plan is replayed on the domain's own formulas, not on our grounder.

Actions are interpreted as they stand in the domain file, with the plan's arguments bound to
their parameters. Nothing here uses `grounding`, so that a mistake there is seen here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from itertools import product

from sitewright.symbolic_planning.domain import Action, Domain, Fact, Guarded, Literal, Parameter
from sitewright.symbolic_planning.problem import Problem
from sitewright.symbolic_planning.problem_text import fact_text

PlanLine = tuple[str, tuple[str, ...]]
"""An action's name and its arguments in PDDL names."""


@dataclass(frozen=True, slots=True, kw_only=True)
class InvalidStep:
    """Why a plan is wrong.

    Attributes:
        number: 1 for the first step; one more than the number of steps if it is the goal.
        missing: Facts that should hold and do not, as PDDL text in site ids.
        reason: The sentence.
    """

    number: int
    missing: tuple[str, ...]
    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ValidPlan:
    """The plan reaches the goal at this cost (tenths of a second)."""

    cost: int


def validate(problem: Problem, plan: Sequence[PlanLine]) -> ValidPlan | InvalidStep:
    """Replay a plan step by step and test the goal.

    Args:
        problem: What the plan is for.
        plan: Action names with PDDL arguments.
    """
    world = _World(problem)
    state = set(problem.init | problem.static)
    cost = 0
    for number, (name, arguments) in enumerate(plan, start=1):
        action = world.action_by_name.get(name)
        if action is None or not world.fits(action, arguments):
            line = fact_text((name, *arguments))
            return InvalidStep(
                number=number,
                missing=(),
                reason=f"Step {number} {line} is no action of the domain.",
            )
        binding = dict(zip((p.name for p in action.parameters), arguments, strict=True))
        missing = world.missing(action, binding, state)
        if missing:
            return _invalid(problem, number, missing, f"Step {number} ({name})")
        state -= {a.ground(binding) for a in action.deletes}
        state |= {a.ground(binding) for a in action.adds}
        cost += world.cost(action, binding)
    unmet = [(f, True) for f in problem.goal - state]
    unmet += [(f, False) for f in problem.goal_not & state]
    if unmet:
        return _invalid(problem, len(plan) + 1, unmet, "The goal")
    return ValidPlan(cost=cost)


def _invalid(
    problem: Problem, number: int, missing: Sequence[tuple[Fact, bool]], who: str
) -> InvalidStep:
    texts = []
    for fact, wanted in sorted(missing):
        text = fact_text(problem.in_site_ids(fact))
        texts.append(text if wanted else f"(not {text})")
    return InvalidStep(
        number=number, missing=tuple(texts), reason=f"{who} needs {', '.join(texts)}."
    )


class _World:
    """The objects and formulas of a problem."""

    def __init__(self, problem: Problem) -> None:
        self._domain: Domain = problem.domain
        self._values = problem.values
        self._type_by_object = {o.name: o.type for o in problem.objects}
        self._type_by_object.update({c.name: c.type for c in problem.domain.constants})
        self.action_by_name = {a.name: a for a in problem.domain.actions}

    def fits(self, action: Action, arguments: Sequence[str]) -> bool:
        """Whether number and types of the arguments are right."""
        if len(arguments) != len(action.parameters):
            return False
        return all(
            name in self._type_by_object and self._domain.is_a(self._type_by_object[name], p.type)
            for name, p in zip(arguments, action.parameters, strict=True)
        )

    def missing(
        self, action: Action, binding: Mapping[str, str], state: AbstractSet[Fact]
    ) -> list[tuple[Fact, bool]]:
        """Return the literals of the precondition that do not hold."""
        wanted = [_ground(x, binding) for x in action.preconditions]
        for part in action.guarded:
            wanted.extend(self._expanded(part, binding, state))
        return [(fact, sign) for fact, sign in wanted if (fact in state) != sign]

    def cost(self, action: Action, binding: Mapping[str, str]) -> int:
        """Return what the action adds to the total cost."""
        if isinstance(action.cost, int):
            return action.cost
        return self._values[action.cost.ground(binding)]

    def _expanded(
        self, part: Guarded, binding: Mapping[str, str], state: AbstractSet[Fact]
    ) -> Iterator[tuple[Fact, bool]]:
        for names in product(*(self._members(p) for p in part.parameters)):
            inner = {
                **binding,
                **{p.name: n for p, n in zip(part.parameters, names, strict=True)},
            }
            if all(g.ground(inner) in state for g in part.guards):
                yield from (_ground(x, inner) for x in part.consequents)

    def _members(self, parameter: Parameter) -> list[str]:
        return [
            name
            for name, type_name in self._type_by_object.items()
            if self._domain.is_a(type_name, parameter.type)
        ]


def _ground(literal: Literal, binding: Mapping[str, str]) -> tuple[Fact, bool]:
    return literal.atom.ground(binding), literal.is_positive
