from __future__ import annotations

import stat
import sys
import time
from dataclasses import replace
from pathlib import Path

import psutil
import pytest

from builders_symbolic import (
    STUD,
    cell,
    four_nails,
    gripper,
    nail,
    robot,
    site,
    team,
    tool,
    with_geometry,
)
from sitewright.building_model.component import Operation, Process
from sitewright.errors import BackendError, BackendMissingError
from sitewright.foundation.ids import OperationId, RobotId
from sitewright.robot_team.cell import RobotSubtype
from sitewright.symbolic_planning.planner import NoPlan, SkillSequence, SymbolicPlanner
from sitewright.symbolic_planning.planners.builtin import BuiltinPlanner
from sitewright.symbolic_planning.planners.fast_downward import (
    OPTIMAL,
    FastDownward,
    FastDownwardDriver,
    search_binary,
)
from sitewright.symbolic_planning.problem import Problem, problem_for, with_state
from sitewright.symbolic_planning.progression import state_after
from sitewright.symbolic_planning.site_view import SiteView
from sitewright.symbolic_planning.validation import ValidPlan, validate
from sitewright.symbolic_planning.vocabulary import TYPED, built_in_domain

DOMAIN = built_in_domain()
OPTIMAL_WITH_AXIOMS = "astar(blind())"
A, B = RobotId("handler-1"), RobotId("nailer-1")


def blocked_by_the_holder() -> SiteView:
    """The case study's blocks: far nails and the holding robot exclude each other."""
    far = ("nail-03", "nail-04")
    pairs = {(B, n, STUD) for n in far} | {(A, STUD, n) for n in far}
    return with_geometry(site(), excludes=frozenset(pairs))


def far_nail_needs_hold() -> SiteView:
    return with_geometry(blocked_by_the_holder(), tacks=frozenset({(OperationId("nail-03"), STUD)}))


def painted() -> SiteView:
    names = ("nail-gun-1", "painter")
    a_cell = cell(
        [
            robot("handler-1", RobotSubtype.HANDLER, "g"),
            robot("nailer-1", RobotSubtype.FINISHER, names[0], names),
        ],
        [gripper("g"), tool(names[0], "nail"), tool(names[1], "paint", None)],
    )
    paint = Operation(id=OperationId("paint-1"), process=Process.PAINT, on=(STUD,))
    return site(a_cell, (nail(1), nail(2), paint), tacks=("nail-01",))


def through_the_buffer(*, has_buffer: bool) -> SiteView:
    """One handler reaches the stock, only the other one the target."""
    view = site(team(2, 2))
    g = view.geometry
    first, second = RobotId("handler-1"), RobotId("handler-2")
    forbidden = {(first, str(STUD)), (second, "stock")}
    return with_geometry(
        view,
        can_reach=frozenset(p for p in g.can_reach if p not in forbidden),
        can_set_down=g.can_set_down if has_buffer else frozenset(),
    )


SITES = {
    "case study": site(),
    "far nails blocked while held": blocked_by_the_holder(),
    "two of each": site(team(2, 2)),
    "paint": painted(),
    "through the buffer": through_the_buffer(has_buffer=True),
}
UNSOLVABLE = {
    "far nail must be driven while held": far_nail_needs_hold(),
    "no buffer": through_the_buffer(has_buffer=False),
}


def planned(planner: SymbolicPlanner, view: SiteView) -> SkillSequence:
    answer = planner.plan(problem_for(DOMAIN, view))
    assert isinstance(answer, SkillSequence), answer
    return answer


@pytest.mark.parametrize("name", SITES)
def test_our_task_and_the_translators_have_the_same_optimum(name: str) -> None:
    ours = planned(FastDownward(searches=(OPTIMAL,)), SITES[name])
    reference = planned(FastDownwardDriver(search=OPTIMAL_WITH_AXIOMS), SITES[name])
    best = planned(FastDownward(), SITES[name])
    assert ours.cost == reference.cost == best.cost
    assert best.is_reproducible


@pytest.mark.parametrize(
    ("search", "code"), [(OPTIMAL, 34), ("astar(lmcut(", 33), ("--evaluator x", 33)]
)
def test_what_the_real_program_refuses_is_an_error_with_its_code(search: str, code: int) -> None:
    with pytest.raises(BackendError, match=f"code {code}"):
        FastDownwardDriver(search=search).plan(problem_for(DOMAIN, site()))


def test_pddl_that_the_real_translator_refuses_is_an_error_with_its_words() -> None:
    problem = problem_for(DOMAIN, site())
    broken = replace(problem, text=problem.text.replace("(at r1 p1)", "(att r1 p1)", 1))
    with pytest.raises(BackendError, match=r"code 31.*att"):
        FastDownwardDriver().plan(broken)


@pytest.mark.parametrize("name", UNSOLVABLE)
@pytest.mark.parametrize("planner", [FastDownward(), FastDownwardDriver(), BuiltinPlanner()])
def test_what_cannot_be_done_is_proven(name: str, planner: SymbolicPlanner) -> None:
    answer = planner.plan(problem_for(DOMAIN, UNSOLVABLE[name]))
    assert isinstance(answer, NoPlan)
    assert answer.is_proven
    assert answer.reason


@pytest.mark.parametrize("name", SITES)
def test_the_builtin_planner_finds_valid_plans_that_cost_little_more(name: str) -> None:
    best = planned(FastDownward(), SITES[name])
    builtin = planned(BuiltinPlanner(), SITES[name])
    assert best.cost <= builtin.cost <= 1.3 * best.cost


@pytest.mark.parametrize("name", ["case study", "far nails blocked while held", "paint"])
def test_the_domain_with_subtypes_as_parameters_gives_the_same_plans(name: str) -> None:
    typed = FastDownward().plan(problem_for(built_in_domain(TYPED), SITES[name]))
    assert isinstance(typed, SkillSequence)
    assert typed.calls == planned(FastDownward(), SITES[name]).calls


def test_the_holder_lets_go_before_the_far_nails_are_driven() -> None:
    plan = planned(FastDownward(), blocked_by_the_holder())
    number = {(c.skill, c.arguments[0]): k for k, c in enumerate(plan.calls)}
    assert number["fasten", "nail-02"] < number["release", STUD] < number["retract", STUD]
    assert number["retract", STUD] < number["reach", "nail-03"]


def test_a_painted_stud_needs_a_change_of_tool_after_it_stands() -> None:
    plan = planned(FastDownward(), painted())
    skills = [c.skill for c in plan.calls]
    assert skills.count("change-end-effector") == 1
    assert skills.index("release") < skills.index("apply-finish")


def test_twelve_nails_are_planned_quickly() -> None:
    operations = tuple(nail(k, f"support-{1 + k % 2}") for k in range(1, 13))
    plan = planned(FastDownward(), site(team(2, 2), operations, tacks=("nail-01", "nail-02")))
    assert [c.skill for c in plan.calls].count("fasten") == 12
    assert plan.wall_s < 5.0


def test_the_same_problem_gives_the_same_plan() -> None:
    assert (
        planned(FastDownward(), site(team(2, 2))).text
        == planned(FastDownward(), site(team(2, 2))).text
    )


def test_an_installed_target_with_all_at_home_needs_no_step() -> None:
    view = site(
        in_place={STUD: site().candidates[0]},
        lies_at={},
        standing=frozenset({STUD}),
        done_operations=frozenset(op.id for op in four_nails()),
    )
    assert planned(FastDownward(), view).calls == ()


def test_planning_goes_on_from_the_middle_of_a_target() -> None:
    problem = problem_for(DOMAIN, site())
    whole = planned(FastDownward(), site())
    for done in (3, 6, 13):
        rest = FastDownward().plan(with_state(problem, state_after(problem, whole.actions[:done])))
        assert isinstance(rest, SkillSequence)
        assert rest.cost == sum(a.cost for a in whole.actions[done:])


# --- the program itself -----------------------------------------------------------------------


def fake(folder: Path, body: str) -> Path:
    """An installation whose search binary is a small script."""
    binary = search_binary(folder)
    binary.parent.mkdir(parents=True)
    binary.write_text(f"#!{sys.executable}\nimport os, sys, time\n{body}\n", encoding="utf-8")
    binary.chmod(binary.stat().st_mode | stat.S_IXUSR)
    return folder


@pytest.fixture
def problem() -> Problem:
    return problem_for(DOMAIN, site())


@pytest.mark.parametrize("code", [10, 11])
def test_exit_codes_of_proof_are_proof(tmp_path: Path, problem: Problem, code: int) -> None:
    answer = FastDownward(folder=fake(tmp_path, f"sys.exit({code})")).plan(problem)
    assert isinstance(answer, NoPlan)
    assert answer.is_proven


@pytest.mark.parametrize("code", [12, 13, 20, 21, 22, 23, 24])
def test_exit_codes_of_limits_are_no_proof(tmp_path: Path, problem: Problem, code: int) -> None:
    answer = FastDownward(folder=fake(tmp_path, f"sys.exit({code})")).plan(problem)
    assert isinstance(answer, NoPlan)
    assert not answer.is_proven
    assert "search 2" in answer.planner


@pytest.mark.parametrize("code", [30, 31, 32, 33, 34, 35, 36, 37, 99])
def test_other_exit_codes_are_errors_with_what_was_printed(
    tmp_path: Path, problem: Problem, code: int
) -> None:
    folder = fake(tmp_path, f"print('the option is wrong', file=sys.stderr)\nsys.exit({code})")
    with pytest.raises(BackendError, match=f"code {code}.*the option is wrong"):
        FastDownward(folder=folder).plan(problem)


def test_a_killed_search_is_an_error_that_names_the_signal(
    tmp_path: Path, problem: Problem
) -> None:
    folder = fake(tmp_path, "os.kill(os.getpid(), 9)")
    with pytest.raises(BackendError, match="killed by SIGKILL; nothing was run"):
        FastDownward(folder=folder).plan(problem)


def test_a_missing_binary_is_named_with_the_way_to_get_it(tmp_path: Path, problem: Problem) -> None:
    with pytest.raises(BackendMissingError, match="up-fast-downward"):
        FastDownward(folder=tmp_path).plan(problem)


def test_a_missing_package_is_named_with_the_way_to_get_it(
    monkeypatch: pytest.MonkeyPatch, problem: Problem
) -> None:
    module = "sitewright.symbolic_planning.planners.fast_downward.find_spec"
    monkeypatch.setattr(module, lambda _: None)
    for planner in (FastDownward(), FastDownwardDriver()):
        with pytest.raises(BackendMissingError, match="pip install 'up-fast-downward"):
            planner.plan(problem)


def test_a_binary_that_cannot_be_run_is_an_error(tmp_path: Path, problem: Problem) -> None:
    folder = fake(tmp_path, "")
    search_binary(folder).write_bytes(b"\x00\x01 no program")
    with pytest.raises(BackendError, match="cannot be started"):
        FastDownward(folder=folder).plan(problem)


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("sys.exit(0)", "wrote none"),
        ("open('plan','w').write('(fly r1)')", "no action of the domain"),
        ("open('plan','w').write('(reach r1 s1)')", "Step 1 .reach. needs"),
        ("open('plan','w').write('')", "The goal needs"),
    ],
)
def test_a_wrong_answer_is_never_passed_on(
    tmp_path: Path, problem: Problem, body: str, message: str
) -> None:
    with pytest.raises(BackendError, match=message):
        FastDownward(folder=fake(tmp_path, body)).plan(problem)


def test_a_second_answer_is_marked_as_not_reproducible(tmp_path: Path, problem: Problem) -> None:
    plan = planned(FastDownward(), site())
    body = f"'w=3' in sys.argv[2] or sys.exit(12)\nopen('plan','w').write({plan.text!r})"
    answer = FastDownward(folder=fake(tmp_path, body)).plan(problem)
    assert isinstance(answer, SkillSequence)
    assert answer.planner == "fast-downward search 2"
    assert not answer.is_reproducible
    assert answer.calls == plan.calls


def test_a_search_that_hangs_is_stopped_with_all_its_children(
    tmp_path: Path, problem: Problem
) -> None:
    pids = tmp_path / "pids"
    body = (
        f"child = os.fork()\nopen({str(pids)!r}, 'a').write(f'{{os.getpid()}}\\n')\ntime.sleep(60)"
    )
    started_s = time.monotonic()
    answer = FastDownward(folder=fake(tmp_path, body)).plan(problem, timeout_s=0.5)
    assert time.monotonic() - started_s < 10.0
    assert isinstance(answer, NoPlan)
    assert not answer.is_proven
    assert "time limit" in answer.reason
    seen = [int(p) for p in pids.read_text(encoding="utf-8").split()]
    assert seen
    deadline_s = time.monotonic() + 5.0
    while any(_lives(p) for p in seen) and time.monotonic() < deadline_s:
        time.sleep(0.05)
    assert not any(_lives(p) for p in seen)


def _lives(pid: int) -> bool:
    return psutil.pid_exists(pid) and bool(psutil.Process(pid).status() != psutil.STATUS_ZOMBIE)


def test_nothing_is_left_in_the_temporary_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, problem: Problem
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    planner: SymbolicPlanner
    for planner in (FastDownward(), FastDownwardDriver()):
        answer = planner.plan(problem)
        assert isinstance(answer, SkillSequence)
        lines = [(a.name, a.arguments) for a in answer.actions]
        assert validate(problem, lines) == ValidPlan(cost=answer.cost)
    assert not list(tmp_path.iterdir())
