"""The straight ways of a tip that the path search takes."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from motion_scenes import HOME, A, kr120, one_arm
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.two_trees import TwoTrees
from sitewright.planning_twin.motion import MotionRequest
from sitewright.planning_twin.refusal import BlockedBy
from sitewright.robot_team.kinematics import tip_pose

GOAL = (HOME[0] + 0.4, *HOME[1:])


@pytest.mark.parametrize("direction", [(0.0, 0.0, 1.0), (0.0, 0.6, -0.8), (-0.6, 0.8, 0.0)])
def test_the_tip_stays_on_its_line_and_does_not_turn(direction: tuple[float, ...]) -> None:
    question = TwoTrees(ProofScenes()).asked(one_arm(), MotionRequest(robot=A, goal_rad=GOAL))
    assert not isinstance(question, BlockedBy)
    way = np.array(direction)
    found = [np.array(HOME), *question.space.straight(0, np.array(HOME), way, 0.36)]
    assert len(found) == 19
    start = tip_pose(kr120(), HOME)
    halves = [(a + b) / 2.0 for a, b in pairwise(found)]
    for q in (*found, *halves):
        tip = tip_pose(kr120(), tuple(q.tolist()))
        shift = np.subtract(tip.position_m, start.position_m)
        assert np.linalg.norm(shift - (shift @ way) * way) < 0.0003
        assert tip.angle_to_rad(start) < 0.0005
    assert shift @ way == pytest.approx(0.35, abs=0.02)
