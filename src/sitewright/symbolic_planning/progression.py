"""States as sets of facts: which actions are applicable, and what they lead to."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.grounding import GroundAction, relaxed_reachable
from sitewright.symbolic_planning.problem import Problem
from sitewright.symbolic_planning.problem_text import fact_text

State = frozenset[Fact]
"""The true facts that actions may change."""


def is_applicable(action: GroundAction, state: AbstractSet[Fact]) -> bool:
    """Whether an action's conditions hold."""
    return action.needs <= state and action.needs_not.isdisjoint(state)


def applicable(problem: Problem, state: AbstractSet[Fact]) -> list[GroundAction]:
    """Return the actions that could be done next, in the order of the domain.

    The state must be one that actions lead to from the problem's initial state; for another
    one, make the problem anew by `sitewright.symbolic_planning.problem.with_state`.
    """
    return [a for a in problem.actions if is_applicable(a, state)]


def apply(action: GroundAction, state: AbstractSet[Fact]) -> State:
    """Return the state after an action."""
    return frozenset((state - action.deletes) | action.adds)


def state_after(problem: Problem, actions: Iterable[GroundAction]) -> State:
    """Return the state that a sequence leads to from the initial state; nothing is checked."""
    state = problem.init
    for action in actions:
        state = apply(action, state)
    return state


def is_goal(problem: Problem, state: AbstractSet[Fact]) -> bool:
    """Whether the target is installed and every robot where it should be."""
    return problem.goal <= state and problem.goal_not.isdisjoint(state)


def lost_goals(problem: Problem, state: AbstractSet[Fact]) -> tuple[Fact, ...]:
    """Return goals that are proven to be out of reach from a state, in site ids.

    None lost is no proof that a plan exists.
    """
    facts, _ = relaxed_reachable(problem.actions, state)
    deletable = {f for a in problem.actions for f in a.deletes}
    lost = {f for f in problem.goal if f not in facts}
    stuck = {f for f in problem.goal_not if f in state and f not in deletable}
    return tuple(sorted(problem.in_site_ids(f) for f in lost | stuck))


def is_goal_reachable(problem: Problem, state: AbstractSet[Fact]) -> bool:
    """Whether nothing proves that the goal is out of reach."""
    return not problem.impossible and not lost_goals(problem, state)


@dataclass(frozen=True, slots=True, kw_only=True)
class OtherAction:
    """An action that could come next instead of the planned one.

    Attributes:
        leads_nowhere: Why the goal cannot be reached after it; empty if that is not proven.
    """

    action: GroundAction
    call: SkillCall
    leads_nowhere: str = ""


def other_actions(problem: Problem, state: AbstractSet[Fact]) -> tuple[OtherAction, ...]:
    """Return all applicable actions, each with a note if it is proven to lead nowhere."""
    found = []
    for action in applicable(problem, state):
        lost = lost_goals(problem, apply(action, state))
        note = f"leads nowhere: {', '.join(fact_text(f) for f in lost)} is lost" if lost else ""
        found.append(OtherAction(action=action, call=problem.call(action), leads_nowhere=note))
    return tuple(found)
