"""What people's rejections mean for the next plan, as far as a planner can respect them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from sitewright.central_controller.site_state import Rejection
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.sentence import Sentence
from sitewright.robot_team.skill import Skill, SkillCall
from sitewright.symbolic_planning.site_view import GeometricFacts

WRONG_COMPONENT, WRONG_ROBOT, PATH_UNSAFE, LATER = (
    "wrong-component",
    "wrong-robot",
    "path-unsafe",
    "later",
)
_SEEDS_APART = 101
_Fact = TypeVar("_Fact", bound=tuple[str, ...])


def why_anew(who: str, rejection: Rejection, *, is_wish: bool = False) -> Sentence:
    """Return why the next plan is asked for, after a person said no.

    Args:
        who: The person.
        rejection: What was said.
        is_wish: Another motion was asked for, without a word against the one before.
    """
    if is_wish:
        return Sentence("{who} asked for another motion.", who=who)
    said = _what_was_said(who, rejection)
    if not rejection.detail:
        return said
    return Sentence("{said} “{detail}”", said=said, detail=rejection.detail)


def _what_was_said(who: str, rejection: Rejection) -> Sentence:
    match rejection.reason:
        case "wrong-component":
            return Sentence("{who} wants another component than the plan before.", who=who)
        case "wrong-robot":
            return Sentence("{who} wants another robot than the plan before.", who=who)
        case "path-unsafe":
            return Sentence(
                "{who} called the plan before unsafe; it has other motions now.", who=who
            )
        case "site-differs":
            return Sentence("{who} says that the site is not as the plan before had it.", who=who)
        case "later":
            return Sentence("{who} put {target} off.", who=who, target=rejection.target)
        case _:
            return Sentence("{who} rejected the plan before.", who=who)


def wanted_pieces(
    pieces: Sequence[ComponentId], rejections: Iterable[Rejection]
) -> list[ComponentId]:
    """Return the pieces that nobody refused as the wrong component."""
    refused = {
        argument
        for r in rejections
        if r.reason == WRONG_COMPONENT
        for call in r.calls
        for argument in call.arguments
    }
    return [p for p in pieces if p not in refused]


def another_seed(seed: int, target: ComponentId, rejections: Iterable[Rejection]) -> int:
    """Return a seed that gives other paths for each time that a path was called unsafe."""
    count = sum(r.reason == PATH_UNSAFE and r.target == target for r in rejections)
    return seed + count * _SEEDS_APART


def detours(
    target: ComponentId, rejections: Iterable[Rejection], *, everywhere: int = 0
) -> Mapping[SkillCall, int]:
    """Return how often the way of a call was called unsafe.

    Args:
        target: What is planned.
        rejections: All of this run.
        everywhere: Whole plans that were called unsafe count so often for each of their calls:
            0 while another seed may give another plan.
    """
    found: Counter[SkillCall] = Counter()
    for rejection in rejections:
        if rejection.reason == PATH_UNSAFE and rejection.target == target:
            times = 1 if rejection.step else everywhere
            found.update({call: times for call in rejection.calls if times})
    return found


def put_off(rejections: Iterable[Rejection]) -> frozenset[ComponentId]:
    """Return the targets that a person wants later."""
    return frozenset(r.target for r in rejections if r.reason == LATER)


def without_refused_robots(
    geometry: GeometricFacts, target: ComponentId, rejections: Iterable[Rejection]
) -> GeometricFacts:
    """Return the facts without what a person gave to another robot.

    Only a rejection of one step says which robot is meant; one of a whole plan does not.
    """
    for rejection in rejections:
        is_meant = rejection.reason == WRONG_ROBOT and rejection.target == target
        if is_meant and rejection.step:
            for call in rejection.calls:
                geometry = _without(geometry, call)
    return geometry


def _without(geometry: GeometricFacts, call: SkillCall) -> GeometricFacts:
    robot, arguments = call.robot, call.arguments
    match call.skill:
        case Skill.GRASP:
            return replace(geometry, can_grasp=_others(geometry.can_grasp, robot, arguments[0]))
        case Skill.POSITION:
            return replace(geometry, can_place=_others(geometry.can_place, robot, arguments[0]))
        case Skill.REACH | Skill.FASTEN | Skill.APPLY_FINISH:
            return replace(geometry, can_reach=_others(geometry.can_reach, robot, arguments[0]))
        case _:
            return geometry


def _others(facts: frozenset[_Fact], robot: RobotId, argument: str) -> frozenset[_Fact]:
    return frozenset(f for f in facts if not (f[0] == robot and argument in f[1:]))
