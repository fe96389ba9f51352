"""Which fasteners other robots reach while one holds the piece at its target."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from sitewright.foundation.ids import OperationId, RobotId
from sitewright.planning_twin.backends.reach.bench import Bench
from sitewright.planning_twin.backends.reach.clearance import Around
from sitewright.planning_twin.backends.reach.drivers import drivers
from sitewright.planning_twin.backends.reach.grasp_end import Hold
from sitewright.planning_twin.backends.reach.operatings import operating
from sitewright.planning_twin.backends.reach.surroundings import placed_parts
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.reachability.answer import Steadying
from sitewright.planning_twin.reachability.question import FOREVER, ReachTarget
from sitewright.planning_twin.tacking import is_enough, tacks_needed

_MOST_HOLDS = 6
"""So many ways to hold are looked at for each robot, spread over all kinds of grasps."""


def steadying(
    bench: Bench, target: ReachTarget, holds: Iterable[tuple[RobotId, Sequence[Hold]]]
) -> Steadying:
    """Look for a way to hold a piece in which enough of its fasteners can be driven."""
    needed = tacks_needed(target.task)
    best = Steadying(target=target.id, needed=needed, robot=None)
    looked = 0
    for robot, hold in _spread(holds):
        looked += 1
        done = _done_while(bench, target, robot, hold, needed)
        if best.robot is None or len(done) > len(best.done):
            best = Steadying(target=target.id, needed=needed, robot=robot, done=done)
        if is_enough(target.task, done):
            return Steadying(
                target=target.id,
                needed=needed,
                robot=robot,
                done=done,
                ways=looked,
                is_enough=True,
            )
    return Steadying(target=target.id, needed=needed, robot=best.robot, done=best.done, ways=looked)


def _spread(
    holds: Iterable[tuple[RobotId, Sequence[Hold]]],
) -> Iterator[tuple[RobotId, Hold]]:
    for robot, ways in holds:
        step = max(1, len(ways) // _MOST_HOLDS)
        for hold in ways[::step][:_MOST_HOLDS]:
            yield robot, hold


def _done_while(
    bench: Bench, target: ReachTarget, robot: RobotId, hold: Hold, needed: int
) -> tuple[OperationId, ...]:
    """Return the fasteners that others reach while a piece is held in one way."""
    around = _holder(hold)
    done: list[OperationId] = []
    for spot in sorted(_fasteners(target), key=lambda s: not s.needs_hold):
        if len(done) >= needed and not spot.needs_hold:
            break
        others = (arm for arm in drivers(bench, spot) if arm.robot.id != robot)
        if any(operating(bench, arm, target, spot, (around,)).ways for arm in others):
            done.append(spot.operation)
        elif spot.needs_hold:
            break
    return tuple(done)


def _fasteners(target: ReachTarget) -> list[Spot]:
    return [s for s in target.task.spots if s.fastener is not None]


def _holder(hold: Hold) -> Around:
    """Return the arm that holds, standing still; the piece stands at the target already."""
    load = hold.arm.load(hold.group.width_m)
    (frames,), moving = load.placed(hold.q[None]), load.moving
    still = placed_parts(
        list(zip(moving.names, moving.parts, frames, strict=True)),
        appears=np.zeros(len(moving.parts), dtype=np.intp),
        vanishes=np.full(len(moving.parts), FOREVER, dtype=np.intp),
        docked=("",) * len(moving.parts),
    )
    return Around(still, np.ones(len(moving.parts), dtype=np.bool_))
