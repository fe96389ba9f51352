"""The port of symbolic planners: a skill sequence, or a "no" that says whether it is proven."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from sitewright.errors import BackendError
from sitewright.foundation.sentence import Sentence
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.grounding import GroundAction
from sitewright.symbolic_planning.problem import Problem
from sitewright.symbolic_planning.problem_text import fact_text
from sitewright.symbolic_planning.progression import is_goal, lost_goals
from sitewright.symbolic_planning.validation import InvalidStep, validate


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillSequence:
    """A validated plan.

    Attributes:
        calls: The plan in site ids.
        actions: The same in PDDL names, with conditions and effects.
        cost: Estimated time one after the other, tenths of a second.
        planner: Name of the planner and of the search that answered.
        wall_s: Time that the search took.
        is_reproducible: False if a watchdog's timing chose the answer.
        text: The plan as PDDL.
    """

    calls: tuple[SkillCall, ...]
    actions: tuple[GroundAction, ...]
    cost: int
    planner: str
    wall_s: float
    is_reproducible: bool
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class NoPlan:
    """No skill sequence.

    Attributes:
        is_proven: True: none exists. False: gave up; more time may help.
        reason: Sentence for people, facts in site ids.
    """

    is_proven: bool
    reason: str
    planner: str = ""
    wall_s: float = 0.0


class SymbolicPlanner(Protocol):
    """Finds a cheap skill sequence for a problem."""

    @property
    def name(self) -> str:
        """Name in the registry."""
        ...

    def plan(self, problem: Problem, *, timeout_s: float = 10.0) -> SkillSequence | NoPlan:
        """Return a validated plan, or a "no".

        Raises:
            sitewright.errors.BackendMissingError: The planner is not installed.
            sitewright.errors.BackendError: It broke, or its plan is not valid.
        """
        ...


def foregone(problem: Problem, *, planner: str) -> SkillSequence | NoPlan | None:
    """Return the answer that needs no search, if there is one."""
    if problem.impossible:
        return NoPlan(
            is_proven=True, reason=Sentence("{all:semi}.", all=problem.impossible), planner=planner
        )
    lost = lost_goals(problem, problem.init)
    if lost:
        facts = tuple(fact_text(f) for f in lost)
        return NoPlan(
            is_proven=True,
            reason=Sentence("No skill of this team makes {facts:comma} true.", facts=facts),
            planner=planner,
        )
    if is_goal(problem, problem.init):
        return sequence(problem, (), planner=planner, wall_s=0.0)
    return None


def sequence(
    problem: Problem,
    lines: Sequence[str],
    *,
    planner: str,
    wall_s: float,
    is_reproducible: bool = True,
) -> SkillSequence:
    """Return the plan that a planner wrote, validated.

    Args:
        problem: What it was written for.
        lines: One action each, ``(grasp r1 m3 s2 e1)``.
        planner: Who answered.
        wall_s: Time that the search took.
        is_reproducible: Whether the same call gives the same plan.

    Raises:
        BackendError: A line is no action, or the plan does not hold.
    """
    words = [line.strip().strip("()").lower().split() for line in lines]
    verdict = validate(problem, [(w[0], tuple(w[1:])) for w in words if w])
    if isinstance(verdict, InvalidStep):
        raise BackendError(f"The plan of {planner} is wrong: {verdict.reason} Nothing was run.")
    actions = problem.actions_of([fact_text(tuple(w)) for w in words])
    text = "".join(f"{a.line}\n" for a in actions)
    return SkillSequence(
        calls=tuple(problem.call(a) for a in actions),
        actions=actions,
        cost=verdict.cost,
        planner=planner,
        wall_s=wall_s,
        is_reproducible=is_reproducible,
        text=f"{text}; cost = {verdict.cost} (tenths of a second)\n",
    )
