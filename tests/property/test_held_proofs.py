"""When collisions prove something: laws of the proof that a piece cannot be fastened while held."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from typing_extensions import override

from builders_held import Stud, stud_of_frame
from builders_planning import A, B
from motion_scenes import kr120
from sitewright.foundation.ids import BodyId, ComponentId, EndEffectorId, FixtureId, RobotId, ZoneId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.holding import find_holding
from sitewright.planning_twin.holding_scope import holding_scope
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.refusal import HeldFreedoms, NoGrasp, pair_of, seen_at
from sitewright.planning_twin.tacking import Holding, drivable_while_held
from sitewright.planning_twin.task import Task, TwinContext
from sitewright.robot_team.cell import EndEffectorKind, Fixture, Zone
from sitewright.robot_team.description import Description
from sitewright.robot_team.kinematics import without_turns

FEW = 13
"""Every so-manieth of 182 grasps is enough where it is about what a proof looks at."""
OTHER = ComponentId("thing-in-the-way")
SERVES = 74
"""Number of the first grasp of frame 16 by which both nails can be driven."""


@pytest.fixture(scope="module")
def hindered() -> Stud:
    """A stud whose near nail nobody gets at while it is held."""
    return stud_of_frame(7, every=FEW)


@pytest.fixture(scope="module")
def with_way_out() -> Stud:
    """A stud of the same kind that two of three grasps fail for as well; the last one serves."""
    stud = stud_of_frame(16)
    return replace(stud, grasps=stud.grasps[SERVES - 2 : SERVES + 1])


def test_a_whole_search_that_the_holder_is_in_the_way_of_is_proven_and_says_over_what() -> None:
    stud = stud_of_frame(7)
    refusal = find_holding(stud.context, stud.holder, stud.piece)
    assert isinstance(refusal, NoGrasp)
    assert refusal.is_proven
    assert refusal.freedoms is not None
    found = refusal.freedoms
    assert (found.grasps, found.ways, found.tool_poses, found.robots) == (182, 468, 100, (B,))
    ((nail, why),) = found.blocked
    pair = why.pairs[0]
    assert nail == "stud-1.nail-1"
    assert (pair_of(refusal), seen_at(refusal)) == (pair, why.moment)
    assert why.moment is not None
    assert set(why.moment.q_rad) == {A, B}
    assert [name.split("/")[0] for name in pair] == [A, B]
    words = (
        f"since {A}, which holds it, is in the way of {nail} ({pair[0]} and {pair[1]}); "
        f"proven over all 182 grasps in every posture (468 ways to hold it), and up to 100 tool "
        f"poses of {B} for each fastener in every posture"
    )
    assert words in refusal.reason


def test_one_grasp_that_serves_is_no_proof_however_many_fail(with_way_out: Stud) -> None:
    failing = replace(with_way_out, grasps=with_way_out.grasps[:-1])
    assert failing.proof() is not None
    assert with_way_out.proof() is None


def test_fewer_fasteners_that_must_be_driven_are_no_proof(hindered: Stud) -> None:
    task = hindered.context.task
    assert task.hold_until == 2
    assert _with(hindered, task=replace(task, hold_until=1)).proof() is None
    near, far = task.spots
    wants_near = replace(task, hold_until=1, spots=(replace(near, needs_hold=True), far))
    wants_far = replace(task, hold_until=1, spots=(near, replace(far, needs_hold=True)))
    assert _with(hindered, task=wants_near).proof() is not None
    assert _with(hindered, task=wants_far).proof() is None


@pytest.mark.parametrize("kind", ["piece", "zone", "obstacle", "fixture"])
def test_only_what_stands_for_good_proves(with_way_out: Stud, kind: str) -> None:
    """Something is put where the tool must be; only a fixture is there whatever is done."""
    stud = replace(with_way_out, grasps=with_way_out.grasps[-1:])
    holding = _a_way_to_hold(stud)
    far = stud.context.task.spots[1].world_T_operation.position_m
    blocked = _with_thing(stud, kind, translation(far[0], far[1], far[2] + 0.2))
    assert len(drivable_while_held(stud.context, holding, stud.gripper)) == 2
    assert len(drivable_while_held(blocked.context, holding, stud.gripper)) < 2
    assert (blocked.proof() is not None) is (kind == "fixture")


def test_a_third_robot_that_gets_at_the_near_nail_is_no_proof(hindered: Stud) -> None:
    """The holder's arm is in the way of neither if it stands at that end of the stud."""
    proof = hindered.proof()
    assert proof is not None
    assert _with_third(hindered, side=1.0).proof() == replace(
        proof, robots=(B, RobotId("kr120-c")), tool_poses=2 * proof.tool_poses
    )
    assert _with_third(hindered, side=-1.0).proof() is None


def test_a_tool_that_somebody_else_has_mounted_counts_all_the_same(hindered: Stud) -> None:
    """It might be brought back; where tools are now proves nothing."""
    third = _with_third(hindered, side=-1.0)
    site, there = third.context.site, RobotId("kr120-c")
    bare = {**site.arms, there: replace(site.arms[there], mounted=None)}
    without = replace(third, context=replace(third.context, site=replace(site, arms=bare)))
    assert without.proof() is None


def test_a_gripper_that_nobody_has_mounted_might_hold_it_differently(hindered: Stud) -> None:
    cell = hindered.context.cell
    spare = replace(hindered.gripper, id=EndEffectorId("gripper-spare"))
    assert spare.kind is EndEffectorKind.GRIPPER
    tools = {**cell.end_effector_by_id, spare.id: spare}
    robot_b = cell.robot_by_id[B]
    for robot in (hindered.holder, robot_b):
        able = replace(robot, end_effectors=(*robot.end_effectors, spare.id))
        robots = {**cell.robot_by_id, robot.id: able}
        other = replace(cell, robot_by_id=robots, end_effector_by_id=tools)
        assert hindered.with_cell(other).proof() is None


def test_a_robot_that_holds_drives_nothing_though_it_might_change_its_tool(
    with_way_out: Stud,
) -> None:
    stud = replace(with_way_out, grasps=with_way_out.grasps[-1:])
    holding, site = _a_way_to_hold(stud), stud.context.site
    gun = replace(site.cell.end_effector_by_id[EndEffectorId("nail-gun")], id=EndEffectorId("gun"))
    assert gun.station is not None
    able = replace(stud.holder, end_effectors=(*stud.holder.end_effectors, gun.id))
    without = replace(site.cell.robot_by_id[B], end_effectors=())
    cell = replace(
        site.cell,
        robot_by_id={**site.cell.robot_by_id, A: able, B: without},
        end_effector_by_id={**site.cell.end_effector_by_id, gun.id: gun},
    )
    changed = replace(site, cell=cell, docked={gun.id: gun.station})
    context = replace(stud.context, site=changed)
    assert drivable_while_held(context, holding, stud.gripper) == ()


def test_distances_are_those_of_the_certificate(hindered: Stud) -> None:
    """Were bodies allowed to pass through each other, nothing would be in the way."""
    through = replace(hindered.context.cell, clearance_m=-3.0)
    assert hindered.with_cell(through).proof() is None


class _SomePostures(OpwKinematics):
    """Says of every pose that there may be more postures than it gives."""

    @override
    def has_all(self, description: Description, base_T_tip: Pose) -> bool:
        del description, base_T_tip
        return False


def test_postures_that_might_be_missing_are_no_proof(hindered: Stud) -> None:
    backends = replace(hindered.context.backends, kinematics=_SomePostures())
    context = replace(hindered.context, backends=backends)
    assert replace(hindered, context=context).proof() is None


def test_not_all_postures_are_known_where_the_wrist_is_straight() -> None:
    """Joints 4 and 6 share the turn there: any posture of the forearm's wrist will do."""
    solver, arm = OpwKinematics(), kr120()
    bent, straight = (0.2, -1.4, 1.5, 0.4, 0.7, 0.1), (0.2, -1.4, 1.5, 0.4, 0.0, 0.1)
    assert solver.has_all(arm, solver.tip(arm, bent))
    assert not solver.has_all(arm, solver.tip(arm, straight))


def test_half_a_turn_either_way_is_one_posture() -> None:
    one, other = (0.0, 0.0, 0.0, math.pi, 0.5, 0.0), (0.0, 0.0, 0.0, -math.pi, 0.5, 0.0)
    assert without_turns(kr120(), one) == without_turns(kr120(), other)


def test_a_kept_proof_is_void_once_another_robot_or_the_demand_changes(hindered: Stud) -> None:
    context, robot, piece = hindered.context, hindered.holder, hindered.piece
    freedoms = HeldFreedoms(grasps=1, ways=1, tool_poses=1, robots=(B,))
    proof = NoGrasp(is_proven=True, candidates=1, freedoms=freedoms)
    far = NoGrasp(is_proven=True, candidates=1)

    def scopes(changed: TwinContext) -> tuple[str, str]:
        return tuple(holding_scope(changed, robot, piece, no) for no in (proof, far))  # type: ignore[return-value]

    site, before = context.site, scopes(context)
    nearer = replace(
        site.cell.robot_by_id[B],
        world_T_base=translation(-0.1, 0.0, 0.0) @ site.cell.robot_by_id[B].world_T_base,
    )
    cell = replace(site.cell, robot_by_id={**site.cell.robot_by_id, B: nearer})
    moved = scopes(replace(context, site=replace(site, cell=cell)))
    demanded = scopes(replace(context, task=replace(context.task, hold_until=1)))
    assert moved[0] != before[0]
    assert moved[1] == before[1]
    assert demanded[0] != before[0]
    assert demanded[1] == before[1]


def _with(stud: Stud, *, task: Task) -> Stud:
    return replace(stud, context=replace(stud.context, task=task))


def _a_way_to_hold(stud: Stud) -> Holding:
    """Return the first holding by the only grasp that is looked at, with both nails drivable."""
    found = find_holding(stud.context, stud.holder, stud.piece)
    assert isinstance(found, Holding)
    assert found.grasp == stud.grasps[0]
    return found


def _with_thing(stud: Stud, kind: str, pose: Pose) -> Stud:
    """Return the stud with a block somewhere that belongs to the site in one way or another."""
    site, shape = stud.context.site, (Box((0.2, 0.2, 0.2)),)
    if kind == "piece":
        block = PieceShape(shape=shape, size_m=(0.2, 0.2, 0.2), mass_kg=1.0)
        site = replace(
            site,
            pieces={**site.pieces, OTHER: block},
            world_T_piece={**site.world_T_piece, OTHER: pose},
        )
    elif kind == "obstacle":
        site = replace(site, obstacles={OTHER: (shape, pose)})
    elif kind == "zone":
        zone = Zone(id=ZoneId(OTHER), shape=shape, world_T_zone=pose)
        site = replace(site, cell=replace(site.cell, zone_by_id={zone.id: zone}))
    else:
        fixture = Fixture(id=FixtureId(OTHER), shape=shape, world_T_fixture=pose)
        known = {**site.cell.fixture_by_id, fixture.id: fixture}
        site = replace(site, cell=replace(site.cell, fixture_by_id=known))
    assert BodyId(OTHER) not in stud.context.task.rests_on
    return replace(stud, context=replace(stud.context, site=site))


def _with_third(stud: Stud, *, side: float) -> Stud:
    """Return the stud with a third robot with a nail gun of its own, on one side of the table."""
    site = stud.context.site
    cell, there = site.cell, RobotId("kr120-c")
    gun = replace(cell.end_effector_by_id[EndEffectorId("nail-gun")], id=EndEffectorId("gun-c"))
    base = translation(-0.6, 1.9 * side, 0.0) @ rotation((0.0, 0.0, 1.0), -side * math.pi / 2.0)
    third = replace(cell.robot_by_id[B], id=there, world_T_base=base, end_effectors=(gun.id,))
    cell = replace(
        cell,
        robot_by_id={**cell.robot_by_id, there: third},
        end_effector_by_id={**cell.end_effector_by_id, gun.id: gun},
    )
    arms = {**site.arms, there: replace(site.arms[B], mounted=gun.id)}
    return replace(stud, context=replace(stud.context, site=replace(site, cell=cell, arms=arms)))
