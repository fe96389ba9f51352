"""Laws of inverse kinematics for arms that nobody listed: pinocchio is the oracle."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pinocchio
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from builders_arms import Step, chain, random_opw, random_pose, seven_axes, ur_like, urdf_text
from motion_scenes import kr120
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.planning_twin.backends.judged_arm import judged
from sitewright.planning_twin.backends.kinematic_chain import Array, chain_of, matrix_of
from sitewright.planning_twin.backends.numeric_kinematics import NumericSolver
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.backends.opw_solver import OpwSolver
from sitewright.planning_twin.backends.whole_turns import distinct
from sitewright.planning_twin.motion import InverseKind
from sitewright.planning_twin.refusal import NoIk
from sitewright.robot_team.description import Description, JointKind, Joints
from sitewright.robot_team.kinematics import tip_pose, without_turns


def pinocchio_tips(description: Description, q: Array) -> Array:
    model = pinocchio.buildModelFromXML(urdf_text(description))
    data = model.createData()
    frame = model.getFrameId("tool0")
    tips = []
    for row in q:
        pinocchio.framesForwardKinematics(model, data, row)
        tips.append(data.oMf[frame].homogeneous.copy())
    return np.array(tips)


def postures(description: Description, count: int, seed: int = 1) -> Array:
    arm = chain_of(description)
    return np.random.default_rng(seed).uniform(arm.lower, arm.upper, (count, arm.joints))


def as_joints(rows: Array) -> list[Joints]:
    return [tuple(row) for row in rows.tolist()]


def solved(description: Description, pose: Pose, near: Joints) -> tuple[Joints, ...]:
    found = OpwKinematics().solve(description, pose, near)
    assert not isinstance(found, NoIk), found
    return found


def on_rails(
    arm: Description,
    *ways: tuple[float, float, float],
    travel_m: tuple[float, float] = (-1.0, 2.5),
) -> Description:
    rails = [Step(Pose(), way, JointKind.PRISMATIC, travel_m) for way in ways]
    names = [f"carriage_{k}" for k in range(len(rails))]
    carrier = chain("rails", rails, Pose())
    joints = tuple(
        replace(j, name=f"rail_{k}", parent=["track", *names][k], child=names[k])
        for k, j in enumerate(carrier.joints[:-1])
    )
    foot = replace(
        carrier.joints[-1],
        name="foot",
        parent=names[-1],
        child=arm.root,
        parent_T_joint=translation(0.1, -0.2, 0.3) @ rotation((0.0, 0.0, 1.0), 0.4),
    )
    links = [replace(arm.links[0], name=n, shape=()) for n in ("track", *names)]
    return replace(
        arm, name="on rails", links=(*links, *arm.links), joints=(*joints, foot, *arm.joints),
        root="track",
    )  # fmt: skip


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_the_closed_form_of_any_spherical_wrist_is_derived_and_exact(seed: int) -> None:
    arm = random_opw(seed)
    solver, verdict = judged(arm)
    assert verdict.kind is InverseKind.CLOSED_FORM, verdict.reason
    assert verdict.fk_error <= 1e-9
    assert isinstance(solver, OpwSolver)
    rows = postures(arm, 5, seed)
    oracle = pinocchio_tips(arm, rows)
    for q, tip in zip(rows, oracle, strict=True):
        assert np.abs(solver.tip(tuple(q.tolist())) - tip).max() < 1e-9
        found = solver.postures(tip, q)
        assert not isinstance(found, NoIk)
        apart = np.remainder(found - q + math.pi, 2 * math.pi) - math.pi
        assert np.abs(apart).max(axis=1).min() < 1e-6, "the posture itself is not among them"
        assert np.abs(pinocchio_tips(arm, found) - tip).max() < 1e-6


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 10_000), at=st.sampled_from([1, 2, 3, 4]), off=st.floats(1e-6, 0.3))
def test_an_arm_that_is_slightly_bent_gets_no_closed_form(seed: int, at: int, off: float) -> None:
    arm = random_opw(seed)
    bent = Pose(quaternion_wxyz=random_pose(np.random.default_rng(seed)).quaternion_wxyz)
    x, y, z = bent.turn((off, 0.0, 0.0))
    joints = list(arm.joints)
    joints[at] = replace(
        joints[at],
        parent_T_joint=joints[at].parent_T_joint
        @ rotation((0.6, 0.0, 0.8), off)
        @ translation(x, y, z),
    )
    _, verdict = judged(replace(arm, joints=tuple(joints)))
    assert verdict.kind is InverseKind.ITERATIONS
    assert verdict.reason


def test_iterations_find_every_branch_of_the_kr_120() -> None:
    exact, _ = judged(kr120())
    numeric = NumericSolver(chain_of(kr120()))
    near = np.zeros(6)
    for q in postures(kr120(), 12):
        tip = numeric.tip(tuple(q.tolist()))
        all_of_them, found = exact.postures(tip, near), numeric.postures(tip, near)
        assert not isinstance(all_of_them, NoIk)
        assert not isinstance(found, NoIk)
        assert len(distinct(found)) == len(distinct(all_of_them))


@pytest.mark.parametrize("arm", [ur_like(), seven_axes()], ids=lambda a: a.name)
def test_arms_without_closed_form_reach_what_they_can_reach(arm: Description) -> None:
    _, verdict = judged(arm)
    assert verdict.kind is InverseKind.ITERATIONS
    limits = chain_of(arm)
    for q in as_joints(postures(arm, 15)):
        pose = tip_pose(arm, q)
        found = solved(arm, pose, (0.0,) * len(q))
        tips = pinocchio_tips(arm, np.array(found))
        assert np.abs(tips - matrix_of(pose)).max() < 1e-8
        assert (np.array(found) >= limits.lower).all()
        assert (np.array(found) <= limits.upper).all()


def test_a_wrist_that_is_not_spherical_has_up_to_eight_branches_and_all_are_found() -> None:
    """Counted by a search from 1500 starts."""
    arm, many = ur_like(), np.random.default_rng(7)
    solver = NumericSolver(chain_of(arm))
    limits = np.full(6, math.pi)
    for q in postures(arm, 3, seed=2):
        tip = solver.tip(tuple(q.tolist()))
        usual = solver._iterated(solver._starts(q), tip, 60)
        starts = many.uniform(-limits, limits, (1500, 6))
        known = distinct(solver._iterated(starts, tip, 80))
        assert 2 <= len(known) <= 8
        assert len(distinct(usual)) == len(known)


def test_what_is_not_found_by_iterations_is_never_called_proven() -> None:
    for arm in (ur_like(), seven_axes()):
        joints = (0.1,) * len(arm.movable_joints)
        found = OpwKinematics().solve(arm, translation(9.0, 0.0, 0.0), joints)
        assert isinstance(found, NoIk)
        assert not found.is_proven


@pytest.mark.parametrize(
    "ways",
    [((1.0, 0.0, 0.0),), ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), ((0.6, 0.8, 0.0), (0.0, 1.0, 0.0))],
    ids=["track", "gantry", "skew gantry"],
)
def test_an_arm_on_rails_reaches_poses_by_exact_branches(
    ways: tuple[tuple[float, float, float], ...],
) -> None:
    arm = on_rails(kr120(), *ways)
    _, verdict = judged(arm)
    assert (verdict.kind, verdict.rails) == (InverseKind.CLOSED_FORM_ON_RAILS, len(ways))
    middle = (0.3,) * len(ways) + (0.0, -1.9, 1.9, 0.0, 1.3, 0.0)
    for q in as_joints(postures(arm, 8)):
        pose = tip_pose(arm, q)
        here = solved(arm, pose, q)
        assert max(abs(a - b) for a, b in zip(here[0], q, strict=True)) < 1e-6
        elsewhere = solved(arm, pose, middle)
        tips = pinocchio_tips(arm, np.array(elsewhere))
        assert np.abs(tips - matrix_of(pose)).max() < 1e-7
        assert len({row[0] for row in elsewhere}) > 1, "only one rail position was used"


def test_rails_stay_where_they_are_on_the_way() -> None:
    arm = on_rails(kr120(), (1.0, 0.0, 0.0))
    q = (0.777, 0.0, -1.9, 1.9, 0.0, 1.3, 0.0)
    moved = translation(0.01, 0.02, -0.03) @ tip_pose(arm, q)
    found = OpwKinematics().follow(arm, moved, q)
    assert not isinstance(found, NoIk)
    assert found[0] == 0.777
    assert tip_pose(arm, found).distance_to_m(moved) < 1e-7


@settings(max_examples=30, deadline=None)
@given(
    x=st.floats(-6.0, 6.0),
    y=st.floats(-6.0, 6.0),
    z=st.floats(-2.0, 5.0),
    turn=st.floats(-3.0, 3.0),
)
def test_unreachable_from_everywhere_on_the_rails_is_claimed_only_where_it_is_so(
    x: float, y: float, z: float, turn: float
) -> None:
    arm = on_rails(kr120(), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    pose = translation(x, y, z) @ rotation((0.0, 1.0, 0.0), turn)
    near = (0.0, 0.0, 0.0, -1.9, 1.9, 0.0, 1.3, 0.0)
    found = OpwKinematics().solve(arm, pose, near)
    if not isinstance(found, NoIk) or not found.is_proven:
        return
    assert found.extension_m > 0.0
    fine = np.stack(np.meshgrid(*[np.linspace(-1.0, 2.5, 12)] * 2), axis=-1).reshape(-1, 2)
    kinematics = OpwKinematics()
    for rails in fine.tolist():
        foot = Pose((rails[0] + 0.1, rails[1] - 0.2, 0.3), (1.0, 0.0, 0.0, 0.0))
        foot = foot @ rotation((0.0, 0.0, 1.0), 0.4)
        there = kinematics.solve(kr120(), foot.inverse() @ pose, near[2:])
        assert isinstance(there, NoIk)


def test_far_from_the_rails_is_proven_and_beside_the_grid_is_not() -> None:
    arm = on_rails(kr120(), (1.0, 0.0, 0.0))
    near = (0.0, 0.0, -1.9, 1.9, 0.0, 1.3, 0.0)
    far = OpwKinematics().solve(arm, translation(0.0, 7.0, 0.5), near)
    assert isinstance(far, NoIk)
    assert far.is_proven
    assert far.extension_m > 3.0
    short = on_rails(kr120(), (1.0, 0.0, 0.0), travel_m=(-0.02, 0.02))
    over_its_own_foot = translation(0.1, -0.2, 0.3 + 0.675 + 0.215)
    inside = OpwKinematics().solve(short, over_its_own_foot, near)
    assert isinstance(inside, NoIk)
    assert not inside.is_proven


def test_whole_turns_are_those_of_turning_joints_only() -> None:
    arm = on_rails(kr120(), (1.0, 0.0, 0.0))
    shape = without_turns(arm, (2.4, 0.0, 0.0, 0.0, 2 * math.pi + 0.5, 0.0, -2 * math.pi))
    assert shape == (2.4, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0)
    rows = np.array([[0.1, 0.2], [0.1 + 2 * math.pi, 0.2]])
    assert len(distinct(rows, np.array([True, False]))) == 2
    assert len(distinct(rows, np.array([False, True]))) == 1


def test_a_pose_that_is_not_a_number_has_no_solution() -> None:
    for arm in (kr120(), on_rails(kr120(), (1.0, 0.0, 0.0)), ur_like()):
        solver, _ = judged(arm)
        tip = np.full((4, 4), math.nan)
        found = solver.postures(tip, np.zeros(len(arm.movable_joints)))
        assert isinstance(found, NoIk)
        assert not found.is_proven
