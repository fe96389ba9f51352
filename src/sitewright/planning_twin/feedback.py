"""What a geometric "no" means for the next symbolic problem (symbolic note, section 6)."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field, replace

from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId
from sitewright.planning_twin.refusal import (
    BlockedBy,
    Disagreement,
    NoGrasp,
    NoIk,
    NoPath,
    NotClear,
    PayloadExceeded,
    Refusal,
    WorkerFailed,
)
from sitewright.planning_twin.sequence import SequenceRefusal
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.site_view import GeometricFacts, PlaceId

_SLOWER = 4.0
_PATIENCE = 2
"""A call whose search just ended without a path loses its fact when it is refused so often."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Lesson:
    """A change of the geometric facts that a refusal taught.

    Attributes:
        facts: Facts taken away (``-``) or added (``+``), in site ids, for people.
        new_seed: The same call is worth another try with another seed.
    """

    geometry: GeometricFacts
    facts: tuple[str, ...]
    new_seed: bool = False


@dataclass(frozen=True, slots=True)
class Lessons:
    """How often each call was refused without a proof."""

    count: Counter[SkillCall] = field(default_factory=Counter)


def learn(
    geometry: GeometricFacts, refused: SequenceRefusal, lessons: Lessons, target: ComponentId
) -> Lesson | None:
    """Return the facts after a refusal, or None if it cannot be said in facts.

    Args:
        geometry: Facts that the refused plan was made with.
        refused: The first call that geometry did not allow.
        lessons: Unproven refusals so far; counted up here.
        target: The active target.
    """
    call, refusal = refused.call, refused.cause.refusal
    other = refused.blocking_robot
    where = None if other is None else refused.place_by_robot.get(other)
    if other is not None and where is not None:
        return _exclude(geometry, call, other, where, refused)
    if _is_final(refusal):
        return _take_away(geometry, refused, target)
    lessons.count[call] += 1
    if lessons.count[call] < _PATIENCE:
        return _slow_down(geometry, call)
    return _take_away(geometry, refused, target)


def _is_final(refusal: Refusal) -> bool:
    match refusal:
        case NoIk(is_proven=is_proven) | NoGrasp(is_proven=is_proven):
            return is_proven
        case BlockedBy() | PayloadExceeded():
            return True
        case NotClear() | Disagreement():
            return False
        case _:
            return False


def _exclude(
    geometry: GeometricFacts,
    call: SkillCall,
    other: RobotId,
    where: PlaceId,
    refused: SequenceRefusal,
) -> Lesson | None:
    """One robot is in the other's way: they must not be at these two places together."""
    place = call.arguments[0] if call.skill == Skill.REACH else _place_of(call, refused)
    if place is None:
        return None
    added = {(call.robot, place, where), (other, where, place)}
    if added <= geometry.excludes:
        return None
    return Lesson(
        geometry=replace(geometry, excludes=geometry.excludes | added),
        facts=tuple(f"+ (excludes {' '.join(a)})" for a in sorted(added)),
    )


def _place_of(call: SkillCall, refused: SequenceRefusal) -> PlaceId | None:
    return refused.place_by_robot.get(call.robot)


def _slow_down(geometry: GeometricFacts, call: SkillCall) -> Lesson:
    if call.skill != Skill.REACH:
        return Lesson(geometry=geometry, facts=(), new_seed=True)
    key = (call.robot, call.arguments[0])
    slower = geometry.reach_time_s.get(key, 1.0) * _SLOWER
    times = {**geometry.reach_time_s, key: slower}
    return Lesson(
        geometry=replace(geometry, reach_time_s=times),
        facts=(f"(reach-time {key[0]} {key[1]}) x 4",),
        new_seed=True,
    )


def _take_away(
    geometry: GeometricFacts, refused: SequenceRefusal, target: ComponentId
) -> Lesson | None:
    """The call is impossible as things are: its geometric precondition is false."""
    call = refused.call
    place = call.arguments[0] if call.skill == Skill.REACH else _place_of(call, refused)
    arm = refused.site.arms[call.robot]
    if arm.held is not None and place == target:
        fact = (call.robot, arm.held, target)
        if fact in geometry.can_place:
            left = geometry.can_place - {fact}
            return _without("can-place", fact, replace(geometry, can_place=left))
    piece = next((a for a in call.arguments if a in refused.site.pieces), None)
    if call.skill == Skill.GRASP and piece is not None and arm.mounted is not None:
        grasp = (call.robot, EndEffectorId(arm.mounted), ComponentId(piece))
        left_grasps = geometry.can_grasp - {grasp}
        return _without("can-grasp", grasp, replace(geometry, can_grasp=left_grasps))
    if place is None or (call.robot, place) not in geometry.can_reach:
        return None
    reach = geometry.can_reach - {(call.robot, place)}
    return _without("can-reach", (call.robot, place), replace(geometry, can_reach=reach))


def _without(name: str, fact: tuple[str, ...], geometry: GeometricFacts) -> Lesson:
    return Lesson(geometry=geometry, facts=(f"- ({name} {' '.join(fact)})",))


def in_words(refusal: Refusal) -> str:
    """Return a refusal as a sentence for people."""
    match refusal:
        case NoIk() | NoGrasp() | PayloadExceeded():
            return _impossible(refusal)
        case BlockedBy(pairs=pairs, reason=reason):
            listed = ", ".join(f"{a} and {b}" for a, b in pairs[:3])
            return f"{reason or 'every posture collides'}: {listed}"
        case NotClear(pair=(a, b), distance_m=d, threshold_m=t):
            return f"{a} and {b} come to {d * 1000:.1f} mm, allowed {t * 1000:.1f} mm"
        case Disagreement(pair=(a, b), distance_m=d):
            return f"the cross-check sees {a} and {b} at {d * 1000:.1f} mm"
        case NoPath(nodes=nodes, reason=reason):
            return reason or f"no path was found within {nodes} nodes"
        case WorkerFailed(task=task, exit_status=status):
            return f"the planning process of {task} died with {status}"


def _impossible(refusal: NoIk | NoGrasp | PayloadExceeded) -> str:
    match refusal:
        case NoIk(extension_m=extension, is_proven=True) if extension < 0:
            return f"out of reach by {-extension * 1000:.0f} mm (proven)"
        case NoIk(reason=reason, is_proven=is_proven):
            proof = "proven" if is_proven else "not proven"
            return f"no posture reaches it ({proof}){f': {reason}' if reason else ''}"
        case NoGrasp(reason=reason):
            return reason
        case PayloadExceeded(mass_kg=mass, payload_kg=limit):
            return f"{mass:.0f} kg with the end effector, the arm carries {limit:.0f} kg"
