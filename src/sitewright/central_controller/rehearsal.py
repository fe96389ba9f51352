"""Plans on without moving anything: the site as it would stand after each proposal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.building_model.component import Layer
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.site_state import PlacedPiece, SiteState
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, EndEffectorId, OperationId, StationId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.driver import Observation, RobotObservation
from sitewright.robot_team.skill import Skill


def initial_observation(model: BuildingModel, cell: Cell, graph: ConstructionGraph) -> Observation:
    """Return what would be sensed before anything has moved.

    Args:
        model: The design; its stock lies on the stock places.
        cell: Robots at home, tools docked or mounted as the cell says.
        graph: Graph of the untouched site, which knows where the stock lies.
    """
    robots = {
        r.id: RobotObservation(
            q_rad=r.home_q_rad,
            velocity_rad_s=(0.0,) * len(r.home_q_rad),
            mounted=r.mounted,
            aperture_m=0.0 if r.mounted is None else cell.end_effector_by_id[r.mounted].opens_to_m,
        )
        for r in cell.robot_by_id.values()
    }
    mounted = {r.mounted for r in cell.robot_by_id.values()}
    return Observation(
        time_s=0.0,
        robots=robots,
        world_T_piece={
            c.id: graph.node_by_id[c.id].world_T_component
            for c in model.component_by_id.values()
            if c.layer is Layer.MATERIAL and c.id in graph.node_by_id
        },
        docked={
            e.id: e.station
            for e in cell.end_effector_by_id.values()
            if e.id not in mounted and e.station is not None
        },
    )


def rehearsed(context: SiteContext, proposal: Proposal) -> SiteContext:
    """Return the context as if a proposal had been carried out exactly."""
    for step in proposal.steps:
        context = _after_motions(context, step)
        context = _after_act(context, step, proposal.target)
    site = context.site
    site = replace(
        site,
        standing=site.standing | {proposal.target},
        installed=(*site.installed, proposal.target),
        place_by_robot={},
    )
    return replace(context, site=site)


def _after_motions(context: SiteContext, step: ProposedStep) -> SiteContext:
    if not step.motions:
        return context
    end_rad = step.motions[-1].timed.path.end_rad
    return _with_robot(context, step.call.robot, q_rad=end_rad)


def _with_robot(context: SiteContext, robot: str, **changes: object) -> SiteContext:
    robots = {
        r: replace(state, **changes) if r == robot else state  # type: ignore[arg-type]
        for r, state in context.observation.robots.items()
    }
    return replace(context, observation=replace(context.observation, robots=robots))


def _after_act(context: SiteContext, step: ProposedStep, target: ComponentId) -> SiteContext:
    call, params = step.call, step.params
    match call.skill:
        case Skill.GRASP:
            return _with_robot(
                context, call.robot, gripped=params["piece"], aperture_m=params["width_m"]
            )
        case Skill.POSITION:
            return _placed(context, step, target)
        case Skill.REACH if "aperture_m" in params:
            return _with_robot(context, call.robot, aperture_m=params["aperture_m"])
        case Skill.RELEASE:
            return _with_robot(context, call.robot, gripped=None, aperture_m=params["aperture_m"])
        case Skill.SET_DOWN:
            laid = _with_robot(context, call.robot, gripped=None, aperture_m=params["aperture_m"])
            return _seen_at(laid, ComponentId(str(params["piece"])), pose_of(params))
        case Skill.FASTEN | Skill.APPLY_FINISH:
            done = context.site.done_operations | {OperationId(call.arguments[0])}
            return replace(context, site=replace(context.site, done_operations=done))
        case Skill.CHANGE_END_EFFECTOR:
            return _changed(context, step)
        case _:
            return context


def _placed(context: SiteContext, step: ProposedStep, target: ComponentId) -> SiteContext:
    piece, pose = ComponentId(step.call.arguments[0]), pose_of(step.params)
    placed = PlacedPiece(
        piece=piece, world_T_wanted=pose, world_T_measured=pose, robot=step.call.robot
    )
    site: SiteState = replace(context.site, placed={**context.site.placed, target: placed})
    return _seen_at(replace(context, site=site), piece, pose)


def _seen_at(context: SiteContext, piece: ComponentId, pose: Pose) -> SiteContext:
    poses = {**context.observation.world_T_piece, piece: pose}
    return replace(context, observation=replace(context.observation, world_T_piece=poses))


def _changed(context: SiteContext, step: ProposedStep) -> SiteContext:
    old, new, station = (step.params[k] for k in ("old", "new", "station"))
    docked = {i: s for i, s in context.observation.docked.items() if i != new}
    if old is not None:
        docked[EndEffectorId(str(old))] = StationId(str(station))
    context = replace(context, observation=replace(context.observation, docked=docked))
    return _with_robot(context, step.call.robot, mounted=new, aperture_m=0.0)


def pose_of(params: Mapping[str, Json]) -> Pose:
    """Return the wanted pose of a piece in a skill's parameters."""
    pose = params["world_T_piece"]
    if not isinstance(pose, Mapping):
        raise TypeError("world_T_piece is no pose")
    position, quaternion = pose["p_m"], pose["q_wxyz"]
    return Pose(tuple(position), tuple(quaternion))  # type: ignore[arg-type]
