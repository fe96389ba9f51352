from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from builders_planning import STUD, A, B, Rehearsal, with_cell
from sitewright.central_controller.ports import Planned, SiteContext
from sitewright.central_controller.proposal import ProposedStep
from sitewright.central_controller.rehearsal import rehearsed
from sitewright.foundation.ids import RobotId
from sitewright.robot_team.skill import Skill, SkillCall

Until = Callable[[ProposedStep], bool]
ONCE = (Skill.GRASP, Skill.POSITION, Skill.RELEASE, Skill.FASTEN)


def calls(planned: Planned) -> list[SkillCall]:
    return [s.call for s in planned.proposal.steps]


def once(steps: list[SkillCall]) -> list[SkillCall]:
    """Calls that can be done only once for a target."""
    return [c for c in steps if c.skill in ONCE]


def after(skill: str, robot: RobotId, *arguments: str) -> Until:
    return lambda step: (
        step.call.skill == skill
        and step.call.robot == robot
        and step.call.arguments[: len(arguments)] == arguments
    )


STATES: dict[str, Until] = {
    "a robot stands in contact with the stock": after(Skill.REACH, A, "pallet-thin"),
    "the piece is in the gripper, still on its stack": after(Skill.GRASP, A),
    "the piece is in the gripper, lifted": after(Skill.RETRACT, A, "pallet-thin"),
    "the piece is in the gripper, at its target": after(Skill.REACH, A, STUD),
    "the piece is in place and steadied": after(Skill.POSITION, A),
    "the nailer stands on the first nail": after(Skill.REACH, B, "stud-1.nail-1"),
    "one nail is in": after(Skill.FASTEN, B, "stud-1.nail-1"),
    "the piece stands with two nails left": after(Skill.RELEASE, A),
    "one nail is left": after(Skill.FASTEN, B, "stud-1.nail-3"),
    "all nails are in, the robots are on their way home": after(Skill.FASTEN, B, "stud-1.nail-4"),
}


@pytest.mark.parametrize("state", STATES)
def test_a_plan_goes_on_from_midway_and_repeats_nothing(frame: Rehearsal, state: str) -> None:
    whole = once(calls(frame.planned[STUD]))
    context = frame.midway(STUD, STATES[state])
    outcome = frame.proposals.propose(context)
    assert isinstance(outcome, Planned)
    assert outcome.proposal.target == STUD
    rest = once(calls(outcome))
    assert set(rest) < set(whole) or state.startswith("a robot stands")
    steps = [s.call for s in frame.planned[STUD].proposal.steps]
    number = next(k for k, s in enumerate(frame.planned[STUD].proposal.steps) if STATES[state](s))
    done = once(steps[: number + 1])
    assert sorted(str(c) for c in (*done, *rest)) == sorted(str(c) for c in whole)
    assert_starts_where_robots_are(outcome, context)
    assert rehearsed(context, outcome.proposal).site.is_secured(STUD)


def assert_starts_where_robots_are(planned: Planned, context: SiteContext) -> None:
    at = {r: s.q_rad for r, s in context.observation.robots.items()}
    for step in planned.proposal.steps:
        for motion in step.motions:
            assert motion.timed.path.start_rad == pytest.approx(at[step.call.robot], abs=1e-9)
            at[step.call.robot] = motion.timed.path.end_rad


@pytest.mark.parametrize(
    ("state", "robot"),
    [
        ("a robot stands in contact with the stock", A),
        ("the piece is in the gripper, still on its stack", A),
        ("the piece is in the gripper, at its target", A),
        ("the nailer stands on the first nail", B),
        ("one nail is in", B),
    ],
)
def test_a_robot_that_was_stopped_in_contact_first_goes_straight_out_of_it(
    frame: Rehearsal, state: str, robot: RobotId
) -> None:
    """Its place is unknown then: the motion that ended there did not end well."""
    context = frame.midway(STUD, STATES[state])
    places = {r: p for r, p in context.site.place_by_robot.items() if r != robot}
    stopped = replace(context, site=replace(context.site, place_by_robot=places))
    outcome = frame.proposals.propose(stopped)
    assert isinstance(outcome, Planned)
    first = next(s for s in outcome.proposal.steps if s.call.robot == robot and s.motions)
    assert first.call.skill == Skill.REACH
    assert first.motions[0].timed.path.start_rad == context.observation.robots[robot].q_rad
    assert rehearsed(stopped, outcome.proposal).site.is_secured(STUD)


def test_a_steadied_piece_is_not_let_go_while_its_nails_cannot_be_driven(
    frame: Rehearsal,
) -> None:
    """Without a nailer nothing may be released, whatever else could be done."""
    context = frame.midway(STUD, STATES["the piece is in place and steadied"])
    gun = frame.proposals.design.cell.robot_by_id[B]
    lame = replace(gun, end_effectors=(), mounted=None)
    cell = frame.proposals.design.cell
    changed = replace(cell, robot_by_id={**cell.robot_by_id, B: lame})
    seen = context.observation
    bare = replace(seen.robots[B], mounted=None)
    unarmed = replace(context, observation=replace(seen, robots={**seen.robots, B: bare}))
    proposals = with_cell(frame.proposals, changed)
    assert not isinstance(proposals.propose(unarmed), Planned)
    ways = proposals.alternatives(unarmed)
    assert all(w.call.skill != Skill.RELEASE for w in ways)
