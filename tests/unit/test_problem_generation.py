from __future__ import annotations

from dataclasses import replace
from itertools import product

import pytest

from builders_symbolic import (
    NAIL,
    SCREW,
    STUD,
    cell,
    four_nails,
    graph,
    gripper,
    nail,
    robot,
    site,
    team,
    tool,
    with_geometry,
)
from sitewright.building_model.component import FastenerSpec, Operation, Process
from sitewright.errors import BackendError, BuildingModelError
from sitewright.foundation.ids import (
    ComponentId,
    EndEffectorId,
    OperationId,
    RobotId,
    StationId,
)
from sitewright.robot_team.cell import RobotSubtype
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.planner import NoPlan, foregone
from sitewright.symbolic_planning.problem import problem_for, with_state
from sitewright.symbolic_planning.progression import (
    applicable,
    apply,
    is_goal_reachable,
    lost_goals,
    other_actions,
)
from sitewright.symbolic_planning.site_view import SiteView
from sitewright.symbolic_planning.vocabulary import TYPED, built_in_domain

DOMAIN = built_in_domain()
HANDLER, NAILER = RobotId("handler-1"), RobotId("nailer-1")
PIECE = ComponentId("piece-3")


def facts(view: SiteView) -> set[str]:
    problem = problem_for(DOMAIN, view)
    return {" ".join(problem.in_site_ids(f)) for f in problem.init | problem.static}


def goals(view: SiteView) -> set[str]:
    problem = problem_for(DOMAIN, view)
    true = {" ".join(problem.in_site_ids(f)) for f in problem.goal}
    return true | {"not " + " ".join(problem.in_site_ids(f)) for f in problem.goal_not}


def with_robot(view: SiteView, name: RobotId, **changes: object) -> SiteView:
    status = replace(view.robot_status[name], **changes)  # type: ignore[arg-type]
    return replace(view, robot_status={**view.robot_status, name: status})


def test_the_goal_is_the_installed_target_with_the_robots_back_at_their_stations() -> None:
    assert goals(site()) == {
        "at handler-1 prep-handler-1",
        "at nailer-1 prep-nailer-1",
        *(f"fastened nail-0{k}" for k in (1, 2, 3, 4)),
        "hand-empty handler-1",
        "hand-empty nailer-1",
        "mobile handler-1",
        "mobile nailer-1",
        "in-place piece-3 stud-1",
        "positioned stud-1",
        "standing stud-1",
        "not pending stud-1",
        "not holding handler-1 piece-3",
        "not holding nailer-1 piece-3",
        "not steadying handler-1 stud-1",
        "not steadying nailer-1 stud-1",
    }


def test_only_the_top_of_the_stack_is_accessible() -> None:
    pieces = tuple(ComponentId(f"piece-{k}") for k in (1, 2, 3))
    found = facts(site(candidates=pieces))
    assert {f for f in found if f.startswith("accessible")} == {"accessible piece-3"}


def test_a_buried_piece_stays_buried_even_if_only_it_is_a_candidate() -> None:
    buried = ComponentId("piece-2")
    view = site(candidates=(buried,), lies_at={buried: "stock"})
    assert "accessible piece-2" not in facts(view)
    lifted = with_robot(view, HANDLER, place="stock", holding=PIECE)
    assert "accessible piece-2" in facts(lifted)


def test_with_several_candidates_none_is_prescribed() -> None:
    pieces = (ComponentId("piece-2"), PIECE)
    assert not {g for g in goals(site(candidates=pieces)) if g.startswith("in-place")}


def test_a_piece_that_lies_in_place_is_the_one_that_must_stay_there() -> None:
    pieces = (ComponentId("piece-2"), PIECE)
    view = site(candidates=pieces, in_place={STUD: PIECE}, lies_at={})
    assert {g for g in goals(view) if g.startswith("in-place")} == {"in-place piece-3 stud-1"}
    assert {"positioned stud-1", "in-place piece-3 stud-1"} <= facts(view)
    assert "pending stud-1" not in facts(view)


def test_a_robot_in_the_middle_of_its_work_is_described_as_it_is() -> None:
    view = with_robot(
        site(
            in_place={STUD: PIECE}, lies_at={}, done_operations=frozenset({OperationId("nail-01")})
        ),
        HANDLER,
        place=STUD,
        steadying=STUD,
    )
    view = with_robot(view, NAILER, place=None)
    found = facts(view)
    assert {"at handler-1 stud-1", "steadying handler-1 stud-1", "fastened nail-01"} <= found
    assert {"in-transit nailer-1"} <= found
    assert found.isdisjoint({"vacant stud-1", "mobile handler-1", "hand-empty handler-1"})


def test_a_robot_at_a_place_of_another_target_is_somewhere_and_can_leave() -> None:
    view = with_robot(site(), NAILER, place="nail-of-yesterday")
    problem = problem_for(DOMAIN, view)
    calls = [problem.call(a) for a in applicable(problem, problem.init)]
    assert SkillCall("retract", NAILER, ("nail-of-yesterday",)) in calls
    assert is_goal_reachable(problem, problem.init)


def test_names_are_numbered_in_order_of_ids_and_mapped_both_ways() -> None:
    problem = problem_for(DOMAIN, site())
    ids = {o.name: o.site_id for o in problem.objects}
    assert [ids[f"c{k}"] for k in (1, 2, 3, 4)] == [f"nail-0{k}" for k in (1, 2, 3, 4)]
    assert all(problem.name_by_site_id[i] == n for n, i in ids.items())
    assert all(name == name.lower() for name in ids)


def test_the_same_site_gives_the_same_text_whatever_the_order_of_its_mappings() -> None:
    view = site(team(2, 2))
    status = dict(sorted(view.robot_status.items(), reverse=True))
    nodes = dict(sorted(view.graph.node_by_id.items(), reverse=True))
    other = replace(view, robot_status=status, graph=replace(view.graph, node_by_id=nodes))
    assert problem_for(DOMAIN, other).text == problem_for(DOMAIN, view).text


def test_every_reach_has_a_time_and_times_are_whole_tenths_of_at_least_one() -> None:
    view = with_geometry(site(), reach_time_s={(HANDLER, "stock"): 0.001})
    problem = problem_for(DOMAIN, view)
    robots = [o.name for o in problem.objects if o.name.startswith("r")]
    places = [o.name for o in problem.objects if DOMAIN.is_a(o.type, "place")]
    times = {f[1:]: v for f, v in problem.values.items() if f[0] == "reach-time"}
    assert set(times) == set(product(robots, places))
    assert times[problem.name_by_site_id["handler-1"], problem.name_by_site_id["stock"]] == 1
    assert min(problem.values.values()) == 1


@pytest.mark.parametrize("key", ["grasping", "grasp"])
def test_skill_times_may_be_given_by_capability_or_by_skill(key: str) -> None:
    problem = problem_for(DOMAIN, with_geometry(site(), skill_time_s={(HANDLER, key): 7.0}))
    assert problem.values["skill-time", "r1", "grasping"] == 70
    assert problem.values["skill-time", "r2", "grasping"] == 20


def test_a_target_whose_support_is_not_built_is_proven_impossible_with_its_reason() -> None:
    problem = problem_for(DOMAIN, site(graph=graph(four_nails(), is_supported=False)))
    answer = foregone(problem, planner="x")
    assert isinstance(answer, NoPlan)
    assert answer.is_proven
    assert "goal needs (ready stud-1), which no skill changes" in answer.reason


def test_where_no_piece_is_left_that_is_the_reason_and_lost_ones_are_named() -> None:
    answer = foregone(problem_for(DOMAIN, site(candidates=())), planner="x")
    assert isinstance(answer, NoPlan)
    assert answer.is_proven
    assert answer.reason == "no piece that fits stud-1 can be taken."


def test_an_operation_that_no_skill_does_is_named() -> None:
    glue = replace(nail(9), process=Process.GLUE, fastener=None)
    answer = foregone(problem_for(DOMAIN, site(operations=(glue,), tacks=())), planner="x")
    assert isinstance(answer, NoPlan)
    assert "operation nail-09 of stud-1 is glue, which no skill does" in answer.reason


def test_a_fastener_that_no_tool_drives_makes_the_goal_unreachable_by_name() -> None:
    thick = nail(5, fastener=replace(NAIL, d_m=0.02))
    answer = foregone(problem_for(DOMAIN, site(operations=(thick,), tacks=())), planner="x")
    assert isinstance(answer, NoPlan)
    assert answer.is_proven
    assert "(fastened nail-05)" in answer.reason


@pytest.mark.parametrize(
    ("fastener", "is_driven"),
    [(NAIL, True), (SCREW, False), (replace(NAIL, l_m=0.2), False), (None, True)],
)
def test_a_tool_drives_what_its_process_and_ranges_cover(
    fastener: FastenerSpec | None, *, is_driven: bool
) -> None:
    found = facts(site(operations=(nail(1, fastener=fastener),), tacks=()))
    assert ("drives nail-gun-1 nail-01" in found) is is_driven


def test_fasteners_of_a_connection_form_a_chain_in_which_tacks_come_first() -> None:
    found = facts(site(tacks=("nail-02", "nail-04")))
    assert {f for f in found if f.startswith("driven-after")} == {
        "driven-after nail-01 nail-02",
        "driven-after nail-03 nail-04",
    }


def test_the_designers_order_wins_over_the_chain() -> None:
    operations = (nail(1, after=(OperationId("nail-02"),)), nail(2), nail(3))
    found = facts(site(operations=operations, tacks=()))
    assert {f for f in found if f.startswith("driven-after")} == {"driven-after nail-01 nail-02"}


def test_an_operation_that_waits_for_one_of_elsewhere_is_impossible_until_that_is_done() -> None:
    operations = (nail(1, after=(OperationId("other-nail"),)),)
    view = site(operations=operations, tacks=())
    assert "comes after other-nail" in problem_for(DOMAIN, view).impossible[0]
    done = replace(view, done_operations=frozenset({OperationId("other-nail")}))
    assert not problem_for(DOMAIN, done).impossible


def test_a_finish_waits_for_the_fasteners_that_the_designer_puts_before_it() -> None:
    paint = Operation(
        id=OperationId("paint-1"),
        process=Process.PAINT,
        on=(STUD,),
        after=(OperationId("nail-01"),),
    )
    names = ("nail-gun-1", "painter")
    effectors = [gripper("g"), tool(names[0], "nail"), tool(names[1], "paint", None)]
    a_cell = cell(
        [robot("handler-1", RobotSubtype.HANDLER, "g"),
         robot("nailer-1", RobotSubtype.FINISHER, names[0], names)],
        effectors,
    )  # fmt: skip
    problem = problem_for(DOMAIN, site(a_cell, (nail(1), paint), tacks=("nail-01",)))
    painting = [a for a in problem.actions if a.name == "apply-finish"]
    assert len(painting) == 1
    assert ("fastened", "c1") in painting[0].needs


def test_two_things_with_one_id_are_refused() -> None:
    with pytest.raises(BuildingModelError, match="'tools' names both"):
        problem_for(DOMAIN, site(operations=(nail(1, id=OperationId("tools")),), tacks=()))


def test_a_robot_whose_type_the_domain_lacks_is_refused_by_name() -> None:
    a_cell = cell([robot("both", RobotSubtype.ALL_ROUNDER, "g")], [gripper("g")])
    with pytest.raises(BuildingModelError, match="no type 'all-rounder', which 'both' is"):
        problem_for(built_in_domain(TYPED), site(a_cell, (), tacks=()))


def test_a_lost_goal_is_named_in_site_ids() -> None:
    view = site()
    reach = frozenset(p for p in view.geometry.can_reach if p[1] != "nail-03")
    problem = problem_for(DOMAIN, with_geometry(view, can_reach=reach))
    assert ("fastened", "nail-03") in lost_goals(problem, problem.init)
    assert not is_goal_reachable(problem, problem.init)


def test_an_action_that_leads_nowhere_is_marked_and_the_others_are_not() -> None:
    view = with_robot(site(), HANDLER, place="stock")
    view = with_geometry(view, can_set_down=frozenset())
    base = problem_for(DOMAIN, view)
    # As if the gripper could no longer place what it holds: only then is a grasp the end of it.
    stuck = problem_for(DOMAIN, with_geometry(view, can_place=frozenset()))
    notes = {o.call.skill: o.leads_nowhere for o in other_actions(base, base.init)}
    assert set(notes) == {"grasp", "retract"}
    assert not any(notes.values())
    assert "leads nowhere: " in other_actions(stuck, stuck.init)[0].leads_nowhere


def test_a_problem_from_a_later_state_has_that_state_as_its_start() -> None:
    problem = problem_for(DOMAIN, site())
    action = applicable(problem, problem.init)[0]
    later = with_state(problem, apply(action, problem.init))
    assert later.init == apply(action, problem.init)
    assert "(in-transit r1)" in later.text
    assert later.goal == problem.goal


def test_a_plan_line_that_is_no_action_is_refused() -> None:
    problem = problem_for(DOMAIN, site())
    with pytest.raises(BackendError, match=r"\(fly r1\)"):
        problem.actions_of(["(fly r1)"])


def test_calls_and_actions_are_turned_into_each_other() -> None:
    problem = problem_for(DOMAIN, site())
    assert all(problem.action(problem.call(a)) == a for a in problem.actions)
    assert problem.action(SkillCall("grasp", HANDLER, ("moon", "stock", "gripper-1"))) is None


def test_a_bare_flange_is_an_end_effector_that_a_tool_can_be_put_on() -> None:
    view = with_robot(site(), NAILER, mounted=None, place="tools")
    names = ("nail-gun-1", "screwdriver-1")
    docked = {EndEffectorId(e): StationId("tools") for e in names}
    problem = problem_for(DOMAIN, replace(view, docked=docked))
    calls = {problem.call(a) for a in applicable(problem, problem.init)}
    wanted = SkillCall("change-end-effector", NAILER, ("bare-nailer-1", "nail-gun-1", "tools"))
    assert wanted in calls
    assert is_goal_reachable(problem, problem.init)
