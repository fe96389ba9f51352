"""What is planned was never called impossible by the reach check, also in cells laid out badly."""

from __future__ import annotations

from dataclasses import replace

import pytest

from builders_planning import EXAMPLES
from builders_reach import checked, contradictions, missed
from sitewright.app.planning import plan_project
from sitewright.app.project import Project, read_project
from sitewright.building_model.component import Layer
from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import translation
from sitewright.planning_twin.reachability.verdict import Standing


def moved(robot: str, x_m: float, y_m: float) -> Project:
    """Return the wooden frame with a robot, and its station, somewhere else."""
    project = read_project(EXAMPLES / "wooden_frame")
    cell, shift = project.cell, translation(x_m, y_m, 0.0)
    arm = cell.robot_by_id[RobotId(robot)]
    stations = {
        i: replace(s, world_T_station=shift @ s.world_T_station)
        if s.robot == robot and s.kind == "preparation"
        else s
        for i, s in cell.station_by_id.items()
    }
    arms = {**cell.robot_by_id, arm.id: replace(arm, world_T_base=shift @ arm.world_T_base)}
    return replace(project, cell=replace(cell, robot_by_id=arms, station_by_id=stations))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("robot", "x_m", "y_m", "buildable"),
    [("kr120-a", 0.0, 0.0, 5), ("kr120-a", -0.5, 0.0, 1), ("kr120-b", 0.5, 0.0, 2)],
)
def test_check_and_plan_agree_on_what_can_be_built(
    robot: str, x_m: float, y_m: float, buildable: int
) -> None:
    project = moved(robot, x_m, y_m)
    reach, plan = checked(project), plan_project(project)
    assert contradictions(reach, plan) == []
    assert missed(reach, plan) == []
    can = {v.target for v in reach.verdicts if v.standing is Standing.BUILDABLE}
    assert can == {p.proposal.target for p in plan.planned}
    assert len(can) == buildable


@pytest.mark.parametrize("is_stock_heavy", [True, False])
def test_check_and_plan_weigh_the_piece_that_is_lifted(is_stock_heavy: bool) -> None:  # noqa: FBT001
    """Not what the design says of the target, which may be of another material."""
    project = read_project(EXAMPLES / "wooden_frame")
    heavy = Layer.MATERIAL if is_stock_heavy else Layer.TARGET
    components = {
        i: replace(c, mass_kg=500.0 if c.layer is heavy else 10.0)
        for i, c in project.model.component_by_id.items()
    }
    project = replace(project, model=replace(project.model, component_by_id=components))
    reach, plan = checked(project), plan_project(project, target="support-1")
    (verdict,) = (v for v in reach.verdicts if v.target == "support-1")
    assert (verdict.standing is Standing.IMPOSSIBLE) is is_stock_heavy
    assert any("the arm carries" in reason for reason in verdict.reasons) is is_stock_heavy
    assert any(e.target == "support-1" and e.is_proven for e in plan.escalated) is is_stock_heavy
