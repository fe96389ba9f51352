"""Studs of random frames right before they are placed: the supports stand already."""

from __future__ import annotations

from dataclasses import dataclass, replace

from builders_planning import A
from builders_random_frames import random_frame
from sitewright.app.engines import proposals_of
from sitewright.app.planning import start_of
from sitewright.app.project import Project
from sitewright.building_model.component import Layer
from sitewright.central_controller.situation import task_of
from sitewright.foundation.ids import ComponentId
from sitewright.planning_twin.grasps import Grasp, grasps_of
from sitewright.planning_twin.held_proof import proof_of_too_few
from sitewright.planning_twin.refusal import HeldFreedoms
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.cell import Cell, EndEffector, Robot


@dataclass(frozen=True, slots=True, kw_only=True)
class Stud:
    """A stud that robot A may hold, in the ways that are looked at."""

    context: TwinContext
    piece: ComponentId
    grasps: tuple[Grasp, ...]

    @property
    def holder(self) -> Robot:
        """Robot A."""
        return self.context.cell.robot_by_id[A]

    @property
    def gripper(self) -> EndEffector:
        """What robot A has mounted."""
        tool = self.context.tool_of(A)
        assert tool is not None
        return tool

    def proof(self) -> HeldFreedoms | None:
        """Return over what it is proven that too few fasteners can be driven."""
        grasps = list(self.grasps)
        return proof_of_too_few(self.context, self.holder, self.gripper, self.piece, grasps)

    def with_cell(self, cell: Cell) -> Stud:
        """Return the stud in another cell."""
        context = replace(self.context, site=replace(self.context.site, cell=cell))
        return replace(self, context=context)


def frame_of_one_stud(seed: int, target: str = "stud-1") -> Project:
    """Return a random frame whose supports stand and of which only one stud is to be built."""
    project = random_frame(seed)
    left_out = {f"stud-{k}" for k in range(1, 10)} - {target}
    built = {
        i: replace(c, layer=Layer.AS_BUILT) if i.startswith("support-") else c
        for i, c in project.model.component_by_id.items()
        if i not in left_out and not i.startswith("supporting-stud-piece")
    }
    stacks = tuple(s for s in project.model.stacks if s.items[0] in built)
    return replace(project, model=replace(project.model, component_by_id=built, stacks=stacks))


def stud_of_frame(seed: int, target: str = "stud-1", *, every: int = 1) -> Stud:
    """Return a stud of a random frame; every so-manieth of all grasps is looked at."""
    project = frame_of_one_stud(seed, target)
    proposals, start = proposals_of(project), start_of(project)
    piece = project.model.stacks[0].items[-1]
    graph = proposals.graph_of(start)
    task = task_of(proposals.design, graph, start, ComponentId(target), (piece,))
    site = proposals.surveyor.jobsite(start)
    context = TwinContext(backends=proposals.ports.backends, site=site, task=task)
    stud = Stud(context=context, piece=piece, grasps=())
    grasps = grasps_of(site.pieces[piece], stud.gripper, site.world_T_piece[piece])
    return replace(stud, grasps=tuple(grasps[::every]))
