"""Proposes better places for robots and stock of a project, judged by the reach check."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, replace

from sitewright.app.layout_judge import ProjectJudge
from sitewright.app.project import Project
from sitewright.app.reach import reach_of
from sitewright.building_model.component import Layer
from sitewright.building_model.shapes import shape_of
from sitewright.construction_graph.build import graph_of
from sitewright.construction_graph.graph import MaterialNode
from sitewright.foundation.clock import Clock
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.backends.reach.check import ArrayReachCheck
from sitewright.planning_twin.layout.floor import Floor, Point, floor_of
from sitewright.planning_twin.layout.judging import Judgement
from sitewright.planning_twin.layout.movables import Arrangement, Shift, Yard, yard_of
from sitewright.planning_twin.layout.search import LayoutSearch
from sitewright.planning_twin.reachability.report import ReachReport

Body = tuple[Shape, Pose]


@dataclass(frozen=True, slots=True, kw_only=True)
class LayoutOptions:
    """What a search may do.

    Attributes:
        seed: The same seed finds the same places.
        budget: How many reach checks may be made.
        area_m: Corners of the floor that may be used; the widest fixture by default.
        kept: Ids of robots and stock places that stay.
    """

    seed: int = 0
    budget: int = 60
    area_m: tuple[Point, Point] | None = None
    kept: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class LayoutProposal:
    """Better places, or the old ones if none were found.

    Attributes:
        before, after: Whole reach checks of the cell as it is and as proposed.
        project: With the proposed cell.
    """

    yard: Yard
    arrangement: Arrangement
    before: ReachReport
    after: ReachReport
    project: Project

    @property
    def is_better(self) -> bool:
        """Whether anything moves."""
        return bool(self.arrangement)


def propose_layout(
    project: Project,
    options: LayoutOptions,
    clock: Clock,
    on_check: Callable[[Judgement], None] = lambda _: None,
) -> LayoutProposal:
    """Search for places from which more of the model can be built; nothing is written.

    Args:
        project: Whose cell is to be laid out better.
        options: Seed, budget, floor and what stays.
        clock: Measures the checks.
        on_check: Told each judgement as it is made.
    """
    yard = yard_of(project.cell, kept=options.kept)
    check = ArrayReachCheck()
    search = LayoutSearch(
        floor=_floor(project, yard, options),
        judge=ProjectJudge(project, yard, check),
        seed=options.seed,
        budget=options.budget,
        on_check=on_check,
    )
    _, best = search.run()
    moves = {i: shift for i, shift in best.arrangement.items() if shift != Shift()}
    better = replace(project, cell=yard.arranged(moves))
    return LayoutProposal(
        yard=yard,
        arrangement=moves,
        before=reach_of(project, clock, check),
        after=reach_of(better, clock, check),
        project=better,
    )


def _floor(project: Project, yard: Yard, options: LayoutOptions) -> Floor:
    model, cell = project.model, project.cell
    building = [
        (shape_of(c), cell.world_T_model @ c.world_T_component)
        for c in model.component_by_id.values()
        if c.layer in (Layer.TARGET, Layer.AS_BUILT, Layer.VIRTUAL_COLLISION)
    ]
    pieces: dict[str, list[Body]] = defaultdict(list)
    for node in graph_of(model, cell).node_by_id.values():
        if isinstance(node, MaterialNode):
            shape = shape_of(model.component_by_id[node.id])
            pieces[node.place].append((shape, node.world_T_component))
    return floor_of(yard, pieces, building, options.area_m)
