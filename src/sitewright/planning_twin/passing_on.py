"""Whether robots could pass a piece on from where it lies to its target, by reach alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.holding import is_out_of_reach
from sitewright.planning_twin.setting_down import pose_on
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.cell import EndEffectorKind, Robot

_START, _TARGET = "where it is", "target"


def might_be_passed_on(context: TwinContext, piece: ComponentId) -> bool:
    """Tell whether a chain of robots and buffers may lead from a piece to its target.

    A robot may carry a piece from one place to another unless every grasp is proven out of
    reach at one of the two. Where this says no, no plan with any number of hand-overs exists.
    """
    reached = _reached_by_each(context, piece)
    known, waiting = {_START}, [_START]
    while waiting:
        here = waiting.pop()
        for places in reached:
            if here in places:
                waiting += places - known
                known |= places
    return _TARGET in known


def ways_by_buffers(
    context: TwinContext, piece: ComponentId, *, most: int
) -> Iterator[tuple[str, ...]]:
    """Yield the buffers on each way of a piece to its target that is not proven out of reach.

    Args:
        context: Engines, site and task.
        piece: Where it lies, or who holds it, is where the ways begin.
        most: So many buffers at most; ways over fewer of them come first.
    """
    reached = _reached_by_each(context, piece)
    ways: list[tuple[str, ...]] = [()]
    for _ in range(most):
        longer = [(*way, b) for way in ways for b in context.task.buffers if b not in way]
        ways = [w for w in longer if _is_linked(reached, *(_START, *w)[-2:])]
        yield from (w for w in ways if _is_linked(reached, w[-1], _TARGET))


def _is_linked(reached: list[set[str]], here: str, there: str) -> bool:
    """Tell whether some robot may carry a piece from one place to another."""
    return any(here in places and there in places for places in reached)


def _reached_by_each(context: TwinContext, piece: ComponentId) -> list[set[str]]:
    poses = _places(context, piece)
    return [_reached(context, r, piece, poses) for r in _handlers(context)]


def _places(context: TwinContext, piece: ComponentId) -> dict[str, Pose]:
    """Return where the piece may be on its way, besides in a gripper."""
    site, task = context.site, context.task
    lies = site.world_T_piece[piece]
    laid = {name: pose_on(at, site.pieces[piece], lies) for name, at in task.buffers.items()}
    return {**laid, _TARGET: task.world_T_target, _START: lies}


def _reached(
    context: TwinContext, robot: Robot, piece: ComponentId, poses: Mapping[str, Pose]
) -> set[str]:
    holder = _holder(context, piece)
    found: set[str] = set()
    for place, pose in poses.items():
        if place == _START and holder is not None:
            is_there = holder == robot.id
        else:
            is_there = not is_out_of_reach(context, robot, piece, pose)
        if is_there:
            found.add(place)
    return found


def _holder(context: TwinContext, piece: ComponentId) -> RobotId | None:
    arms = context.site.arms.items()
    return next((robot for robot, arm in arms if arm.held == piece), None)


def _handlers(context: TwinContext) -> list[Robot]:
    robots = context.cell.robot_by_id.values()
    tools = ((r, context.tool_of(r.id)) for r in robots)
    return [r for r, t in tools if t is not None and t.kind is EndEffectorKind.GRIPPER]
