"""The reach check: every robot, end effector, target and operation of a model."""

from __future__ import annotations

from collections.abc import Iterator

from typing_extensions import override

from sitewright.planning_twin.backends.reach.bench import Bench, Engines
from sitewright.planning_twin.backends.reach.drivers import drivers, grippers
from sitewright.planning_twin.backends.reach.handlings import handled
from sitewright.planning_twin.backends.reach.operatings import operating
from sitewright.planning_twin.backends.reach.steadyings import steadying
from sitewright.planning_twin.backends.reach.surroundings import surroundings
from sitewright.planning_twin.reachability.answer import Operating, ReachAnswer, ReachCheck
from sitewright.planning_twin.reachability.question import ReachQuestion, ReachTarget
from sitewright.planning_twin.tacking import tacks_needed


class ArrayReachCheck(ReachCheck):
    """Looks at ends of motions in batches; what depends on no cell is kept between questions."""

    def __init__(self) -> None:
        self._engines = Engines()

    @override
    def answer(self, question: ReachQuestion) -> ReachAnswer:
        bench = Bench(self._engines, question.cell, surroundings(question.bodies))
        handlings, operatings, steadyings = [], [], []
        for target in question.targets:
            found = [handled(bench, arm, target) for arm in grippers(bench)]
            handlings += [h.handling for h in found]
            holds = [(h.handling.robot, h.holds) for h in found]
            operatings += list(_operatings(bench, target))
            if tacks_needed(target.task):
                steadyings.append(steadying(bench, target, holds))
        return ReachAnswer(
            handlings=tuple(handlings),
            operatings=tuple(operatings),
            steadyings=tuple(steadyings),
            spheres=tuple(map(self._engines.sphere, question.cell.robot_by_id.values())),
        )


def _operatings(bench: Bench, target: ReachTarget) -> Iterator[Operating]:
    for spot in target.task.spots:
        for arm in drivers(bench, spot):
            yield operating(bench, arm, target, spot)
