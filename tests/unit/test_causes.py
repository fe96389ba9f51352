"""Which step needs what another one brings about: laws over plans of the planner."""

from __future__ import annotations

from itertools import pairwise

import pytest

from builders_symbolic import site
from sitewright.central_controller.causes import (
    CausalLink,
    causal_links,
    is_asked_for,
    way_to_purpose,
)
from sitewright.central_controller.proposal import ProposedStep
from sitewright.foundation.ids import RobotId
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.planner import SkillSequence
from sitewright.symbolic_planning.planners.builtin import BuiltinPlanner
from sitewright.symbolic_planning.problem import problem_for
from sitewright.symbolic_planning.problem_text import fact_text
from sitewright.symbolic_planning.reasons import effects, relies_on
from sitewright.symbolic_planning.vocabulary import built_in_domain


@pytest.fixture(scope="module")
def goal() -> set[str]:
    problem = problem_for(built_in_domain(), site())
    return {fact_text(problem.in_site_ids(f)) for f in problem.goal}


@pytest.fixture(scope="module")
def steps() -> tuple[ProposedStep, ...]:
    problem = problem_for(built_in_domain(), site())
    plan = BuiltinPlanner().plan(problem)
    assert isinstance(plan, SkillSequence)
    return tuple(
        ProposedStep(
            number=number,
            call=call,
            params={},
            motions=(),
            duration_s=1.0,
            relies_on=relies_on(problem, action),
            effects=effects(problem, action),
        )
        for number, (call, action) in enumerate(zip(plan.calls, plan.actions, strict=True), 1)
    )


def is_spot(step: ProposedStep) -> bool:
    return step.call.arguments[0].startswith("nail-")


def numbers(steps: tuple[ProposedStep, ...], skill: str) -> list[int]:
    return [s.number for s in steps if s.call.skill == skill]


def test_every_need_is_linked_to_the_last_step_that_brought_it_about(
    steps: tuple[ProposedStep, ...],
) -> None:
    links = [x for x in causal_links(steps) if x.consumer is not None]
    assert {(x.consumer, x.fact) for x in links} == {
        (s.number, f) for s in steps for f in s.relies_on
    }
    for link in links:
        assert link.producer < (link.consumer or 0)
        between = steps[link.producer : (link.consumer or 0) - 1]
        negated = link.fact[5:-1] if link.fact.startswith("(not ") else f"(not {link.fact})"
        assert not any({link.fact, negated} & set(s.effects) for s in between)
        if link.producer:
            assert link.fact in steps[link.producer - 1].effects


def test_what_lasts_is_what_is_true_at_the_end_the_goal_among_it(
    steps: tuple[ProposedStep, ...], goal: set[str]
) -> None:
    lasting = {x.fact for x in causal_links(steps) if x.consumer is None}
    for step in steps:
        for effect in step.effects:
            later = {e for s in steps[step.number :] for e in s.effects}
            opposite = effect[5:-1] if effect.startswith("(not ") else f"(not {effect})"
            assert (effect in lasting) or opposite in later
    made = {e for s in steps for e in s.effects}
    assert goal & made <= lasting
    assert any(is_asked_for(f) for f in lasting)


def test_a_nail_is_driven_because_the_stud_is_in_place(steps: tuple[ProposedStep, ...]) -> None:
    (position,) = numbers(steps, Skill.POSITION)
    served = {x.consumer for x in causal_links(steps) if x.producer == position}
    assert set(numbers(steps, Skill.RELEASE)) <= served
    reached = {s.number for s in steps if s.call.skill == Skill.REACH and is_spot(s)}
    assert reached
    assert reached <= served


def test_every_step_but_the_tidying_up_leads_to_something_that_the_design_asks_for(
    steps: tuple[ProposedStep, ...],
) -> None:
    links = causal_links(steps)
    for step in steps:
        way = way_to_purpose(links, step.number)
        is_tidying = step.call.skill == Skill.RETRACT or step.call.arguments[0].startswith("prep-")
        assert is_tidying or way[:1] == (step.number,)
        for first, then in pairwise(way):
            assert any((x.producer, x.consumer) == (first, then) for x in links)
        if way:
            assert any(is_asked_for(e) for e in steps[way[-1] - 1].effects)


def test_a_step_whose_effects_nobody_needs_leads_nowhere() -> None:
    alone = ProposedStep(
        number=1,
        call=SkillCall("wave", RobotId("r1"), ()),
        params={},
        motions=(),
        duration_s=1.0,
        effects=("(waved r1)",),
    )
    links = causal_links((alone,))
    assert links == (CausalLink(1, None, "(waved r1)"),)
    assert way_to_purpose(links, 1) == ()
