"""Where a held piece can be laid down: buffer stations that are empty and within reach."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.pose import Pose, Vector, distance, rotation, translation
from sitewright.planning_twin.approach import Approaches
from sitewright.planning_twin.grasp_trial import grasp_trial, is_proven
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.tacking import Holding
from sitewright.planning_twin.task import Task, TwinContext
from sitewright.planning_twin.touches import set_down_touch
from sitewright.robot_team.waiting import home_opposite
from sitewright.symbolic_planning.site_view import PlaceId

_TAKEN_M = 0.3
_ROLLS: tuple[tuple[Vector, int, float], ...] = (
    ((0.0, 0.0, 1.0), 2, 0.0),
    ((0.0, 1.0, 0.0), 1, math.pi / 2.0),
    ((0.0, 0.0, -1.0), 2, math.pi),
    ((0.0, -1.0, 0.0), 1, -math.pi / 2.0),
)
"""Which way of a piece is up, the axis of it, and the roll about x that turns it up."""


def pose_on(world_T_surface: Pose, piece: PieceShape, world_T_piece: Pose) -> Pose:
    """Return the pose of a piece on a buffer's surface, along its x axis.

    Args:
        world_T_surface: Middle of the surface, z up.
        piece: What is laid down.
        world_T_piece: Where it was taken: the side that was up there stays up.
    """
    _, axis, roll_rad = max(_ROLLS, key=lambda r: world_T_piece.turn(r[0])[2])
    raised = world_T_surface @ translation(0.0, 0.0, piece.size_m[axis] / 2.0)
    return raised @ rotation((1.0, 0.0, 0.0), roll_rad)


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


def _pose(context: TwinContext, piece: ComponentId, surface: Pose) -> Pose:
    site = context.site
    return pose_on(surface, site.pieces[piece], site.world_T_piece[piece])


def _is_taken(context: TwinContext, surface: Pose, *, by_other_than: ComponentId) -> bool:
    return is_taken(context.site.world_T_piece, surface, by_other_than=by_other_than)


def is_taken(
    world_T_pieces: Mapping[ComponentId, Pose], surface: Pose, *, by_other_than: ComponentId
) -> bool:
    """Tell whether another piece lies on a buffer's surface."""
    return any(
        distance(pose.position_m, surface.position_m) < _TAKEN_M
        for piece, pose in world_T_pieces.items()
        if piece != by_other_than
    )


def _reaches(context: TwinContext, holding: Holding, surface: Pose) -> bool:
    robot = context.cell.robot_by_id[holding.robot]
    tool = context.tool_of(holding.robot)
    if tool is None:
        return False
    trial = grasp_trial(context, robot, tool, holding.piece, holding.grasp)
    touch = set_down_touch(
        _pose(context, holding.piece, surface),
        tool,
        holding.piece,
        holding.grasp,
        touches=tuple(BodyId(f) for f in context.cell.fixture_by_id),
    )
    near_rad = home_opposite(robot, touch.world_T_tip.position_m)
    found = Approaches(trial.carrying, touch, near_rad)
    return any(is_proven(trial.carrying, a.segments) for a in found)
