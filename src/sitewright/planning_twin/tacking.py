"""Which fasteners can be driven while the piece is still held."""

from __future__ import annotations

from dataclasses import dataclass, replace

from sitewright.foundation.ids import ComponentId, OperationId, RobotId
from sitewright.planning_twin.approach import Reaching, approaches
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.grasps import Grasp
from sitewright.planning_twin.jobsite import Jobsite, scene_of, tool_for, with_tool
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.touches import spot_touch
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.description import Joints


@dataclass(frozen=True, slots=True, kw_only=True)
class Holding:
    """How one robot takes one piece, places it and holds it.

    Attributes:
        hold_rad: Posture while the piece stands at its target and is held.
        pick_rad: Posture in which it is taken; None if it is in hand already.
        rank: Place of the grasp among the candidates, to go on searching from there.
        insertion: Number of the task's insertion that is used.
        tacks: Fasteners that a finisher can drive meanwhile, in order.
    """

    robot: RobotId
    piece: ComponentId
    grasp: Grasp
    hold_rad: Joints
    pick_rad: Joints | None = None
    rank: int = 0
    insertion: int = 0
    tacks: tuple[OperationId, ...] = ()


def with_tacks(context: TwinContext, holding: Holding, gripper: EndEffector) -> Holding:
    """Return the holding with the fasteners that can be driven during it."""
    return replace(holding, tacks=drivable_while_held(context, holding, gripper))


def drivable_while_held(
    context: TwinContext, holding: Holding, gripper: EndEffector
) -> tuple[OperationId, ...]:
    """Return the fasteners that some other robot can drive while this one holds the piece.

    Those that must be driven while it is held come first; then as many as have to be.
    """
    task = context.task
    if task.hold_until == 0:
        return ()
    forced = [s for s in task.spots if s.fastener is not None and s.needs_hold]
    others = [s for s in task.spots if s.fastener is not None and not s.needs_hold]
    site = held_site(context, holding, gripper)
    found: list[OperationId] = []
    for spot in [*forced, *others]:
        if len(found) >= max(task.hold_until, len(forced)):
            break
        if any(can_drive(context, site, r, spot, holding.piece) for r in _drivers(context, spot)):
            found.append(spot.operation)
    return tuple(found)


def held_site(context: TwinContext, holding: Holding, gripper: EndEffector) -> Jobsite:
    """Return the whole site while a robot steadies the piece at its target."""
    task, site = context.task, context.site
    arm = replace(
        site.arms[holding.robot],
        q_rad=holding.hold_rad,
        held=holding.piece,
        tip_T_held=holding.grasp.tip_T_piece(gripper),
        aperture_m=holding.grasp.width_m,
    )
    return replace(
        site,
        arms={**site.arms, holding.robot: arm},
        world_T_piece={**site.world_T_piece, holding.piece: task.world_T_target},
        steadied={**site.steadied, holding.piece: holding.robot},
    )


def can_drive(
    context: TwinContext, site: Jobsite, robot: Robot, spot: Spot, piece: ComponentId
) -> bool:
    """Tell whether a robot reaches a fastener, with any tilt that its tool allows."""
    tool = tool_for(site, robot, spot)
    if tool is None:
        return False
    scene = scene_of(with_tool(site, robot.id, tool))
    reaching = Reaching(backends=context.backends, scene=scene, robot=robot.id)
    for pose in tool_poses(spot, tool, has_yaw=False):
        touch = spot_touch(tool, piece, pose)
        if isinstance(approaches(reaching, touch, robot.home_q_rad), list):
            return True
    return False


def _drivers(context: TwinContext, spot: Spot) -> list[Robot]:
    robots = context.cell.robot_by_id.values()
    return [r for r in robots if tool_for(context.site, r, spot) is not None]
