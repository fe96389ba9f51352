"""Refusals of earlier plans are used again, and are void once what they depend on has changed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import pytest
from typing_extensions import override

from builders_planning import (
    STUD,
    SUPPORT_1,
    Rehearsal,
    case_study_start,
    with_cell,
    with_component,
    with_operation,
    with_piece_at,
)
from sitewright.central_controller.fingerprint import fingerprint
from sitewright.central_controller.ports import Escalation, Planned
from sitewright.central_controller.proposing import Proposals
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import rotation, translation
from sitewright.planning_twin.kept_refusals import KeptRefusals
from sitewright.planning_twin.motion import CollisionCheck
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.robot_team.cell import StationKind
from sitewright.robot_team.description import Joints

FAR, FALLEN = "stud-1.nail-3", ComponentId("thick.3")


@dataclass
class Counted(CollisionCheck):
    """A collision check that counts how often it is asked."""

    engine: CollisionCheck
    asked: int = 0

    @override
    def is_clear(
        self,
        scene: SceneSnapshot,
        robot: RobotId,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
        *,
        is_padded: bool = False,
    ) -> bool:
        self.asked += 1
        return self.engine.is_clear(scene, robot, q_rad, threshold_m, is_padded=is_padded)

    @override
    def violations(
        self,
        scene: SceneSnapshot,
        robot: RobotId,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
        *,
        is_padded: bool = False,
    ) -> tuple[Pair, ...]:
        self.asked += 1
        return self.engine.violations(scene, robot, q_rad, threshold_m, is_padded=is_padded)


def counting(proposals: Proposals) -> tuple[Proposals, Counted]:
    """Return the planner with a memory of its own and a collision check that counts."""
    ports = proposals.ports
    counted = Counted(ports.backends.collision)
    backends = replace(ports.backends, collision=counted)
    changed = replace(ports, backends=backends, kept=KeptRefusals())
    return replace(proposals, ports=changed), counted


def test_what_was_refused_is_not_searched_again_while_nothing_relevant_changes(
    frame: Rehearsal,
) -> None:
    stud = frame.proposals.design.component(STUD)
    forced = with_component(frame.proposals, with_operation(stud, FAR, needs_hold=True))
    planner, counted = counting(forced)
    first = planner.propose(frame.before[STUD])
    searched, counted.asked = counted.asked, 0
    again = planner.propose(frame.before[STUD])
    assert isinstance(first, Escalation)
    assert isinstance(again, Escalation)
    assert (again.reason, again.refusals) == (first.reason, first.refusals)
    assert searched > 100
    assert counted.asked < searched / 4
    assert planner.ports.kept.reused == 2, "here, and on the copy that lets go of it earlier"


def test_a_refusal_is_void_for_another_design_of_the_same_target(frame: Rehearsal) -> None:
    stud = frame.proposals.design.component(STUD)
    forced = with_component(frame.proposals, with_operation(stud, FAR, needs_hold=True))
    planner, _ = counting(forced)
    assert isinstance(planner.propose(frame.before[STUD]), Escalation)
    as_designed = replace(frame.proposals, ports=planner.ports)
    outcome = as_designed.propose(frame.before[STUD])
    assert isinstance(outcome, Planned)
    assert fingerprint(outcome.proposal) == fingerprint(frame.planned[STUD].proposal)


@pytest.mark.parametrize("is_taken_away", [True, False], ids=["taken away", "pushed aside"])
def test_a_target_that_was_blocked_is_planned_once_the_blocker_is_gone(
    *, is_taken_away: bool
) -> None:
    proposals, clear = case_study_start()
    stations = proposals.design.cell.station_by_id
    bare = {i: s for i, s in stations.items() if s.kind is not StationKind.BUFFER}
    planner, _ = counting(with_cell(proposals, replace(proposals.design.cell, station_by_id=bare)))
    here = planner.design.world_T_target(SUPPORT_1)
    askew = translation(0.03, 0.2, 0.0) @ here @ rotation((0.0, 0.0, 1.0), 0.2)
    blocked = with_piece_at(clear, FALLEN, askew)
    assert isinstance(planner.propose(blocked), Escalation)
    assert planner.ports.kept.reused == 0
    assert isinstance(planner.propose(blocked), Escalation)
    assert planner.ports.kept.reused == 1
    aside = None if is_taken_away else translation(1.2, 0.0, -0.33) @ here
    assert isinstance(planner.propose(with_piece_at(clear, FALLEN, aside)), Planned)
    assert isinstance(planner.propose(blocked), Escalation)
