"""A path that a person calls unsafe is not shown again: another way is found, or none is said."""

from __future__ import annotations

from dataclasses import replace

import pytest

from builders_planning import case_study_start
from motion_scenes import A, one_arm
from sitewright.central_controller.ports import Planned, SiteContext
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.site_state import Rejection
from sitewright.planning_twin.backends.twin import make_backends
from sitewright.planning_twin.detour import plan_detour
from sitewright.planning_twin.motion import PathSegment, PlanningBackends
from sitewright.planning_twin.refusal import NoPath


@pytest.fixture(scope="module")
def backends() -> PlanningBackends:
    return make_backends()


def rejecting(context: SiteContext, proposal: Proposal, step: int) -> SiteContext:
    calls = tuple(s.call for s in proposal.steps if step in (0, s.number))
    rejection = Rejection(
        fingerprint="", target=proposal.target, reason="path-unsafe", step=step, calls=calls
    )
    rejections = (*context.site.rejections, rejection)
    return replace(context, site=replace(context.site, rejections=rejections))


def hashes(step: ProposedStep) -> list[str]:
    return [m.timed.trajectory.sha256() for m in step.motions]


def test_the_motion_of_a_step_that_was_called_unsafe_goes_another_way_each_time() -> None:
    proposals, context = case_study_start()
    seen: list[list[str]] = []
    outcome = proposals.propose(context)
    assert isinstance(outcome, Planned)
    first = next(s for s in outcome.proposal.steps if s.motions)
    for _ in range(3):
        assert isinstance(outcome, Planned)
        step = next(s for s in outcome.proposal.steps if s.call == first.call)
        assert hashes(step) not in seen
        seen.append(hashes(step))
        for motion in step.motions:
            assert motion.agreement.samples > 0  # certified and confirmed as any other
        context = rejecting(context, outcome.proposal, step.number)
        outcome = proposals.propose(context)
    again = proposals.propose(context)
    assert isinstance(again, Planned)
    assert isinstance(outcome, Planned)
    assert [hashes(s) for s in again.proposal.steps] == [hashes(s) for s in outcome.proposal.steps]


def test_a_detour_is_proven_repeatable_and_aside(backends: PlanningBackends) -> None:
    scene = one_arm()
    start = scene.robots[A].q_rad
    goal = (start[0] + 1.2, *start[1:])
    ways = [
        plan_detour(backends, scene, A, goal, {}, seed=3, number=number) for number in (1, 1, 2)
    ]
    for way in ways:
        assert isinstance(way, PathSegment)
        assert (way.waypoints_rad[0], way.waypoints_rad[-1]) == (start, goal)
        aside = max(
            abs(q - a) for w in way.waypoints_rad for q, a in zip(w[1:], start[1:], strict=True)
        )
        assert aside > 0.1  # the direct way turns the first joint only
    assert ways[0] == ways[1]
    assert ways[0] != ways[2]


def test_where_there_is_no_other_way_that_is_what_is_said(backends: PlanningBackends) -> None:
    class Nowhere:
        def is_clear(self, *_: object, **__: object) -> bool:
            return False

    closed = replace(backends, collision=Nowhere())  # type: ignore[arg-type]
    scene = one_arm()
    start = scene.robots[A].q_rad
    found = plan_detour(closed, scene, A, (start[0] + 0.5, *start[1:]), {}, seed=3, number=1)
    assert isinstance(found, NoPath)
    assert found.reason == "no other way was found than the one that was called unsafe"
