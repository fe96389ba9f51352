"""What a refusal claims is true: by iteration, by arithmetic, and by trying all cases."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain as chained
from itertools import combinations

import numpy as np
import pytest

from builders_planning import EXAMPLES
from motion_scenes import HOME, A, box, gripper, kr120, one_arm
from sitewright.app.engines import proposals_of
from sitewright.app.planning import start_of
from sitewright.app.project import open_project
from sitewright.central_controller.situation import task_of
from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.planning_twin.approach import Approaches, Reaching, Touch
from sitewright.planning_twin.backends.kinematic_chain import chain_of
from sitewright.planning_twin.backends.numeric_kinematics import NumericSolver
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.backends.twin import make_backends
from sitewright.planning_twin.holding import find_holding
from sitewright.planning_twin.refusal import BlockedBy, NoIk, PayloadExceeded
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.planning_twin.task import TwinContext

PIECE, KR_A = ComponentId("thick.3"), RobotId("kr120-a")
_WRIST_TO_TIP_M = 0.215
"""Of the KR 120 R2500 pro, along the tip's z axis."""


def random_pose(rng: np.random.Generator) -> Pose:
    """A tip pose anywhere within 3.4 m, looking anywhere."""
    direction, axis = (v / np.linalg.norm(v) for v in rng.normal(size=(2, 3)))
    x, y, z = (float(v) for v in direction * rng.uniform(0.3, 3.4) + (0.0, 0.0, 0.7))
    turn = rotation(tuple(float(v) for v in axis), float(rng.uniform(0.0, math.pi)))  # type: ignore[arg-type]
    return translation(x, y, z) @ turn


def test_what_is_proven_out_of_reach_is_found_by_no_iteration() -> None:
    """Two independent solvers: all branches in closed form, and 96 seeded starts."""
    closed, iterated = OpwKinematics(), NumericSolver(chain_of(kr120()))
    rng, proven, reached = np.random.default_rng(7), 0, 0
    for _ in range(50):
        pose = random_pose(rng)
        exact = closed.solve(kr120(), pose, HOME)
        found = iterated.postures(np.array(pose.matrix()), np.array(HOME))
        if isinstance(exact, NoIk) and exact.is_proven:
            proven += 1
            assert isinstance(found, NoIk), pose
        if not isinstance(found, NoIk):
            reached += 1
            assert not isinstance(exact, NoIk), pose
    assert proven > 10
    assert reached > 10


def test_no_posture_brings_the_wrist_nearer_than_a_proof_says() -> None:
    """The wrist stands at a fixed place behind the tip; 40,000 postures show where it gets."""
    arm, rng = chain_of(kr120()), np.random.default_rng(11)
    q = np.zeros((40_000, 6))
    q[:, :3] = rng.uniform(arm.lower[:3], arm.upper[:3], (len(q), 3))
    wrists = _wrist_of(arm.tips(q))
    closed, told = OpwKinematics(), []
    for _ in range(80):
        pose = random_pose(rng)
        refusal = closed.solve(kr120(), pose, HOME)
        if isinstance(refusal, NoIk) and refusal.extension_m > 0.0:
            wanted = _wrist_of(np.array(pose.matrix())[None])[0]
            lacking_m = float(np.linalg.norm(wrists - wanted, axis=1).min())
            assert refusal.is_proven
            assert lacking_m >= refusal.extension_m - 1e-6
            told.append(refusal.extension_m / lacking_m)
    assert len(told) > 20
    assert max(told) > 0.9, "the bound is nearly met somewhere"


def _wrist_of(base_T_tips: np.ndarray) -> np.ndarray:
    return np.asarray(base_T_tips[:, :3, 3] - _WRIST_TO_TIP_M * base_T_tips[:, :3, 2])


@pytest.mark.parametrize("over_kg", [-0.001, 0.001])
def test_a_piece_is_too_heavy_exactly_above_what_arm_and_gripper_leave(over_kg: float) -> None:
    context = first_support()
    robot = context.cell.robot_by_id[KR_A]
    tool = context.tool_of(KR_A)
    assert tool is not None
    left_kg = robot.description.payload_kg - sum(link.mass_kg for link in tool.description.links)
    pieces = context.site.pieces
    heavy = replace(pieces[PIECE], mass_kg=left_kg + over_kg)
    site = replace(context.site, pieces={**pieces, PIECE: heavy})
    found = find_holding(replace(context, site=site), robot, PIECE)
    assert isinstance(found, PayloadExceeded) is (over_kg > 0.0)
    if isinstance(found, PayloadExceeded):
        assert found.mass_kg - found.payload_kg == pytest.approx(over_kg)


def first_support() -> TwinContext:
    project = open_project(EXAMPLES / "wooden_frame")
    proposals, context = proposals_of(project), start_of(project)
    target = ComponentId("support-1")
    task = task_of(proposals.design, proposals.graph_of(context), context, target, (PIECE,))
    return TwinContext(
        backends=proposals.ports.backends, site=proposals.surveyor.jobsite(context), task=task
    )


BACKENDS = make_backends()
TOUCH = Touch(
    world_T_tip=translation(1.6, 0.1, 0.9) @ rotation((0.0, 1.0, 0.0), math.pi),
    back_off=(0.0, 0.0, 1.0),
)


def cluttered(rng: np.random.Generator) -> SceneSnapshot:
    """An arm with an open gripper, and four boxes around the place that it is to reach."""
    x, y, z = TOUCH.world_T_tip.position_m
    boxes = []
    for n in range(4):
        dx, dy, dz = (float(v) for v in rng.uniform(-0.45, 0.45, 3))
        size = tuple(float(v) for v in rng.uniform(0.05, 0.5, 3))
        boxes.append(box(f"box-{n}", size, translation(x + dx, y + dy, z + dz)))  # type: ignore[arg-type]
    return one_arm(*boxes, *gripper(A))


def has_approach(scene: SceneSnapshot) -> bool:
    reaching = Reaching(backends=BACKENDS, scene=scene, robot=A)
    return next(iter(Approaches(reaching, TOUCH, HOME)), None) is not None


def subsets(names: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    return chained.from_iterable(combinations(names, n) for n in range(len(names) + 1))


def test_removals_are_all_the_smallest_sets_that_make_room_and_no_others() -> None:
    """Every subset of the bodies is taken away, and the approach looked for again."""
    rng, several, blocked = np.random.default_rng(5), 0, 0
    for _ in range(14):
        scene = cluttered(rng)
        search = Approaches(Reaching(backends=BACKENDS, scene=scene, robot=A), TOUCH, HOME)
        if next(iter(search), None) is not None:
            continue
        why = search.why_not()
        assert isinstance(why, BlockedBy)
        names = tuple(sorted(i for i in scene.bodies if i.startswith("box")))
        freeing = [
            frozenset(gone)
            for gone in subsets(names)
            if has_approach(scene.without(*(BodyId(g) for g in gone)))
        ]
        smallest = {s for s in freeing if not any(other < s for other in freeing)}
        assert {frozenset(r) for r in why.removals} == smallest
        blocked += 1
        several += any(len(s) > 1 for s in smallest)
    assert blocked >= 6
    assert several >= 2
