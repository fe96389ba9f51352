"""What is tried when a target has no plan, before a person is asked."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from sitewright.central_controller.choosing import choices_of_pieces, other_ready_targets
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.outcomes import steps_of
from sitewright.central_controller.passing_pieces import (
    PassedOn,
    buffers_for,
    errand_plan,
    passed_in_words,
)
from sitewright.central_controller.ports import RefusalNote, SiteContext
from sitewright.central_controller.rehearsal import built, carried_out
from sitewright.central_controller.surveying import Surveyor
from sitewright.central_controller.target_outcome import TargetPlan, TargetRefusal
from sitewright.central_controller.target_planning import plan_target
from sitewright.construction_graph.graph import MaterialNode
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.sentence import Sentence
from sitewright.symbolic_planning.site_view import Errand

_MOST_ERRANDS = 4
"""So many errands are planned for one target before a person is asked."""
_MOST_BROUGHT = 2
"""So many pieces are tried to be laid down and taken differently."""


@dataclass(frozen=True, slots=True)
class _WayRound:
    """A plan that goes round a refusal, and what it does to get there, in words."""

    plan: TargetPlan
    words: str


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
        """Plan the target, if need be after pieces were moved."""
        outcome = self.by_itself(context)
        if isinstance(outcome, TargetPlan):
            return outcome
        for rung in (self._in_another_order, self._by_way_of_buffers, self._cleared):
            found = next(rung(context, outcome), None)
            if found is not None:
                answered = answered_by(outcome.notes, found.words)
                return replace(found.plan, notes=(*answered, *found.plan.notes))
        return outcome

    def by_itself(self, context: SiteContext) -> TargetPlan | TargetRefusal:
        """Plan the target, widening the choice of pieces if geometry refuses."""
        surveyor, notes = self.surveyor, list[RefusalNote]()
        graph = surveyor.graph_of(context)
        choices = choices_of_pieces(surveyor.design, graph, context, self.target)
        for candidates in choices:
            notes = (
                [*answered_by(notes, Sentence("{piece} may be taken", piece=candidates[-1]))]
                if notes
                else notes
            )
            outcome = self.made_of(context, candidates)
            notes += outcome.notes
            if isinstance(outcome, TargetPlan):
                break
        return replace(outcome, notes=tuple(notes))

    def made_of(
        self, context: SiteContext, candidates: tuple[ComponentId, ...]
    ) -> TargetPlan | TargetRefusal:
        """Plan the target from some pieces only, and on the site as it is."""
        surveyor = self.surveyor
        graph = surveyor.graph_of(context)
        found = surveyor.situation(graph, context, self.target, candidates, self.watch)
        return plan_target(surveyor.ports, found.twin, found.study, found.view, self.watch)

    def _in_another_order(
        self, context: SiteContext, refusal: TargetRefusal
    ) -> Iterator[_WayRound]:
        """Yield plans of other targets that are made of what is in the way of this one."""
        if self.target in context.site.placed:
            return
        graph = self.surveyor.graph_of(context)
        for other in other_ready_targets(graph, context, self.target):
            for piece in pieces_in_the_way(self.surveyor, context, refusal, other):
                first = replace(self, target=other).made_of(context, (piece,))
                if isinstance(first, TargetPlan):
                    after = built(context, steps_of(first), other)
                    if isinstance(self.by_itself(after), TargetPlan):
                        words = Sentence(
                            "{other} is built first, of {piece}, which is in the way",
                            other=other,
                            piece=piece,
                        )
                        yield _WayRound(first, words)

    def _by_way_of_buffers(
        self, context: SiteContext, refusal: TargetRefusal
    ) -> Iterator[_WayRound]:
        """Yield plans in which a piece is laid down first: for other robots, or another grasp."""
        for piece in refusal.passable[:_MOST_BROUGHT]:
            passed = PassedOn(
                surveyor=self.surveyor,
                context=context,
                target=self.target,
                piece=piece,
                watch=self.watch,
            )
            for way in passed.ways():
                moved = passed.brought(way)
                if moved is None:
                    continue
                after = carried_out(context, steps_of(moved), self.target)
                rest = self.made_of(after, (piece,))
                if isinstance(rest, TargetPlan):
                    yield _WayRound(rest.after(moved), passed_in_words(moved, rest, way))

    def once_cleared(self, context: SiteContext, refusal: TargetRefusal) -> TargetPlan | None:
        """Return a plan that first brings the pieces in the way to buffers, if there is one."""
        found = next(self._cleared(context, refusal), None)
        return None if found is None else found.plan

    def _cleared(self, context: SiteContext, refusal: TargetRefusal) -> Iterator[_WayRound]:
        """Yield plans that first bring the pieces in the way to buffers."""
        for things in refusal.removals[:_MOST_ERRANDS]:
            pieces = [ComponentId(t) for t in things]
            if all(self._is_movable(context, p) for p in pieces):
                for plan in self._after_moving(context, pieces):
                    words = _moved_first(tuple(pieces))
                    yield _WayRound(plan, words)

    def _after_moving(
        self, context: SiteContext, pieces: list[ComponentId]
    ) -> Iterator[TargetPlan]:
        if not pieces:
            outcome = self.by_itself(context)
            if isinstance(outcome, TargetPlan):
                yield outcome
            return
        first, *others = pieces
        for place in buffers_for(self.surveyor, context, first):
            errand = Errand(piece=first, place=place)
            moved = errand_plan(self.surveyor, context, self.target, errand, self.watch)
            if moved is not None:
                after = carried_out(context, steps_of(moved), self.target)
                for rest in self._after_moving(after, others):
                    yield rest.after(moved)

    def _is_movable(self, context: SiteContext, piece: ComponentId) -> bool:
        node = self.surveyor.graph_of(context).node_by_id.get(piece)
        return isinstance(node, MaterialNode)


def answered_by(notes: Iterable[RefusalNote], then: str) -> tuple[RefusalNote, ...]:
    """Return refusals with what was done instead, where that was not known before."""
    return tuple(n if n.then else replace(n, then=then) for n in notes)


def _moved_first(pieces: tuple[ComponentId, ...]) -> Sentence:
    if len(pieces) == 1:
        return Sentence("{pieces:and} is moved out of the way first", pieces=pieces)
    return Sentence("{pieces:and} are moved out of the way first", pieces=pieces)


def pieces_in_the_way(
    surveyor: Surveyor, context: SiteContext, refusal: TargetRefusal, other: ComponentId
) -> list[ComponentId]:
    """Return the pieces of which each is all that is in the way, and may become another target."""
    graph = surveyor.graph_of(context)
    fitting = choices_of_pieces(surveyor.design, graph, context, other)[-1]
    return [p for p in fitting if (p,) in refusal.removals]
