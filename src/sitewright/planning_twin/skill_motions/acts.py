"""Skills in which only the end effector acts: grasp, position, set-down, release, fasten."""

from __future__ import annotations

from dataclasses import replace

from sitewright.building_model.component import FastenerSpec
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.foundation.shapes import Hull, Shape
from sitewright.planning_twin.approach import CONTACT_M, NEIGHBOUR_M
from sitewright.planning_twin.jobsite import Jobsite, bodies_of_tool, finger_body, scene_of
from sitewright.planning_twin.moment import moment_of
from sitewright.planning_twin.refusal import BlockedBy, NoGrasp, NoIk
from sitewright.planning_twin.scene import Body
from sitewright.planning_twin.setting_down import lying_on_fixtures, pose_on
from sitewright.planning_twin.skill_motions.reach import placed_piece
from sitewright.planning_twin.skill_motions.resting import resting_contacts
from sitewright.planning_twin.skill_motions.stage import (
    PlannedSkill,
    SkillRefusal,
    Stage,
    pose_json,
)
from sitewright.planning_twin.skill_times import ACT_TIME_S
from sitewright.planning_twin.task import declared
from sitewright.robot_team.gripper import finger_parts
from sitewright.robot_team.skill import Skill, SkillCall

_APERTURE_TOLERANCE_M = 0.002
_POSE_TOLERANCE_M = 0.005
_ANGLE_TOLERANCE_RAD = 0.0087
MIN_PENETRATION_M = 0.030
"""A fastener must go at least this far into its receiver (building-model note, C1)."""


def plan_grasp(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Close the gripper on the piece that it stands at."""
    piece = ComponentId(call.arguments[0])
    holding = stage.holding(call.robot, piece)
    if holding is None:
        reason = Sentence("no grasp of {piece}", piece=piece)
        return _refused(call, NoGrasp(is_proven=False, candidates=0, reason=reason))
    blocked = _finger_sweep(stage, call.robot, piece, holding.grasp.width_m)
    if blocked is not None:
        return _refused(call, blocked)
    arm = stage.site.arms[call.robot]
    taken = replace(
        arm,
        held=piece,
        tip_T_held=stage.tip(call.robot).inverse() @ stage.site.world_T_piece[piece],
        aperture_m=holding.grasp.width_m,
    )
    params: dict[str, Json] = {
        "piece": piece,
        "width_m": holding.grasp.width_m,
        "tolerance_m": _APERTURE_TOLERANCE_M,
    }
    return _planned(stage, call, piece, params, _with_arm(stage.site, call.robot, taken))


def plan_position(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Sense the held piece at its target and keep steadying it."""
    piece, task = ComponentId(call.arguments[0]), stage.context.task
    params: dict[str, Json] = {
        "piece": piece,
        "world_T_piece": pose_json(task.world_T_target),
        "tolerance_m": _POSE_TOLERANCE_M,
        "tolerance_rad": _ANGLE_TOLERANCE_RAD,
        "rests_on": list(task.rests_on),
    }
    site = replace(
        stage.site,
        world_T_piece={**stage.site.world_T_piece, piece: task.world_T_target},
        steadied={**stage.site.steadied, piece: call.robot},
    )
    return _planned(stage, call, piece, params, site)


def plan_release(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Open the gripper around the piece that stands now."""
    piece = placed_piece(stage)
    opening = _opening(stage, call.robot, piece)
    if isinstance(opening, BlockedBy):
        return _refused(call, opening)
    site = _let_go(stage.site, call.robot, piece, opening)
    return _planned(stage, call, piece, {"piece": piece, "aperture_m": opening}, site)


def plan_set_down(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Lay the held piece on a buffer and open the gripper."""
    piece, place = ComponentId(call.arguments[0]), call.arguments[1]
    if place not in stage.context.task.buffers:
        return _refused(
            call, NoIk(is_proven=False, reason=Sentence("{place} is no buffer", place=place))
        )
    task = lying_on_fixtures(stage.context, piece)
    stage = replace(stage, context=replace(stage.context, task=task))
    opening = _opening(stage, call.robot, piece)
    if isinstance(opening, BlockedBy):
        return _refused(call, opening)
    site = stage.site
    pose = pose_on(task.buffers[place], site.pieces[piece], site.world_T_piece[piece])
    params: dict[str, Json] = {
        "piece": piece,
        "world_T_piece": pose_json(pose),
        "tolerance_m": _POSE_TOLERANCE_M,
        "tolerance_rad": _ANGLE_TOLERANCE_RAD,
        "aperture_m": opening,
    }
    site = _let_go(stage.site, call.robot, piece, opening)
    site = replace(site, world_T_piece={**site.world_T_piece, piece: pose})
    return _planned(stage, call, piece, params, site)


def plan_fasten(stage: Stage, call: SkillCall) -> PlannedSkill | SkillRefusal:
    """Drive one fastener from the contact pose."""
    spot = stage.context.task.spot(call.arguments[0])
    piece = placed_piece(stage)
    receiver = None if spot is None else spot.receiver(piece)
    if spot is None or spot.fastener is None or receiver is None:
        reason = Sentence("{spot} has no fastener or no receiver", spot=call.arguments[0])
        return _refused(call, NoIk(is_proven=True, reason=reason))
    params: dict[str, Json] = {
        "operation": spot.operation,
        "through": spot.body(piece),
        "into": receiver,
        "fastener": _fastener_json(spot.fastener),
        "penetration_m": MIN_PENETRATION_M,
    }
    act = _planned(stage, call, piece, params, stage.site)
    tip = declared(CONTACT_M, bodies_of_tool(stage.tool(call.robot)), (BodyId(spot.body(piece)),))
    return replace(act, contacts=tuple(sorted({*act.contacts, *tip})))


def _fastener_json(fastener: FastenerSpec) -> Json:
    return {"type": fastener.type, "d_m": fastener.d_m, "l_m": fastener.l_m}


def _planned(
    stage: Stage, call: SkillCall, piece: ComponentId, params: dict[str, Json], site: Jobsite
) -> PlannedSkill:
    """Return an act: the end effector may touch its piece, and the piece what it lies on."""
    task, own = stage.context.task, bodies_of_tool(stage.tool(call.robot))
    around = (*task.touches, *task.lies_on.get(piece, ()))
    pairs = {
        **declared(CONTACT_M, own, (BodyId(piece),)),
        **declared(CONTACT_M, (BodyId(piece),), around),
    }
    return PlannedSkill(
        motions=(),
        params=params,
        site_after=site,
        act_s=ACT_TIME_S[call.skill],
        contacts=tuple(sorted(pairs)),
    )


def _refused(call: SkillCall, refusal: BlockedBy | NoGrasp | NoIk) -> SkillRefusal:
    return SkillRefusal(call=call, refusal=refusal)


def _with_arm(site: Jobsite, robot: RobotId, arm: object) -> Jobsite:
    return replace(site, arms={**site.arms, robot: arm})  # type: ignore[dict-item]


def _let_go(site: Jobsite, robot: RobotId, piece: ComponentId, aperture_m: float) -> Jobsite:
    arm = replace(site.arms[robot], held=None, aperture_m=aperture_m)
    steadied = {p: r for p, r in site.steadied.items() if p != piece}
    return replace(site, arms={**site.arms, robot: arm}, steadied=steadied)


def _opening(stage: Stage, robot: RobotId, piece: ComponentId) -> float | BlockedBy:
    """Return how far the fingers may open here: as at the pick if there is room, else a little."""
    tool = stage.tool(robot)
    holding = stage.holding(robot, piece)
    width_m = stage.site.arms[robot].aperture_m
    wide = tool.opens_to_m if holding is None else holding.grasp.open_m
    blocked: BlockedBy | None = None
    for aperture_m in (wide, min(wide, width_m + 0.020), min(wide, width_m + 0.008)):
        blocked = _finger_sweep(stage, robot, piece, aperture_m)
        if blocked is None:
            return aperture_m
    return blocked if blocked is not None else width_m


def _finger_sweep(
    stage: Stage, robot: RobotId, piece: ComponentId, aperture_m: float
) -> BlockedBy | None:
    """Check the whole way of the fingers from their opening now to another one."""
    tool = stage.tool(robot)
    now = finger_parts(tool.description, stage.site.arms[robot].aperture_m)
    then = finger_parts(tool.description, aperture_m)
    scene = scene_of(stage.site)
    for name, parts in then.items():
        swept = Body(
            id=finger_body(tool.id, name),
            shape=_swept(parts, now[name]),
            placement=scene.bodies[BodyId(tool.id)].placement,
        )
        scene = scene.with_body(swept)
    gripper = bodies_of_tool(tool)
    allowed = {
        **resting_contacts(stage, robot),
        **declared(NEIGHBOUR_M, gripper, stage.context.task.touches),
        **declared(NEIGHBOUR_M, gripper, stage.context.task.lies_on.get(piece, ())),
        **declared(CONTACT_M, (BodyId(piece),), stage.context.task.touches),
        **declared(CONTACT_M, (BodyId(piece),), stage.context.task.lies_on.get(piece, ())),
        **declared(CONTACT_M, gripper, (BodyId(piece),)),
    }
    pairs = stage.context.backends.collision.violations(scene, robot, stage.q_rad(robot), allowed)
    if not pairs:
        return None
    moment = moment_of(scene, {robot: stage.q_rad(robot)}, pairs[0])
    return BlockedBy(pairs=pairs, reason=Sentence("the fingers have no room"), moment=moment)


def _swept(*ends: Shape) -> Shape:
    """Return what a shape passes through between two places, part by part."""
    return tuple(
        Hull(tuple(v for part in both for v in part.vertices_m()))
        for both in zip(*ends, strict=True)
    )


PLANNERS = {
    Skill.GRASP: plan_grasp,
    Skill.POSITION: plan_position,
    Skill.SET_DOWN: plan_set_down,
    Skill.RELEASE: plan_release,
    Skill.FASTEN: plan_fasten,
}
"""The acting skills by name."""
