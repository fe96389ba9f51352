"""The batch check before symbolic planning: which robot can take, place and reach what."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial

from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.holding import (
    depends_on_start,
    find_holding,
    is_for_fasteners,
    steadying,
)
from sitewright.planning_twin.holding_scope import holding_scope
from sitewright.planning_twin.jobsite import Jobsite
from sitewright.planning_twin.passing_on import might_be_passed_on
from sitewright.planning_twin.refusal import BlockedBy, NoGrasp, Refusal
from sitewright.planning_twin.scope import scope_of
from sitewright.planning_twin.study_facts import base_facts, out_of_reach, tools_at_spots
from sitewright.planning_twin.study_waiting import in_the_way_where_they_wait
from sitewright.planning_twin.tacking import Holding
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.wording import in_words, is_proof
from sitewright.robot_team.cell import EndEffectorKind, Robot
from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.nogood import Change, Nogood, with_nogoods
from sitewright.symbolic_planning.site_view import GeometricFacts, PlaceId


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyRefusal:
    """What the batch check found impossible, and the fact that is false because of it.

    Attributes:
        piece: Which piece cannot be taken and placed; None if it is about something else.
    """

    nogood: Nogood
    refusal: Refusal
    piece: ComponentId | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Study:
    """What the twin knows of a task before any plan is made.

    Attributes:
        base: Facts as if nothing had been refused.
        holdings: By robot and piece: the grasp that serves all its motions.
        lies_at: Stock place or buffer station of each candidate piece.
        passable: Pieces that robots might pass on to the target by way of buffers.
    """

    base: GeometricFacts
    holdings: Mapping[tuple[RobotId, ComponentId], Holding]
    refusals: tuple[StudyRefusal, ...] = ()
    lies_at: Mapping[ComponentId, PlaceId] = field(default_factory=dict)
    passable: frozenset[ComponentId] = frozenset()

    def depends_on_start(self, piece: ComponentId) -> bool:
        """Tell whether a piece might be taken and placed if it lay, or were held, differently.

        Not if all that refuse it would refuse it anywhere: too heavy, or the target is too far.
        """
        told = [r.refusal for r in self.refusals if r.piece == piece]
        is_served = any(p == piece for _, p in self.holdings)
        is_held = bool(told) and piece not in self.lies_at
        return is_served or is_held or any(depends_on_start(r) for r in told)

    @property
    def nogoods(self) -> tuple[Nogood, ...]:
        """What the refusals take away."""
        return tuple(r.nogood for r in self.refusals)

    @property
    def facts(self) -> GeometricFacts:
        """The facts as the refusals leave them."""
        return with_nogoods(self.base, self.nogoods)


def study(context: TwinContext, lies_at: Mapping[ComponentId, PlaceId]) -> Study:
    """Check reach, grasps, holds and fastener access of every robot for a task.

    Args:
        context: Engines, site and task.
        lies_at: Stock place or buffer station of each candidate piece.
    """
    handlers = list(_handlers(context))
    holdings: dict[tuple[RobotId, ComponentId], Holding] = {}
    refusals: list[StudyRefusal] = []
    for robot, piece in handlers:
        found = _holding(context, robot, piece)
        if isinstance(found, Holding):
            found = _if_tacks_agree(holdings, found)
        if isinstance(found, Holding):
            holdings[robot.id, piece] = found
        elif found is not None:
            refusals.append(_no_holding(context, robot, piece, found))
    refusals += _no_reach(context)
    might = [(r.id, p) for r, p in handlers]
    return Study(
        base=_base(context, might, holdings, lies_at),
        holdings=holdings,
        refusals=tuple(refusals),
        lies_at=lies_at,
        passable=frozenset(_passable(context)),
    )


def _passable(context: TwinContext) -> Iterator[ComponentId]:
    task = context.task
    if task.buffers and task.placed is None:
        yield from (p for p in task.candidates if might_be_passed_on(context, p))


def with_another_grasp(
    context: TwinContext, studied: Study, holding: Holding, tried: tuple[Holding, ...]
) -> Study | None:
    """Return the study with the next grasp of a robot for a piece, or None if none is left.

    Args:
        context: As for `study`.
        studied: What is known so far.
        holding: The one whose motions were refused.
        tried: All that were refused, this one included, in order.
    """
    robot = context.cell.robot_by_id[holding.robot]
    found = find_holding(context, robot, holding.piece, tried=tried)
    if not isinstance(found, Holding):
        return None
    holdings = {**studied.holdings, (holding.robot, holding.piece): found}
    might = [(r.id, p) for r, p in _handlers(context)]
    return replace(
        studied,
        base=_base(context, might, holdings, studied.lies_at),
        holdings=holdings,
    )


def _base(
    context: TwinContext,
    might: list[tuple[RobotId, ComponentId]],
    holdings: Mapping[tuple[RobotId, ComponentId], Holding],
    lies_at: Mapping[ComponentId, PlaceId],
) -> GeometricFacts:
    facts = base_facts(context, might, holdings, lies_at)
    waiting = frozenset(in_the_way_where_they_wait(context, holdings))
    return replace(facts, excludes=facts.excludes | waiting)


def _holding(context: TwinContext, robot: Robot, piece: ComponentId) -> Holding | Refusal | None:
    """Return a holding, why there is none, or None where none is needed."""
    if context.task.placed is not None:
        return steadying(context, robot, piece)
    question = ("hold", robot.id, piece, context.task.target)
    scope = partial(holding_scope, context, robot, piece)
    known = context.kept.recall(question, scope)
    if known is not None:
        return known
    found = find_holding(context, robot, piece)
    if not isinstance(found, Holding):
        context.kept.keep(question, found, scope(found))
    return found


def _if_tacks_agree(
    holdings: Mapping[tuple[RobotId, ComponentId], Holding], found: Holding
) -> Holding | NoGrasp:
    """Return a holding if it waits for the same fasteners as the first one.

    Which fasteners a release waits for is one fact of the target, whoever holds the piece.
    """
    first = next(iter(holdings.values()), found)
    if set(first.tacks) == set(found.tacks):
        return found
    reason = Sentence(
        "{robot} holds {piece} while other fasteners are driven",
        robot=first.robot,
        piece=first.piece,
    )
    return NoGrasp(is_proven=False, candidates=1, reason=reason)


def _handlers(context: TwinContext) -> Iterator[tuple[Robot, ComponentId]]:
    for robot in context.cell.robot_by_id.values():
        tool = context.tool_of(robot.id)
        if tool is None or tool.kind is not EndEffectorKind.GRIPPER:
            continue
        held = context.site.arms[robot.id].held
        for piece in context.task.candidates:
            if held in (None, piece) and _is_free_for(context.site, robot.id, piece):
                yield robot, piece


def _is_free_for(site: Jobsite, robot: RobotId, piece: ComponentId) -> bool:
    return all(arm.held != piece or r == robot for r, arm in site.arms.items())


def _no_holding(
    context: TwinContext, robot: Robot, piece: ComponentId, refusal: Refusal
) -> StudyRefusal:
    arm, target = context.site.arms[robot.id], context.task.target
    if arm.held == piece or arm.mounted is None:
        fact: Fact = ("can-place", robot.id, piece, target)
    else:
        fact = ("can-grasp", robot.id, arm.mounted, piece)
    evidence = Sentence(
        "{robot} cannot take {piece} and place it at {target}: {why}",
        robot=robot.id,
        piece=piece,
        target=target,
        why=in_words(refusal),
    )
    refused = replace(_refused(context, robot, fact, refusal, evidence), piece=piece)
    if isinstance(refusal, BlockedBy):
        away = tuple(other for _, other in refusal.pairs)
        remedy = Sentence("take {things:and} out of the way", things=away)
    elif is_for_fasteners(refusal):
        remedy = Sentence(
            "let go of {target} with fewer fasteners driven, or another robot or gripper",
            target=target,
        )
    else:
        return refused
    return replace(refused, nogood=replace(refused.nogood, remedy=remedy))


def _no_reach(context: TwinContext) -> Iterator[StudyRefusal]:
    for robot, spot, tool in tools_at_spots(context):
        refusal = out_of_reach(context, robot, spot, tool)
        if refusal is not None:
            evidence = Sentence(
                "{robot} cannot reach {place}: {why}",
                robot=robot.id,
                place=spot.operation,
                why=in_words(refusal),
            )
            fact = ("can-reach", robot.id, spot.operation)
            yield _refused(context, robot, fact, refusal, evidence)


def _refused(
    context: TwinContext, robot: Robot, fact: Fact, refusal: Refusal, evidence: str
) -> StudyRefusal:
    nogood = Nogood(
        fact=fact,
        change=Change.REMOVED,
        is_proven=is_proof(refusal),
        evidence=evidence,
        scope=scope_of(context.site, robot.id, fact),
        removals=refusal.removals if isinstance(refusal, BlockedBy | NoGrasp) else (),
    )
    return StudyRefusal(nogood=nogood, refusal=refusal)
