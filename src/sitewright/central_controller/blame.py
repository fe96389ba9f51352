"""Why a target cannot be built, in the fewest words that are true, and what would help."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.sentence import Sentence
from sitewright.symbolic_planning.nogood import Change, MinimalReason, Nogood, minimal_reason

IsSolvable = Callable[[Sequence[Nogood]], bool]
_MOST_BLAMED = 12
"""Each takes a symbolic plan; with more nogoods than this the last ones are looked at."""


def to_blame(nogoods: Sequence[Nogood], is_solvable: IsSolvable) -> MinimalReason:
    """Return the fewest nogoods without which the target could be built.

    Args:
        nogoods: All that stand.
        is_solvable: Whether a plan exists with only some of them.
    """
    standing = [n for n in nogoods if n.change is not Change.SLOWER]
    kept, looked_at = standing[:-_MOST_BLAMED], standing[-_MOST_BLAMED:]
    return minimal_reason(looked_at, lambda some: is_solvable([*kept, *some]))


def reason_for(target: ComponentId, otherwise: str, blame: MinimalReason) -> Sentence:
    """Return a minimal reason for people.

    Args:
        target: What cannot be built.
        otherwise: What the symbolic planner says; used if nothing learned is to blame.
        blame: What is to blame.
    """
    if len(blame.alone) == 1:
        return Sentence(
            "{target}: {evidence:semi}. This might help: {remedies:semi}.",
            target=target,
            evidence=_evidence(blame.alone),
            remedies=_remedies(blame.alone),
        )
    if blame.alone:
        return Sentence(
            "{target}: {evidence:semi}. Any one of these might help: {remedies:semi}.",
            target=target,
            evidence=_evidence(blame.alone),
            remedies=_remedies(blame.alone),
        )
    if blame.together:
        return Sentence(
            "{target}: {evidence:semi}. All of these may be needed: {remedies:semi}.",
            target=target,
            evidence=_evidence(blame.together),
            remedies=_remedies(blame.together),
        )
    return Sentence("{target}: {why}", target=target, why=otherwise)


def removals_of(blame: MinimalReason) -> tuple[tuple[str, ...], ...]:
    """Return the smallest sets of things that would have to go, the smallest first."""
    sets = {things for n in blame.alone for things in n.removals}
    if blame.together and all(n.removals for n in blame.together):
        sets.add(tuple(sorted({t for n in blame.together for t in n.removals[0]})))
    return tuple(sorted(sets, key=lambda s: (len(s), s)))


def pieces_to_blame(blame: MinimalReason) -> tuple[ComponentId, ...]:
    """Return the pieces that could be taken and placed if what is to blame did not stand."""
    found: list[ComponentId] = []
    for nogood in (*blame.alone, *blame.together):
        match nogood.fact:
            case ("can-grasp", _, _, piece) | ("can-place", _, piece, _):
                found.append(ComponentId(piece))
            case _:
                pass
    return tuple(dict.fromkeys(found))


def _evidence(nogoods: Sequence[Nogood]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(n.evidence for n in nogoods))


def _remedies(nogoods: Sequence[Nogood]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(_remedy(n) for n in nogoods))


def _remedy(nogood: Nogood) -> str:
    if nogood.remedy:
        return nogood.remedy
    predicate, robot, *others = nogood.fact
    match predicate:
        case "can-reach":
            return Sentence(
                "move {robot}'s base, let another robot do {place}, or do it by hand",
                robot=robot,
                place=others[0],
            )
        case "can-grasp":
            return Sentence("another robot, gripper or stock place for {piece}", piece=others[1])
        case "can-place" | "can-set-down":
            return Sentence("another robot or another way to hold {piece}", piece=others[0])
        case "excludes":
            return Sentence("another posture for whoever stands at {place}", place=others[1])
        case _:
            return Sentence("make {fact} true", fact=f"({' '.join(nogood.fact)})")
