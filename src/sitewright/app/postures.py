"""Looks at load whether home and parking postures are clear of everything and of each other."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.errors import Problem
from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId, StationId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.jobsite import ArmState, Jobsite, scene_of
from sitewright.planning_twin.motion import CollisionCheck
from sitewright.robot_team.cell import Cell, Robot

Obstacles = dict[ComponentId, tuple[Shape, Pose]]
_CODE = "Q7"


def posture_problems(
    cell: Cell, obstacles: Obstacles, collision: CollisionCheck
) -> Iterator[Problem]:
    """Yield each home or parking posture that is too near to something.

    A home posture is an error: the robot starts there. A parking posture is a warning: the
    planner takes another one.

    Args:
        cell: Robots with their start tools, fixtures, zones, docked tools.
        obstacles: Virtual collision volumes of the building, in the world.
        collision: Exact distances against the cell's clearance.
    """
    site = _at_home(cell, obstacles)
    scene = scene_of(site)
    for robot in cell.robot_by_id.values():
        for name, severity, q_rad in _postures(robot):
            pairs = collision.violations(scene, robot.id, q_rad, {})
            if pairs:
                listed = ", ".join(f"{a} and {b}" for a, b in pairs[:3])
                yield Problem(
                    code=_CODE,
                    severity=severity,
                    where=robot.id,
                    message=f"{name} is nearer than {cell.clearance_m * 1000:.0f} mm: {listed}.",
                    fix="Change the posture, the base or what stands there in cell.toml.",
                )


def _postures(robot: Robot) -> Iterator[tuple[str, str, tuple[float, ...]]]:
    yield "home_q_deg", "E", robot.home_q_rad
    for number, q_rad in enumerate(robot.parking_q_rad, start=1):
        yield f"parking_q_deg {number}", "W", q_rad


def _at_home(cell: Cell, obstacles: Obstacles) -> Jobsite:
    arms = {
        RobotId(r.id): ArmState(
            q_rad=r.home_q_rad, mounted=r.mounted, aperture_m=_opening(cell, r.mounted)
        )
        for r in cell.robot_by_id.values()
    }
    mounted = {r.mounted for r in cell.robot_by_id.values()}
    docked = {
        e.id: StationId(e.station)
        for e in cell.end_effector_by_id.values()
        if e.station is not None and e.id not in mounted
    }
    return Jobsite(
        cell=cell, pieces={}, world_T_piece={}, arms=arms, docked=docked, obstacles=obstacles
    )


def _opening(cell: Cell, mounted: EndEffectorId | None) -> float:
    return 0.0 if mounted is None else cell.end_effector_by_id[mounted].opens_to_m
