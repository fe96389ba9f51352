"""What would help where a target has no plan: changes that were planned through on a copy."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice

from sitewright.building_model.model import RelationKind
from sitewright.central_controller.copies import (
    moved_on_a_copy,
    with_component,
    with_model,
    without_pieces,
)
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.outcomes import steps_of
from sitewright.central_controller.ports import CounterProposal, SiteContext
from sitewright.central_controller.recovering import Recovery, pieces_in_the_way
from sitewright.central_controller.rehearsal import built
from sitewright.central_controller.surveying import Surveyor
from sitewright.central_controller.target_outcome import TargetPlan, TargetRefusal
from sitewright.construction_graph.graph import MaterialNode
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Vector
from sitewright.foundation.sentence import Sentence

_MOST_TRIED = 6
"""So many changes are planned through; each may take as long as the target itself."""
_ENOUGH = 2
"""So many that work are told."""
_STACK_STEPS_M = (0.3, 0.6)
_BASE_STEPS_M = (0.1, 0.3)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Change:
    """A change of model, cell or site, in words, and what the planner would look at then.

    Attributes:
        about: Changes about the same thing are told once: the first that works.
        first: Another target that is built before, and the piece that it is made of.
    """

    words: str
    surveyor: Surveyor
    context: SiteContext
    about: str = ""
    first: tuple[ComponentId, ComponentId] | None = None


@dataclass(frozen=True, slots=True)
class _Nearer:
    """A stack or a robot that may be put nearer to a goal, with the names for people."""

    thing: str
    name: str
    towards: str
    goal_m: Vector
    steps_m: tuple[float, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Adviser:
    """Looks for changes with which a target has a plan.

    Attributes:
        target: What has no plan.
        watch: Where the time goes.
    """

    surveyor: Surveyor
    target: ComponentId
    watch: Stopwatch

    def counter_proposals(
        self, context: SiteContext, refusal: TargetRefusal
    ) -> tuple[CounterProposal, ...]:
        """Return the first changes that work, in words; only what was planned through is told."""
        found: dict[str, CounterProposal] = {}
        for change in islice(self._changes(context, refusal), _MOST_TRIED):
            about = change.about or change.words
            works = None if about in found else self._planned(change)
            if works is not None:
                found[about] = works
            if len(found) >= _ENOUGH:
                break
        return tuple(found.values())

    def _planned(self, change: _Change) -> CounterProposal | None:
        """Plan the target after a change; None if there is no plan then either."""
        recovery = Recovery(surveyor=change.surveyor, target=self.target, watch=self.watch)
        context = change.context
        if change.first is not None:
            other, piece = change.first
            before = replace(recovery, target=other).made_of(context, (piece,))
            if not isinstance(before, TargetPlan):
                return None
            context = built(context, steps_of(before), other)
        outcome = recovery.by_itself(context)
        if isinstance(outcome, TargetRefusal):
            cleared = recovery.once_cleared(context, outcome)
            if cleared is None:
                return None
            outcome = cleared
        steps = steps_of(outcome)
        duration_s = sum(s.duration_s for s in steps)
        return CounterProposal(words=change.words, steps=len(steps), duration_s=duration_s)

    def _changes(self, context: SiteContext, refusal: TargetRefusal) -> Iterator[_Change]:
        """Yield changes in the order of how little they ask for."""
        yield from self._other_orders(context, refusal)
        yield from self._taken_away(context, refusal)
        yield from self._driven_later(context)
        yield from self._let_go_earlier(context, refusal)
        yield from self._moved(context, refusal)

    def _other_orders(self, context: SiteContext, refusal: TargetRefusal) -> Iterator[_Change]:
        """Yield that what is in the way becomes a target first that the design wants later."""
        model = self.surveyor.design.model
        for relation in model.relations:
            if (relation.kind, relation.a) != (RelationKind.BEFORE, self.target):
                continue
            others = tuple(r for r in model.relations if r is not relation)
            surveyor = with_model(self.surveyor, replace(model, relations=others))
            for piece in pieces_in_the_way(surveyor, context, refusal, relation.b):
                yield _Change(
                    words=Sentence(
                        "place {other} before {target}", other=relation.b, target=self.target
                    ),
                    surveyor=surveyor,
                    context=context,
                    first=(relation.b, piece),
                )

    def _taken_away(self, context: SiteContext, refusal: TargetRefusal) -> Iterator[_Change]:
        """Yield that loose pieces are taken out of the way by hand."""
        nodes = self.surveyor.graph_of(context).node_by_id
        for things in refusal.removals:
            pieces = [ComponentId(t) for t in things]
            if all(isinstance(nodes.get(p), MaterialNode) for p in pieces):
                yield _Change(
                    words=Sentence("take {pieces:and} away", pieces=tuple(pieces)),
                    surveyor=self.surveyor,
                    context=without_pieces(context, pieces),
                )

    def _driven_later(self, context: SiteContext) -> Iterator[_Change]:
        """Yield that a fastener which must be driven while the piece is held comes afterwards."""
        model = self.surveyor.design.model
        component = model.component_by_id[self.target]
        for forced in (o for o in component.operations if o.needs_hold):
            operations = tuple(
                replace(o, needs_hold=False) if o is forced else o for o in component.operations
            )
            yield _Change(
                words=Sentence(
                    "let {operation} be driven after {target} is let go of",
                    operation=forced.id,
                    target=self.target,
                ),
                surveyor=with_component(self.surveyor, replace(component, operations=operations)),
                context=context,
            )

    def _let_go_earlier(self, context: SiteContext, refusal: TargetRefusal) -> Iterator[_Change]:
        """Yield that fewer fasteners are driven while the piece is held, the rest afterwards."""
        component = self.surveyor.design.model.component_by_id[self.target]
        forced = sum(o.needs_hold for o in component.operations)
        if not any(f[0] in ("can-grasp", "can-place") for f in refusal.blamed):
            return
        for count in range(component.hold_until_fasteners - 1, max(forced, 1) - 1, -1):
            fewer = replace(component, hold_until_fasteners=count)
            yield _Change(
                words=Sentence(
                    "let go of {target} with {count} of its fasteners driven",
                    target=self.target,
                    count=count,
                ),
                about="hold_until_fasteners",
                surveyor=with_component(self.surveyor, fewer),
                context=context,
            )

    def _moved(self, context: SiteContext, refusal: TargetRefusal) -> Iterator[_Change]:
        """Yield that a stack or a robot stands a little nearer to where it is needed."""
        for wanted in self._wanted_nearer(context, refusal):
            for by_m in wanted.steps_m:
                moved = moved_on_a_copy(self.surveyor, context, wanted.thing, wanted.goal_m, by_m)
                if moved is not None:
                    yield _Change(
                        words=Sentence(
                            "move {thing} by {by_m:g} m towards {towards}",
                            thing=wanted.name,
                            by_m=by_m,
                            towards=wanted.towards,
                        ),
                        about=wanted.thing,
                        surveyor=moved[0],
                        context=moved[1],
                    )

    def _wanted_nearer(self, context: SiteContext, refusal: TargetRefusal) -> Iterator[_Nearer]:
        """Yield the stacks and robots that are too far from where they are needed."""
        design = self.surveyor.design
        nodes = self.surveyor.graph_of(context).node_by_id
        operations = design.component(self.target).operations
        spots = {str(o.id): o.component_T_operation for o in operations}
        for fact in refusal.blamed:
            robot = design.cell.robot_by_id[RobotId(fact[1])]
            match fact:
                case ("can-grasp", _, _, piece) if piece in refusal.start_matters:
                    node = nodes.get(ComponentId(piece))
                    if isinstance(node, MaterialNode):
                        base_m = robot.world_T_base.position_m
                        name = Sentence("the stack at {place}", place=node.place)
                        yield _Nearer(node.place, name, robot.id, base_m, _STACK_STEPS_M)
                case ("can-reach", _, place) if place in spots:
                    at_m = (design.world_T_target(self.target) @ spots[place]).position_m
                    yield _Nearer(
                        robot.id,
                        Sentence("the base of {robot}", robot=robot.id),
                        place,
                        at_m,
                        _BASE_STEPS_M,
                    )
                case _:
                    pass
