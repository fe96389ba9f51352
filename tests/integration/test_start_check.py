from __future__ import annotations

from dataclasses import replace

import pytest

from builders_planning import STUD, SUPPORT_1, SUPPORT_2, A, B, Rehearsal, with_piece_at
from sitewright.central_controller.ports import (
    Escalation,
    FactsChanged,
    NothingToDo,
    Planned,
    StillClear,
)
from sitewright.central_controller.rehearsal import after_step
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, translation
from sitewright.planning_twin.refusal import StaleCertificate
from sitewright.robot_team.skill import Skill, SkillCall

THIN = ComponentId("thin.5")


def test_the_same_motions_hold_on_the_same_site(frame: Rehearsal) -> None:
    context = frame.before[SUPPORT_1]
    for step in frame.planned[SUPPORT_1].proposal.steps[:3]:
        answer = frame.proposals.check(step, context)
        assert isinstance(answer, StillClear)
        for again, motion in zip(answer.certificates, step.motions, strict=True):
            assert again.path_sha256 == motion.certificate.path_sha256
            assert again.closest_distance_m == pytest.approx(
                motion.certificate.closest_distance_m, abs=1e-6
            )
        context = after_step(context, step, SUPPORT_1)


def test_sensor_noise_does_not_void_a_certificate(frame: Rehearsal) -> None:
    step, context = frame.steps(STUD, Skill.REACH)[0], frame.before[STUD]
    context = after_step(context, frame.planned[STUD].proposal.steps[0], STUD)
    noisy = context
    for piece, pose in context.observation.world_T_piece.items():
        noisy = with_piece_at(noisy, piece, translation(4e-4, -3e-4, 1e-4) @ pose)
    answer = frame.proposals.check(step, noisy)
    assert isinstance(answer, StillClear)
    assert answer.certificates[0].scene_revision != step.motions[0].certificate.scene_revision


@pytest.mark.parametrize(
    ("piece", "shift"),
    [
        ("thick.1", translation(0.0, 0.10, 0.14)),
        ("thick.2", translation(0.0, 0.05, 0.0)),
        ("thick.2", translation(0.0, 0.0, 0.2)),
    ],
)
def test_a_piece_that_was_moved_into_the_way_makes_the_certificate_stale(
    frame: Rehearsal, piece: str, shift: Pose
) -> None:
    """The fingers come down beside the upper piece: it or its neighbour is where they go."""
    step = frame.steps(SUPPORT_2, Skill.REACH)[0]
    context = after_step(frame.before[SUPPORT_2], frame.planned[SUPPORT_2].proposal.steps[0], STUD)
    pose = context.observation.world_T_piece[ComponentId(piece)]
    assert isinstance(frame.proposals.check(step, context), StillClear)
    answer = frame.proposals.check(step, with_piece_at(context, ComponentId(piece), shift @ pose))
    assert isinstance(answer, StaleCertificate)
    assert piece in answer.cause.pair


def test_a_piece_in_the_way_of_a_carry_makes_the_certificate_stale(frame: Rehearsal) -> None:
    context = frame.midway(SUPPORT_2, lambda s: s.call == SkillCall(Skill.RETRACT, B, ("ready-b",)))
    step = next(s for s in frame.steps(SUPPORT_2, Skill.REACH) if s.call.arguments == (SUPPORT_2,))
    assert isinstance(frame.proposals.check(step, context), StillClear)
    placed = frame.planned[SUPPORT_1].proposal.steps[2].call.arguments[0]
    pose = context.observation.world_T_piece[ComponentId(placed)]
    moved = with_piece_at(context, ComponentId(placed), translation(1.1, 0.0, 0.0) @ pose)
    answer = frame.proposals.check(step, moved)
    assert isinstance(answer, StaleCertificate)
    assert placed in answer.cause.pair


def test_a_piece_that_is_gone_changes_the_facts_of_its_grasp(frame: Rehearsal) -> None:
    context = frame.midway(STUD, lambda s: s.call.skill == Skill.REACH)
    (grasp,) = frame.steps(STUD, Skill.GRASP)
    assert isinstance(frame.proposals.check(grasp, context), StillClear)
    answer = frame.proposals.check(grasp, with_piece_at(context, THIN, None))
    assert isinstance(answer, FactsChanged)
    assert "(accessible thin.5)" in answer.facts


def test_a_piece_that_was_dropped_changes_the_facts_of_its_placement(frame: Rehearsal) -> None:
    context = frame.midway(STUD, lambda s: s.call.arguments == (STUD,))
    (position,) = frame.steps(STUD, Skill.POSITION)
    assert isinstance(frame.proposals.check(position, context), StillClear)
    seen = context.observation
    empty = replace(seen.robots[A], gripped=None)
    dropped = replace(seen, robots={**seen.robots, A: empty})
    answer = frame.proposals.check(position, replace(context, observation=dropped))
    assert isinstance(answer, FactsChanged)
    assert f"(holding {A} {THIN})" in answer.facts


def test_a_nail_that_is_missing_keeps_the_holder_from_letting_go(frame: Rehearsal) -> None:
    before_release = frame.midway(STUD, lambda s: s.call.arguments[0] == "stud-1.nail-2")
    (release,) = frame.steps(STUD, Skill.RELEASE)
    answer = frame.proposals.check(release, before_release)
    assert isinstance(answer, FactsChanged)
    assert "(fastened stud-1.nail-2)" in answer.facts


def test_other_ways_are_applicable_now_and_the_planned_one_costs_nothing(
    frame: Rehearsal,
) -> None:
    context = frame.midway(STUD, lambda s: s.call.skill == Skill.POSITION)
    planned = frame.proposals.propose(context)
    assert isinstance(planned, Planned)
    ways = {w.call: w for w in frame.proposals.alternatives(context)}
    first = planned.proposal.steps[0].call
    assert ways[first].price_s == pytest.approx(0.0)
    priced = [w.price_s for w in ways.values() if w.price_s is not None]
    assert priced == sorted(priced)
    assert min(priced) >= 0.0
    assert SkillCall(Skill.RELEASE, A, (STUD,)) not in ways
    assert SkillCall(Skill.RETRACT, A, (STUD,)) not in ways


def test_a_chosen_action_becomes_one_certified_step(frame: Rehearsal) -> None:
    context = frame.before[STUD]
    call = SkillCall(Skill.RETRACT, B, ("ready-b",))
    assert call in {w.call for w in frame.proposals.alternatives(context)}
    outcome = frame.proposals.propose_single(context, call)
    assert isinstance(outcome, Planned)
    (step,) = outcome.proposal.steps
    assert (step.number, step.call) == (1, call)
    assert f"(in-transit {B})" in step.effects
    assert isinstance(frame.proposals.check(step, context), StillClear)
    after = after_step(context, step, STUD)
    assert isinstance(frame.proposals.propose(after), Planned)


def test_each_other_way_is_planned_or_refused_with_a_reason(frame: Rehearsal) -> None:
    context = frame.midway(STUD, lambda s: s.call.skill == Skill.POSITION)
    for way in frame.proposals.alternatives(context):
        outcome = frame.proposals.propose_single(context, way.call)
        assert isinstance(outcome, Planned | Escalation)
        if isinstance(outcome, Planned):
            assert [s.call for s in outcome.proposal.steps] == [way.call]
        else:
            assert outcome.reason


@pytest.mark.parametrize(
    "call",
    [
        SkillCall(Skill.RELEASE, A, (STUD,)),
        SkillCall(Skill.GRASP, A, ("thin.1", "pallet-thin", "gripper-s")),
        SkillCall(Skill.FASTEN, B, ("stud-1.nail-1", STUD, "nail-gun")),
        SkillCall("dance", A, ()),
    ],
)
def test_what_cannot_be_done_now_is_no_proposal(frame: Rehearsal, call: SkillCall) -> None:
    assert isinstance(frame.proposals.propose_single(frame.before[STUD], call), NothingToDo)


def test_a_target_that_needs_rework_is_left_to_people(frame: Rehearsal) -> None:
    context = frame.before[SUPPORT_1]
    rework = replace(context, site=replace(context.site, needs_rework={SUPPORT_1: "half done"}))
    single = frame.proposals.propose_single(rework, SkillCall(Skill.RETRACT, A, ("ready-a",)))
    assert isinstance(single, Planned)
    assert single.proposal.target == SUPPORT_2
