"""Looks at the site for one target, or for one errand: what both planners are told."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from sitewright.central_controller.design import Design
from sitewright.central_controller.errands import errand_task
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.situation import jobsite_of, task_of
from sitewright.central_controller.statuses import lies_at, robot_statuses
from sitewright.central_controller.target_planning import PlanningPorts
from sitewright.central_controller.wishes import another_seed, detours, without_refused_robots
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.foundation.ids import ComponentId
from sitewright.planning_twin.jobsite import Jobsite, PieceShape
from sitewright.planning_twin.study import Study, study
from sitewright.planning_twin.task import Task, TwinContext
from sitewright.symbolic_planning.site_view import Errand, SiteView

GraphOf = Callable[[SiteContext], ConstructionGraph]


@dataclass(frozen=True, slots=True, kw_only=True)
class Situation:
    """Everything that is known about one target, or one errand, at one moment."""

    twin: TwinContext
    study: Study
    view: SiteView


@dataclass(frozen=True, slots=True, kw_only=True)
class Surveyor:
    """Turns the site as folded and sensed into what the planners look at.

    Attributes:
        graph_of: The construction relationship graph of a folded site.
        seed: First seed of all motion searches.
    """

    design: Design
    shapes: Mapping[ComponentId, PieceShape]
    ports: PlanningPorts
    graph_of: GraphOf
    seed: int = 0

    def jobsite(self, context: SiteContext) -> Jobsite:
        """Return the cell as sensed."""
        return jobsite_of(self.design, self.shapes, context, self.ports.backends.kinematics)

    def situation(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        target: ComponentId,
        candidates: tuple[ComponentId, ...],
        watch: Stopwatch,
    ) -> Situation:
        """Return what is known about a target, after the batch check.

        Args:
            graph: Graph of the site as it is.
            context: Folded site and observation.
            target: What is to be built.
            candidates: Pieces that may become it.
            watch: Where the time goes.
        """
        site = self.jobsite(context)
        task = task_of(self.design, graph, context, target, candidates)
        view = self.view(graph, context, site, target, candidates)
        return self._studied(context, site, task, view, watch)

    def errand(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        target: ComponentId,
        errand: Errand,
        watch: Stopwatch,
    ) -> Situation:
        """Return what is known about bringing a piece to a buffer, for the sake of a target."""
        site = self.jobsite(context)
        task = errand_task(self.design, graph, context, site, errand)
        bare = self.view(graph, context, site, target, ())
        view = replace(
            bare,
            movable=(errand.piece,),
            errand=errand,
            lies_at=lies_at(graph, context, (errand.piece,)),
        )
        return self._studied(context, site, task, view, watch)

    def _studied(
        self, context: SiteContext, site: Jobsite, task: Task, view: SiteView, watch: Stopwatch
    ) -> Situation:
        rejections, target = context.site.rejections, view.target
        twin = self._twin(context, site, task, target)
        watch.start()
        studied = study(twin, view.lies_at)
        watch.stop("motion")
        base = without_refused_robots(studied.base, target, rejections)
        studied = replace(studied, base=base)
        return Situation(twin=twin, study=studied, view=replace(view, geometry=studied.facts))

    def twin(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        target: ComponentId,
        candidates: tuple[ComponentId, ...],
    ) -> TwinContext:
        """Return the twin's picture of a target, before any check."""
        site = self.jobsite(context)
        task = task_of(self.design, graph, context, target, candidates)
        return self._twin(context, site, task, target)

    def _twin(
        self, context: SiteContext, site: Jobsite, task: Task, target: ComponentId
    ) -> TwinContext:
        return TwinContext(
            backends=self.ports.backends,
            site=site,
            task=task,
            seed=another_seed(self.seed, target, context.site.rejections),
            kept=self.ports.kept,
            detours=detours(target, context.site.rejections, everywhere=context.again),
        )

    def view(
        self,
        graph: ConstructionGraph,
        context: SiteContext,
        site: Jobsite,
        target: ComponentId,
        candidates: tuple[ComponentId, ...],
    ) -> SiteView:
        """Return the symbolic picture, without geometric facts."""
        placed = context.site.placed
        return SiteView(
            graph=graph,
            cell=self.design.cell,
            target=target,
            candidates=candidates,
            robot_status=robot_statuses(self.design, context, site),
            lies_at=lies_at(graph, context, candidates),
            in_place={t: p.piece for t, p in placed.items() if t not in context.site.installed},
            standing=context.site.standing,
            done_operations=context.site.done_operations,
            docked=dict(context.observation.docked),
        )
