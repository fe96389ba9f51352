"""What is tried before a person is asked: one scene for each step, in which it is what helps."""

from __future__ import annotations

from dataclasses import replace

import pytest

from builders_planning import (
    STUD,
    SUPPORT_1,
    A,
    Rehearsal,
    case_study_start,
    with_cell,
    with_component,
    with_operation,
    with_piece_at,
)
from sitewright.central_controller.ports import Escalation, Planned, SiteContext
from sitewright.central_controller.proposing import Proposals
from sitewright.central_controller.rehearsal import rehearsed
from sitewright.foundation.ids import ComponentId, FixtureId, ZoneId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.robot_team.cell import Cell, Fixture, StationKind, Zone
from sitewright.robot_team.skill import Skill, SkillCall

FALLEN, LOOSE, FAR = ComponentId("thick.3"), ComponentId("thick.1"), "stud-1.nail-3"


@pytest.fixture(scope="module")
def start() -> tuple[Proposals, SiteContext]:
    return case_study_start()


def lying_in_the_way(proposals: Proposals, context: SiteContext, roll: Pose) -> SiteContext:
    """Return the site with a piece dropped where the first support belongs, a little askew."""
    here = proposals.design.world_T_target(SUPPORT_1)
    askew = translation(0.03, 0.2, 0.0) @ here @ rotation((0.0, 0.0, 1.0), 0.2)
    return with_piece_at(context, FALLEN, askew @ roll)


def without_buffers(cell: Cell) -> Cell:
    stations = {i: s for i, s in cell.station_by_id.items() if s.kind is not StationKind.BUFFER}
    return replace(cell, station_by_id=stations)


def acts(planned: Planned) -> list[SkillCall]:
    moves = (Skill.REACH, Skill.RETRACT)
    return [s.call for s in planned.proposal.steps if s.call.skill not in moves]


ON_ITS_SIDE = translation(0.0, 0.0, -0.025) @ rotation((1.0, 0.0, 0.0), 1.5707963267948966)


@pytest.mark.parametrize("roll", [Pose(), ON_ITS_SIDE], ids=["upright", "on its side"])
def test_a_piece_in_the_way_is_brought_to_a_free_buffer_first(
    start: tuple[Proposals, SiteContext], roll: Pose
) -> None:
    proposals, clear = start
    context = lying_in_the_way(proposals, clear, roll)
    outcome = proposals.propose(context)
    assert isinstance(outcome, Planned)
    grasped, down, *rest = acts(outcome)
    assert grasped.arguments[0] == FALLEN
    assert down == SkillCall(Skill.SET_DOWN, A, (FALLEN, "buffer-a"))
    assert [c.skill for c in rest] == [Skill.GRASP, Skill.POSITION, Skill.RELEASE]
    after = rehearsed(context, outcome.proposal)
    assert after.site.is_secured(SUPPORT_1)
    assert proposals.graph_of(after).node_by_id[FALLEN].place == "buffer-a"  # type: ignore[attr-defined]
    assert [s.number for s in outcome.proposal.steps] == list(
        range(1, len(outcome.proposal.steps) + 1)
    )
    assert outcome.refusals[0].reason.endswith("thick.3 is in its place: thick.2 and thick.3")


def test_without_a_buffer_the_piece_in_the_way_is_named_to_a_person(
    start: tuple[Proposals, SiteContext],
) -> None:
    proposals, clear = start
    context = lying_in_the_way(proposals, clear, Pose())
    bare = with_cell(proposals, without_buffers(proposals.design.cell))
    outcome = bare.propose(context)
    assert isinstance(outcome, Escalation)
    assert outcome.target == SUPPORT_1
    assert not outcome.is_proven
    assert "take thick.3 out of the way" in outcome.reason
    assert ("thick.2", "thick.3") in {note.pair for note in outcome.refusals}


@pytest.mark.parametrize("thing", ["crate", "no-go"])
def test_a_fixture_or_zone_where_a_piece_belongs_is_named(
    start: tuple[Proposals, SiteContext], thing: str
) -> None:
    proposals, clear = start
    cell, here = proposals.design.cell, proposals.design.world_T_target(SUPPORT_1)
    shape = (Box((0.2, 0.2, 0.2)),)
    crate = Fixture(id=FixtureId("crate"), shape=shape, world_T_fixture=here)
    no_go = Zone(id=ZoneId("no-go"), shape=shape, world_T_zone=here)
    changed = {
        "crate": replace(cell, fixture_by_id={**cell.fixture_by_id, crate.id: crate}),
        "no-go": replace(cell, zone_by_id={**cell.zone_by_id, no_go.id: no_go}),
    }
    outcome = with_cell(proposals, changed[thing]).propose(clear)
    assert isinstance(outcome, Escalation)
    assert outcome.target == SUPPORT_1
    assert outcome.verdict == f"blocked by {thing}"
    assert f"take {thing} out of the way" in outcome.reason


def test_a_change_that_helps_only_once_a_piece_is_out_of_the_way_is_tried_with_that_errand(
    frame: Rehearsal,
) -> None:
    """A loose support lies where the stud belongs, and a far nail must be driven while it is held.

    To clear the place is not enough, nor is it enough to drive the nail later.
    """
    stud = replace(frame.proposals.design.component(STUD), hold_until_fasteners=1)
    forced = with_component(frame.proposals, with_operation(stud, FAR, needs_hold=True))
    on_supports = translation(0.0, 0.0, 0.05) @ forced.design.world_T_target(STUD)
    context = with_piece_at(frame.before[STUD], LOOSE, on_supports)
    outcome = forced.propose(context)
    assert isinstance(outcome, Escalation)
    assert outcome.blockers == (LOOSE,)
    (found,) = outcome.counter_proposals
    assert found.words == f"let {FAR} be driven after {STUD} is let go of"
    assert found.steps > len(frame.planned[STUD].proposal.steps)
