"""Fingerprint and approval: what was approved is what runs, to the last hashed number."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from builders_run import KEY, SmallPlanner, design, motion, place_rad
from sitewright.central_controller.approval import Approval, is_genuine, sealed
from sitewright.central_controller.codec import DecodeError, from_json, to_json
from sitewright.central_controller.events import (
    DeviationSeen,
    RunStarted,
    event_from_json,
    event_to_json,
)
from sitewright.central_controller.fingerprint import check_code, content, fingerprint
from sitewright.central_controller.ports import Planned, Scope, ScopeKind, SiteContext
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.foundation.canonical import Json, canonical_json
from sitewright.foundation.ids import BodyId, ComponentId, RobotId, RunId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.scene import Attachment
from sitewright.robot_team.driver import Observation, RobotObservation
from sitewright.robot_team.skill import SkillCall


def proposal() -> Proposal:
    robots = {
        RobotId(r): RobotObservation(q_rad=(0.0,), velocity_rad_s=(0.0,), mounted=None)
        for r in ("robot-a", "robot-b")
    }
    piece = ComponentId("piece-1")
    seen = Observation(time_s=0.0, robots=robots, world_T_piece={piece: Pose()})
    planned = SmallPlanner().propose(
        SiteContext(run=RunId("run-1"), site=design(), observation=seen)
    )
    assert isinstance(planned, Planned)
    return planned.proposal


def leaves(value: Json) -> list[Json]:
    if isinstance(value, dict):
        return [leaf for v in value.values() for leaf in leaves(v)]
    if isinstance(value, list):
        return [leaf for v in value for leaf in leaves(v)]
    return [value]


def test_only_integers_and_strings_are_hashed() -> None:
    assert {type(leaf) for leaf in leaves(content(proposal()))} == {int, str}


def test_the_check_code_is_the_first_forty_bits_in_crockford_letters() -> None:
    assert check_code("00" * 32) == "0000-0000"
    assert check_code("ff" * 32) == "ZZZZ-ZZZZ"
    assert check_code("08421" * 2 + "0" * 54) == "11111111"[:4] + "-" + check_code("08421" * 2)[5:]
    assert len(check_code(fingerprint(proposal()))) == 9


def test_a_proposal_read_back_from_its_file_has_the_same_fingerprint() -> None:
    import json

    first = proposal()
    text = canonical_json(to_json(first))
    again = from_json(Proposal, json.loads(text))
    assert fingerprint(again) == fingerprint(first)
    assert canonical_json(to_json(again)) == text
    assert again.steps[0].motions == first.steps[0].motions


def with_step(change: Callable[[ProposedStep], ProposedStep], number: int = 1) -> Proposal:
    whole = proposal()
    steps = tuple(change(s) if s.number == number else s for s in whole.steps)
    return replace(whole, steps=steps)


def with_motion(end_rad: float) -> Callable[[ProposedStep], ProposedStep]:
    changed = motion(RobotId("robot-a"), 0.0, end_rad)
    return lambda s: replace(s, motions=(changed,))


def with_edit(pose: Pose) -> Callable[[ProposedStep], ProposedStep]:
    edits = {BodyId("gun"): Attachment(RobotId("robot-a"), pose)}
    return lambda s: replace(s, motions=(replace(s.motions[0], scene_edits=edits),))


def with_certificate(**change: float | str) -> Callable[[ProposedStep], ProposedStep]:
    def changed(s: ProposedStep) -> ProposedStep:
        certificate = replace(s.motions[0].certificate, **change)  # type: ignore[arg-type]
        return replace(s, motions=(replace(s.motions[0], certificate=certificate),))

    return changed


CALL = SkillCall("reach", RobotId("robot-a"), ("piece-1",))
MUTANTS = {
    "run": replace(proposal(), run="run-2"),
    "target": replace(proposal(), target=ComponentId("stud-2")),
    "serial": replace(proposal(), site_serial=1),
    "context": replace(proposal(), context={**proposal().context, "cell": "d" * 64}),
    "dropped step": replace(proposal(), steps=proposal().steps[:-1]),
    "other order": replace(
        proposal(), steps=(proposal().steps[1], proposal().steps[0], *proposal().steps[2:])
    ),
    "skill": with_step(lambda s: replace(s, call=replace(CALL, skill="retract"))),
    "robot": with_step(lambda s: replace(s, call=replace(CALL, robot=RobotId("robot-b")))),
    "argument": with_step(lambda s: replace(s, call=replace(CALL, arguments=("piece-2",)))),
    "trajectory by 2 urad": with_step(with_motion(place_rad("piece-1") + 2e-6)),
    "scene edit by 2 um": with_step(with_edit(Pose((0.0, 0.0, 0.100002)))),
    "certificate": with_step(with_certificate(closest_distance_m=0.030)),
    "scene of the certificate": with_step(with_certificate(scene_revision="r2")),
    "effects": with_step(lambda s: replace(s, effects=("(at robot-a piece-2)",))),
    "relied on": with_step(lambda s: replace(s, relies_on=())),
    "duration": with_step(lambda s: replace(s, duration_s=1.1)),
    "param": with_step(lambda s: replace(s, params={**s.params, "width_m": 0.041}), 2),
    "param type": with_step(lambda s: replace(s, params={**s.params, "piece": None}), 2),
    "no param": with_step(lambda s: replace(s, params={}), 2),
}


@pytest.mark.parametrize("what", MUTANTS)
def test_a_changed_proposal_has_another_fingerprint(what: str) -> None:
    assert fingerprint(MUTANTS[what]) != fingerprint(proposal())


def test_all_mutants_differ_from_each_other() -> None:
    assert len({fingerprint(m) for m in MUTANTS.values()}) == len(MUTANTS)


def test_a_quaternion_and_its_negative_are_the_same_place() -> None:
    half = Pose((0.0, 0.0, 0.1), (0.0, 1.0, 0.0, 0.0))
    minus = Pose((0.0, 0.0, 0.1), (0.0, -1.0, 0.0, 0.0))
    assert fingerprint(with_step(with_edit(half))) == fingerprint(with_step(with_edit(minus)))


APPROVAL = Approval(
    approval_id="a",
    fingerprint="f" * 64,
    scope=Scope(ScopeKind.UNTIL, 3),
    who="operator",
    given_utc_ns=1,
    start_before_utc_ns=2,
    nonce="n",
    comment="looked at step 3",
)


@pytest.mark.parametrize(
    "change",
    [
        {"approval_id": "b"},
        {"fingerprint": "e" * 64},
        {"scope": Scope()},
        {"scope": Scope(ScopeKind.UNTIL, 4)},
        {"who": "somebody"},
        {"given_utc_ns": 5},
        {"start_before_utc_ns": 5},
        {"nonce": "m"},
        {"comment": ""},
        {"mac": "0" * 64},
    ],
)
def test_an_approval_that_was_changed_is_not_genuine(change: dict[str, object]) -> None:
    genuine = sealed(APPROVAL, KEY)
    assert is_genuine(genuine, KEY)
    assert not is_genuine(replace(genuine, **change), KEY)  # type: ignore[arg-type]
    assert not is_genuine(genuine, b"other")
    assert not is_genuine(APPROVAL, KEY)


@settings(deadline=None, max_examples=50)
@given(level=st.integers(0, 3), subject=st.text(max_size=20), what=st.text(max_size=40))
def test_an_event_comes_back_from_its_body_as_it_was(level: int, subject: str, what: str) -> None:
    event = DeviationSeen(level=level, subject=subject, what=what)
    assert event_from_json(event.kind, event.version, event_to_json(event)) == event


NEWER = RunStarted.version + 1


@pytest.mark.parametrize(
    ("kind", "version", "body"),
    [
        ("unheard_of", 1, {}),
        ("run_started", NEWER, {"run": "r", "project": "p", "hashes": {}}),
        ("run_started", 1, {"run": "r"}),
        ("run_started", 1, {"run": "r", "project": "p", "hashes": {}, "extra": 1}),
        ("run_started", 1, {"run": 3, "project": "p", "hashes": {}}),
        ("run_started", 1, {"run": "r", "project": "p", "hashes": []}),
        ("deviation_seen", 1, {"level": True, "subject": "s", "what": "w"}),
        ("question_answered", 1, {"question_id": "q", "answer": "perhaps", "who": "w"}),
        ("run_started", 1, []),
    ],
)
def test_a_body_that_does_not_fit_its_kind_is_refused(kind: str, version: int, body: Json) -> None:
    with pytest.raises(DecodeError):
        event_from_json(kind, version, body)


def test_an_older_body_without_newer_fields_is_still_read() -> None:
    event = event_from_json("run_started", 1, {"run": "r", "project": "p", "hashes": {}})
    assert event == RunStarted(run=RunId("r"), project="p", hashes={})
