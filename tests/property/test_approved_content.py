"""Whatever is changed of an approved plan in memory, its next step does not start."""

from __future__ import annotations

import random
from typing import Any

from builders_run import KEY, A, B, SmallPlanner, design
from sitewright.central_controller.approval import Approval, sealed
from sitewright.central_controller.codec import DecodeError, from_json, to_json
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import (
    ApprovalGiven,
    ProposalMade,
    RunStarted,
    StepSummary,
)
from sitewright.central_controller.fingerprint import fingerprint
from sitewright.central_controller.guard import Granted, may_start
from sitewright.central_controller.ports import Planned, Scope, SiteContext
from sitewright.central_controller.proposal import Proposal
from sitewright.foundation.ids import ComponentId, RunId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.driver import Observation, RobotObservation

CASES = 6_000
NOW_NS = 1_000
SEEN = Observation(
    time_s=0.0,
    robots={r: RobotObservation(q_rad=(0.0,), velocity_rad_s=(0.0,), mounted=None) for r in (A, B)},
    world_T_piece={ComponentId("piece-1"): Pose()},
)
REPORTED = {"eps_m", "evaluations", "closest_at", "timing_s"}
"""What a certificate tells of its making; it does not change what moves."""
SECOND_LOOK = ("agreement", "closest_distance_m")
"""What the second engine measured; that it agreed is hashed."""


def approved() -> tuple[Proposal, CycleState]:
    site = design(targets=1, operations=1)
    made = SmallPlanner().propose(SiteContext(run=RunId("run-1"), site=site, observation=SEEN))
    assert isinstance(made, Planned)
    proposal = made.proposal
    digest = fingerprint(proposal)
    steps = tuple(
        StepSummary(
            number=s.number,
            call=s.call,
            duration_s=s.duration_s,
            trajectories=len(s.motions),
            closest_distance_m=s.closest_distance_m,
        )
        for s in proposal.steps
    )
    approval = Approval(
        approval_id="a-1",
        fingerprint=digest,
        scope=Scope(),
        who="tester",
        given_utc_ns=0,
        start_before_utc_ns=10 * NOW_NS,
        nonce="n",
    )
    state = CycleState(site=site)
    for event in (
        RunStarted(run=RunId("run-1"), project="small", hashes={}),
        ProposalMade(
            fingerprint=digest, target=proposal.target, site_serial=site.serial, steps=steps
        ),
        ApprovalGiven(approval=sealed(approval, KEY)),
    ):
        state = folded(state, event)
    return proposal, state


def places(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Return the paths of all leaves of a document, and of all lists that could lose an entry."""
    if isinstance(value, dict):
        inner = [p for k, v in value.items() if k != "is" for p in places(v, (*path, k))]
        return [p for p in inner if not (REPORTED & set(p) or p[-2:] == SECOND_LOOK)]
    if isinstance(value, list):
        own = [path] if value else []
        return own + [p for n, v in enumerate(value) for p in places(v, (*path, n))]
    return [path]


def changed(value: Any, chance: random.Random) -> Any:
    match value:
        case bool():
            return not value
        case int():
            return value + chance.choice((-3, -1, 1, 2))
        case float():
            return value + chance.choice((-1, 1)) * 10.0 ** chance.uniform(-5, 1)
        case str():
            return value + chance.choice("xyz0") if value else "x"
        case list():
            n = chance.randrange(len(value))
            return [*value[:n], *value[n + 1 :]] if chance.random() < 0.5 else [*value, value[n]]
        case _:
            return "something"


def test_no_change_of_an_approved_plan_lets_its_step_start() -> None:
    proposal, state = approved()
    whole = may_start(proposal.steps[0], proposal, state, SEEN, key=KEY, now_utc_ns=NOW_NS)
    assert isinstance(whole, Granted)
    document, chance = to_json(proposal), random.Random(20_260)  # noqa: S311 -- repeats
    everywhere, tried = places(document), 0
    for case in range(CASES):
        path = everywhere[case % len(everywhere)]
        place: Any = document
        for key in path[:-1]:
            place = place[key]
        before = place[path[-1]]
        place[path[-1]] = changed(before, chance)
        try:
            mutant = from_json(Proposal, document)
            first = mutant.steps[0]
            answer = may_start(first, mutant, state, SEEN, key=KEY, now_utc_ns=NOW_NS)
        except (DecodeError, ValueError, TypeError, KeyError, IndexError):
            continue  # it is no plan any more
        finally:
            place[path[-1]] = before
        if mutant != proposal:
            tried += 1
            assert not isinstance(answer, Granted), path
    assert tried >= 5_000
