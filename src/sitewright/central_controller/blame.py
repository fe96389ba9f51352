"""Why a target cannot be built, in the fewest words that are true, and what would help."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sitewright.foundation.ids import ComponentId
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


def reason_for(target: ComponentId, otherwise: str, blame: MinimalReason) -> str:
    """Return a minimal reason for people.

    Args:
        target: What cannot be built.
        otherwise: What the symbolic planner says; used if nothing learned is to blame.
        blame: What is to blame.
    """
    if blame.alone:
        lead = "This might help" if len(blame.alone) == 1 else "Any one of these might help"
        return f"{target}: {_evidence(blame.alone)}. {lead}: {_remedies(blame.alone)}."
    if blame.together:
        return (
            f"{target}: {_evidence(blame.together)}. "
            f"All of these may be needed: {_remedies(blame.together)}."
        )
    return f"{target}: {otherwise}"


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


def _evidence(nogoods: Sequence[Nogood]) -> str:
    return "; ".join(dict.fromkeys(n.evidence for n in nogoods))


def _remedies(nogoods: Sequence[Nogood]) -> str:
    return "; ".join(dict.fromkeys(_remedy(n) for n in nogoods))


def _remedy(nogood: Nogood) -> str:
    if nogood.remedy:
        return nogood.remedy
    predicate, robot, *others = nogood.fact
    match predicate:
        case "can-reach":
            return f"move {robot}'s base, let another robot do {others[0]}, or do it by hand"
        case "can-grasp":
            return f"another robot, gripper or stock place for {others[1]}"
        case "can-place" | "can-set-down":
            return f"another robot or another way to hold {others[0]}"
        case "excludes":
            return f"another posture for whoever stands at {others[1]}"
        case _:
            return f"make ({' '.join(nogood.fact)}) true"
