"""The reach check: every robot, end effector, target and operation of a model."""

from __future__ import annotations

from collections.abc import Iterator

from typing_extensions import override

from sitewright.planning_twin.backends.reach.bench import Bench, Engines
from sitewright.planning_twin.backends.reach.drivers import drivers, grippers
from sitewright.planning_twin.backends.reach.handlings import Handled, handled
from sitewright.planning_twin.backends.reach.homes import blocked_homes
from sitewright.planning_twin.backends.reach.operatings import operating
from sitewright.planning_twin.backends.reach.steadyings import steadying
from sitewright.planning_twin.backends.reach.surroundings import surroundings
from sitewright.planning_twin.reachability.answer import (
    Handling,
    Operating,
    ReachAnswer,
    ReachCheck,
    Steadying,
)
from sitewright.planning_twin.reachability.question import ReachQuestion, ReachTarget
from sitewright.planning_twin.tacking import tacks_needed


class ArrayReachCheck(ReachCheck):
    """Looks at ends of motions in batches; what depends on no cell is kept between questions."""

    def __init__(self) -> None:
        self._engines = Engines()

    @property
    def engines(self) -> Engines:
        """What depends on no cell."""
        return self._engines

    @override
    def answer(self, question: ReachQuestion, *, is_brief: bool = False) -> ReachAnswer:
        bench = Bench(self._engines, question.cell, surroundings(question.bodies))
        handlings: list[Handling] = []
        operatings: list[Operating] = []
        steadyings: list[Steadying] = []
        for target in question.targets:
            is_held = tacks_needed(target.task) > 0
            found = list(_handlings(bench, target, is_brief=is_brief and not is_held))
            handlings += [h.handling for h in found]
            operatings += _operatings(bench, target, is_brief=is_brief)
            if is_held:
                holds = [(h.handling.robot, h.holds) for h in found]
                steadyings.append(steadying(bench, target, holds))
        return ReachAnswer(
            handlings=tuple(handlings),
            operatings=tuple(operatings),
            steadyings=tuple(steadyings),
            spheres=tuple(map(self._engines.sphere, question.cell.robot_by_id.values())),
            homes=tuple(blocked_homes(bench)),
        )


def _handlings(bench: Bench, target: ReachTarget, *, is_brief: bool) -> Iterator[Handled]:
    for arm in grippers(bench):
        found = handled(bench, arm, target, is_brief=is_brief)
        yield found
        if is_brief and found.holds:
            return


def _operatings(bench: Bench, target: ReachTarget, *, is_brief: bool) -> Iterator[Operating]:
    for spot in target.task.spots:
        for arm in drivers(bench, spot):
            found = operating(bench, arm, target, spot)
            yield found
            if is_brief and found.ways:
                break
