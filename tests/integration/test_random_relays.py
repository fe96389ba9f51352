"""Random cells of two arms, a stack, a buffer and a target: every plan and every proof holds."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from builders_relay import Relay
from sitewright.app.engines import proposals_of
from sitewright.app.planning import start_of
from sitewright.app.project import Project, open_project
from sitewright.central_controller.ports import Escalation, Planned
from sitewright.central_controller.rehearsal import built
from sitewright.errors import SitewrightError
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.grasps import Grasp, grasps_of
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.setting_down import pose_on
from sitewright.robot_team.cell import Robot

PIECE, TARGET = ComponentId("thick.3"), ComponentId("support-1")
_CELLS = 10


def relay(rng: np.random.Generator) -> Relay:
    """Stack, buffer and target side by side, and two arms somewhere between."""
    stock_x, gap_1, gap_2 = -4.0, *rng.uniform(1.2, 3.4, 2)
    middle_x = stock_x + gap_1
    target_x = middle_x + gap_2
    a, b = sorted(rng.uniform(stock_x, target_x, 2))
    return Relay(
        arms=(("a", round(float(a), 3), 1.9), ("b", round(float(b), 3), -1.9)),
        stock_x=stock_x,
        target_x=round(float(target_x), 3),
        buffers=((round(float(middle_x), 3), 0.0),),
        is_across=True,
    )


def opened(folder: Path, relay_: Relay) -> Project | None:
    """Return the project, or None if an arm stands in something."""
    try:
        return open_project(relay_.write(folder))
    except SitewrightError:
        return None


class Reachable:
    """Which grasps bring which arm to a pose of the piece, by kinematics alone."""

    def __init__(self, project: Project) -> None:
        self.cell = project.cell
        proposals, context = proposals_of(project), start_of(project)
        self.kinematics = proposals.ports.backends.kinematics
        self.lies = context.observation.world_T_piece[PIECE]
        self.shape = proposals.shapes[PIECE]
        (buffer,) = (s for s in self.cell.station_by_id.values() if s.kind == "buffer")
        self.laid = pose_on(buffer.world_T_station, self.shape, self.lies)
        self.placed = proposals.design.world_T_target(TARGET)

    def grasps(self, robot: Robot, *poses: Pose) -> list[Grasp]:
        """Return the grasps with which an arm gets to all of some poses."""
        tool = self.cell.end_effector_by_id[robot.end_effectors[0]]
        found = grasps_of(self.shape, tool, self.lies)
        return [g for g in found if all(self._reaches(robot, g, p) for p in poses)]

    def _reaches(self, robot: Robot, grasp: Grasp, world_T_piece: Pose) -> bool:
        tool = self.cell.end_effector_by_id[robot.end_effectors[0]]
        tip = robot.world_T_base.inverse() @ world_T_piece @ grasp.tip_T_piece(tool).inverse()
        found = self.kinematics.solve(robot.description, tip, robot.home_q_rad)
        return not isinstance(found, NoIk)

    def is_possible(self) -> bool:
        """Tell whether an arm has a grasp for both ends, directly or by way of the buffer."""
        robots = list(self.cell.robot_by_id.values())
        directly = any(self.grasps(r, self.lies, self.placed) for r in robots)
        onto = any(self.grasps(r, self.lies, self.laid) for r in robots)
        from_there = any(self.grasps(r, self.laid, self.placed) for r in robots)
        return directly or (onto and from_there)

    def has_chain(self) -> bool:
        """Tell whether an arm gets to both ends with any grasp, directly or by the buffer."""
        robots = self.cell.robot_by_id.values()
        places = (self.lies, self.laid, self.placed)
        ends = [tuple(bool(self.grasps(r, p)) for p in places) for r in robots]
        directly = any(stock and target for stock, _, target in ends)
        onto = any(stock and buffer for stock, buffer, _ in ends)
        from_there = any(buffer and target for _, buffer, target in ends)
        return directly or (onto and from_there)


@pytest.mark.slow
def test_every_random_cell_is_planned_or_refused_truly(tmp_path: Path) -> None:
    rng, seen = np.random.default_rng(3), Counter[str]()
    for n in range(_CELLS):
        project = opened(tmp_path / str(n), relay(rng))
        if project is None:
            seen["invalid"] += 1
            continue
        proposals, context = proposals_of(project), start_of(project)
        outcome = proposals.propose(context)
        if isinstance(outcome, Planned):
            steps = outcome.proposal.steps
            after = built(context, steps, TARGET)
            assert after.observation.world_T_piece[PIECE] == proposals.design.world_T_target(TARGET)
            assert all(m.certificate.closest_distance_m >= 0.010 for s in steps for m in s.motions)
            is_laid = any(s.call.skill == "set-down" for s in steps)
            seen["by way of the buffer" if is_laid else "directly"] += 1
            assert Reachable(project).is_possible()
        else:
            assert isinstance(outcome, Escalation)
            seen[outcome.verdict] += 1
            assert outcome.is_proven is not Reachable(project).has_chain()
    assert seen["directly"]
    assert seen["by way of the buffer"]
    assert seen["proven impossible"]
    assert seen.total() == _CELLS
