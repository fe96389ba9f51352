from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest

from builders_planning import STUD, SUPPORT_2, A, B, Rehearsal
from sitewright.central_controller.blame import IsSolvable, reason_for, to_blame
from sitewright.central_controller.fingerprint import fingerprint
from sitewright.central_controller.ports import Planned
from sitewright.central_controller.situation import jobsite_of
from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.pose import translation
from sitewright.planning_twin import study
from sitewright.planning_twin.feedback import Lessons
from sitewright.planning_twin.jobsite import Jobsite
from sitewright.planning_twin.refusal import (
    BlockedBy,
    Disagreement,
    NoIk,
    NoPath,
    NotClear,
    PayloadExceeded,
    Refusal,
)
from sitewright.planning_twin.scope import scope_of
from sitewright.planning_twin.sequence import SequenceRefusal
from sitewright.planning_twin.skill_motions.stage import SkillRefusal
from sitewright.planning_twin.wording import in_words, is_proof
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.nogood import Change, Nogood
from sitewright.symbolic_planning.site_view import GeometricFacts

PIECE, STOCK = ComponentId("thin.5"), "pallet-thin"
NO_PATH = NoPath(nodes=500, seeds=(0,))
NOT_CLEAR = NotClear(
    pair=("stud", "table"), q_rad=(0.0,) * 6, distance_m=0.004, threshold_m=0.01, segment=0
)
PLAN = (
    SkillCall(Skill.REACH, A, (STOCK,)),
    SkillCall(Skill.GRASP, A, (PIECE, STOCK, "gripper-s")),
    SkillCall(Skill.RETRACT, A, (STOCK,)),
    SkillCall(Skill.REACH, A, (STUD,)),
    SkillCall(Skill.POSITION, A, (PIECE, STUD)),
)


@pytest.fixture(scope="module")
def site(frame: Rehearsal) -> Jobsite:
    proposals = frame.proposals
    kinematics = proposals.ports.backends.kinematics
    return jobsite_of(proposals.design, proposals.shapes, frame.before[STUD], kinematics)


def lessons() -> Lessons:
    facts = GeometricFacts(
        can_reach=frozenset({(A, STOCK), (A, STUD), (B, "nail")}),
        can_grasp=frozenset({(A, "gripper-s", PIECE)}),  # type: ignore[arg-type]
        can_place=frozenset({(A, PIECE, STUD)}),
        reach_time_s={(A, STOCK): 3.0, (A, STUD): 3.0},
    )
    return Lessons(base=facts, nogoods=[])


def refused(
    site: Jobsite,
    number: int,
    refusal: Refusal,
    *,
    by: RobotId | None = None,
    at: str | None = None,
) -> SequenceRefusal:
    call = PLAN[number]
    return SequenceRefusal(
        number=number,
        call=call,
        cause=SkillRefusal(call=call, refusal=refusal),
        site=site,
        place_by_robot={A: STOCK if number else None, B: at},
        blocking_robot=by,
    )


def test_a_blocked_carry_takes_away_the_placement_and_says_why(site: Jobsite) -> None:
    taught = lessons()
    blocked = BlockedBy(pairs=(("support", "thin.5"),))
    assert taught.learn(refused(site, 3, blocked), PLAN)
    assert taught.facts.can_place == frozenset()
    assert taught.facts.can_grasp
    assert taught.nogoods[0].evidence.startswith(f"{A} cannot place {PIECE} at {STUD}: ")
    assert not taught.nogoods[0].is_proven


def test_a_blocked_pick_takes_away_the_grasp(site: Jobsite) -> None:
    taught = lessons()
    taught.learn(refused(site, 0, BlockedBy(pairs=(("gripper-s", "table"),))), PLAN)
    assert taught.facts.can_grasp == frozenset()


def test_a_piece_that_cannot_be_lifted_is_not_grasped_this_way(site: Jobsite) -> None:
    taught = lessons()
    held = replace(site, arms={**site.arms, A: replace(site.arms[A], held=PIECE)})
    taught.learn(refused(held, 2, BlockedBy(pairs=((PIECE, "table"),))), PLAN)
    assert taught.facts.can_grasp == frozenset()


def test_a_robot_in_the_way_at_a_place_excludes_both_ways(site: Jobsite) -> None:
    taught = lessons()
    blocked = BlockedBy(pairs=(("kr120-a/link_4", "nail-gun"),))
    assert taught.learn(refused(site, 3, blocked, by=B, at="ready-b"), PLAN)
    assert taught.facts.excludes == {(A, STUD, "ready-b"), (B, "ready-b", STUD)}
    assert taught.facts.can_place


def test_the_same_refusal_in_the_same_scope_ends_the_search(site: Jobsite) -> None:
    taught = lessons()
    again = refused(site, 3, BlockedBy(pairs=(("kr120-a/link_4", "nail-gun"),)), by=B, at="ready-b")
    assert taught.learn(again, PLAN)
    assert not taught.learn(again, PLAN)


def test_a_search_without_a_path_is_dearer_with_a_new_seed_then_gone(site: Jobsite) -> None:
    taught = lessons()
    assert taught.learn(refused(site, 0, NO_PATH), PLAN)
    assert (taught.new_seeds, taught.facts.can_grasp) == (1, taught.base.can_grasp)
    assert taught.facts.reach_time_s[A, STOCK] == pytest.approx(12.0)
    assert taught.learn(refused(site, 0, NO_PATH), PLAN)
    assert taught.facts.can_grasp == frozenset()
    assert not any(n.is_proven for n in taught.nogoods)


@pytest.mark.parametrize(
    "refusal",
    [NOT_CLEAR, Disagreement(pair=("a", "b"), q_rad=(), distance_m=0.0, threshold_m=0.01)],
)
def test_a_motion_that_could_not_be_certified_is_tried_again_but_not_for_ever(
    site: Jobsite, refusal: Refusal
) -> None:
    taught = lessons()
    rounds = 0
    while taught.learn(refused(site, 0, refusal), PLAN):
        rounds += 1
        assert rounds < 10
    assert taught.new_seeds >= 1
    assert taught.facts.can_grasp == frozenset()


def test_a_proof_stays_a_proof(site: Jobsite) -> None:
    taught = lessons()
    taught.learn(refused(site, 0, NoIk(is_proven=True, extension_m=0.038)), PLAN)
    (nogood,) = taught.nogoods
    assert nogood.is_proven
    assert "38 mm" in nogood.evidence


def test_a_refusal_is_void_once_what_was_in_the_way_has_moved(site: Jobsite) -> None:
    about = (Skill.REACH, STUD)
    blocker = ComponentId("thin.4")
    here = scope_of(site, A, about, (blocker, "kr120-b/link_4"))
    assert scope_of(site, A, about, ("kr120-b/link_4", blocker)) == here
    pose = translation(0.0, 0.01, 0.0) @ site.world_T_piece[blocker]
    moved = replace(site, world_T_piece={**site.world_T_piece, blocker: pose})
    assert scope_of(moved, A, about, (blocker, "kr120-b/link_4")) != here
    turned = replace(site.arms[B], q_rad=(0.5, *site.arms[B].q_rad[1:]))
    elsewhere = replace(site, arms={**site.arms, B: turned})
    assert scope_of(elsewhere, A, about, (blocker, "kr120-b/link_4")) != here
    assert scope_of(elsewhere, A, about, (blocker,)) == scope_of(site, A, about, (blocker,))


def test_a_refused_piece_is_void_once_the_piece_has_moved(site: Jobsite) -> None:
    about = ("can-grasp", A, "gripper-s", PIECE)
    pose = translation(0.0, 0.0, 0.05) @ site.world_T_piece[PIECE]
    moved = replace(site, world_T_piece={**site.world_T_piece, PIECE: pose})
    assert scope_of(moved, A, about) != scope_of(site, A, about)


@pytest.mark.parametrize(
    ("refusal", "words", "proof"),
    [
        (NoIk(is_proven=True, extension_m=0.038), "out of reach by 38 mm (proven)", True),
        (NoIk(is_proven=False, reason="no branch"), "(not proven): no branch", False),
        (PayloadExceeded(mass_kg=150.0, payload_kg=120.0), "the arm carries 120 kg", True),
        (BlockedBy(pairs=(("a", "b"), ("c", "d"))), "a and b, c and d", False),
        (NOT_CLEAR, "stud and table come to 4.0 mm, allowed 10.0 mm", False),
        (NO_PATH, "within 500 nodes", False),
    ],
)
def test_a_refusal_has_words_with_figures(refusal: Refusal, words: str, *, proof: bool) -> None:
    assert words in in_words(refusal)
    assert is_proof(refusal) is proof


def nogood(predicate: str, *arguments: str) -> Nogood:
    return Nogood(
        fact=(predicate, *arguments),
        change=Change.REMOVED,
        is_proven=True,
        evidence=f"no {predicate} {arguments[-1]}",
        scope="",
    )


NOGOODS = (
    nogood("can-reach", B, "nail-3"),
    nogood("can-grasp", A, "gripper-s", PIECE),
    nogood("excludes", A, STUD, "ready-b"),
)


def blamed(is_solvable: IsSolvable) -> str:
    return reason_for(STUD, "No plan.", to_blame(NOGOODS, is_solvable))


def test_the_reason_names_only_what_is_to_blame_and_what_would_help() -> None:
    def is_solvable(some: Sequence[Nogood]) -> bool:
        return NOGOODS[0] not in some

    text = blamed(is_solvable)
    assert text.startswith(f"{STUD}: no can-reach nail-3. This might help: move {B}'s base")
    assert PIECE not in text


def test_the_reason_names_alternatives_as_such_and_sets_as_such() -> None:
    either = blamed(lambda some: len(some) < len(NOGOODS))
    assert "Any one of these might help: " in either
    both = blamed(lambda some: not {NOGOODS[0], NOGOODS[1]} & set(some))
    assert "All of these may be needed: " in both
    assert "ready-b" not in both


def test_where_no_refusal_is_to_blame_the_symbolic_planner_speaks() -> None:
    assert blamed(lambda _some: False) == f"{STUD}: No plan."


def test_what_is_known_of_waiting_robots_is_what_refusals_would_teach(
    frame: Rehearsal, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(study, "in_the_way_where_they_wait", lambda _context, _holdings: ())
    taught = frame.proposals.propose(frame.before[SUPPORT_2])
    assert isinstance(taught, Planned)
    (note,) = taught.refusals
    assert note.reason.startswith(f"{A} cannot place thick.2 at {SUPPORT_2}: every posture")
    assert BodyId("nail-gun") in note.reason
    assert fingerprint(taught.proposal) == fingerprint(frame.planned[SUPPORT_2].proposal)
