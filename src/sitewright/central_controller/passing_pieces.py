"""A piece passed on to its target by way of buffers: over which, and what it takes to bring it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from sitewright.central_controller.errands import free_buffers, lying_on_buffer
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.outcomes import steps_of
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.rehearsal import carried_out
from sitewright.central_controller.surveying import Surveyor
from sitewright.central_controller.target_outcome import PlanPart, TargetPlan
from sitewright.central_controller.target_planning import plan_target
from sitewright.construction_graph.graph import MaterialNode
from sitewright.foundation.ids import ComponentId, RobotId, StationId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.passing_on import ways_by_buffers
from sitewright.robot_team.skill import Skill
from sitewright.symbolic_planning.site_view import Errand

_MOST_BUFFERS = 3
"""A piece is laid down so often at most on its way."""
_MOST_ERRANDS = 12
"""So many errands are planned for one piece before another way round is looked for."""

Way = tuple[str, ...]
"""Buffers, from where the piece is towards the target."""


def buffers_for(surveyor: Surveyor, context: SiteContext, piece: ComponentId) -> list[str]:
    """Return the buffers that are free for a piece and that it does not lie on."""
    graph, cell = surveyor.graph_of(context), surveyor.design.cell
    node = graph.node_by_id.get(piece)
    here = node.place if isinstance(node, MaterialNode) else None
    free = free_buffers(cell, context.observation.world_T_piece, piece)
    return [place for place in free if place != here]


def errand_plan(
    surveyor: Surveyor, context: SiteContext, target: ComponentId, errand: Errand, watch: Stopwatch
) -> TargetPlan | None:
    """Return how a piece comes to a free buffer for the sake of a target, if it can."""
    found = surveyor.errand(surveyor.graph_of(context), context, target, errand, watch)
    outcome = plan_target(surveyor.ports, found.twin, found.study, found.view, watch)
    return outcome if isinstance(outcome, TargetPlan) else None


@dataclass(slots=True, kw_only=True)
class PassedOn:
    """The ways of one piece over buffers; what ways have in common is planned once.

    Attributes:
        context: The site as it is.
        target: What the piece is to become.
    """

    surveyor: Surveyor
    context: SiteContext
    target: ComponentId
    piece: ComponentId
    watch: Stopwatch
    _brought: dict[Way, TargetPlan | None] = field(default_factory=dict)
    _serves: dict[str, bool] = field(default_factory=dict)

    def ways(self) -> Iterator[Way]:
        """Yield the ways that reach does not rule out and whose end serves, the shortest first."""
        surveyor = self.surveyor
        free = set(buffers_for(surveyor, self.context, self.piece))
        graph = surveyor.graph_of(self.context)
        twin = surveyor.twin(graph, self.context, self.target, (self.piece,))
        for way in ways_by_buffers(twin, self.piece, most=_MOST_BUFFERS):
            if free.issuperset(way) and self._serves_from(way[-1]):
                yield way

    def brought(self, way: Way) -> TargetPlan | None:
        """Return the errands that bring the piece to the end of a way, as one plan."""
        if way not in self._brought:
            self._brought[way] = self._made(way)
        return self._brought[way]

    def _made(self, way: Way) -> TargetPlan | None:
        *before, place = way
        context, first = self.context, None
        if before:
            first = self.brought(tuple(before))
            if first is None:
                return None
            context = carried_out(context, steps_of(first), self.target)
        if len(self._brought) >= _MOST_ERRANDS:
            return None
        errand = Errand(piece=self.piece, place=place)
        moved = errand_plan(self.surveyor, context, self.target, errand, self.watch)
        return moved if moved is None or first is None else moved.after(first)

    def _serves_from(self, place: str) -> bool:
        """Tell whether a robot could take the piece from a buffer and place it at the target."""
        if place not in self._serves:
            surveyor, piece = self.surveyor, self.piece
            surface = surveyor.design.cell.station_by_id[StationId(place)].world_T_station
            there = lying_on_buffer(self.context, piece, surveyor.shapes[piece], surface)
            graph = surveyor.graph_of(there)
            found = surveyor.situation(graph, there, self.target, (piece,), self.watch)
            self._serves[place] = bool(found.study.holdings)
        return self._serves[place]


def passed_in_words(moved: TargetPlan, rest: TargetPlan, way: Way) -> Sentence:
    """Return how a piece goes by way of buffers: from hand to hand, or to be held otherwise."""
    by = [_who(part, Skill.SET_DOWN) for part in moved.parts]
    takes = _who(rest.parts[-1], Skill.GRASP)
    legs = [Sentence("{robot} lays it down at {place}", robot=by[0], place=way[0])]
    legs += [
        Sentence("{robot} takes it from there to {place}", robot=r, place=b)
        for r, b in zip(by[1:], way[1:], strict=True)
    ]
    if takes == by[-1]:
        return Sentence("{legs:comma} and takes it differently", legs=tuple(legs))
    return Sentence("{legs:comma}, where {robot} takes it", legs=tuple(legs), robot=takes)


def _who(part: PlanPart, skill: Skill) -> RobotId:
    """Return the robot that does a skill in a part of a plan."""
    return next(call.robot for call in part.motions.calls if call.skill == skill)
