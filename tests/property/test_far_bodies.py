"""Bodies that are left out of a motion's scene are far away; leaving them out changes nothing."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

import numpy as np
import pytest
from typing_extensions import override

from motion_scenes import STUD, A, B, box, gripper, held_stud, kr120, nailer
from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.collision_check import CoalCollisionCheck
from sitewright.planning_twin.backends.distances import DistanceEngine
from sitewright.planning_twin.backends.mujoco_crosscheck import MujocoCrossCheck
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.ruckig_timer import RuckigTimer
from sitewright.planning_twin.backends.surroundings import FAR_M, Surroundings, whole
from sitewright.planning_twin.backends.two_trees import TwoTrees
from sitewright.planning_twin.motion import (
    Certificate,
    JointLimits,
    JointPath,
    MotionRequest,
    PathSegment,
)
from sitewright.planning_twin.scene import Body, RobotInScene, SceneSnapshot
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.rails import Rail, on_rails

BOXES = 100
CARRIAGE = (Box((1.2, 1.2, 0.2), translation(0.0, 0.0, -0.12)),)
ALONG, ACROSS, UP = (1.0, 0.0, 0.0), (0.6, 0.8, 0.0), (0.0, 0.0, 1.0)


class WholeScenes(ProofScenes):
    """Leaves nothing out."""

    @override
    def around(
        self, scene: SceneSnapshot, moved: Mapping[RobotId, Iterable[Sequence[float]]]
    ) -> Surroundings:
        return whole(scene)


def rail(axis: tuple[float, float, float], half_m: float) -> Rail:
    return Rail(axis=axis, travel_m=(-half_m, half_m), speed_m_s=1.5, carriage=CARRIAGE)


def track() -> Description:
    return on_rails(kr120(), [rail(ALONG, 14.0)], rotation(UP, 0.7))


def skew_gantry() -> Description:
    hanging = translation(0.1, 0.2, -0.3) @ rotation(ALONG, math.pi)
    return on_rails(kr120(), [rail(ALONG, 14.0), rail(ACROSS, 1.0), rail(UP, 0.5)], hanging)


ARMS = {"track": track(), "gantry": skew_gantry(), "fixed": kr120()}
PARTS, WHOLE = ProofScenes(), WholeScenes()
every_arm = pytest.mark.parametrize("arm", ARMS.values(), ids=ARMS)


def random_posture(arm: Description, random: np.random.Generator) -> Joints:
    joints = arm.movable_joints
    return tuple(float(random.uniform(j.lower_rad, j.upper_rad)) for j in joints)


def wall(arm: Description, random: np.random.Generator) -> SceneSnapshot:
    """An arm that carries a stud, another one that stands, a floor, and boxes along 50 m."""
    boxes = [
        box(
            f"box-{k}",
            tuple(random.uniform(0.05, 0.5, 3).tolist()),
            translation(*random.uniform((-25.0, -5.0, 0.0), (25.0, 5.0, 3.5)).tolist())
            @ rotation(UP, float(random.uniform(0.0, math.pi))),
        )
        for k in range(BOXES)
    ]
    floor = box("floor", (60.0, 12.0, 0.1), translation(0.0, 0.0, -2.0))
    long = box("beam", (9.0, *STUD[1:]), translation(12.0, 1.5, 4.5))
    aside = Body(
        id=BodyId("aside"),
        shape=(Box((0.3, 0.3, 0.3), translation(-6.0, 0.0, 0.0)),),
        placement=translation(float(random.uniform(-10.0, 10.0)), 0.0, 1.5),
    )
    still = [floor, long, aside, *boxes]
    arms = {
        A: RobotInScene(
            description=arm,
            world_T_base=translation(0.4, 0.2, 0.5) @ rotation(UP, 0.2),
            q_rad=random_posture(arm, random),
        ),
        B: RobotInScene(
            description=kr120(),
            world_T_base=translation(float(random.uniform(-15.0, 15.0)), 9.0, 0.0),
            q_rad=random_posture(kr120(), random),
        ),
    }
    bodies = [*still, *gripper(A), held_stud(A), nailer(B)]
    return SceneSnapshot(robots=arms, bodies={b.id: b for b in bodies})


def free_wall(arm: Description, random: np.random.Generator) -> SceneSnapshot:
    """The same, in a posture that touches nothing if one is found soon."""
    scene, check = wall(arm, random), CoalCollisionCheck(WHOLE)
    for _ in range(40):
        if check.is_clear(scene, A, scene.robots[A].q_rad, {}):
            break
        scene = scene.with_joints(A, random_posture(arm, random))
    return scene


def near_posture(arm: Description, q: Joints, by: float, random: np.random.Generator) -> Joints:
    limits = [(j.lower_rad, j.upper_rad) for j in arm.movable_joints]
    changed = [v + float(random.uniform(-by, by)) for v in q]
    return tuple(min(max(v, a), b) for v, (a, b) in zip(changed, limits, strict=True))


@every_arm
@pytest.mark.parametrize("seed", range(3))
def test_what_is_left_out_is_far_away_from_everything_that_moves(
    arm: Description, seed: int
) -> None:
    random = np.random.default_rng(seed)
    scene, proofs = wall(arm, random), PARTS
    ends = [near_posture(arm, scene.robots[A].q_rad, 1.5, random) for _ in range(2)]
    part = proofs.around(scene, {A: ends})
    left_out = scene.bodies.keys() - part.scene.bodies.keys()
    assert part.left_out == len(left_out) > BOXES / 4
    assert len(part.scene.bodies) > BOXES / 30
    assert part.beyond_m == scene.clearance_m + FAR_M
    low, high = np.min(ends, axis=0), np.max(ends, axis=0)
    rails = len(arm.movable_joints) - 6
    q = np.array([random_posture(arm, random) for _ in range(60)])
    q[:, :rails] = random.uniform(low[:rails], high[:rails], (60, rails))
    proof = proofs.of(scene)
    for table, placed in (
        (proof.layout.pairs_of[A], proof.placed(A, q)),
        (proof.layout.standing_of[A], proof.standing()),
    ):
        is_out = [any(name in left_out for name in table.names[n]) for n in table.name]
        rows = np.flatnonzero(is_out)
        assert len(rows)
        for posture in range(60 if table is proof.layout.pairs_of[A] else 1):
            numbers = np.full(len(rows), posture, dtype=np.intp)
            found = DistanceEngine().distances(proof.layout, placed, table, numbers, rows)
            assert found.min() > part.beyond_m


@every_arm
def test_verdicts_are_those_of_the_whole_scene(arm: Description) -> None:
    random = np.random.default_rng(11)
    verdicts: list[type] = []
    for _ in range(40):
        scene = free_wall(arm, random)
        start = scene.robots[A].q_rad
        path = JointPath(
            robot=A,
            segments=(PathSegment(waypoints_rad=(start, near_posture(arm, start, 0.25, random))),),
        )
        parts, wholes = (ConservativeAdvancement(s).certify(scene, path) for s in (PARTS, WHOLE))
        verdicts.append(type(parts))
        if isinstance(parts, Certificate) and isinstance(wholes, Certificate):
            assert parts.pairs == wholes.pairs
            assert parts.scene_revision == wholes.scene_revision == scene.revision()
            assert parts.closest_pair == wholes.closest_pair
            assert parts.closest_distance_m == pytest.approx(wholes.closest_distance_m, rel=0.05)
        else:
            assert parts == wholes
        checks = [CoalCollisionCheck(s) for s in (PARTS, WHOLE)]
        assert len({c.violations(scene, A, path.end_rad, {}) for c in checks}) == 1
        assert len({c.is_clear(scene, A, path.end_rad, {}, is_padded=True) for c in checks}) == 1
    assert len(set(verdicts)) == 2
    assert min(verdicts.count(kind) for kind in set(verdicts)) >= 3


@every_arm
def test_paths_and_second_opinions_are_those_of_the_whole_scene(arm: Description) -> None:
    random = np.random.default_rng(5)
    limits = JointLimits(
        velocity_rad_s=tuple(j.velocity_rad_s for j in arm.movable_joints),
        acceleration_rad_s2=(2.0,) * len(arm.movable_joints),
        jerk_rad_s3=(20.0,) * len(arm.movable_joints),
    )
    searched = 0
    for _ in range(8):
        scene = free_wall(arm, random)
        start = scene.robots[A].q_rad
        goal = near_posture(arm, start, 0.6, random)
        request = MotionRequest(robot=A, goal_rad=goal, max_nodes=60)
        both = [TwoTrees(s).plan(scene, request, seed=3) for s in (PARTS, WHOLE)]
        assert both[0] == both[1]
        searched += isinstance(both[0], tuple)
        path = JointPath(robot=A, segments=(PathSegment(waypoints_rad=(start, goal)),))
        timed = RuckigTimer().time(path, limits)
        seen = [MujocoCrossCheck(s).check(scene, timed) for s in (PARTS, WHOLE)]
        assert seen[0] == seen[1]
    assert searched >= 3


def test_a_certificate_never_claims_more_than_what_was_left_out_allows() -> None:
    """With nothing but far bodies, distances are told of the whole scene."""
    far = box("far", (0.2, 0.2, 0.2), Pose((9.0, 0.0, 1.0)))
    scene = SceneSnapshot(
        robots={A: RobotInScene(description=kr120(), world_T_base=Pose(), q_rad=(0.0,) * 6)},
        bodies={far.id: far},
    )
    turn = ((0.0, -1.9, 1.9, 0.0, 1.3, 0.0), (0.1, -1.9, 1.9, 0.0, 1.3, 0.0))
    path = JointPath(robot=A, segments=(PathSegment(waypoints_rad=turn),))
    assert PARTS.around(scene, {A: turn}).left_out == 1
    found, told = (ConservativeAdvancement(s).certify(scene, path) for s in (PARTS, WHOLE))
    assert isinstance(found, Certificate)
    assert isinstance(told, Certificate)
    assert found.closest_distance_m == told.closest_distance_m
    assert found.pairs == told.pairs
