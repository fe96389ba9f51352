"""Where a held piece can be laid down: buffer stations that are empty and within reach."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.pose import Pose, distance, translation
from sitewright.planning_twin.approach import Approaches
from sitewright.planning_twin.grasp_trial import grasp_trial, is_proven
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.tacking import Holding
from sitewright.planning_twin.task import Task, TwinContext
from sitewright.planning_twin.touches import set_down_touch
from sitewright.symbolic_planning.site_view import PlaceId

_TAKEN_M = 0.3


def pose_on(world_T_surface: Pose, piece: PieceShape) -> Pose:
    """Return the pose of a piece that lies on a buffer's surface, along its x axis."""
    return world_T_surface @ translation(0.0, 0.0, piece.size_m[2] / 2.0)


def lying_on_fixtures(context: TwinContext, piece: ComponentId) -> Task:
    """Return the task with a piece that lies on a buffer, which is some fixture of the cell."""
    fixtures = tuple(BodyId(f) for f in context.cell.fixture_by_id)
    return replace(context.task, lies_on={**context.task.lies_on, piece: fixtures})


def places_to_set_down(
    context: TwinContext, holdings: Iterable[Holding]
) -> Iterator[tuple[RobotId, ComponentId, PlaceId]]:
    """Yield which robot can lay which piece on which buffer with the grasp that it uses."""
    for holding in holdings:
        for place, surface in context.task.buffers.items():
            is_free = not _is_taken(context, surface, by_other_than=holding.piece)
            if is_free and _reaches(context, holding, surface):
                yield holding.robot, holding.piece, place


def _is_taken(context: TwinContext, surface: Pose, *, by_other_than: ComponentId) -> bool:
    return any(
        distance(pose.position_m, surface.position_m) < _TAKEN_M
        for piece, pose in context.site.world_T_piece.items()
        if piece != by_other_than
    )


def _reaches(context: TwinContext, holding: Holding, surface: Pose) -> bool:
    robot = context.cell.robot_by_id[holding.robot]
    tool = context.tool_of(holding.robot)
    if tool is None:
        return False
    trial = grasp_trial(context, robot, tool, holding.piece, holding.grasp)
    touch = set_down_touch(
        pose_on(surface, context.site.pieces[holding.piece]),
        tool,
        holding.piece,
        holding.grasp,
        touches=tuple(BodyId(f) for f in context.cell.fixture_by_id),
    )
    found = Approaches(trial.carrying, touch, robot.home_q_rad)
    return any(is_proven(trial.carrying, a.segments) for a in found)
