"""What is tried when a target has no plan, before a person is asked."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from sitewright.central_controller.choosing import choices_of_pieces
from sitewright.central_controller.errands import free_buffers
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.outcomes import steps_of
from sitewright.central_controller.ports import RefusalNote, SiteContext
from sitewright.central_controller.rehearsal import carried_out
from sitewright.central_controller.surveying import Surveyor
from sitewright.central_controller.target_planning import TargetPlan, TargetRefusal, plan_target
from sitewright.construction_graph.graph import MaterialNode
from sitewright.foundation.ids import ComponentId
from sitewright.symbolic_planning.site_view import Errand

_MOST_ERRANDS = 4
"""So many errands are planned for one target before a person is asked."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Recovery:
    """Plans one target, and looks for ways round a refusal.

    Attributes:
        target: What is to be built.
        watch: Where the time goes.
    """

    surveyor: Surveyor
    target: ComponentId
    watch: Stopwatch

    def plan(self, context: SiteContext) -> TargetPlan | TargetRefusal:
        """Plan the target, if need be after things were moved out of the way."""
        outcome = self._by_itself(context)
        if isinstance(outcome, TargetPlan):
            return outcome
        cleared = next(self._cleared(context, outcome), None)
        if cleared is None:
            return outcome
        return replace(cleared, notes=(*outcome.notes, *cleared.notes))

    def _by_itself(self, context: SiteContext) -> TargetPlan | TargetRefusal:
        """Plan the target, widening the choice of pieces if geometry refuses."""
        surveyor, notes = self.surveyor, list[RefusalNote]()
        graph = surveyor.graph_of(context)
        choices = choices_of_pieces(surveyor.design, graph, context, self.target)
        for candidates in choices:
            found = surveyor.situation(graph, context, self.target, candidates, self.watch)
            outcome = plan_target(surveyor.ports, found.twin, found.study, found.view, self.watch)
            notes += outcome.notes
            if isinstance(outcome, TargetPlan):
                break
        return replace(outcome, notes=tuple(notes))

    def _cleared(self, context: SiteContext, refusal: TargetRefusal) -> Iterator[TargetPlan]:
        """Yield plans that first bring the pieces in the way to buffers."""
        for things in refusal.removals[:_MOST_ERRANDS]:
            pieces = [ComponentId(t) for t in things]
            if all(self._is_movable(context, p) for p in pieces):
                yield from self._after_moving(context, pieces)

    def _after_moving(
        self, context: SiteContext, pieces: list[ComponentId]
    ) -> Iterator[TargetPlan]:
        if not pieces:
            outcome = self._by_itself(context)
            if isinstance(outcome, TargetPlan):
                yield outcome
            return
        first, *others = pieces
        for moved in self._errands(context, first):
            after = carried_out(context, steps_of(moved), self.target)
            for rest in self._after_moving(after, others):
                yield replace(rest, parts=(*moved.parts, *rest.parts))

    def _errands(self, context: SiteContext, piece: ComponentId) -> Iterator[TargetPlan]:
        """Yield the ways to bring a piece to a free buffer."""
        surveyor = self.surveyor
        graph, cell = surveyor.graph_of(context), surveyor.design.cell
        for place in free_buffers(cell, context.observation.world_T_piece, piece):
            errand = Errand(piece=piece, place=place)
            found = surveyor.errand(graph, context, self.target, errand, self.watch)
            outcome = plan_target(surveyor.ports, found.twin, found.study, found.view, self.watch)
            if isinstance(outcome, TargetPlan):
                yield outcome

    def _is_movable(self, context: SiteContext, piece: ComponentId) -> bool:
        node = self.surveyor.graph_of(context).node_by_id.get(piece)
        return isinstance(node, MaterialNode)
