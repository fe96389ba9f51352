"""Plans on without moving anything: the site as it would stand after each proposal."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from sitewright.building_model.component import Layer
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.expectation import pose_of
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.site_fold import places_after
from sitewright.central_controller.site_state import PlacedPiece, SiteState
from sitewright.construction_graph.graph import ConstructionGraph
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
    """Return the context as if a proposal for a whole target had been carried out exactly."""
    return built(context, proposal.steps, proposal.target)


def built(context: SiteContext, steps: Iterable[ProposedStep], target: ComponentId) -> SiteContext:
    """Return the context as if the steps that build a target had been carried out exactly."""
    context = carried_out(context, steps, target)
    site = context.site
    site = replace(site, standing=site.standing | {target}, installed=(*site.installed, target))
    return replace(context, site=site)


def carried_out(
    context: SiteContext, steps: Iterable[ProposedStep], target: ComponentId
) -> SiteContext:
    """Return the context as if some steps had been carried out exactly."""
    for step in steps:
        context = after_step(context, step, target)
    return context


def after_step(context: SiteContext, step: ProposedStep, target: ComponentId) -> SiteContext:
    """Return the context as if one step had been carried out exactly.

    A piece in a gripper is seen where it was taken until it is placed or laid down.
    """
    robot = step.call.robot
    if step.motions:
        context = _with_robot(context, robot, q_rad=step.motions[-1].timed.path.end_rad)
    act = _ACTS.get(step.call.skill)
    context = context if act is None else act(context, step, target)
    places = places_after(context.site.place_by_robot, robot, step.effects)
    return replace(context, site=replace(context.site, place_by_robot=places))


def _with_robot(context: SiteContext, robot: str, **changes: object) -> SiteContext:
    robots = {
        r: replace(state, **changes) if r == robot else state  # type: ignore[arg-type]
        for r, state in context.observation.robots.items()
    }
    return replace(context, observation=replace(context.observation, robots=robots))


def _opened(context: SiteContext, step: ProposedStep, _target: ComponentId) -> SiteContext:
    opening = step.params.get("aperture_m")
    return context if opening is None else _with_robot(context, step.call.robot, aperture_m=opening)


def _grasped(context: SiteContext, step: ProposedStep, _target: ComponentId) -> SiteContext:
    params = step.params
    return _with_robot(
        context, step.call.robot, gripped=params["piece"], aperture_m=params["width_m"]
    )


def _let_go(context: SiteContext, step: ProposedStep, _target: ComponentId) -> SiteContext:
    return _with_robot(context, step.call.robot, gripped=None, aperture_m=step.params["aperture_m"])


def _released(context: SiteContext, step: ProposedStep, target: ComponentId) -> SiteContext:
    site = replace(context.site, standing=context.site.standing | {target})
    return _let_go(replace(context, site=site), step, target)


def _laid_down(context: SiteContext, step: ProposedStep, target: ComponentId) -> SiteContext:
    piece = ComponentId(str(step.params["piece"]))
    return _seen_at(_let_go(context, step, target), piece, pose_of(step.params["world_T_piece"]))


def _operated(context: SiteContext, step: ProposedStep, _target: ComponentId) -> SiteContext:
    done = context.site.done_operations | {OperationId(step.call.arguments[0])}
    return replace(context, site=replace(context.site, done_operations=done))


def _placed(context: SiteContext, step: ProposedStep, target: ComponentId) -> SiteContext:
    piece, pose = ComponentId(step.call.arguments[0]), pose_of(step.params["world_T_piece"])
    placed = PlacedPiece(
        piece=piece, world_T_wanted=pose, world_T_measured=pose, robot=step.call.robot
    )
    site: SiteState = replace(context.site, placed={**context.site.placed, target: placed})
    return _seen_at(replace(context, site=site), piece, pose)


def _seen_at(context: SiteContext, piece: ComponentId, pose: Pose) -> SiteContext:
    poses = {**context.observation.world_T_piece, piece: pose}
    return replace(context, observation=replace(context.observation, world_T_piece=poses))


def _changed(context: SiteContext, step: ProposedStep, _target: ComponentId) -> SiteContext:
    old, new, station = (step.params[k] for k in ("old", "new", "station"))
    docked = {i: s for i, s in context.observation.docked.items() if i != new}
    if old is not None:
        docked[EndEffectorId(str(old))] = StationId(str(station))
    context = replace(context, observation=replace(context.observation, docked=docked))
    return _with_robot(context, step.call.robot, mounted=new, aperture_m=0.0)


_ACTS: Mapping[str, Callable[[SiteContext, ProposedStep, ComponentId], SiteContext]] = {
    Skill.REACH: _opened,
    Skill.GRASP: _grasped,
    Skill.POSITION: _placed,
    Skill.RELEASE: _released,
    Skill.SET_DOWN: _laid_down,
    Skill.FASTEN: _operated,
    Skill.APPLY_FINISH: _operated,
    Skill.CHANGE_END_EFFECTOR: _changed,
}
"""What each skill's act does to the site, on top of its motions."""
