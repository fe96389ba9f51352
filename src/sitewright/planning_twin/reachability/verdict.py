"""What a reach answer means for each target: buildable, waiting, not found, or impossible."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from sitewright.foundation.ids import ComponentId, OperationId, RobotId
from sitewright.planning_twin.reachability.answer import (
    Handling,
    Operating,
    ReachAnswer,
    Steadying,
)
from sitewright.planning_twin.reachability.question import ReachQuestion, ReachTarget
from sitewright.planning_twin.wording import in_words, is_proof


class Standing(StrEnum):
    """How a target stands in the check."""

    BUILDABLE = "buildable"
    """Some robot reaches every end that it takes, and so it is with all that it waits for."""
    WAITING = "waiting"
    """It could be built, but not something that must be there before."""
    NOT_FOUND = "not-found"
    """No way was found; that none exists is not proven."""
    IMPOSSIBLE = "impossible"
    """It is proven that no robot of this cell, as it stands, can do what it takes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetVerdict:
    """One target.

    Attributes:
        robots: Who can place it, the one with the most kinds of grasps first.
        ways: Kinds of grasps of all of them.
        reasons: Why it cannot be built, in sentences for people.
        waits_for: What it waits for that cannot be built.
    """

    target: ComponentId
    standing: Standing
    robots: tuple[RobotId, ...] = ()
    ways: int = 0
    reasons: tuple[str, ...] = ()
    waits_for: tuple[ComponentId, ...] = ()


@dataclass(frozen=True, slots=True)
class _No:
    reason: str
    is_proven: bool


def verdicts(question: ReachQuestion, answer: ReachAnswer) -> tuple[TargetVerdict, ...]:
    """Return what stands for each target, in construction order."""
    handlings: dict[ComponentId, list[Handling]] = defaultdict(list)
    operatings: dict[OperationId, list[Operating]] = defaultdict(list)
    for handling in answer.handlings:
        handlings[handling.target].append(handling)
    for operating in answer.operatings:
        operatings[operating.operation].append(operating)
    steadyings = {s.target: s for s in answer.steadyings}
    found: dict[ComponentId, TargetVerdict] = {}
    for target in question.targets:
        noes = [
            *_placing_noes(handlings[target.id]),
            *_operation_noes(target, operatings),
            *_holding_noes(steadyings.get(target.id)),
        ]
        found[target.id] = _verdict(target, handlings[target.id], noes, found)
    return tuple(found.values())


def share_of(found: Iterable[TargetVerdict]) -> float:
    """Return the share of targets that can be built, 0..1; of no targets it is 1."""
    standings = [v.standing for v in found]
    return standings.count(Standing.BUILDABLE) / len(standings) if standings else 1.0


def _verdict(
    target: ReachTarget,
    handlings: Iterable[Handling],
    noes: Sequence[_No],
    before: Mapping[ComponentId, TargetVerdict],
) -> TargetVerdict:
    able = sorted((h for h in handlings if h.ways), key=lambda h: (-len(h.ways), h.robot))
    missing = tuple(
        w for w in target.waits_for if w in before and before[w].standing is not Standing.BUILDABLE
    )
    return TargetVerdict(
        target=target.id,
        standing=_standing(noes, is_waiting=bool(missing)),
        robots=tuple(dict.fromkeys(h.robot for h in able)),
        ways=sum(len(h.ways) for h in able),
        reasons=tuple(no.reason for no in noes),
        waits_for=missing,
    )


def _standing(noes: Sequence[_No], *, is_waiting: bool) -> Standing:
    if any(no.is_proven for no in noes):
        return Standing.IMPOSSIBLE
    if noes:
        return Standing.NOT_FOUND
    return Standing.WAITING if is_waiting else Standing.BUILDABLE


def _placing_noes(handlings: Sequence[Handling]) -> Iterator[_No]:
    """Yield why nobody places a target; a hand-over can join robots that reach one end each."""
    if not handlings:
        yield _No("no robot has a gripper", is_proven=True)
    elif not any(h.ways for h in handlings):
        is_proven = all(h.never_at_target for h in handlings) or all(
            h.never_at_stock for h in handlings
        )
        yield _No("; ".join(map(_of_handling, handlings)), is_proven)


def _of_handling(handling: Handling) -> str:
    refused = handling.refused
    if refused is None:
        return f"{handling.robot}: can"
    where = "" if refused.where == "both" else f" at the {refused.where}"
    is_whole = handling.never_at_target or handling.never_at_stock
    only = " as the piece lies" if is_proof(refused.refusal) and not is_whole else ""
    return f"{handling.robot}{where}: {in_words(refused.refusal)}{only}"


def _operation_noes(
    target: ReachTarget, operatings: Mapping[OperationId, Sequence[Operating]]
) -> Iterator[_No]:
    for spot in target.task.spots:
        rows = operatings.get(spot.operation, ())
        if not rows:
            reason = f"{spot.operation}: no robot has a tool for it"
            yield _No(reason, is_proven=True)
        elif not any(r.ways for r in rows):
            refusals = [(r.robot, r.refused.refusal) for r in rows if r.refused is not None]
            words = "; ".join(f"{robot}: {in_words(no)}" for robot, no in refusals)
            yield _No(f"{spot.operation}: {words}", all(is_proof(no) for _, no in refusals))


def _holding_noes(steadying: Steadying | None) -> Iterator[_No]:
    """Yield that too few fasteners can be driven while a piece is held, if it can be held."""
    if steadying is None or steadying.is_enough or not steadying.ways:
        return
    yield _No(
        f"of {steadying.needed} fasteners that must be driven before it is let go, "
        f"{len(steadying.done)} are reached while it is held ({steadying.ways} ways to hold it "
        "were looked at)",
        is_proven=False,
    )
