"""Writer of Fast Downward's search input (SAS, version 3) from ground actions.

Facts of one robot that exclude each other share a variable: where it is, what it has in hand,
what is mounted. Each such group is checked against all actions first; a domain in which it
does not hold gets a variable per fact. All other facts are variables of two values.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.grounding import GroundAction

_EXCLUSIVE = (("at", "in-transit"), ("hand-empty", "holding", "steadying"), ("mounted",))
"""Predicates of which at most one fact holds for the same first argument."""


_Places = Mapping[Fact, tuple[int, int]]
"""Variable and value of each fact."""


@dataclass(frozen=True, slots=True)
class _Variable:
    """Facts of which at most one is true; the value after the last one means none of them."""

    facts: tuple[Fact, ...]

    def value(self, state: AbstractSet[Fact]) -> int:
        return next((k for k, f in enumerate(self.facts) if f in state), len(self.facts))

    def text(self, number: int) -> str:
        only = len(self.facts) == 1
        none = f"Negated{_atom(self.facts[0])}" if only else "<none of those>"
        values = [_atom(f) for f in self.facts]
        lines = ("begin_variable", f"var{number}", "-1", str(len(values) + 1), *values, none)
        return "\n".join((*lines, "end_variable"))


def sas_text(
    actions: Sequence[GroundAction],
    *,
    init: AbstractSet[Fact],
    goal: AbstractSet[Fact],
    goal_not: AbstractSet[Fact],
) -> str:
    """Return a task for the search binary; the goal must be relaxed reachable.

    Args:
        actions: Ground actions; their order is kept.
        init: True facts.
        goal: Facts to be made true.
        goal_not: Facts to be made false.
    """
    variables = _variables(actions, init, goal, goal_not)
    place = {f: (v, k) for v, x in enumerate(variables) for k, f in enumerate(x.facts)}
    goals = {place[f][0]: place[f][1] for f in sorted(goal) if f in place}
    for fact in sorted(goal_not):
        if fact in place:
            goals.setdefault(place[fact][0], len(variables[place[fact][0]].facts))
    operators = [text for a in actions if (text := _operator(a, variables, place))]
    parts = [
        "begin_version\n3\nend_version\nbegin_metric\n1\nend_metric",
        str(len(variables)),
        *(x.text(v) for v, x in enumerate(variables)),
        "0",
        "begin_state",
        *(str(x.value(init)) for x in variables),
        "end_state",
        "begin_goal",
        str(len(goals)),
        *(f"{v} {k}" for v, k in sorted(goals.items())),
        "end_goal",
        str(len(operators)),
        *operators,
        "0",
        "",
    ]
    return "\n".join(parts)


def _variables(
    actions: Sequence[GroundAction],
    init: AbstractSet[Fact],
    goal: AbstractSet[Fact],
    goal_not: AbstractSet[Fact],
) -> list[_Variable]:
    asked = set().union(goal, goal_not, *(a.needs for a in actions))
    asked = asked.union(*(a.needs_not for a in actions))
    added = set().union(*(a.adds for a in actions))
    deleted = set().union(*(a.deletes for a in actions))
    varying = {f for f in asked if (f in init or f in added) and (f in deleted or f not in init)}
    single = set().union(*(a.needs_not for a in actions))
    groups = _groups(varying - single, goal, goal_not)
    found = [_Variable(tuple(g)) for g in groups if _is_exclusive(frozenset(g), actions, init)]
    grouped = {f for x in found for f in x.facts}
    return [*found, *(_Variable((f,)) for f in sorted(varying - grouped))]


def _groups(
    facts: AbstractSet[Fact], goal: AbstractSet[Fact], goal_not: AbstractSet[Fact]
) -> list[list[Fact]]:
    """Return candidate groups; a negative goal stays outside unless its group has a goal."""
    by_key: dict[tuple[str, int], list[Fact]] = defaultdict(list)
    for fact in sorted(facts):
        for number, names in enumerate(_EXCLUSIVE):
            if fact[0] in names and len(fact) > 1:
                by_key[fact[1], number].append(fact)
    groups = []
    for _, members in sorted(by_key.items()):
        is_settled = not goal.isdisjoint(members)
        groups.append([f for f in members if is_settled or f not in goal_not])
    return [g for g in groups if len(g) > 1]


def _is_exclusive(
    group: frozenset[Fact], actions: Iterable[GroundAction], init: AbstractSet[Fact]
) -> bool:
    """Whether every action keeps at most one fact of the group true, for all it can know."""
    return len(group & init) <= 1 and all(_keeps_exclusive(group, a) for a in actions)


def _keeps_exclusive(group: frozenset[Fact], action: GroundAction) -> bool:
    needed, added = group & action.needs, group & action.adds
    removed = (group & action.deletes) - added
    if not removed <= needed or len(added) > 1:
        return False
    return not added or (bool(needed) and needed - removed <= added)


def _operator(action: GroundAction, variables: Sequence[_Variable], place: _Places) -> str:
    """Return an operator, or nothing if it can never apply or changes nothing."""
    needed = [place[f] for f in action.needs if f in place]
    before = dict(needed)
    if any(before[v] != k for v, k in needed):
        return ""
    before.update({place[f][0]: 1 for f in action.needs_not if f in place})
    changed = {v for v, _ in (place[f] for f in action.deletes if f in place)}
    after = {v: len(variables[v].facts) for v in changed}
    after.update(place[f] for f in action.adds if f in place)
    changes = {v: k for v, k in after.items() if before.get(v) != k}
    if not changes:
        return ""
    stays = sorted((v, k) for v, k in before.items() if v not in changes)
    lines = [
        "begin_operator",
        action.line[1:-1],
        str(len(stays)),
        *(f"{v} {k}" for v, k in stays),
        str(len(changes)),
        *(f"0 {v} {before.get(v, -1)} {k}" for v, k in sorted(changes.items())),
        str(action.cost),
        "end_operator",
    ]
    return "\n".join(lines)


def _atom(fact: Fact) -> str:
    return f"Atom {fact[0]}({', '.join(fact[1:])})"
