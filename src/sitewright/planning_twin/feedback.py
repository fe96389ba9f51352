"""What a geometric "no" means for the next symbolic problem (symbolic note, section 6)."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field, replace

from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.blockers import removals
from sitewright.planning_twin.jobsite import scene_of
from sitewright.planning_twin.refusal import BlockedBy, Disagreement, NoGrasp, NotClear, Refusal
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.planning_twin.scope import scope_of
from sitewright.planning_twin.sequence import SequenceRefusal
from sitewright.planning_twin.wording import in_words, is_proof
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.nogood import (
    Nogood,
    RefusedCall,
    nogoods_of,
    purpose,
    with_nogoods,
)
from sitewright.symbolic_planning.site_view import GeometricFacts

_PLAIN_RETRIES = 2
"""A motion that could not be certified is planned so often again before it is a fact."""


@dataclass(slots=True)
class Lessons:
    """What the refusals of one target have taught so far.

    Attributes:
        base: Facts without any refusal.
        nogoods: Those of the batch check, then those of refused motions.
        new_seeds: So many refusals ask for another seed rather than for another plan.
    """

    base: GeometricFacts
    nogoods: list[Nogood]
    new_seeds: int = 0
    _count: Counter[tuple[SkillCall, str]] = field(default_factory=Counter)

    @property
    def facts(self) -> GeometricFacts:
        """The facts as all that was learned leaves them."""
        return with_nogoods(self.base, self.nogoods)

    def learn(self, refused: SequenceRefusal, calls: tuple[SkillCall, ...]) -> bool:
        """Take in a refusal; tell whether there is anything left to try.

        Args:
            refused: The first call of the plan that geometry did not allow.
            calls: The whole plan.
        """
        scope = _scope(refused)
        self._count[refused.call, scope] += 1
        attempt = self._count[refused.call, scope]
        call = refused_call(refused, calls, scope=scope, attempt=attempt)
        proof = is_proof(refused.cause.refusal)
        learned = [replace(n, is_proven=n.is_proven and proof) for n in nogoods_of(call)]
        if not learned or (not proof and attempt == 1 and call.blocking_robot is None):
            self.new_seeds += 1
        before = self.facts
        self.nogoods += [n for n in learned if n not in self.nogoods]
        return not learned or self.facts != before or attempt == 1


def refused_call(
    refused: SequenceRefusal, calls: tuple[SkillCall, ...], *, scope: str, attempt: int
) -> RefusedCall:
    """Return a refusal in plain values, as the symbolic planner takes it."""
    call, refusal = refused.call, refused.cause.refusal
    act = purpose(calls, refused.number)
    arm = refused.site.arms[call.robot]
    piece = next((ComponentId(a) for a in act.arguments if a in refused.site.pieces), arm.held)
    is_lift = call.skill == Skill.RETRACT and arm.held is not None
    other = refused.blocking_robot
    where = None if other is None else refused.place_by_robot.get(other)
    kind, attempt = _as_last_resort(refusal, attempt, is_known=where is not None)
    return RefusedCall(
        kind=kind,
        skill=Skill.GRASP if is_lift else act.skill,
        robot=call.robot,
        place=_place(refused),
        end_effector=arm.mounted,
        piece=piece,
        is_proven=is_proof(refusal),
        blocking_robot=other,
        blocking_place=where,
        attempt=attempt,
        evidence=sentence(act, _place(refused), piece, refusal),
        scope=scope,
        removals=removals_of_refused(refused),
    )


def removals_of_refused(refused: SequenceRefusal) -> tuple[tuple[str, ...], ...]:
    """Return the smallest sets of bodies and robots without which a call might be possible."""
    scene = scene_of(refused.site)
    return removals_of(scene, refused.call.robot, refused.cause.refusal)


def removals_of(
    scene: SceneSnapshot, robot: RobotId, refusal: Refusal
) -> tuple[tuple[str, ...], ...]:
    """Return the smallest sets of bodies and robots without which a motion might be possible."""
    match refusal:
        case NoGrasp(removals=sets):
            return sets
        case BlockedBy(pairs=pairs, removals=sets):
            return sets or removals(scene, robot, [pairs])
        case NotClear(pair=pair) | Disagreement(pair=pair):
            return removals(scene, robot, [(pair,)])
        case _:
            return ()


def _as_last_resort(refusal: Refusal, attempt: int, *, is_known: bool) -> tuple[str, int]:
    """Return kind and attempt; what stays uncertified counts as blocked, or as without a path."""
    kind = type(refusal).__name__
    if not isinstance(refusal, NotClear) or attempt <= _PLAIN_RETRIES:
        return kind, attempt
    return "BlockedBy" if is_known else "NoPath", attempt - _PLAIN_RETRIES


def _place(refused: SequenceRefusal) -> str:
    """Return where the motion goes to, or where the robot is."""
    call = refused.call
    if call.skill in (Skill.REACH, Skill.RETRACT):
        return call.arguments[0]
    return refused.place_by_robot.get(call.robot) or call.arguments[0]


def _scope(refused: SequenceRefusal) -> str:
    names = {name for pair in _pairs(refused.cause.refusal) for name in pair}
    return scope_of(
        refused.site, refused.call.robot, (refused.call.skill, *refused.call.arguments), names
    )


def _pairs(refusal: Refusal) -> tuple[Pair, ...]:
    match refusal:
        case BlockedBy(pairs=pairs):
            return pairs
        case NotClear(pair=pair):
            return (pair,)
        case _:
            return ()


def sentence(act: SkillCall, place: str, piece: ComponentId | None, refusal: Refusal) -> Sentence:
    """Return what cannot be done, by whom and why."""
    robot, why = act.robot, in_words(refusal)
    here = {"robot": robot, "place": place, "piece": str(piece), "why": why}
    match act.skill:
        case Skill.GRASP:
            return Sentence("{robot} cannot take {piece} at {place}: {why}", **here)
        case Skill.POSITION:
            return Sentence("{robot} cannot place {piece} at {place}: {why}", **here)
        case Skill.SET_DOWN:
            return Sentence("{robot} cannot set {piece} down at {place}: {why}", **here)
        case Skill.RETRACT:
            return Sentence("{robot} cannot leave {place}: {why}", **here)
        case Skill.RELEASE:
            held = piece or place
            return Sentence(
                "{robot} cannot let go of {held}: {why}", robot=robot, held=held, why=why
            )
        case _:
            return Sentence("{robot} cannot reach {place}: {why}", **here)
