from __future__ import annotations

import math
from itertools import pairwise

import pytest

from builders_planning import EXAMPLES, B
from sitewright.app.planning import PlanReport, plan_project
from sitewright.app.project import Project, open_project
from sitewright.central_controller.proposal import ProposedStep
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.robot_team.gripper import mount_T_tcp
from sitewright.robot_team.skill import Skill

SPEED_M_S, STANDOFF_M = 0.15, 0.12


@pytest.fixture(scope="module")
def project() -> Project:
    return open_project(EXAMPLES / "painted_frame")


@pytest.fixture(scope="module")
def report(project: Project) -> PlanReport:
    return plan_project(project)


def steps(report: PlanReport, skill: str) -> list[ProposedStep]:
    return [s for p in report.planned for s in p.proposal.steps if s.call.skill == skill]


def test_all_targets_are_planned_in_the_order_of_the_design(report: PlanReport) -> None:
    assert [p.proposal.target for p in report.planned] == ["support-1", "support-2", "stud-1"]
    assert (report.targets_planned, report.targets_total) == (3, 3)
    assert (report.escalated, report.waiting) == ((), ())
    assert report.timing_s["total"] == pytest.approx(
        sum(p.timing_s["total"] for p in report.planned)
    )


def test_tools_are_changed_for_the_screws_and_then_for_the_paint(report: PlanReport) -> None:
    changes = [s.call.arguments for s in steps(report, Skill.CHANGE_END_EFFECTOR)]
    assert changes == [
        ("nail-gun", "screwdriver", "tools-b"),
        ("screwdriver", "paint-head", "tools-b"),
    ]
    calls = [s.call.skill for s in report.planned[-1].proposal.steps]
    last_screw = max(k for k, c in enumerate(calls) if c == Skill.FASTEN)
    assert last_screw < calls.index(Skill.APPLY_FINISH)


def test_a_tool_change_docks_and_takes_in_the_scene_between_its_motions(
    report: PlanReport,
) -> None:
    for step in steps(report, Skill.CHANGE_END_EFFECTOR):
        old, new = step.call.arguments[:2]
        edited = [set(m.scene_edits) for m in step.motions]
        assert edited == [{old}, {new}, set()]


def test_the_paint_head_never_moves_faster_than_the_process_and_keeps_its_distance(
    report: PlanReport, project: Project
) -> None:
    (step,) = steps(report, Skill.APPLY_FINISH)
    (motion,) = step.motions
    robot, kinematics = project.cell.robot_by_id[B], OpwKinematics()
    tool = next(e for i, e in project.cell.end_effector_by_id.items() if i == "paint-head")
    tip_T_tcp, trajectory = mount_T_tcp(tool.description), motion.timed.trajectory
    count = 3000
    step_s = trajectory.duration_s / count
    postures = [trajectory.at(k * step_s)[0] for k in range(count + 1)]
    points = [
        (robot.world_T_base @ kinematics.tip(robot.description, q) @ tip_T_tcp).position_m
        for q in postures
    ]
    speeds = [math.dist(a, b) / step_s for a, b in pairwise(points)]
    assert max(speeds) <= SPEED_M_S
    assert max(speeds) > SPEED_M_S / 2
    face_m = 0.40 + 0.16 + 0.02
    assert all(p[2] == pytest.approx(face_m + STANDOFF_M, abs=0.001) for p in points)
