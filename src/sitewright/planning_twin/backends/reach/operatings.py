"""Who can drive a fastener or paint a face of a placed target, and with which lean of the tool."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np

from sitewright.foundation.pose import subtract
from sitewright.planning_twin.approach import Touch
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.reach.bench import ArmBench, Bench
from sitewright.planning_twin.backends.reach.clearance import Around, Thresholds
from sitewright.planning_twin.backends.reach.end_record import EndRecord
from sitewright.planning_twin.backends.reach.ends import End
from sitewright.planning_twin.backends.reach.stage import Stage, Way
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.reachability.answer import Operating, Refused
from sitewright.planning_twin.reachability.question import ReachTarget
from sitewright.planning_twin.skill_motions.finish import first_touches, stroke_points
from sitewright.planning_twin.touches import spot_touch


def operating(
    bench: Bench,
    arm: ArmBench,
    target: ReachTarget,
    spot: Spot,
    beside: Sequence[Around] = (),
) -> Operating:
    """Try the leans of a tool at an operation, the smallest first, until some serve.

    Args:
        bench: The cell.
        arm: Robot and tool.
        target: What the operation is on; it stands in its place.
        spot: The operation.
        beside: What stands there besides, e.g. a robot that holds the target.
    """
    record = EndRecord()
    around = (Around(bench.still, _standing(bench, arm, target)), *beside)
    ways: tuple[str, ...] = ()
    for touches in _rings(arm, target, spot):
        ways = tuple(_serving(bench, arm, spot, touches, around, record))
        if ways:
            break
    return Operating(
        robot=arm.robot.id,
        end_effector=arm.tool.id,
        target=target.id,
        operation=spot.operation,
        ways=ways,
        refused=None if ways else Refused(where=spot.operation, refusal=record.refusal()),
    )


def _rings(arm: ArmBench, target: ReachTarget, spot: Spot) -> Iterator[list[Touch]]:
    """Yield tool poses in contact, those of one tilt together."""
    if spot.patch is not None:
        yield list(first_touches(spot, arm.tool, target.id))
        return
    poses = tool_poses(spot, arm.tool, has_yaw=False)
    for _, ring in groupby(poses, key=lambda p: p.label.split(" about")[0]):
        yield [spot_touch(arm.tool, target.id, pose) for pose in ring]


def _serving(
    bench: Bench,
    arm: ArmBench,
    spot: Spot,
    touches: list[Touch],
    around: Sequence[Around],
    record: EndRecord,
) -> Iterator[str]:
    """Yield the labels of the touches that have a clear posture all along their strokes."""
    starts = np.array([matrix_of(t.world_T_tip) for t in touches])
    back_m = np.array([t.back_off for t in touches]) * touches[0].distance_m
    rows = arm.postures(starts)
    record.note(rows)
    end = End(
        arm=arm,
        load=arm.load(0.0),
        around=around,
        contact=Thresholds(clearance_m=bench.cell.clearance_m, declared_m=touches[0].near_m),
        free=Thresholds(clearance_m=bench.cell.clearance_m),
        blame=record.blame,
    )
    stage = Stage(end, (Way(0, back_m),))
    has_room = stage.hand_serves(starts)
    rows = rows.only(has_room[rows.pose])
    rows = rows.only(stage.in_contact(rows))
    serves = rows.only(stage.way_of(rows, starts) >= 0).has()
    for shift_m in _strokes(spot):
        serves &= _clear_at(end, starts, shift_m)
    for touch, is_serving in zip(touches, serves, strict=True):
        if is_serving:
            yield touch.label


def _strokes(spot: Spot) -> Iterator[Array]:
    """Yield the shifts from the first corner of a finish's strokes to the others."""
    if spot.patch is None:
        return
    first, *others = (spot.world_T_operation.turn(p) for p in stroke_points(spot))
    for other in others:
        yield np.array(subtract(other, first))


def _clear_at(end: End, starts: Array, shift_m: Array) -> Flags:
    shifted = starts.copy()
    shifted[:, :3, 3] += shift_m
    rows = end.arm.postures(shifted)
    return rows.only(end.clear(rows)).has() & end.hand_clear(shifted)


def _standing(bench: Bench, arm: ArmBench, target: ReachTarget) -> Flags:
    """Return what is there while the target stands and its piece is no stock any more."""
    there = bench.there(target.number, arm).copy()
    for piece in target.task.candidates[:1]:
        there[bench.still.rows(piece)] = False
    there[bench.still.rows(target.id)] = True
    return there
