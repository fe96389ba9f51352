"""The hard motions first: one grasp that serves pick, carry, place, steadying and letting go."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace

from sitewright.foundation.ids import BodyId, ComponentId, OperationId, RobotId
from sitewright.planning_twin.approach import Approach, Reaching, approaches, straight_approach
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.grasps import Grasp, grasp_in_use, grasps_of
from sitewright.planning_twin.jobsite import (
    Jobsite,
    scene_of,
    tool_for,
    with_aperture,
    with_tool,
)
from sitewright.planning_twin.refusal import NoGrasp, NoIk, PayloadExceeded, Refusal
from sitewright.planning_twin.scene import Attachment, SceneSnapshot
from sitewright.planning_twin.task import Task, TwinContext
from sitewright.planning_twin.touches import (
    leave_touch,
    lift_thresholds,
    pick_touch,
    place_touch,
    spot_touch,
)
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.description import Joints

_GRAVITY_M_S2 = 9.81


@dataclass(frozen=True, slots=True, kw_only=True)
class Holding:
    """How one robot takes one piece, places it and holds it.

    Attributes:
        hold_rad: Posture while the piece stands at its target and is held.
        tacks: Fasteners that the finisher can drive meanwhile, in order.
        insertion: Number of the task's insertion direction that is used.
    """

    robot: RobotId
    piece: ComponentId
    grasp: Grasp
    hold_rad: Joints
    insertion: int = 0
    tacks: tuple[OperationId, ...] = ()


def alone(scene: SceneSnapshot, robot: RobotId) -> SceneSnapshot:
    """Return the scene without the other robots and what they carry."""
    carried = [
        i
        for i, body in scene.bodies.items()
        if isinstance(body.placement, Attachment) and body.placement.robot != robot
    ]
    return replace(scene.without(*carried), robots={robot: scene.robots[robot]})


def with_held(
    site: Jobsite, robot: RobotId, piece: ComponentId, grasp: Grasp, tool: EndEffector
) -> Jobsite:
    """Return the site with a piece in a robot's gripper."""
    arm = replace(
        site.arms[robot], held=piece, tip_T_held=grasp.tip_T_piece(tool), aperture_m=grasp.width_m
    )
    return replace(site, arms={**site.arms, robot: arm})


def find_holding(context: TwinContext, robot: Robot, piece: ComponentId) -> Holding | Refusal:
    """Search the grasp freedoms of a robot for a piece, cheapest first.

    The other robots are left out: where they stand is a matter of order, which the symbolic plan
    decides. The grasp that lets enough fasteners be driven while held wins; if none does, the
    one that lets most.
    """
    tool = context.tool_of(robot.id)
    if tool is None or tool.grips_m is None:
        return NoGrasp(is_proven=True, candidates=0, reason="no gripper is mounted")
    if heavy := _too_heavy(context, robot, tool, piece):
        return heavy
    candidates = _candidates(context, robot, tool, piece)
    dropped: Counter[str] = Counter()
    best: Holding | None = None
    for grasp in candidates:
        for holding in _serving(context, robot, tool, piece, grasp, dropped):
            if len(holding.tacks) >= context.task.hold_until:
                return holding
            if best is None or len(holding.tacks) > len(best.tacks):
                best = holding
    if best is not None:
        dropped["fasten while held"] += 1
    return NoGrasp(
        is_proven=False,
        candidates=len(candidates),
        dropped_by=tuple(sorted(dropped.items())),
        reason=_reason(context.task, best, dropped),
    )


def _candidates(
    context: TwinContext, robot: Robot, tool: EndEffector, piece: ComponentId
) -> list[Grasp]:
    arm = context.site.arms[robot.id]
    if arm.held == piece:
        return [grasp_in_use(tool, arm.tip_T_held, arm.aperture_m)]
    return grasps_of(context.site.pieces[piece], tool, context.site.world_T_piece[piece])


def steadying(context: TwinContext, robot: Robot, piece: ComponentId) -> Holding | None:
    """Return how a robot holds the piece that is in place already, or None if it does not."""
    tool, arm = context.tool_of(robot.id), context.site.arms[robot.id]
    if tool is None or arm.held != piece or context.task.placed != piece:
        return None
    grasp = grasp_in_use(tool, arm.tip_T_held, arm.aperture_m)
    holding = Holding(robot=robot.id, piece=piece, grasp=grasp, hold_rad=arm.q_rad)
    return replace(holding, tacks=drivable_while_held(context, holding, tool))


def _reason(task: Task, best: Holding | None, dropped: Counter[str]) -> str:
    if best is not None:
        return (
            f"at most {len(best.tacks)} of the {task.hold_until} fasteners that must be driven "
            f"before letting go can be driven while it is held"
        )
    if not dropped:
        return "no side of the piece fits between the gripper's fingers"
    return "no grasp serves " + ", ".join(f"{name} ({n})" for name, n in dropped.most_common())


def _too_heavy(
    context: TwinContext, robot: Robot, tool: EndEffector, piece: ComponentId
) -> PayloadExceeded | None:
    own_kg = sum(link.mass_kg for link in tool.description.links)
    mass_kg = own_kg + context.site.pieces[piece].mass_kg
    limit_kg = robot.description.payload_kg
    if limit_kg and mass_kg > limit_kg:
        return PayloadExceeded(mass_kg=mass_kg, payload_kg=limit_kg)
    return None


def _serving(
    context: TwinContext,
    robot: Robot,
    tool: EndEffector,
    piece: ComponentId,
    grasp: Grasp,
    dropped: Counter[str],
) -> list[Holding]:
    """Return the holdings of one grasp: one for each clear posture at the target."""
    task, home = context.task, robot.home_q_rad
    base = alone(scene_of(context.site), robot.id)
    place_scene = alone(scene_of(with_held(context.site, robot.id, piece, grasp, tool)), robot.id)
    placing = Reaching(backends=context.backends, scene=place_scene, robot=robot.id)
    opened = with_aperture(base, tool, grasp.open_m)
    picking = Reaching(backends=context.backends, scene=opened, robot=robot.id)

    if context.site.arms[robot.id].held != piece:
        at = context.site.world_T_piece[piece]
        picks = approaches(picking, pick_touch(task, tool, piece, at, grasp), home)
        if not isinstance(picks, list):
            dropped["pick"] += 1
            return []
        if not any(_can_lift(placing, task, tool, piece, a) for a in picks):
            dropped["lift"] += 1
            return []
    found: list[Holding] = []
    for number, insertion in enumerate(task.insertions):
        touch = place_touch(task, tool, piece, grasp, insertion)
        places = approaches(placing, touch, home)
        if not isinstance(places, list):
            dropped["place"] += 1
            continue
        placed = opened.placed(BodyId(piece), task.world_T_target)
        leaving = Reaching(backends=context.backends, scene=placed, robot=robot.id)
        for place in places:
            if not _can_leave(leaving, task, tool, piece, place):
                dropped["let go"] += 1
                continue
            holding = Holding(
                robot=robot.id,
                piece=piece,
                grasp=grasp,
                hold_rad=place.contact_rad,
                insertion=number,
            )
            holding = replace(holding, tacks=drivable_while_held(context, holding, tool))
            found.append(holding)
            if len(holding.tacks) >= task.hold_until:
                return found
    return found


def _can_lift(
    carrying: Reaching, task: Task, tool: EndEffector, piece: ComponentId, pick: Approach
) -> bool:
    touch = replace(
        pick.touch, back_off=(0.0, 0.0, 1.0), near_m=lift_thresholds(task, tool, piece), free_m={}
    )
    lift = straight_approach(carrying, touch, pick.contact_rad)
    return not isinstance(lift, NoIk) and not carrying.violations(lift.pre_rad, {}, is_padded=True)


def _can_leave(
    leaving: Reaching, task: Task, tool: EndEffector, piece: ComponentId, place: Approach
) -> bool:
    touch = leave_touch(task, tool, piece, place.touch.world_T_tip)
    if leaving.violations(place.contact_rad, touch.near_m):
        return False
    way_out = straight_approach(leaving, touch, place.contact_rad)
    return not isinstance(way_out, NoIk) and not leaving.violations(
        way_out.pre_rad, {}, is_padded=True
    )


def drivable_while_held(
    context: TwinContext, holding: Holding, gripper: EndEffector
) -> tuple[OperationId, ...]:
    """Return the fasteners that some other robot can drive while this one holds the piece."""
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


def _drivers(context: TwinContext, spot: Spot) -> list[Robot]:
    return [
        r for r in context.cell.robot_by_id.values() if tool_for(context.site, r, spot) is not None
    ]


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
