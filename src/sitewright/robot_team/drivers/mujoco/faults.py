"""Faults on demand: real ones, made in the physics, never in a report.

Settings of ``[simulation]`` in the cell file (all off unless given):

    drop_after_s            a gripper loses its piece so long after it was gripped ...
    drop_after_m            ... or so far from where it was gripped ...
    drop_grip_number        ... but only this grip, counted from 1 (default: the next one)
    miss_shot_number        this fastener, counted from 1, leaves the tool at an angle ...
    miss_angle_deg          ... of so much (default 60)
    nudge_after_skills      after so many commands somebody moves a piece ...
    nudge_piece_number      ... this one, counted from 1 in order of id ...
    nudge_m                 ... by so much along the world's x (default 0.03)

Each happens once, also when the cell is started again.
"""

from __future__ import annotations

import math

from sitewright.robot_team.drivers.mujoco.fixings import Grip
from sitewright.robot_team.drivers.mujoco.params import pose_json
from sitewright.robot_team.drivers.mujoco.simulation import Simulation

_NUDGE_M = 0.03
_SETTLE_S = 0.3


def drop_when_due(sim: Simulation) -> None:
    """Open a gripper whose time or way has come; called after every time step."""
    settings = sim.cell.simulation
    after_s = settings.get("drop_after_s", 0.0)
    after_m = settings.get("drop_after_m", 0.0)
    if max(after_s, after_m) <= 0.0 or "drop" in sim.fixings.faults_done:
        return
    wanted = int(settings.get("drop_grip_number", 0))
    for robot, grip in sim.fixings.grips.items():
        is_late = 0.0 < after_s <= sim.time_s - grip.since_s
        if (is_late or 0.0 < after_m <= _way_m(sim, grip)) and wanted in (0, grip.number):
            sim.fixings = sim.fixings.fault_done("drop")
            sim.drop(robot, "fault on demand")
            return


def _way_m(sim: Simulation, grip: Grip) -> float:
    """Return how far a held piece is from where it was gripped, in a straight line."""
    return math.dist(sim.physics.pose(grip.piece).position_m, grip.taken_at_m)


def nudge_when_due(sim: Simulation, skills_done: int) -> None:
    """Move a piece as a passer-by would; called after every command."""
    settings = sim.cell.simulation
    due = int(settings.get("nudge_after_skills", 0))
    if due <= 0 or skills_done < due or "nudge" in sim.fixings.faults_done:
        return
    pieces = sorted(sim.contents.pieces)
    piece = pieces[int(settings.get("nudge_piece_number", 1)) - 1]
    sim.fixings = sim.fixings.fault_done("nudge")
    sim.push(piece, settings.get("nudge_m", _NUDGE_M))
    sim.advance(_SETTLE_S)
    sim.effect("nudged", piece=piece, world_T_piece=pose_json(sim.physics.pose(piece)))
