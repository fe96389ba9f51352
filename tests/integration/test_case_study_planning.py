from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest

from builders_planning import (
    STUD,
    SUPPORT_1,
    SUPPORT_2,
    A,
    B,
    Rehearsal,
    with_cell,
    with_component,
    with_operation,
    with_piece_at,
)
from sitewright.central_controller.fingerprint import fingerprint
from sitewright.central_controller.ports import Escalation, Planned
from sitewright.central_controller.situation import spot_of
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import translation
from sitewright.robot_team.skill import Skill, SkillCall

NEAR = ("stud-1.nail-1", "stud-1.nail-2")
FAR = ("stud-1.nail-3", "stud-1.nail-4")


def numbers(frame: Rehearsal, target: ComponentId, skill: str) -> dict[tuple[str, ...], int]:
    return {s.call.arguments: s.number for s in frame.steps(target, skill)}


def test_near_nails_are_driven_while_the_stud_is_held_and_far_ones_after_it_stands(
    frame: Rehearsal,
) -> None:
    (release,) = numbers(frame, STUD, Skill.RELEASE).values()
    driven = {call[0]: n for call, n in numbers(frame, STUD, Skill.FASTEN).items()}
    assert set(driven) == {*NEAR, *FAR}
    assert all(driven[nail] < release for nail in NEAR)
    assert all(driven[nail] > release for nail in FAR)


def test_every_motion_of_the_plan_is_certified_and_joins_the_one_before(frame: Rehearsal) -> None:
    for target, planned in frame.planned.items():
        at = {r: s.q_rad for r, s in frame.before[target].observation.robots.items()}
        for step in planned.proposal.steps:
            for motion in step.motions:
                assert motion.timed.path.start_rad == pytest.approx(at[step.call.robot], abs=1e-9)
                assert motion.certificate.closest_distance_m >= 0.010
                assert motion.certificate.path_sha256 == motion.timed.path.sha256()
                assert motion.agreement.samples > 0
                at[step.call.robot] = motion.timed.path.end_rad


def test_a_planned_trajectory_does_not_jump_between_its_pieces(frame: Rehearsal) -> None:
    for step in frame.planned[SUPPORT_1].proposal.steps:
        for motion in step.motions:
            trajectory = motion.timed.trajectory
            for time_s in trajectory.times_s:
                before, after = trajectory.at(time_s - 1e-7), trajectory.at(time_s + 1e-7)
                assert before[0] == pytest.approx(after[0], abs=1e-5)
                assert before[1] == pytest.approx(after[1], abs=1e-4)
            assert all(a < b for a, b in pairwise(trajectory.times_s))


def test_the_second_support_makes_the_nailer_leave_its_home_first(frame: Rehearsal) -> None:
    """Its tool is in the way there: known before the first plan, so that nothing is refused."""
    planned = frame.planned[SUPPORT_2]
    assert planned.refusals == ()
    assert "(excludes " not in frame.planned[SUPPORT_1].attachments["problem"]
    assert "(excludes " in planned.attachments["problem"]
    calls = [s.call for s in planned.proposal.steps]
    leaves = calls.index(SkillCall(Skill.RETRACT, B, ("ready-b",)))
    comes = calls.index(SkillCall(Skill.REACH, A, (SUPPORT_2,)))
    back = calls.index(SkillCall(Skill.REACH, B, ("ready-b",)))
    assert leaves < comes < back


def test_only_the_top_of_a_stack_is_ever_offered(frame: Rehearsal) -> None:
    taken = [frame.steps(t, Skill.GRASP)[0].call.arguments[0] for t in frame.planned]
    assert taken == ["thick.3", "thick.2", "thin.5"]
    problem = frame.planned[STUD].attachments["problem"]
    assert not any(f"thin.{n}" in problem for n in (1, 2, 3, 4))


def test_the_same_site_and_seed_give_the_same_fingerprint(frame: Rehearsal) -> None:
    again = frame.proposals.propose(frame.before[SUPPORT_2])
    assert isinstance(again, Planned)
    assert fingerprint(again.proposal) == fingerprint(frame.planned[SUPPORT_2].proposal)


def test_a_far_nail_that_must_be_driven_while_held_is_refused_with_its_name(
    frame: Rehearsal,
) -> None:
    stud = frame.proposals.design.component(STUD)
    forced = with_component(frame.proposals, with_operation(stud, FAR[0], needs_hold=True))
    outcome = forced.propose(frame.before[STUD])
    assert isinstance(outcome, Escalation)
    assert outcome.target == STUD
    assert outcome.is_proven, "the holder's own arm is in the way however it holds the stud"
    assert f"{FAR[0]} must be driven while" in outcome.reason
    assert f"since {A}, which holds it, is in the way of {FAR[0]}" in outcome.reason
    assert {r.kind for r in outcome.refusals} == {"NoGrasp"}


def test_a_near_nail_that_must_be_driven_while_held_changes_nothing_but_its_order(
    frame: Rehearsal,
) -> None:
    stud = replace(frame.proposals.design.component(STUD), hold_until_fasteners=0)
    forced = with_component(frame.proposals, with_operation(stud, NEAR[1], needs_hold=True))
    outcome = forced.propose(frame.before[STUD])
    assert isinstance(outcome, Planned)
    calls = [s.call for s in outcome.proposal.steps]
    released = calls.index(SkillCall(Skill.RELEASE, A, (STUD,)))
    before = [c.arguments[0] for c in calls[:released] if c.skill == Skill.FASTEN]
    assert NEAR[1] in before


def test_a_target_out_of_reach_is_refused_with_proof_and_by_how_much(frame: Rehearsal) -> None:
    support = frame.proposals.design.component(SUPPORT_1)
    away = replace(
        support, world_T_component=translation(8.0, 0.0, 0.0) @ support.world_T_component
    )
    outcome = with_component(frame.proposals, away).propose(frame.before[SUPPORT_1])
    assert isinstance(outcome, Escalation)
    assert outcome.is_proven
    assert outcome.exit_code == 4
    assert "out of reach" in outcome.reason


def test_a_nail_out_of_reach_is_refused_with_proof_and_named(frame: Rehearsal) -> None:
    stud = frame.proposals.design.component(STUD)
    pose = translation(-4.0, 0.0, 0.0) @ stud.operations[2].component_T_operation
    away = with_component(frame.proposals, with_operation(stud, FAR[0], component_T_operation=pose))
    outcome = away.propose(frame.before[STUD])
    assert isinstance(outcome, Escalation)
    assert outcome.is_proven
    assert FAR[0] in outcome.reason
    assert "out of reach" in outcome.reason
    assert FAR[1] not in outcome.reason


def test_a_piece_that_is_too_heavy_is_refused_with_both_figures(frame: Rehearsal) -> None:
    proposals = frame.proposals
    heavy = {i: replace(s, mass_kg=150.0) for i, s in proposals.shapes.items()}
    outcome = replace(proposals, shapes=heavy).propose(frame.before[SUPPORT_1])
    assert isinstance(outcome, Escalation)
    assert outcome.is_proven
    assert {r.kind for r in outcome.refusals} == {"PayloadExceeded"}
    assert "the arm carries 120 kg" in outcome.reason


def test_a_wide_piece_that_fits_no_gripper_is_refused_with_proof(frame: Rehearsal) -> None:
    cell = frame.proposals.design.cell
    gripper = next(e for e in cell.end_effector_by_id.values() if e.grips_m is not None)
    narrow = replace(gripper, grips_m=(0.001, 0.002))
    changed = replace(cell, end_effector_by_id={**cell.end_effector_by_id, narrow.id: narrow})
    outcome = with_cell(frame.proposals, changed).propose(frame.before[SUPPORT_1])
    assert isinstance(outcome, Escalation)
    assert outcome.is_proven
    assert "between the gripper's fingers" in outcome.reason


def test_a_piece_that_nobody_sees_is_not_offered(frame: Rehearsal) -> None:
    gone = with_piece_at(frame.before[SUPPORT_1], ComponentId("thick.3"), None)
    outcome = frame.proposals.propose(gone)
    assert isinstance(outcome, Planned)
    (grasp,) = [s for s in outcome.proposal.steps if s.call.skill == Skill.GRASP]
    assert grasp.call.arguments[0] == "thick.2"


def test_a_nail_through_what_stands_is_shot_from_there_into_the_target(frame: Rehearsal) -> None:
    design, context = frame.proposals.design, frame.before[STUD]
    nail = design.component(STUD).operations[0]
    turned = replace(nail, on=nail.on[::-1])
    spots = [spot_of(context, STUD, o, design.world_T_target(STUD)) for o in (nail, turned)]
    stud = ComponentId("some stud")
    support = context.site.placed[SUPPORT_2].piece
    assert [(s.body(stud), s.receiver(stud)) for s in spots] == [(stud, support), (support, stud)]
