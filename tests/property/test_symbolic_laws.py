"""Laws of symbolic planning on random teams, fasteners and geometric facts."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

from hypothesis import given, settings
from hypothesis import strategies as st

from builders_symbolic import STUD, nail, reach_times, site, team, with_geometry
from sitewright.foundation.ids import RobotId
from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.planner import NoPlan, SkillSequence
from sitewright.symbolic_planning.planners.builtin import BuiltinPlanner
from sitewright.symbolic_planning.planners.fast_downward import (
    OPTIMAL,
    FastDownward,
    FastDownwardDriver,
)
from sitewright.symbolic_planning.problem import Problem, problem_for
from sitewright.symbolic_planning.progression import (
    State,
    applicable,
    apply,
    is_applicable,
    is_goal,
    lost_goals,
)
from sitewright.symbolic_planning.site_view import SiteView
from sitewright.symbolic_planning.validation import InvalidStep, ValidPlan, validate
from sitewright.symbolic_planning.vocabulary import built_in_domain

DOMAIN = built_in_domain()
OPTIMAL_WITH_AXIOMS = "astar(blind())"


@st.composite
def sites(draw: st.DrawFn, *, max_robots: int = 2) -> SiteView:
    """A team, some nails, some tacks; some reaches are lost, some exclude each other."""
    a_cell = team(draw(st.integers(1, max_robots)), draw(st.integers(1, max_robots)))
    operations = tuple(
        nail(k, f"support-{1 + k % 2}") for k in range(1, draw(st.integers(1, 4)) + 1)
    )
    tacks = draw(st.sets(st.sampled_from([op.id for op in operations]), max_size=2))
    view = site(a_cell, operations, tacks=sorted(tacks))
    reach = sorted(view.geometry.can_reach)
    lost = draw(st.sets(st.sampled_from(reach), max_size=3))
    spots = [op.id for op in operations]
    blocks = st.tuples(st.sampled_from(sorted(a_cell.robot_by_id)), st.sampled_from(spots))
    excludes = {(r, c, STUD) for r, c in draw(st.sets(blocks, max_size=3))}
    return with_geometry(
        view,
        can_reach=frozenset(reach) - lost,
        excludes=frozenset(excludes),
    )


def states_on_the_way(problem: Problem, choices: list[int]) -> list[State]:
    """States of a random walk."""
    states = [problem.init]
    for choice in choices:
        actions = applicable(problem, states[-1])
        if not actions:
            break
        states.append(apply(actions[choice % len(actions)], states[-1]))
    return states


def applicable_by_brute_force(problem: Problem, state: State) -> set[tuple[str, ...]]:
    """Try every action with every argument on the domain's own formulas."""
    here = replace(problem, init=state, goal=frozenset(), goal_not=frozenset())
    members = {
        p.type: [o.name for o in problem.objects if DOMAIN.is_a(o.type, p.type)]
        for a in DOMAIN.actions
        for p in a.parameters
    }
    return {
        (action.name, *arguments)
        for action in DOMAIN.actions
        for arguments in product(*(members[p.type] for p in action.parameters))
        if isinstance(validate(here, [(action.name, arguments)]), ValidPlan)
    }


walks = st.lists(st.integers(0, 99), max_size=25)


@settings(deadline=None, max_examples=12)
@given(view=sites(), walk=walks)
def test_applicable_actions_are_those_of_brute_force(view: SiteView, walk: list[int]) -> None:
    problem = problem_for(DOMAIN, view)
    state = states_on_the_way(problem, walk)[-1]
    found = {(a.name, *a.arguments) for a in applicable(problem, state)}
    assert found == applicable_by_brute_force(problem, state)


def _one_of(state: State, wanted: set[Fact]) -> bool:
    return len(state & wanted) == 1


@settings(deadline=None, max_examples=25)
@given(view=sites(), walk=walks)
def test_everything_is_at_exactly_one_place(view: SiteView, walk: list[int]) -> None:
    problem = problem_for(DOMAIN, view)
    names = {o.name: o.type for o in problem.objects}
    robots = [n for n, t in names.items() if DOMAIN.is_a(t, "robot")]
    places = [n for n, t in names.items() if DOMAIN.is_a(t, "place")]
    pieces = [n for n, t in names.items() if t == "thing"]
    tools = [n for n, t in names.items() if DOMAIN.is_a(t, "end-effector")]
    for state in states_on_the_way(problem, walk):
        for r in robots:
            assert _one_of(state, {("in-transit", r), *(("at", r, p) for p in places)})
            hand: set[Fact] = {("hand-empty", r), ("steadying", r, "t1")}
            assert _one_of(state, hand | {("holding", r, m) for m in pieces})
            assert _one_of(state, {("mounted", r, e) for e in tools})
        for m in pieces:
            held = {("holding", r, m) for r in robots}
            assert _one_of(
                state, held | {("lies-at", m, p) for p in places} | {("in-place", m, "t1")}
            )
        for p in places:
            assert _one_of(state, {("vacant", p), *(("at", r, p) for r in robots)})
        for e in tools:
            mounted = {("mounted", r, e) for r in robots}
            docked = {f for f in state if f[:2] == ("docked", e)}
            assert len(state & mounted) + len(docked) == 1


@settings(deadline=None, max_examples=12)
@given(view=sites())
def test_our_task_and_the_translators_agree_in_verdict_and_optimum(view: SiteView) -> None:
    problem = problem_for(DOMAIN, view)
    ours = FastDownward(searches=(OPTIMAL,)).plan(problem)
    reference = FastDownwardDriver(search=OPTIMAL_WITH_AXIOMS).plan(problem)
    if isinstance(reference, NoPlan):
        assert isinstance(ours, NoPlan)
        assert ours.is_proven
        assert reference.is_proven
    else:
        assert isinstance(ours, SkillSequence)
        assert ours.cost == reference.cost


@settings(deadline=None, max_examples=12)
@given(view=sites())
def test_fast_path_and_builtin_agree_whether_there_is_a_plan(view: SiteView) -> None:
    problem = problem_for(DOMAIN, view)
    fast, builtin = FastDownward().plan(problem), BuiltinPlanner().plan(problem)
    assert isinstance(fast, NoPlan) == isinstance(builtin, NoPlan)
    if isinstance(fast, SkillSequence) and isinstance(builtin, SkillSequence):
        assert fast.cost <= builtin.cost


@settings(deadline=None, max_examples=20)
@given(view=sites(), data=st.data())
def test_a_plan_holds_in_both_semantics_and_a_spoilt_one_in_neither(
    view: SiteView, data: st.DataObject
) -> None:
    problem = problem_for(DOMAIN, view)
    plan = BuiltinPlanner().plan(problem)
    if isinstance(plan, NoPlan) or not plan.actions:
        return
    actions = list(plan.actions)
    del actions[data.draw(st.integers(0, len(actions) - 1))]
    state, holds = problem.init, True
    for action in actions:
        holds = holds and is_applicable(action, state)
        state = apply(action, state)
    holds = holds and is_goal(problem, state)
    verdict = validate(problem, [(a.name, a.arguments) for a in actions])
    assert isinstance(verdict, InvalidStep) == (not holds)


@settings(deadline=None, max_examples=15)
@given(view=sites(), walk=walks)
def test_a_lost_goal_stays_lost(view: SiteView, walk: list[int]) -> None:
    problem = problem_for(DOMAIN, view)
    lost: set[Fact] = set()
    for state in states_on_the_way(problem, walk):
        now = set(lost_goals(problem, state))
        assert lost <= now
        lost = now


@settings(deadline=None, max_examples=8)
@given(names=st.permutations(["a", "m", "z"]))
def test_other_names_for_the_robots_keep_the_cost(names: list[str]) -> None:
    view = site()
    new = {r: RobotId(f"{names[k]}-robot") for k, r in enumerate(view.cell.robot_by_id)}
    renamed = {new[i]: replace(r, id=new[i]) for i, r in view.cell.robot_by_id.items()}
    stations = {
        s.id: replace(s, robot=new[s.robot]) if s.robot else s
        for s in view.cell.station_by_id.values()
    }
    geometry = view.geometry

    def moved(facts: frozenset[tuple[str, ...]]) -> frozenset[tuple[str, ...]]:
        return frozenset((new[RobotId(f[0])], *f[1:]) for f in facts)

    other = replace(
        view,
        cell=replace(view.cell, robot_by_id=renamed, station_by_id=stations),
        robot_status={new[r]: s for r, s in view.robot_status.items()},
    )
    other = with_geometry(
        other,
        can_reach=moved(geometry.can_reach),
        can_grasp=moved(geometry.can_grasp),
        can_place=moved(geometry.can_place),
        can_set_down=moved(geometry.can_set_down),
        reach_time_s={(new[r], p): t for (r, p), t in geometry.reach_time_s.items()},
    )
    costs = []
    for each in (view, other):
        plan = FastDownward(searches=(OPTIMAL,)).plan(problem_for(DOMAIN, each))
        assert isinstance(plan, SkillSequence)
        costs.append(plan.cost)
    assert costs[0] == costs[1]


@settings(deadline=None, max_examples=6)
@given(finishers=st.integers(1, 2))
def test_one_more_finisher_never_makes_a_plan_dearer(finishers: int) -> None:
    costs = []
    for count in (finishers, finishers + 1):
        view = site(team(1, count))
        times = dict.fromkeys(reach_times(view.geometry.can_reach), 3.0)
        view = with_geometry(view, reach_time_s=times)
        plan = FastDownward(searches=(OPTIMAL,)).plan(problem_for(DOMAIN, view))
        assert isinstance(plan, SkillSequence)
        costs.append(plan.cost)
    assert costs[1] <= costs[0]
