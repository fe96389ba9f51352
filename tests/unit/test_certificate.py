"""What the certificate refuses and what it says."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from motion_scenes import HOME, STUD, A, B, box, held_stud, kr120, lowering, one_arm, two_arms
from sitewright.foundation.ids import BodyId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.collision_check import CoalCollisionCheck
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.motion import Certificate, JointPath, PathSegment
from sitewright.planning_twin.refusal import NotClear
from sitewright.planning_twin.scene import Attachment, Body, Pair, SceneSnapshot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.kinematics import tip_pose

PROOFS = ProofScenes()
CERTIFIER = ConservativeAdvancement(PROOFS)
CHECK = CoalCollisionCheck(PROOFS)
HELD_ON_TABLE: Pair = ("held", "table")


def swing(joint: int, by_rad: float, start: Joints = HOME) -> tuple[Joints, Joints]:
    return start, tuple(q + (by_rad if k == joint else 0.0) for k, q in enumerate(start))


def path(*segments: PathSegment) -> JointPath:
    return JointPath(robot=A, segments=segments)


def free(*waypoints: Joints) -> JointPath:
    return path(PathSegment(waypoints_rad=waypoints))


def certificate(scene: SceneSnapshot, line: JointPath) -> Certificate:
    found = CERTIFIER.certify(scene, line)
    assert isinstance(found, Certificate), found
    return found


def refusal(scene: SceneSnapshot, line: JointPath) -> NotClear:
    found = CERTIFIER.certify(scene, line)
    assert isinstance(found, NotClear), found
    return found


def fin_in_the_way() -> Body:
    """A fin of 1 mm across the swing of the probe's end, between two samples."""
    end = tip_pose(kr120(), swing(0, 0.525)[1]).apply((0.0, 0.0, 0.19))
    bearing = math.atan2(end[1], end[0])
    return box("fin", (0.06, 0.001, 0.06), Pose(end) @ rotation((0.0, 0.0, 1.0), bearing))


def test_a_fin_of_one_millimetre_that_coarse_samples_miss_is_refused() -> None:
    scene = one_arm(fin_in_the_way(), box_at_tip(), clearance_m=0.0)
    start, end = swing(0, 1.0)
    samples = [
        tuple(a + k / 20 * (b - a) for a, b in zip(start, end, strict=True)) for k in range(21)
    ]
    assert not any(CHECK.violations(scene, A, q, {}) for q in samples)
    found = refusal(scene, free(start, end))
    assert "fin" in found.pair
    assert found.distance_m <= 1e-5
    assert CHECK.violations(scene, A, found.q_rad, {})


def box_at_tip() -> Body:
    """A thin probe at the flange, so that the fin can be missed."""
    return box("probe", (0.004, 0.004, 0.2), Attachment(A, translation(0.0, 0.0, 0.1)))


def test_a_clear_path_gets_a_certificate_about_this_path_and_scene() -> None:
    scene = two_arms(held_stud())
    line = free(*swing(0, 0.3))
    found = certificate(scene, line)
    assert found.path_sha256 == line.sha256()
    assert found.scene_revision == scene.revision()
    assert found.clearance_m == scene.clearance_m
    assert found.closest_distance_m > scene.clearance_m
    assert found.closest_pair is not None
    assert 0.0 <= found.closest_at[1] <= 1.0
    assert found.engine.startswith("coal 3")


def test_a_body_in_the_way_is_named_with_where_and_how_near() -> None:
    scene = two_arms(held_stud())
    there = tip_pose(kr120(), swing(0, 0.2)[1])
    blocked = scene.with_body(
        box("pillar", (0.1, 0.1, 2.0), Pose(scene.robots[A].world_T_base.apply(there.position_m)))
    )
    found = refusal(blocked, free(*swing(0, 0.4)))
    assert "pillar" in found.pair
    assert found.segment == 0
    assert found.distance_m < found.threshold_m == 0.010
    assert found.pair in CHECK.violations(blocked, A, found.q_rad, {})


def test_closest_distance_is_a_lower_bound_close_to_the_truth() -> None:
    """A box beside the swing: the truth is known from dense samples."""
    start, end = swing(0, 0.4)
    ahead = tip_pose(kr120(), swing(0, 0.6)[1])
    scene = one_arm(box("wall", (0.02, 0.02, 0.02), Pose(ahead.position_m)))
    found = certificate(scene, free(start, end))
    wide = [replace(scene, clearance_m=c) for c in np.linspace(0.0, 0.4, 401)]
    dense = [
        tuple(a + k / 40 * (b - a) for a, b in zip(start, end, strict=True)) for k in range(41)
    ]
    first = next(s.clearance_m for s in wide if any(_telling(s, q) for q in dense))
    assert found.closest_distance_m <= first
    assert found.closest_distance_m >= first - 0.001 - max(0.001, 0.03 * first)


def _telling(scene: SceneSnapshot, q: Joints) -> bool:
    """Tell whether any pair but those across one joint is within the clearance."""
    return bool(CHECK.violations(scene, A, q, {}))


def test_placing_at_gap_zero_is_certified_only_as_a_declared_contact() -> None:
    scene, approach, last = lowering(0.12)
    declared = path(
        PathSegment(waypoints_rad=approach),
        PathSegment(waypoints_rad=last, threshold_m={HELD_ON_TABLE: -0.001}),
    )
    found = certificate(scene, declared)
    assert found.closest_at[0] == 0, "declared pairs are left out of the closest distance"
    assert found.closest_distance_m > 0.025
    undeclared = refusal(scene, free(*approach, *last[1:]))
    assert undeclared.pair == HELD_ON_TABLE
    assert undeclared.threshold_m == 0.010


def test_a_declared_neighbour_may_be_near_but_not_touch() -> None:
    scene, approach, last = lowering(0.12)
    line = path(
        PathSegment(waypoints_rad=approach),
        PathSegment(waypoints_rad=last, threshold_m={HELD_ON_TABLE: 0.001}),
    )
    found = refusal(scene, line)
    assert (found.pair, found.segment, found.threshold_m) == (HELD_ON_TABLE, 1, 0.001)


def test_a_gap_between_two_segments_is_no_path() -> None:
    (a, b), (c, d) = swing(0, 0.1), swing(0, 0.2, start=swing(0, 0.1001)[1])
    with pytest.raises(ValueError, match="starts"):
        CERTIFIER.certify(
            one_arm(), path(PathSegment(waypoints_rad=(a, b)), PathSegment(waypoints_rad=(c, d)))
        )


def test_a_single_waypoint_is_no_line() -> None:
    with pytest.raises(ValueError, match="no line"):
        CERTIFIER.certify(one_arm(), free(HOME))


def test_standing_still_is_proven_as_well() -> None:
    assert certificate(one_arm(), free(HOME, HOME)).evaluations >= 1
    on_it = box("lump", (0.2, 0.2, 0.2), Pose(tip_pose(kr120(), HOME).position_m))
    assert "lump" in refusal(one_arm(on_it), free(HOME, HOME)).pair


def test_the_other_robot_must_stand_clear_too() -> None:
    scene = two_arms()
    gun = scene.robots[B].world_T_base @ tip_pose(kr120(), HOME)
    touching = scene.with_body(box("plank", (0.3, 0.3, 0.02), Pose(gun.apply((0.0, 0.0, 0.2)))))
    found = refusal(touching, free(*swing(0, 0.1)))
    assert found.pair == ("nailer", "plank")
    declared = path(
        PathSegment(waypoints_rad=swing(0, 0.1), threshold_m={("nailer", "plank"): -1.0})
    )
    assert isinstance(CERTIFIER.certify(touching, declared), Certificate)


def test_a_carried_body_counts_against_its_own_arm() -> None:
    along = box("bar", STUD, Attachment(A, translation(0.0, 0.0, 0.24)))
    assert CHECK.violations(one_arm(along), A, HOME, {}) == (("a/link_2", "bar"),)


def test_still_bodies_never_collide_with_each_other_or_with_a_base() -> None:
    inside = box("inside", (0.2, 0.2, 0.2), Pose())
    stacked = box("stacked", (0.2, 0.2, 0.2), translation(0.05, 0.0, 0.0))
    assert not CHECK.violations(one_arm(inside, stacked), A, HOME, {})


def test_padded_questions_keep_one_millimetre_more_and_leave_contacts_out() -> None:
    q = HOME
    edge = tip_pose(kr120(), q)
    scene = one_arm(
        box("near", (0.1, 0.1, 0.1), translation(0.0, 0.0, -0.05) @ Pose(edge.position_m))
    )
    pair: Pair = ("a/link_6", "near")
    assert pair in CHECK.violations(scene, A, q, {})
    assert pair in CHECK.violations(scene, A, q, {pair: -0.001}, is_padded=False)
    assert pair not in CHECK.violations(scene, A, q, {pair: -0.001}, is_padded=True)


@pytest.mark.parametrize(
    ("gap_m", "plain", "padded"), [(0.0095, 1, 1), (0.0105, 0, 1), (0.012, 0, 0)]
)
def test_the_clearance_is_kept_to_the_tenth_of_a_millimetre(
    gap_m: float, plain: int, padded: int
) -> None:
    tip = tip_pose(kr120(), HOME)
    probe = box("probe", (0.02, 0.02, 0.1), Attachment(A, translation(0.0, 0.0, 0.05)))
    beyond = tip @ translation(0.0, 0.0, 0.1 + gap_m + 0.01)
    scene = one_arm(probe, box("wall", (0.02, 0.02, 0.02), beyond))
    assert len(CHECK.violations(scene, A, HOME, {})) == plain
    assert len(CHECK.violations(scene, A, HOME, {}, is_padded=True)) == padded


def test_a_moved_body_is_seen_at_its_new_place() -> None:
    tip = tip_pose(kr120(), HOME)
    scene = one_arm(box("lump", (0.2, 0.2, 0.2), translation(0.0, 3.0, 0.0)))
    assert not CHECK.violations(scene, A, HOME, {})
    assert CHECK.violations(scene.placed(BodyId("lump"), Pose(tip.position_m)), A, HOME, {})
    assert not CHECK.violations(scene, A, HOME, {})
