"""Which robots stand in something's way at home: also what is built or stored only later."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sitewright.planning_twin.backends.reach.bench import Bench
from sitewright.planning_twin.backends.reach.clearance import Around, Thresholds
from sitewright.planning_twin.backends.reach.load import Load
from sitewright.planning_twin.backends.reach.surroundings import Surroundings, placed_parts
from sitewright.planning_twin.reachability.answer import BlockedHome
from sitewright.planning_twin.reachability.question import FOREVER
from sitewright.planning_twin.scene import Pair
from sitewright.robot_team.cell import Robot
from sitewright.robot_team.description import Joints


def blocked_homes(bench: Bench) -> Iterator[BlockedHome]:
    """Yield each robot whose home is too near to anything, at whatever time that is there.

    So it is with a robot none of whose parking postures is clear.
    """
    robots = list(bench.cell.robot_by_id.values())
    loads = {r.id: load for r in robots if (load := _load(bench, r)) is not None}
    mounted = {r.mounted for r in robots if r.mounted is not None}
    docked = {*bench.cell.end_effector_by_id} - mounted
    homes = {r.id: _standing(loads[r.id], r) for r in robots if r.id in loads}
    for robot in robots:
        if robot.id not in loads:
            continue
        around = [Around(bench.still, bench.still.lying(docked))]
        around += [
            Around(home, np.ones(len(home.parts), dtype=np.bool_))
            for other, home in homes.items()
            if other != robot.id
        ]
        load = loads[robot.id]
        pairs = _too_near(bench, load, robot.home_q_rad, around)
        parked = [_too_near(bench, load, q_rad, around) for q_rad in robot.parking_q_rad]
        if pairs or all(parked):
            yield BlockedHome(robot=robot.id, pairs=pairs or min(parked, key=len))


def _too_near(bench: Bench, load: Load, q_rad: Joints, around: list[Around]) -> tuple[Pair, ...]:
    q, hand = np.array([q_rad]), load.hand()
    tips = load.world_T_base @ load.arm.chain.tips(q)
    thresholds = Thresholds(clearance_m=bench.cell.clearance_m)
    shares = ((load.moving, load.placed(q)), (hand.moving, hand.placed(tips)))
    found = (
        bench.engines.clearance.too_near(moving, placed, around, thresholds)
        for moving, placed in shares
    )
    return tuple(pair for ((*pairs,),) in found for pair in pairs)


def _load(bench: Bench, robot: Robot) -> Load | None:
    if robot.mounted is None:
        return None
    tool = bench.cell.end_effector_by_id[robot.mounted]
    return bench.arm(robot, tool).load(tool.opens_to_m)


def _standing(load: Load, robot: Robot) -> Surroundings:
    """Return a robot at home as something that stands still."""
    (frames,), moving = load.placed(np.array([robot.home_q_rad])), load.moving
    return placed_parts(
        list(zip(moving.names, moving.parts, frames, strict=True)),
        appears=np.zeros(len(moving.parts), dtype=np.intp),
        vanishes=np.full(len(moving.parts), FOREVER, dtype=np.intp),
        docked=("",) * len(moving.parts),
    )
