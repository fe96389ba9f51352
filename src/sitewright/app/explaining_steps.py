"""Gathers why a step of a proposal is as it is, from journal, proposal, model and cell."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from sitewright.app.design_changes import project_at
from sitewright.app.looking import FoundProposal, find_proposal, graph_at
from sitewright.app.planning import start_of
from sitewright.app.project import Project
from sitewright.app.run_folder import RunFolder, chain_events, chain_of
from sitewright.central_controller.causes import causal_links
from sitewright.central_controller.choosing import PieceOnSite, pieces_for
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.design import Design
from sitewright.central_controller.doers import doers
from sitewright.central_controller.events import (
    AnyEvent,
    ProposalMade,
    ProposalSuperseded,
    SkillIntent,
    SkillOutcome,
)
from sitewright.central_controller.expectation import pose_of
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.site_state import SiteState, site_of
from sitewright.construction_graph.graph import TargetNode
from sitewright.errors import ApprovalError
from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId
from sitewright.foundation.pose import Pose, dot
from sitewright.interaction_twin.step_reasons import Stance, StepReasons
from sitewright.planning_twin.backends.twin import make_backends
from sitewright.robot_team.description import Joints
from sitewright.robot_team.gripper import mount_T_tcp
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.nogood import purpose

_ABOUT_PIECES = (Skill.GRASP, Skill.POSITION, Skill.SET_DOWN)
_WITH_TOOLS = (Skill.FASTEN, Skill.APPLY_FINISH)
_DOWN = (0.0, 0.0, -1.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Then:
    """The project and its site when a proposal was made.

    Attributes:
        state: The fold up to and with the proposal.
        later: The events since.
    """

    project: Project
    state: CycleState
    context: SiteContext
    later: tuple[AnyEvent, ...]


def explain_step(
    project: Project, number: int, *, code: str | None = None, target: str | None = None
) -> StepReasons:
    """Return why a step of a proposal of the project's runs is as it is.

    Args:
        project: A project that can be read.
        number: Of the step in its proposal.
        code: Check code or fingerprint of the proposal; the newest by default.
        target: The newest proposal for this target.

    Raises:
        ApprovalError: There is no such proposal, or it has no such step.
    """
    found = find_proposal(project, code, target)
    steps = found.proposal.steps
    if not 1 <= number <= len(steps):
        raise ApprovalError(f"That plan has steps 1 to {len(steps)}; there is no step {number}.")
    then = _then(project, found)
    design = Design(model=then.project.model, cell=then.project.cell)
    calls = [s.call for s in steps]
    act = purpose(calls, number - 1)
    piece = ComponentId(act.arguments[0]) if act.skill in _ABOUT_PIECES else None
    return StepReasons(
        run=found.run,
        fingerprint=found.fingerprint,
        target=found.proposal.target,
        steps=steps,
        number=number,
        status=_status(found.fingerprint, number, then.later),
        links=causal_links(steps),
        act=act,
        doers=doers(design, act, then.state.refusals),
        piece=piece,
        pieces=_pieces(then, design, found.proposal.target) if act.skill == Skill.GRASP else (),
        stance=_stance(then, design, found.proposal, number, act),
        refusals=then.state.refusals,
    )


def _then(project: Project, found: FoundProposal) -> _Then:
    events, _ = chain_events(chain_of(RunFolder(project.folder / "runs" / found.run)))
    made = max(
        n
        for n, e in enumerate(events)
        if isinstance(e, ProposalMade) and e.fingerprint == found.fingerprint
    )
    state = CycleState(site=site_of(project.model))
    for event in events[: made + 1]:
        state = folded(state, event)
    project = project_at(project, state.model_sha256)
    return _Then(
        project=project,
        state=state,
        context=_context(project, state.site),
        later=events[made + 1 :],
    )


def _context(project: Project, site: SiteState) -> SiteContext:
    start = start_of(project)
    seen = site.sensed if site.sensed is not None else start.observation
    return SiteContext(run=start.run, site=site, observation=seen)


def _status(fingerprint: str, number: int, later: Sequence[AnyEvent]) -> str:
    """Return what became of a step: the last that is known of it counts."""
    commands, status = set[str](), "open"
    for event in later:
        match event:
            case SkillIntent(fingerprint=f, step=n, command_id=command):
                if (f, n) == (fingerprint, number):
                    commands.add(command)
                    status = "under way"
            case SkillOutcome(command_id=command, report=report) if command in commands:
                status = "done" if report.is_done else f"not done: {report.reason}"
            case ProposalSuperseded(fingerprint=f, reason=reason) if f == fingerprint:
                status = f"superseded: {reason}" if status == "open" else status
            case _:
                pass
    return status


def _pieces(then: _Then, design: Design, target: ComponentId) -> tuple[PieceOnSite, ...]:
    graph = graph_at(then.project, then.context.site)
    if not isinstance(graph.node_by_id.get(target), TargetNode):
        return ()
    return pieces_for(design, graph, then.context, target)


def _stance(
    then: _Then, design: Design, proposal: Proposal, number: int, act: SkillCall
) -> Stance | None:
    """Return how the robot stands at the end of a step, told by its joints there."""
    steps, target = proposal.steps[:number], proposal.target
    robot = design.cell.robot_by_id[act.robot]
    q_rad = _joints_after(then, steps, act)
    mounted = _mounted_after(then, steps, act.robot)
    if q_rad is None or mounted is None:
        return None
    base_T_tip = make_backends().kinematics.tip(robot.description, q_rad)
    tool = design.cell.end_effector_by_id[mounted]
    world_T_tcp = robot.world_T_base @ base_T_tip @ mount_T_tcp(tool.description)
    if act.skill in _WITH_TOOLS:
        return Stance(world_T_tcp=world_T_tcp, lean_rad=_lean(design, act, target, world_T_tcp))
    piece_at = _piece_at(then, proposal.steps, act)
    if piece_at is None:
        return Stance(world_T_tcp=world_T_tcp)
    return Stance(
        world_T_tcp=world_T_tcp,
        from_middle_m=(piece_at.inverse() @ world_T_tcp).position_m[0],
        from_above_rad=_angle(dot(world_T_tcp.z_axis, _DOWN)),
    )


def _joints_after(then: _Then, steps: Sequence[ProposedStep], act: SkillCall) -> Joints | None:
    moved = [m for s in steps if s.call.robot == act.robot for m in s.motions]
    if moved:
        return moved[-1].timed.path.end_rad
    seen = then.context.observation.robots.get(act.robot)
    return None if seen is None else seen.q_rad


def _mounted_after(
    then: _Then, steps: Sequence[ProposedStep], robot: RobotId
) -> EndEffectorId | None:
    for step in reversed(steps):
        if step.call.robot == robot and step.call.skill == Skill.CHANGE_END_EFFECTOR:
            new = EndEffectorId(step.call.arguments[1])
            return new if new in then.project.cell.end_effector_by_id else None
    seen = then.context.observation.robots.get(robot)
    return None if seen is None else seen.mounted


def _piece_at(then: _Then, steps: Sequence[ProposedStep], act: SkillCall) -> Pose | None:
    """Return where the piece of an act is when the act happens; None for acts without one."""
    if act.skill not in _ABOUT_PIECES:
        return None
    piece = ComponentId(act.arguments[0])
    if act.skill != Skill.GRASP:
        return next((pose_of(s.params["world_T_piece"]) for s in steps if s.call == act), None)
    before = steps[: next((s.number for s in steps if s.call == act), 0)]
    for step in reversed(before):
        if step.call.skill == Skill.SET_DOWN and step.call.arguments[0] == piece:
            return pose_of(step.params["world_T_piece"])
    return then.context.observation.world_T_piece.get(piece)


def _lean(design: Design, act: SkillCall, target: ComponentId, world_T_tcp: Pose) -> float | None:
    operations = (o for o in design.component(target).operations if o.id == act.arguments[0])
    operation = next(operations, None)
    if operation is None:
        return None
    axis = (design.world_T_target(target) @ operation.component_T_operation).z_axis
    return _angle(dot(world_T_tcp.z_axis, axis))


def _angle(cosine: float) -> float:
    return math.acos(max(-1.0, min(1.0, cosine)))
