"""What a refused motion teaches the symbolic planner: facts that go, come, or cost more.

Refusals arrive as plain values, because the planning twin lies above this package.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from sitewright.errors import BackendError
from sitewright.foundation.canonical import Json, canonical_json, sha256_hex
from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.site_view import GeometricFacts, PlaceId

SLOWER_FACTOR = 4.0
"""A reach whose search budget ended is tried again at this many times its price."""


class Change(StrEnum):
    """What a nogood does to its fact."""

    REMOVED = "removed"
    ADDED = "added"
    SLOWER = "slower"
    """The fact is a ``reach-time``; it is multiplied by `SLOWER_FACTOR`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Nogood:
    """One thing learned.

    Attributes:
        fact: Predicate and site ids.
        is_proven: False if a search budget ended.
        evidence: Sentence for people: what was tried and what was in the way.
        scope: Hash of all that it depends on (`scope_hash`); another hash and it is void.
        remedy: What a person can do about it; empty if the fact says enough.
        removals: Smallest sets of bodies and robots without which the motion might be possible.
    """

    fact: Fact
    change: Change
    is_proven: bool
    evidence: str
    scope: str
    remedy: str = ""
    removals: tuple[tuple[str, ...], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class RefusedCall:
    """A refusal by the planning twin, in plain values.

    Attributes:
        kind: Class of the refusal: ``NoIk``, ``BlockedBy``, ``NoPath``, ...
        skill: What the motion is for (`purpose`): a reach that carries a piece to its target
            is refused as ``position``, one towards stock as ``grasp``.
        place: Site id of the place that the motion goes to, or stays at.
        end_effector: Mounted gripper; needed for ``grasp``.
        piece: For ``grasp``, ``position`` and ``set-down``.
        is_proven: As the refusal says; ignored where its class decides.
        blocking_robot: If another robot is in the way.
        blocking_place: Where that robot is; None is in transit or parked.
        attempt: 1 if this call in this scope is refused for the first time.
        removals: As `Nogood` has them.
    """

    kind: str
    skill: str
    robot: RobotId
    place: PlaceId
    end_effector: EndEffectorId | None = None
    piece: ComponentId | None = None
    is_proven: bool = True
    blocking_robot: RobotId | None = None
    blocking_place: PlaceId | None = None
    attempt: int = 1
    evidence: str = ""
    scope: str = ""
    removals: tuple[tuple[str, ...], ...] = ()


def scope_hash(parts: Mapping[str, Json]) -> str:
    """Return the hash of all that a refusal depends on.

    Args:
        parts: Robot, base, end effector, place pose, grasp, shapes and poses of blockers.
    """
    return sha256_hex(canonical_json(parts))


def purpose(calls: Sequence[SkillCall], index: int) -> SkillCall:
    """Return the act that a reach serves: its robot's next call, unless that leaves again."""
    call = calls[index]
    if call.skill != Skill.REACH:
        return call
    later = (c for c in calls[index + 1 :] if c.robot == call.robot)
    act = next(later, call)
    return call if act.skill in (Skill.REACH, Skill.RETRACT) else act


def fact_of(refused: RefusedCall) -> Fact:
    """Return the geometric fact that a call relies on."""
    match refused.skill:
        case Skill.GRASP if refused.end_effector is not None and refused.piece is not None:
            return ("can-grasp", refused.robot, refused.end_effector, refused.piece)
        case Skill.POSITION if refused.piece is not None:
            return ("can-place", refused.robot, refused.piece, refused.place)
        case Skill.SET_DOWN if refused.piece is not None:
            return ("can-set-down", refused.robot, refused.piece, refused.place)
        case _:
            return ("can-reach", refused.robot, refused.place)


def nogoods_of(refused: RefusedCall) -> tuple[Nogood, ...]:
    """Return what a refusal teaches; nothing means: plan the motion again.

    Raises:
        BackendError: The kind of refusal is unknown.
    """
    match refused.kind:
        case "NoGrasp" | "PayloadExceeded":
            return (_removed(replace(refused, skill=Skill.GRASP), is_proven=refused.is_proven),)
        case "NoIk" if refused.is_proven:
            return (_removed(refused, is_proven=True),)
        case "BlockedBy":
            return _blocked(refused)
        case "NoIk" | "NoPath":
            return _budget_ended(refused, first=1)
        case "Disagreement" | "WorkerFailed":
            return _budget_ended(refused, first=2) if refused.attempt > 1 else ()
        case "NotClear" | "StaleCertificate":
            return ()
        case _:
            raise BackendError(f"Refusal {refused.kind!r} is not known to the symbolic planner.")


def _blocked(refused: RefusedCall) -> tuple[Nogood, ...]:
    if refused.blocking_robot is None:
        return (_removed(refused, is_proven=True),)
    if refused.blocking_place is None or refused.blocking_place == refused.place:
        return _budget_ended(refused, first=1)
    here, there = refused.place, refused.blocking_place
    return tuple(
        Nogood(
            fact=fact,
            change=Change.ADDED,
            is_proven=True,
            evidence=refused.evidence,
            scope=refused.scope,
            removals=refused.removals,
        )
        for fact in (
            ("excludes", refused.robot, here, there),
            ("excludes", refused.blocking_robot, there, here),
        )
    )


def _budget_ended(refused: RefusedCall, *, first: int) -> tuple[Nogood, ...]:
    if refused.attempt > first:
        return (_removed(refused, is_proven=False),)
    return (
        Nogood(
            fact=("reach-time", refused.robot, refused.place),
            change=Change.SLOWER,
            is_proven=False,
            evidence=refused.evidence,
            scope=refused.scope,
        ),
    )


def _removed(refused: RefusedCall, *, is_proven: bool) -> Nogood:
    return Nogood(
        fact=fact_of(refused),
        change=Change.REMOVED,
        is_proven=is_proven,
        evidence=refused.evidence,
        scope=refused.scope,
        removals=refused.removals,
    )


def with_nogoods(facts: GeometricFacts, nogoods: Iterable[Nogood]) -> GeometricFacts:
    """Return the geometric facts as all nogoods leave them."""
    for nogood in nogoods:
        facts = _with_nogood(facts, nogood)
    return facts


def _with_nogood(facts: GeometricFacts, nogood: Nogood) -> GeometricFacts:
    predicate, arguments = nogood.fact[0], nogood.fact[1:]
    if nogood.change is Change.SLOWER:
        times = dict(facts.reach_time_s)
        key = (RobotId(arguments[0]), arguments[1])
        if key in times:
            times[key] *= SLOWER_FACTOR
        return replace(facts, reach_time_s=times)
    name = predicate.replace("-", "_")
    known = getattr(facts, name)
    one = frozenset({arguments})
    changed = known | one if nogood.change is Change.ADDED else known - one
    changes: dict[str, frozenset[tuple[str, ...]]] = {name: changed}
    return replace(facts, **changes)  # type: ignore[arg-type]


def still_valid(
    nogoods: Iterable[Nogood], scope_now: Callable[[Nogood], str]
) -> tuple[Nogood, ...]:
    """Return the nogoods whose scope is unchanged; the others have expired."""
    return tuple(n for n in nogoods if scope_now(n) == n.scope)


def is_known(nogoods: Iterable[Nogood], fact: Fact, scope: str) -> bool:
    """Whether a fact was already taken away in this very scope: then do not try it again."""
    return any(
        n.fact == fact and n.scope == scope and n.change is not Change.SLOWER for n in nogoods
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class MinimalReason:
    """Why a target cannot be built, and what would help.

    Attributes:
        alone: Nogoods of which lifting any single one is enough.
        together: If none is: a smallest set by greedy choice that must be lifted together;
            empty if nothing learned is to blame.
    """

    alone: tuple[Nogood, ...]
    together: tuple[Nogood, ...]


def minimal_reason(
    nogoods: Sequence[Nogood], is_solvable: Callable[[Sequence[Nogood]], bool]
) -> MinimalReason:
    """Return which nogoods are to blame.

    Args:
        nogoods: All that stand.
        is_solvable: Whether a plan exists with only these nogoods.
    """
    alone = tuple(
        n for k, n in enumerate(nogoods) if is_solvable([*nogoods[:k], *nogoods[k + 1 :]])
    )
    if alone or not is_solvable([]):
        return MinimalReason(alone=alone, together=())
    lifted = list(nogoods)
    for nogood in nogoods:
        rest = [n for n in lifted if n is not nogood]
        if is_solvable([n for n in nogoods if n not in rest]):
            lifted = rest
    return MinimalReason(alone=(), together=tuple(lifted))
