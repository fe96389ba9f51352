"""A refusal holds exactly as long as the geometry that it depends on."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from builders_relay import REGRASP
from motion_scenes import kr120
from sitewright.app.engines import proposals_of
from sitewright.app.planning import start_of
from sitewright.app.project import open_project
from sitewright.central_controller.situation import task_of
from sitewright.foundation.ids import ComponentId, FixtureId, RobotId
from sitewright.foundation.pose import Pose, Vector, norm, rotation, scale, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.holding_scope import holding_scope
from sitewright.planning_twin.kept_refusals import KeptRefusals
from sitewright.planning_twin.reach_ball import MARGIN_M, reach_with_tools_m, tip_reach_m
from sitewright.planning_twin.refusal import BlockedBy, NoGrasp, NoIk, NoPath, Refusal, WorkerFailed
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.cell import Fixture

ARM, PIECE, OTHER = RobotId("arm-a"), ComponentId("thick.3"), ComponentId("thick.1")
SEARCHED = NoGrasp(is_proven=False, candidates=252, dropped_by=(("place", 252),))
PROVEN = NoGrasp(is_proven=True, candidates=252, dropped_by=(("reach the target", 252),))
BLOCKED = BlockedBy(pairs=((OTHER, PIECE),), removals=((OTHER,),))
REFUSALS = (SEARCHED, PROVEN, BLOCKED)
KINDS = st.sampled_from(REFUSALS)

directions = st.tuples(st.floats(-1, 1), st.floats(-1, 1), st.floats(-1, 1)).filter(
    lambda v: norm(v) > 0.1
)


@lru_cache(maxsize=1)
def here() -> TwinContext:
    """One arm, a beam to take at its one end and to place by the other."""
    with TemporaryDirectory() as folder:
        project = open_project(REGRASP.write(Path(folder) / "p"))
        proposals, context = proposals_of(project), start_of(project)
    surveyor = proposals.surveyor
    task = task_of(
        proposals.design,
        proposals.graph_of(context),
        context,
        ComponentId("support-1"),
        (PIECE,),
    )
    return TwinContext(backends=proposals.ports.backends, site=surveyor.jobsite(context), task=task)


def scope(context: TwinContext, refusal: Refusal) -> str:
    return holding_scope(context, context.cell.robot_by_id[ARM], PIECE, refusal)


def shifted(pose: Pose, direction: Vector, by_m: float) -> Pose:
    x, y, z = scale(direction, by_m / norm(direction))
    return translation(x, y, z) @ pose


def with_fixture(context: TwinContext, name: str, pose: Pose, size_m: Vector) -> TwinContext:
    """Return the site with a fixture put up, or put elsewhere."""
    fixture = Fixture(id=FixtureId(name), shape=(Box(size_m),), world_T_fixture=pose)
    cell = context.site.cell
    changed = replace(cell, fixture_by_id={**cell.fixture_by_id, fixture.id: fixture})
    return replace(context, site=replace(context.site, cell=changed))


def with_piece(context: TwinContext, piece: ComponentId, pose: Pose) -> TwinContext:
    poses = {**context.site.world_T_piece, piece: pose}
    return replace(context, site=replace(context.site, world_T_piece=poses))


@settings(max_examples=60, deadline=None)
@given(directions, st.floats(0.001, 3.0), st.floats(0.02, 1.0))
def test_a_search_that_found_nothing_expires_by_anything_new_within_reach(
    direction: Vector, share: float, size_m: float
) -> None:
    robot = here().cell.robot_by_id[ARM]
    reach_m = reach_with_tools_m(here().cell, robot)
    pose = shifted(robot.world_T_base, direction, min(share, 1.0) * reach_m)
    changed = with_fixture(here(), "new", pose, (size_m, size_m, size_m))
    assert scope(changed, SEARCHED) != scope(here(), SEARCHED)
    elsewhere = with_fixture(changed, "new", shifted(pose, direction, 0.001), (size_m,) * 3)
    assert scope(elsewhere, SEARCHED) != scope(changed, SEARCHED)
    larger = with_fixture(changed, "new", pose, (size_m, size_m, size_m + 0.001))
    assert scope(larger, SEARCHED) != scope(changed, SEARCHED)


@settings(max_examples=60, deadline=None)
@given(KINDS, directions, st.floats(0.001, 20.0), st.floats(0.02, 1.0))
def test_nothing_expires_by_what_is_out_of_reach(
    refusal: Refusal, direction: Vector, beyond_m: float, size_m: float
) -> None:
    robot = here().cell.robot_by_id[ARM]
    ball_m = reach_with_tools_m(here().cell, robot) + MARGIN_M
    radius_m = math.sqrt(3.0) * size_m / 2.0
    pose = shifted(robot.world_T_base, direction, ball_m + radius_m + beyond_m)
    ends = (here().site.world_T_piece[PIECE], here().task.world_T_target)
    assume(all(pose.distance_to_m(end) > radius_m + 1.6 for end in ends))
    changed = with_fixture(here(), "far", pose, (size_m, size_m, size_m))
    assert scope(changed, refusal) == scope(here(), refusal)


@settings(max_examples=40, deadline=None)
@given(KINDS, directions, st.floats(0.001, 0.5), st.floats(0.001, 0.5))
def test_every_refusal_expires_when_the_piece_the_target_or_the_robot_moves(
    refusal: Refusal, direction: Vector, by_m: float, turn_rad: float
) -> None:
    site, task = here().site, here().task
    before = scope(here(), refusal)
    turned = rotation((0.0, 0.0, 1.0), turn_rad)
    for pose in (
        shifted(site.world_T_piece[PIECE], direction, by_m),
        site.world_T_piece[PIECE] @ turned,
    ):
        assert scope(with_piece(here(), PIECE, pose), refusal) != before
    for pose in (shifted(task.world_T_target, direction, by_m), task.world_T_target @ turned):
        moved = replace(task, world_T_target=pose)
        assert scope(replace(here(), task=moved), refusal) != before
    robot = site.cell.robot_by_id[ARM]
    based = replace(robot, world_T_base=shifted(robot.world_T_base, direction, by_m))
    cell = replace(site.cell, robot_by_id={**site.cell.robot_by_id, ARM: based})
    moved_site = replace(site, cell=cell)
    assert scope(replace(here(), site=moved_site), refusal) != before


@settings(max_examples=40, deadline=None)
@given(directions, st.floats(0.001, 2.0))
def test_what_is_blocked_expires_by_what_blocks_it_and_by_nothing_else(
    direction: Vector, by_m: float
) -> None:
    before = scope(here(), BLOCKED)
    pose = shifted(here().site.world_T_piece[OTHER], direction, by_m)
    assert scope(with_piece(here(), OTHER, pose), BLOCKED) != before
    third = ComponentId("thick.2")
    pose = shifted(here().site.world_T_piece[third], direction, by_m)
    assert scope(with_piece(here(), third, pose), BLOCKED) == before
    assert scope(with_fixture(here(), "new", pose, (0.1, 0.1, 0.1)), BLOCKED) == before


@settings(max_examples=40, deadline=None)
@given(directions, st.floats(0.0, 3.0))
def test_a_proof_does_not_expire_by_anything_that_stands_about(
    direction: Vector, by_m: float
) -> None:
    pose = shifted(here().site.world_T_piece[OTHER], direction, by_m)
    changed = with_fixture(with_piece(here(), OTHER, pose), "new", pose, (0.1, 0.1, 0.1))
    assert scope(changed, PROVEN) == scope(here(), PROVEN)


@settings(max_examples=60, deadline=None)
@given(st.lists(st.floats(-math.pi, math.pi), min_size=6, max_size=6))
def test_no_tip_is_farther_from_its_base_than_the_bound(q: list[float]) -> None:
    tip = OpwKinematics().tip(kr120(), tuple(q))
    assert norm(tip.position_m) <= tip_reach_m(kr120())


@pytest.mark.parametrize(
    "refusal", [NoIk(is_proven=True), BLOCKED, SEARCHED, NoPath(nodes=1, seeds=(0,))]
)
def test_a_kept_refusal_is_found_again_in_its_own_surroundings_only(refusal: Refusal) -> None:
    kept, question = KeptRefusals(), ("hold", "a", "p", "t")
    kept.keep(question, refusal, "here")
    assert kept.recall(question, lambda _: "here") is refusal
    assert kept.recall(question, lambda _: "there") is None
    assert kept.recall(("hold", "b", "p", "t"), lambda _: "here") is None
    kept.keep(question, BLOCKED, "there")
    assert kept.recall(question, lambda _: "here") is refusal
    assert kept.reused == 2


@pytest.mark.parametrize(
    "refusal",
    [NoPath(nodes=1, seeds=(0,), is_reproducible=False), WorkerFailed(task="t", exit_status=9)],
)
def test_what_may_end_otherwise_the_next_time_is_not_kept(refusal: Refusal) -> None:
    kept = KeptRefusals()
    kept.keep(("move", "a"), refusal, "here")
    assert kept.recall(("move", "a"), lambda _: "here") is None


def test_only_so_many_refusals_are_kept() -> None:
    kept = KeptRefusals()
    for n in range(20):
        kept.keep(("hold", "a"), BLOCKED, f"scope {n}")
    assert kept.recall(("hold", "a"), lambda _: "scope 0") is None
    assert kept.recall(("hold", "a"), lambda _: "scope 19") is BLOCKED
    for n in range(600):
        kept.keep(("hold", str(n)), BLOCKED, "here")
    assert kept.recall(("hold", "a"), lambda _: "scope 19") is None
