from __future__ import annotations

from dataclasses import replace

import pytest

from builders_symbolic import STUD, four_nails, geometry, site, team, with_geometry
from sitewright.foundation.ids import ComponentId
from sitewright.symbolic_planning.planner import NoPlan, SkillSequence, SymbolicPlanner
from sitewright.symbolic_planning.planners.builtin import BuiltinPlanner
from sitewright.symbolic_planning.planners.fast_downward import FastDownward
from sitewright.symbolic_planning.problem import Problem, problem_for
from sitewright.symbolic_planning.site_view import Errand, RobotStatus, SiteView
from sitewright.symbolic_planning.vocabulary import built_in_domain

PIECE = ComponentId("piece-3")
FELL = "where-piece-3-lies"
PLANNERS = [BuiltinPlanner(), FastDownward()]


def errand_site(handlers: int = 1) -> SiteView:
    """The uppermost piece lies somewhere, in the way of the target, and is to go to the buffer."""
    view = site(team(handlers, 1), errand=Errand(piece=PIECE, place="buffer"))
    reach = {(r, FELL if p == "stock" else p) for r, p in view.geometry.can_reach}
    view = with_geometry(
        view,
        can_reach=frozenset(reach),
        can_place=frozenset(),
        reach_time_s=dict.fromkeys(reach, 3.0),
    )
    return replace(view, candidates=(), movable=(PIECE,), lies_at={PIECE: FELL})


def problem(view: SiteView) -> Problem:
    return problem_for(built_in_domain(), view)


@pytest.mark.parametrize("planner", PLANNERS, ids=lambda p: p.name)
def test_an_errand_brings_its_piece_to_the_buffer_and_leaves_the_target_alone(
    planner: SymbolicPlanner,
) -> None:
    plan = planner.plan(problem(errand_site()))
    assert isinstance(plan, SkillSequence)
    acts = [(c.skill, c.arguments) for c in plan.calls if c.skill not in ("reach", "retract")]
    assert acts == [("grasp", (PIECE, FELL, "gripper-1")), ("set-down", (PIECE, "buffer"))]
    robots = {c.robot for c in plan.calls}
    assert robots == {"handler-1"}
    assert plan.calls[-1].arguments == ("prep-handler-1",)


@pytest.mark.parametrize("planner", PLANNERS, ids=lambda p: p.name)
def test_an_errand_with_a_piece_in_hand_only_lays_it_down(planner: SymbolicPlanner) -> None:
    view = errand_site()
    robots = dict(view.robot_status)
    hand = next(r for r in robots if r.startswith("handler"))
    robots[hand] = RobotStatus(place=None, mounted=robots[hand].mounted, holding=PIECE)
    plan = planner.plan(problem(replace(view, robot_status=robots, lies_at={})))
    assert isinstance(plan, SkillSequence)
    assert [c.skill for c in plan.calls] == ["reach", "set-down", "retract", "reach"]


@pytest.mark.parametrize("planner", PLANNERS, ids=lambda p: p.name)
def test_an_errand_that_no_robot_can_do_is_proven_impossible(planner: SymbolicPlanner) -> None:
    view = with_geometry(errand_site(2), can_set_down=frozenset())
    no = planner.plan(problem(view))
    assert isinstance(no, NoPlan)
    assert no.is_proven


def test_an_errand_does_not_wait_for_a_target_that_is_not_ready_or_cannot_be_finished() -> None:
    wish = problem(errand_site())
    assert not {f[0] for f in wish.goal} & {"positioned", "standing", "fastened", "finished"}
    assert wish.impossible == ()
    target = problem(site(geometry=geometry(team(1, 1), four_nails())))
    assert ("positioned", target.name_by_site_id[STUD]) in target.goal
