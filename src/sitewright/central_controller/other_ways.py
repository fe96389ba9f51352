"""Another feasible action: what else could come next, at what price, and how it would go on."""

from __future__ import annotations

from collections.abc import Callable

from sitewright.central_controller.ports import Alternative
from sitewright.foundation.sentence import Sentence
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.planner import NoPlan, SymbolicPlanner
from sitewright.symbolic_planning.problem import Problem, with_state
from sitewright.symbolic_planning.progression import (
    OtherAction,
    apply,
    is_applicable,
    other_actions,
)

_MOST_PRICED = 8
"""So many alternatives are priced by a plan of their own."""
_TENTHS = 10.0


WhyNot = Callable[[SkillCall, tuple[SkillCall, ...]], str]
"""Why geometry does not allow a call that these others follow; empty if it does."""


def other_ways(
    problem: Problem, planner: SymbolicPlanner, why_not: WhyNot
) -> tuple[Alternative, ...]:
    """Return the applicable actions, the cheapest first, those that lead nowhere last.

    Args:
        problem: The target from the state as sensed.
        planner: Prices each alternative by planning on from it.
        why_not: Asks the planning twin; only for those that are priced.
    """
    best = planner.plan(problem)
    best_cost = None if isinstance(best, NoPlan) else best.cost
    found = other_actions(problem, problem.init)
    open_ways = [o for o in found if not o.leads_nowhere]
    closed = [o for o in found if o.leads_nowhere]
    priced = [_priced(problem, planner, o, best_cost, why_not) for o in open_ways[:_MOST_PRICED]]
    unpriced = [_plain(o, "not priced") for o in open_ways[_MOST_PRICED:]]
    priced.sort(key=lambda a: (a.leads_nowhere, a.price_s is None, a.price_s or 0.0))
    return (*priced, *unpriced, *(_plain(o, o.leads_nowhere) for o in closed))


def can_come_next(problem: Problem, call: SkillCall) -> bool:
    """Tell whether a call is applicable in the state that a problem starts from."""
    action = problem.action(call)
    return action is not None and is_applicable(action, problem.init)


def continuation(
    problem: Problem, planner: SymbolicPlanner, call: SkillCall
) -> tuple[SkillCall, ...]:
    """Return how the plan would go on after a chosen call; empty if no plan follows."""
    action = problem.action(call)
    if action is None:
        return ()
    after = planner.plan(with_state(problem, apply(action, problem.init)))
    return () if isinstance(after, NoPlan) else after.calls


def _priced(
    problem: Problem,
    planner: SymbolicPlanner,
    other: OtherAction,
    best_cost: int | None,
    why_not: WhyNot,
) -> Alternative:
    after = planner.plan(with_state(problem, apply(other.action, problem.init)))
    if isinstance(after, NoPlan):
        note = after.reason if after.is_proven else Sentence("no plan found from there in time")
        return Alternative(
            call=other.call,
            duration_s=other.action.cost / _TENTHS,
            leads_nowhere=after.is_proven,
            note=note,
        )
    if refusal := why_not(other.call, after.calls):
        return Alternative(
            call=other.call,
            duration_s=other.action.cost / _TENTHS,
            leads_nowhere=True,
            note=Sentence("no motion: {why}", why=refusal),
        )
    total = other.action.cost + after.cost
    price = None if best_cost is None else (total - best_cost) / _TENTHS
    return Alternative(call=other.call, duration_s=other.action.cost / _TENTHS, price_s=price)


def _plain(other: OtherAction, note: str) -> Alternative:
    return Alternative(
        call=other.call,
        duration_s=other.action.cost / _TENTHS,
        leads_nowhere=bool(other.leads_nowhere),
        note=note,
    )
