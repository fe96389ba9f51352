"""The case study planned by the real engines: sites before each target, and changed designs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from sitewright.app.engines import proposals_of
from sitewright.app.planning import start_of
from sitewright.app.project import open_project
from sitewright.building_model.component import Component, Operation
from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import Planned, SiteContext
from sitewright.central_controller.proposal import ProposedStep
from sitewright.central_controller.proposing import Proposals
from sitewright.central_controller.rehearsal import after_step, rehearsed
from sitewright.central_controller.site_graph import graph_now
from sitewright.central_controller.situation import piece_shapes
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.description import Joints

EXAMPLES = Path(__file__).parent.parent / "examples"
A, B = RobotId("kr120-a"), RobotId("kr120-b")
SUPPORT_1, SUPPORT_2, STUD = (ComponentId(t) for t in ("support-1", "support-2", "stud-1"))


@dataclass(frozen=True)
class Rehearsal:
    """Some targets of the case study, planned one after the other.

    Attributes:
        before: The site right before each target.
    """

    proposals: Proposals
    before: Mapping[ComponentId, SiteContext]
    planned: Mapping[ComponentId, Planned]

    def midway(self, target: ComponentId, until: Callable[[ProposedStep], bool]) -> SiteContext:
        """Return the site after the first step of a target's proposal that fits."""
        context = self.before[target]
        for step in self.planned[target].proposal.steps:
            context = self._carried_along(context, after_step(context, step, target))
            if until(step):
                return context
        raise AssertionError(f"no such step for {target}")

    def _carried_along(self, before: SiteContext, after: SiteContext) -> SiteContext:
        """Return the site after a step with the pieces in grippers moved along."""
        for robot, state in before.observation.robots.items():
            piece = state.gripped
            if piece is None or after.observation.robots[robot].gripped != piece:
                continue
            was, now = (
                self._tip(robot, c.observation.robots[robot].q_rad) for c in (before, after)
            )
            pose = now @ was.inverse() @ before.observation.world_T_piece[piece]
            after = with_piece_at(after, piece, pose)
        return after

    def _tip(self, robot: RobotId, q_rad: Joints) -> Pose:
        unit = self.proposals.design.cell.robot_by_id[robot]
        kinematics = self.proposals.ports.backends.kinematics
        return unit.world_T_base @ kinematics.tip(unit.description, q_rad)

    def steps(self, target: ComponentId, skill: str) -> list[ProposedStep]:
        """Return the steps of a target's proposal with a skill."""
        steps = self.planned[target].proposal.steps
        return [s for s in steps if s.call.skill == skill]


def case_study_start() -> tuple[Proposals, SiteContext]:
    project = open_project(EXAMPLES / "wooden_frame")
    return proposals_of(project), start_of(project)


def rehearse(*targets: ComponentId) -> Rehearsal:
    proposals, context = case_study_start()
    before, planned = {}, {}
    for target in targets:
        outcome = proposals.propose(context)
        assert isinstance(outcome, Planned)
        assert outcome.proposal.target == target
        before[target], planned[target] = context, outcome
        context = rehearsed(context, outcome.proposal)
    return Rehearsal(proposals=proposals, before=before, planned=planned)


def with_component(proposals: Proposals, component: Component) -> Proposals:
    """Return the planner of a design in which one component differs."""
    model = proposals.design.model
    changed = replace(model, component_by_id={**model.component_by_id, component.id: component})
    cell = proposals.design.cell
    return replace(
        proposals,
        design=Design(model=changed, cell=cell),
        shapes=piece_shapes(changed),
        graph_of=partial(graph_now, changed, cell),
    )


def with_cell(proposals: Proposals, cell: Cell) -> Proposals:
    model = proposals.design.model
    return replace(
        proposals,
        design=Design(model=model, cell=cell),
        graph_of=partial(graph_now, model, cell),
    )


def with_operation(component: Component, name: str, **changes: object) -> Component:
    operations = tuple(
        replace(o, **changes) if o.id == name else o  # type: ignore[arg-type]
        for o in component.operations
    )
    known: tuple[Operation, ...] = operations
    return replace(component, operations=known)


def with_piece_at(context: SiteContext, piece: ComponentId, pose: Pose | None) -> SiteContext:
    """Return the site with a piece seen elsewhere, or not at all."""
    poses = {p: T for p, T in context.observation.world_T_piece.items() if p != piece}
    if pose is not None:
        poses[piece] = pose
    return replace(context, observation=replace(context.observation, world_T_piece=poses))
