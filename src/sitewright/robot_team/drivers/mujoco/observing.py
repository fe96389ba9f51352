"""What the cell's sensors say: the only way for the controller to learn poses."""

from __future__ import annotations

import numpy as np

from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId, StationId
from sitewright.foundation.pose import Pose, from_axis_angle
from sitewright.robot_team.driver import Observation, RobotObservation
from sitewright.robot_team.drivers.mujoco.simulation import Simulation


def observe(sim: Simulation) -> Observation:
    """Return all robots and pieces as sensed at the present instant.

    Poses carry seeded noise if the cell's ``[simulation]`` asks for it (``noise_m``,
    ``noise_rad``: standard deviations); the same instant gives the same reading.
    """
    sim.physics.refresh()
    settings = sim.cell.simulation
    shift_m, turn_rad = settings.get("noise_m", 0.0), settings.get("noise_rad", 0.0)
    random = np.random.default_rng((int(settings.get("seed", 0)), round(sim.time_s * 1e6)))
    world_T_piece: dict[ComponentId, Pose] = {}
    for piece in sim.contents.pieces:
        draw = random.normal(size=7)
        world_T_piece[piece] = _noisy(sim.physics.pose(piece), draw.tolist(), shift_m, turn_rad)
    return Observation(
        time_s=sim.time_s,
        robots={robot: _robot(sim, robot) for robot in sim.cell.robot_by_id},
        world_T_piece=world_T_piece,
        fasteners=sim.fixings.fasteners,
        coverage=dict(sim.fixings.coverage),
        docked={tool: _station(sim, tool) for tool in sim.fixings.world_T_docked},
    )


def _station(sim: Simulation, tool: EndEffectorId) -> StationId:
    station = sim.cell.end_effector_by_id[tool].station
    if station is None:
        raise ValueError(f"end effector {tool} is docked but has no station")
    return station


def _robot(sim: Simulation, robot: RobotId) -> RobotObservation:
    span, gripper = sim.arms.span[robot], sim.gripper_of(robot)
    return RobotObservation(
        q_rad=tuple(sim.physics.d.qpos[sim.arms.positions[span]].tolist()),
        velocity_rad_s=tuple(sim.physics.d.qvel[sim.arms.speeds[span]].tolist()),
        mounted=sim.fixings.mounted.get(robot),
        aperture_m=0.0 if gripper is None else sim.aperture_m(gripper),
        gripped=sim.gripped(robot),
    )


def _noisy(pose: Pose, draw: list[float], shift_m: float, turn_rad: float) -> Pose:
    if shift_m == 0.0 and turn_rad == 0.0:
        return pose
    x, y, z = (p + shift_m * v for p, v in zip(pose.position_m, draw[:3], strict=True))
    turn = Pose(quaternion_wxyz=from_axis_angle((draw[3], draw[4], draw[5]), turn_rad * draw[6]))
    return Pose((x, y, z), (pose @ turn).quaternion_wxyz)
