"""Another order before a person is asked, and what a person is told that was tried on a copy."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from builders_in_the_way import plank_in_the_way
from builders_planning import EXAMPLES, STUD, Rehearsal, with_component, with_operation
from builders_relay import HAND_OVER
from builders_site import RealSite
from sitewright.app.planning import PlanReport, plan_project, start_of
from sitewright.app.project import open_project
from sitewright.central_controller.choosing import front_target
from sitewright.central_controller.design import Design
from sitewright.central_controller.events import ProposalMade, TargetWaits
from sitewright.central_controller.ports import Escalation
from sitewright.central_controller.site_fold import site_after
from sitewright.central_controller.site_graph import graph_now
from sitewright.foundation.ids import ComponentId

PLANK, SUPPORT = ComponentId("plank"), ComponentId("support-1")


def words(report: PlanReport) -> list[str]:
    (refused,) = report.escalated
    return [c.words for c in refused.counter_proposals]


def with_base_of_b(folder: Path, x_m: float) -> Path:
    """Write the wooden frame with the nailing robot farther away, and return its folder."""
    folder.mkdir()
    frame = EXAMPLES / "wooden_frame"
    (folder / "building.json").write_bytes((frame / "building.json").read_bytes())
    cell = (frame / "cell.toml").read_text()
    old = "world_T_base = { p_m = [1.6, 0.0, 0.0], q_wxyz = [0, 0, 0, 1] }"
    assert old in cell
    (folder / "cell.toml").write_text(cell.replace(old, old.replace("1.6", str(x_m))))
    return folder


def test_what_is_in_the_way_is_built_first_where_another_target_is_made_of_it(
    tmp_path: Path,
) -> None:
    report = plan_project(open_project(plank_in_the_way(tmp_path / "p")))
    first, second = report.planned
    assert (first.proposal.target, first.waits) == (PLANK, (SUPPORT,))
    assert (second.proposal.target, second.waits) == (SUPPORT, ())
    (note,) = first.refusals
    assert (note.target, note.verdict) == (SUPPORT, "blocked by thin.1")
    assert note.then == "plank is built first, of thin.1, which is in the way"


def test_a_design_that_wants_another_order_is_kept_and_the_piece_laid_aside(
    tmp_path: Path,
) -> None:
    report = plan_project(open_project(plank_in_the_way(tmp_path / "p", is_after=True)))
    assert [p.proposal.target for p in report.planned] == [SUPPORT, PLANK]
    assert report.planned[0].refusals[0].then == "thin.1 is moved out of the way first"


def test_a_person_is_told_the_order_and_the_removal_that_were_planned_through(
    tmp_path: Path,
) -> None:
    project = plank_in_the_way(tmp_path / "p", is_after=True, has_buffer=False)
    report = plan_project(open_project(project), target=SUPPORT)
    refused = report.escalated[0]
    assert [c.words for c in refused.counter_proposals] == [
        "place plank before support-1",
        "take thin.1 away",
    ]
    assert all(c.steps > 0 and c.duration_s > 0.0 for c in refused.counter_proposals)
    assert "Tried on a copy, and it works: place plank before support-1" in refused.reason
    assert refused.verdict == "blocked by thin.1"


@pytest.mark.parametrize(("stock_x", "helps"), [(-2.9, True), (-4.0, False)])
def test_a_stack_that_is_too_far_may_be_moved_nearer_if_that_is_enough(
    tmp_path: Path, stock_x: float, *, helps: bool
) -> None:
    relay = replace(
        HAND_OVER, arms=(("a", 0.0, 0.0),), stock_x=stock_x, target_x=1.7, buffers=((6.0, 1.7),)
    )
    told = words(plan_project(open_project(relay.write(tmp_path / "p"))))
    assert told == (["move the stack at pallet-thick by 0.6 m towards arm-a"] if helps else [])


def test_the_smallest_step_of_a_robot_that_is_enough_is_told(tmp_path: Path) -> None:
    """What is told is true: with the robot there, the same target has a plan."""
    away = plan_project(open_project(with_base_of_b(tmp_path / "p", 1.8)))
    told = {e.target: [c.words for c in e.counter_proposals] for e in away.escalated}
    assert told == {
        "stud-1": ["move the base of kr120-b by 0.1 m towards stud-1.nail-3"],
        "stud-3": ["move the base of kr120-b by 0.1 m towards stud-3.nail-4"],
    }
    assert all(e.verdict == "proven impossible" for e in away.escalated)
    nearer = plan_project(open_project(with_base_of_b(tmp_path / "q", 1.7)), target="stud-1")
    assert nearer.planned[-1].proposal.target == "stud-1"


def test_a_nail_that_cannot_be_driven_meanwhile_may_come_afterwards(frame: Rehearsal) -> None:
    stud = frame.proposals.design.component(STUD)
    far = with_operation(stud, "stud-1.nail-3", needs_hold=True)
    outcome = with_component(frame.proposals, far).propose(frame.before[STUD])
    assert isinstance(outcome, Escalation)
    assert [c.words for c in outcome.counter_proposals] == [
        "let stud-1.nail-3 be driven after stud-1 is let go of"
    ]


def test_a_target_waits_only_until_the_other_one_is_built(tmp_path: Path) -> None:
    project = open_project(plank_in_the_way(tmp_path / "p"))
    design = Design(model=project.model, cell=project.cell)
    context = start_of(project)
    graph = graph_now(project.model, project.cell, context)
    assert front_target(design, graph, context) == SUPPORT
    waits = site_after(context.site, TargetWaits(target=SUPPORT, until=PLANK))
    assert front_target(design, graph, replace(context, site=waits)) == PLANK
    aside = replace(waits, refused={PLANK: "a person said so"})
    assert front_target(design, graph, replace(context, site=aside)) == SUPPORT


@pytest.mark.slow
def test_the_other_order_is_built_in_simulation_and_stands_in_the_journal(tmp_path: Path) -> None:
    plank_in_the_way(tmp_path / "project", has_buffer=False)
    site = RealSite(tmp_path)
    try:
        ended = site.run()
        assert ended.exit_code == 0, ended.message or ended.said
        assert ended.document["targets_installed"] == ended.document["targets_total"] == 2
        assert ended.document["unallowed_contacts"] == 0
        events = site.events()
        assert [e for e in events if isinstance(e, TargetWaits)] == [
            TargetWaits(target=SUPPORT, until=PLANK)
        ]
        built = [e.target for e in events if isinstance(e, ProposalMade)]
        assert built == [PLANK, SUPPORT]
        assert any("which is in the way" in r["then"] for r in ended.document["refusals"])
    finally:
        site.clean_up()
