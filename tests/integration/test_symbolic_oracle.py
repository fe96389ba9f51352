"""unified-planning as an oracle: a second reader, a second semantics, a second validator."""

from __future__ import annotations

from itertools import product
from typing import Any

import pytest

from builders_symbolic import STUD, site, team, with_geometry
from sitewright.foundation.ids import RobotId
from sitewright.symbolic_planning.planner import SkillSequence
from sitewright.symbolic_planning.planners.builtin import BuiltinPlanner
from sitewright.symbolic_planning.problem import Problem, problem_for, with_state
from sitewright.symbolic_planning.progression import applicable, state_after
from sitewright.symbolic_planning.site_view import SiteView
from sitewright.symbolic_planning.validation import ValidPlan, validate
from sitewright.symbolic_planning.vocabulary import TYPED, built_in_domain

# Its reader calls old names of pyparsing.
pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")

DOMAIN = built_in_domain()


def blocked() -> SiteView:
    a, b = RobotId("handler-1"), RobotId("nailer-1")
    pairs = {(b, "nail-03", STUD), (a, STUD, "nail-03")}
    return with_geometry(site(), excludes=frozenset(pairs))


SITES = {"case study": site(), "blocked": blocked(), "three robots": site(team(1, 2))}


def read(problem: Problem) -> Any:
    from unified_planning.io import PDDLReader

    return PDDLReader().parse_problem_string(problem.domain.text, problem.text)


def applicable_by_oracle(problem: Problem) -> set[tuple[str, ...]]:
    from unified_planning.model import UPState
    from unified_planning.model.walkers import StateEvaluator

    task = read(problem)
    evaluator, state = StateEvaluator(task), UPState(task.initial_values, task)
    found = set()
    for action in task.actions:
        for objects in product(*(list(task.objects(p.type)) for p in action.parameters)):
            binding = dict(zip(action.parameters, objects, strict=True))
            values = (
                evaluator.evaluate(c.substitute(binding), state).bool_constant_value()
                for c in action.preconditions
            )
            if all(values):
                found.add((action.name, *(o.name for o in objects)))
    return found


@pytest.mark.parametrize("name", SITES)
def test_applicable_actions_are_those_of_the_oracle_all_along_a_plan(name: str) -> None:
    problem = problem_for(DOMAIN, SITES[name])
    plan = BuiltinPlanner().plan(problem)
    assert isinstance(plan, SkillSequence)
    for done in (0, 5, len(plan.actions) // 2):
        state = state_after(problem, plan.actions[:done])
        here = with_state(problem, state)
        found = {(a.name, *a.arguments) for a in applicable(problem, state)}
        assert found == applicable_by_oracle(here)


@pytest.mark.parametrize("name", SITES)
@pytest.mark.parametrize("file", ["domain.pddl", TYPED])
def test_the_oracles_validator_agrees_on_good_and_on_spoilt_plans(name: str, file: str) -> None:
    from unified_planning.engines import SequentialPlanValidator
    from unified_planning.io import PDDLReader

    problem = problem_for(built_in_domain(file), SITES[name])
    plan = BuiltinPlanner().plan(problem)
    assert isinstance(plan, SkillSequence)
    task = read(problem)
    validator = SequentialPlanValidator()
    verdicts = set()
    for left_out in (None, 1, 4, 9, len(plan.actions) - 1):
        actions = [a for k, a in enumerate(plan.actions) if k != left_out]
        text = "\n".join(a.line for a in actions)
        theirs = validator.validate(task, PDDLReader().parse_plan_string(task, text))
        ours = validate(problem, [(a.name, a.arguments) for a in actions])
        assert bool(theirs) == isinstance(ours, ValidPlan)
        verdicts.add(bool(theirs))
        if isinstance(ours, ValidPlan):
            (cost,) = theirs.metric_evaluations.values()
            assert cost == ours.cost
    assert verdicts == {True, False}
