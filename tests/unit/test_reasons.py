from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from builders_symbolic import site
from sitewright.errors import BackendError
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.files import write_pddl_files
from sitewright.symbolic_planning.planner import NoPlan, SkillSequence
from sitewright.symbolic_planning.planners.builtin import BuiltinPlanner
from sitewright.symbolic_planning.problem import Problem, problem_for
from sitewright.symbolic_planning.reasons import (
    effects,
    facts_that_fail,
    relies_on,
)
from sitewright.symbolic_planning.validation import InvalidStep, ValidPlan, validate
from sitewright.symbolic_planning.vocabulary import built_in_domain

HANDLER, NAILER = RobotId("handler-1"), RobotId("nailer-1")


@pytest.fixture(scope="module")
def problem() -> Problem:
    return problem_for(built_in_domain(), site())


@pytest.fixture(scope="module")
def plan(problem: Problem) -> SkillSequence:
    answer = BuiltinPlanner().plan(problem)
    assert isinstance(answer, SkillSequence)
    return answer


def test_facts_of_a_step_are_pddl_in_site_ids(problem: Problem) -> None:
    reach = problem.action(SkillCall("reach", NAILER, ("nail-01",)))
    assert reach is not None
    assert relies_on(problem, reach) == (
        "(in-transit nailer-1)",
        "(positioned stud-1)",
        "(vacant nail-01)",
    )
    assert effects(problem, reach) == (
        "(at nailer-1 nail-01)",
        "(not (in-transit nailer-1))",
        "(not (vacant nail-01))",
    )


def test_facts_that_do_not_hold_any_more_are_found(problem: Problem) -> None:
    retract = problem.action(SkillCall("retract", HANDLER, ("prep-handler-1",)))
    assert retract is not None
    facts = (*relies_on(problem, retract), "(not (standing stud-1))")
    assert facts_that_fail(facts, site()) == ()
    status = dict(site().robot_status)
    status[HANDLER] = replace(status[HANDLER], place=None)
    assert facts_that_fail(facts, site(robot_status=status)) == ("(at handler-1 prep-handler-1)",)
    standing = site(standing=frozenset({problem.target}))
    assert facts_that_fail(facts, standing) == ("(not (standing stud-1))",)


def test_a_text_that_is_no_fact_is_refused() -> None:
    with pytest.raises(BackendError, match=r"\(wet floor\)"):
        facts_that_fail(("(wet floor)",), site())


def test_a_left_out_step_is_named_with_what_is_missing(
    problem: Problem, plan: SkillSequence
) -> None:
    lines = [(a.name, a.arguments) for a in plan.actions]
    number = next(k for k, c in enumerate(plan.calls) if c.skill == "grasp")
    verdict = validate(problem, lines[:number] + lines[number + 1 :])
    assert isinstance(verdict, InvalidStep)
    assert verdict.missing == ("(holding handler-1 piece-3)",)
    assert "(position) needs (holding handler-1 piece-3)" in verdict.reason
    assert lines[verdict.number][0] == "position"


def test_a_plan_that_stops_early_is_named_with_the_unmet_goal(
    problem: Problem, plan: SkillSequence
) -> None:
    lines = [(a.name, a.arguments) for a in plan.actions]
    assert validate(problem, lines) == ValidPlan(cost=plan.cost)
    verdict = validate(problem, lines[:-1])
    assert isinstance(verdict, InvalidStep)
    assert verdict.number == len(lines)
    assert any(f.startswith("(at ") for f in verdict.missing)


@pytest.mark.parametrize(
    "line", [("fly", ("r1",)), ("reach", ("r1",)), ("reach", ("s1", "r1")), ("reach", ("r1", "q9"))]
)
def test_what_is_no_action_of_the_domain_is_an_invalid_step(
    problem: Problem, line: tuple[str, tuple[str, ...]]
) -> None:
    verdict = validate(problem, [line])
    assert isinstance(verdict, InvalidStep)
    assert "is no action of the domain" in verdict.reason


def test_a_nail_before_the_stud_is_there_is_invalid_because_of_the_guarded_condition(
    problem: Problem,
) -> None:
    name = problem.name_by_site_id
    robot, station, spot = (name[i] for i in ("nailer-1", "prep-nailer-1", "nail-01"))
    verdict = validate(problem, [("retract", (robot, station)), ("reach", (robot, spot))])
    assert isinstance(verdict, InvalidStep)
    assert verdict.missing == ("(positioned stud-1)",)


def test_domain_problem_and_plan_are_written_for_anyone_to_check(
    tmp_path: Path, problem: Problem, plan: SkillSequence
) -> None:
    hostile = replace(problem, target=ComponentId("../a/b"))
    paths = write_pddl_files(tmp_path / "pddl", hostile, plan, number=2)
    assert sorted(p.name for p in (tmp_path / "pddl").iterdir()) == sorted(p.name for p in paths)
    texts = {p.suffix: p.read_text(encoding="utf-8") for p in paths}
    assert texts[".domain"] == problem.domain.text
    assert texts[".problem"] == problem.text
    assert texts[".plan"].splitlines()[:-1] == [a.line for a in plan.actions]


def test_a_no_is_written_as_a_comment(tmp_path: Path, problem: Problem) -> None:
    answer = NoPlan(is_proven=True, reason="No order of\nskills.")
    paths = write_pddl_files(tmp_path, problem, answer)
    assert paths[-1].read_text(encoding="utf-8") == "; proven: No order of skills.\n"
