"""Planner without any outside program: greedy best-first search on the FF heuristic."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from heapq import heappop, heappush
from itertools import count

from sitewright.foundation.sentence import Sentence
from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.grounding import GroundAction
from sitewright.symbolic_planning.planner import NoPlan, SkillSequence, foregone, sequence
from sitewright.symbolic_planning.problem import Problem
from sitewright.symbolic_planning.progression import State, apply, is_applicable, is_goal


@dataclass(frozen=True, slots=True)
class _Entry:
    action: GroundAction | None
    parent: State | None
    helpful: AbstractSet[GroundAction]


class BuiltinPlanner:
    """For platforms without Fast Downward; its plans may cost some more."""

    name = "builtin"

    def __init__(self, *, max_states: int = 200_000) -> None:
        """Limit the search; the limit, unlike the clock, is the same on every machine."""
        self._max_states = max_states

    def plan(self, problem: Problem, *, timeout_s: float = 10.0) -> SkillSequence | NoPlan:
        """Return a validated plan, or a "no"; see `SymbolicPlanner`."""
        answer = foregone(problem, planner=self.name)
        if answer is not None:
            return answer
        started_s = time.perf_counter()
        deadline_s = started_s + timeout_s
        found = _Search(problem).run(self._max_states, deadline_s)
        wall_s = time.perf_counter() - started_s
        if isinstance(found, str):
            return NoPlan(
                is_proven=not found,
                reason=found or Sentence("No order of skills reaches the goal."),
                planner=self.name,
                wall_s=wall_s,
            )
        lines = [a.line for a in found]
        return sequence(problem, lines, planner=self.name, wall_s=wall_s)


class _Search:
    """Greedy best-first search; among equals, what a helpful action led to comes first."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._heuristic = _RelaxedPlans(problem)
        self._reached_by: dict[State, _Entry] = {}
        self._queue: list[tuple[int, int, int, State]] = []
        self._order = count()

    def run(self, max_states: int, deadline_s: float) -> list[GroundAction] | str:
        """Return the plan; or why the search gave up; or an empty text if there is none."""
        self._reach(self._problem.init, None, None, is_helpful=True)
        while self._queue:
            if len(self._reached_by) > max_states:
                return f"No plan was found among {max_states} states."
            if time.perf_counter() > deadline_s:
                return "The time limit was reached."
            state = heappop(self._queue)[3]
            if is_goal(self._problem, state):
                return self._plan(state)
            helpful = self._reached_by[state].helpful
            for action in self._problem.actions:
                if is_applicable(action, state):
                    after = apply(action, state)
                    if after not in self._reached_by:
                        self._reach(after, action, state, is_helpful=action in helpful)
        return ""

    def _reach(
        self,
        state: State,
        action: GroundAction | None,
        parent: State | None,
        *,
        is_helpful: bool,
    ) -> None:
        cost, helpful = self._heuristic.estimate(state)
        self._reached_by[state] = _Entry(action, parent, helpful)
        if cost is not None:
            heappush(self._queue, (cost, not is_helpful, next(self._order), state))

    def _plan(self, state: State) -> list[GroundAction]:
        actions: list[GroundAction] = []
        entry = self._reached_by[state]
        while entry.action is not None and entry.parent is not None:
            actions.append(entry.action)
            entry = self._reached_by[entry.parent]
        return actions[::-1]


class _RelaxedPlans:
    """The FF heuristic: cost of a plan in which nothing is ever made false."""

    def __init__(self, problem: Problem) -> None:
        self._goal = problem.goal
        self._actions = problem.actions
        self._waiting_for: dict[Fact, list[int]] = defaultdict(list)
        for k, action in enumerate(problem.actions):
            for fact in action.needs:
                self._waiting_for[fact].append(k)
        self._free = [k for k, a in enumerate(problem.actions) if not a.needs]

    def estimate(self, state: State) -> tuple[int | None, AbstractSet[GroundAction]]:
        """Return the cost (None: the goal is out of reach) and the helpful first actions."""
        best = self._supporters(state)
        if any(f not in state and f not in best for f in self._goal):
            return None, frozenset()
        chosen: set[int] = set()
        wanted = [f for f in sorted(self._goal) if f not in state]
        while wanted:
            k = best[wanted.pop()]
            if k not in chosen:
                chosen.add(k)
                wanted.extend(f for f in self._actions[k].needs if f not in state)
        helpful = frozenset(
            self._actions[k] for k in chosen if is_applicable(self._actions[k], state)
        )
        return sum(self._actions[k].cost for k in chosen), helpful

    def _supporters(self, state: AbstractSet[Fact]) -> Mapping[Fact, int]:
        """Return the cheapest action for each fact by additive cost (Dijkstra over facts)."""
        missing = [len(a.needs) for a in self._actions]
        price = [a.cost for a in self._actions]
        best: dict[Fact, int] = {}
        value: dict[Fact, int] = dict.fromkeys(state, 0)
        queue: list[tuple[int, Fact]] = [(0, f) for f in sorted(state)]
        self._offer(self._free, price, best, value, queue)
        closed: set[Fact] = set()
        while queue:
            cost, fact = heappop(queue)
            if fact in closed:
                continue
            closed.add(fact)
            ready = []
            for k in self._waiting_for.get(fact, ()):
                missing[k] -= 1
                price[k] += cost
                if missing[k] == 0:
                    ready.append(k)
            self._offer(ready, price, best, value, queue)
        return best

    def _offer(
        self,
        ready: Sequence[int],
        price: Sequence[int],
        best: dict[Fact, int],
        value: dict[Fact, int],
        queue: list[tuple[int, Fact]],
    ) -> None:
        for k in ready:
            for fact in self._actions[k].adds:
                if price[k] < value.get(fact, price[k] + 1):
                    value[fact], best[fact] = price[k], k
                    heappush(queue, (price[k], fact))
