from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest

from builders_symbolic import STUD, site
from sitewright.errors import BackendError
from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId
from sitewright.robot_team.skill import SkillCall
from sitewright.symbolic_planning.nogood import (
    SLOWER_FACTOR,
    Change,
    Nogood,
    RefusedCall,
    is_known,
    minimal_reason,
    nogoods_of,
    purpose,
    scope_hash,
    still_valid,
    with_nogoods,
)

A, B = RobotId("handler-1"), RobotId("nailer-1")
PIECE = ComponentId("piece-3")


def refused(kind: str, skill: str = "grasp", place: str = "stock") -> RefusedCall:
    return RefusedCall(
        kind=kind,
        skill=skill,
        robot=A,
        place=place,
        end_effector=EndEffectorId("gripper-1"),
        piece=PIECE,
        evidence="tried 96 grasps",
        scope="abc",
    )


@pytest.mark.parametrize(
    ("skill", "place", "fact"),
    [
        ("grasp", "stock", ("can-grasp", A, "gripper-1", PIECE)),
        ("position", STUD, ("can-place", A, PIECE, STUD)),
        ("set-down", "buffer", ("can-set-down", A, PIECE, "buffer")),
        ("reach", "stock", ("can-reach", A, "stock")),
        ("fasten", "nail-01", ("can-reach", A, "nail-01")),
    ],
)
@pytest.mark.parametrize("kind", ["NoIk", "BlockedBy"])
def test_a_proven_no_takes_away_the_fact_that_the_call_relies_on(
    kind: str, skill: str, place: str, fact: tuple[str, ...]
) -> None:
    (nogood,) = nogoods_of(refused(kind, skill, place))
    assert nogood.fact == fact
    assert nogood.change is Change.REMOVED
    assert nogood.is_proven
    assert nogood.evidence == "tried 96 grasps"


@pytest.mark.parametrize("kind", ["NoGrasp", "PayloadExceeded"])
def test_what_no_grasp_can_carry_is_not_grasped_whatever_the_motion_was(kind: str) -> None:
    (nogood,) = nogoods_of(refused(kind, "position", STUD))
    assert nogood.fact == ("can-grasp", A, "gripper-1", PIECE)


def test_a_robot_in_the_way_excludes_both_ways() -> None:
    call = replace(refused("BlockedBy", "fasten", "nail-03"), robot=B, blocking_robot=A)
    nogoods = nogoods_of(replace(call, blocking_place=STUD))
    assert [n.fact for n in nogoods] == [
        ("excludes", B, "nail-03", STUD),
        ("excludes", A, STUD, "nail-03"),
    ]
    facts = with_nogoods(site().geometry, nogoods)
    assert {(B, "nail-03", STUD), (A, STUD, "nail-03")} <= facts.excludes


def test_a_robot_in_the_way_that_is_at_no_place_only_makes_the_reach_dearer() -> None:
    (nogood,) = nogoods_of(replace(refused("BlockedBy"), blocking_robot=B))
    assert nogood.change is Change.SLOWER


@pytest.mark.parametrize("kind", ["NoPath", "NoIk"])
def test_a_spent_budget_is_dearer_first_and_gone_the_second_time_but_never_proven(
    kind: str,
) -> None:
    call = replace(refused(kind), is_proven=False)
    (first,) = nogoods_of(call)
    (second,) = nogoods_of(replace(call, attempt=2))
    assert (first.change, second.change) == (Change.SLOWER, Change.REMOVED)
    assert not first.is_proven
    assert not second.is_proven
    before = site().geometry
    after = with_nogoods(before, [first])
    key = (A, "stock")
    assert after.reach_time_s[key] == pytest.approx(SLOWER_FACTOR * before.reach_time_s[key])
    assert with_nogoods(before, [second]).can_grasp == frozenset()


@pytest.mark.parametrize("kind", ["Disagreement", "WorkerFailed"])
def test_an_engine_that_stumbles_gets_another_seed_before_anything_is_learned(kind: str) -> None:
    changes = [[n.change for n in nogoods_of(replace(refused(kind), attempt=k))] for k in (1, 2, 3)]
    assert changes == [[], [Change.SLOWER], [Change.REMOVED]]


@pytest.mark.parametrize("kind", ["NotClear", "StaleCertificate"])
def test_a_motion_that_is_only_to_be_planned_again_teaches_nothing(kind: str) -> None:
    assert nogoods_of(refused(kind)) == ()


def test_an_unknown_refusal_is_an_error() -> None:
    with pytest.raises(BackendError, match="'Tired'"):
        nogoods_of(refused("Tired"))


def test_a_changed_scope_voids_a_nogood() -> None:
    here = scope_hash({"robot": "a", "blockers": [[0.0, 1.0]]})
    moved = scope_hash({"robot": "a", "blockers": [[0.0, 1.1]]})
    (nogood,) = nogoods_of(replace(refused("BlockedBy"), scope=here))
    assert still_valid([nogood], lambda _: here) == (nogood,)
    assert still_valid([nogood], lambda _: moved) == ()
    assert is_known([nogood], nogood.fact, here)
    assert not is_known([nogood], nogood.fact, moved)


def test_a_dearer_reach_may_be_tried_again_in_the_same_scope() -> None:
    (nogood,) = nogoods_of(replace(refused("NoPath"), is_proven=False))
    assert not is_known([nogood], nogood.fact, "abc")


def test_a_reach_serves_the_act_that_follows_it_on_the_same_robot() -> None:
    calls = [
        SkillCall("reach", A, ("stock",)),
        SkillCall("retract", B, ("prep-nailer-1",)),
        SkillCall("grasp", A, (PIECE, "stock", "gripper-1")),
        SkillCall("retract", A, ("stock",)),
        SkillCall("reach", A, ("prep-handler-1",)),
    ]
    assert purpose(calls, 0) == calls[2]
    assert purpose(calls, 3) == calls[3]
    assert purpose(calls, 4) == calls[4]


def _nogoods(count: int) -> list[Nogood]:
    return [
        replace(nogoods_of(refused("NoIk"))[0], fact=("can-reach", A, f"p{k}"))
        for k in range(count)
    ]


def test_each_nogood_that_alone_suffices_is_listed() -> None:
    nogoods = _nogoods(4)

    def is_solvable(standing: Sequence[Nogood]) -> bool:
        return nogoods[1] not in standing or nogoods[3] not in standing

    reason = minimal_reason(nogoods, is_solvable)
    assert reason.alone == (nogoods[1], nogoods[3])
    assert reason.together == ()


def test_where_none_suffices_alone_a_minimal_set_is_found() -> None:
    nogoods = _nogoods(5)

    def is_solvable(standing: Sequence[Nogood]) -> bool:
        return nogoods[0] not in standing and nogoods[2] not in standing

    reason = minimal_reason(nogoods, is_solvable)
    assert reason.alone == ()
    assert reason.together == (nogoods[0], nogoods[2])


def test_where_nothing_learned_is_to_blame_nothing_is_named() -> None:
    reason = minimal_reason(_nogoods(2), lambda _: False)
    assert (reason.alone, reason.together) == ((), ())
