"""Walls of many bays: what is planned at one end has nothing to do with how long the wall is."""

from __future__ import annotations

from itertools import pairwise

from builders_long_walls import BAY_M, long_wall
from sitewright.app.planning import plan_project
from sitewright.central_controller.proposal import Proposal

BAYS = 10


def ways_m(proposal: Proposal) -> dict[str, float]:
    """Return how far each robot drives on its track for a target."""
    found: dict[str, float] = {}
    for step in proposal.steps:
        for motion in step.motions:
            lines = [s.waypoints_rad for s in motion.timed.path.segments]
            way = sum(abs(b[0] - a[0]) for line in lines for a, b in pairwise(line))
            found[step.call.robot] = found.get(step.call.robot, 0.0) + way
    return found


def pieces(proposal: Proposal) -> list[str]:
    """Return what is taken."""
    return [s.call.arguments[0] for s in proposal.steps if s.call.skill == "grasp"]


def test_robots_on_a_long_track_stay_where_the_work_is() -> None:
    report = plan_project(long_wall(3 * BAYS), "bay-000.stud-2")
    assert report.targets_planned == 5
    assert not report.escalated
    first_nailed = 2
    for number, planned in enumerate(report.planned):
        way_m = ways_m(planned.proposal)
        assert way_m["kr120-a"] < 4.0 * BAY_M, planned.proposal.target
        if number > first_nailed:
            assert way_m["kr120-b"] < 4.0 * BAY_M, planned.proposal.target
        assert {p.split(".")[0] for p in pieces(planned.proposal)} <= {"bay-000", "bay-001"}
    ends = {
        step.call.robot: step.call.arguments
        for step in report.planned[-1].proposal.steps
        if step.call.skill == "reach"
    }
    assert ends == {"kr120-a": ("ready-kr120-a",), "kr120-b": ("ready-kr120-b",)}
