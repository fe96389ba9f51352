"""Robots that are in the way where they wait are known before the first plan."""

from __future__ import annotations

from dataclasses import replace

from builders_planning import STUD, SUPPORT_1, SUPPORT_2, B, Rehearsal, with_cell
from sitewright.central_controller.ports import Planned
from sitewright.foundation.ids import ComponentId
from sitewright.robot_team.skill import Skill


def test_a_robot_that_waits_elsewhere_is_not_sent_away(frame: Rehearsal) -> None:
    """In the case study the nailer has to leave its station; from another home it need not."""
    context, cell = frame.before[SUPPORT_2], frame.proposals.design.cell
    nailer = cell.robot_by_id[B]
    away = replace(nailer, home_q_rad=nailer.parking_q_rad[0])
    there = replace(cell, robot_by_id={**cell.robot_by_id, B: away})
    seen = context.observation
    robots = {**seen.robots, B: replace(seen.robots[B], q_rad=away.home_q_rad)}
    outcome = with_cell(frame.proposals, there).propose(
        replace(context, observation=replace(seen, robots=robots))
    )
    assert isinstance(outcome, Planned)
    assert outcome.refusals == ()
    assert "(excludes " not in outcome.attachments["problem"]
    assert not any(s.call.robot == B for s in outcome.proposal.steps)
    assert "(excludes " in frame.planned[SUPPORT_2].attachments["problem"]
    leaves = [s.call for s in frame.steps(SUPPORT_2, Skill.RETRACT) if s.call.robot == B]
    assert [c.arguments for c in leaves] == [("ready-b",)]


def test_who_is_in_the_way_of_nothing_may_stay(frame: Rehearsal) -> None:
    """The only other exclusions are of fasteners that wait until the piece is let go of."""
    assert _exclusions(frame, SUPPORT_1) == []
    assert len(_exclusions(frame, STUD)) == 2
    assert all(line.endswith(" t1)") for line in _exclusions(frame, STUD))


def _exclusions(frame: Rehearsal, target: ComponentId) -> list[str]:
    problem = frame.planned[target].attachments["problem"]
    return [line for line in problem.splitlines() if "(excludes " in line]
