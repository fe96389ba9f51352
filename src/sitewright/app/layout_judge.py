"""Judges arrangements of a project's cell: guesses by a sketch, judgements by the reach check."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from typing_extensions import override

from sitewright.app.project import Project
from sitewright.app.reach_question import reach_question
from sitewright.foundation.pose import Vector
from sitewright.planning_twin.backends.reach.check import ArrayReachCheck
from sitewright.planning_twin.backends.reach.sketch import ReachSketch
from sitewright.planning_twin.layout.judging import Judgement, LayoutJudge
from sitewright.planning_twin.layout.movables import Arrangement, Yard
from sitewright.planning_twin.reachability.answer import ReachAnswer
from sitewright.planning_twin.reachability.question import ReachQuestion
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.planning_twin.reachability.verdict import verdicts


class ProjectJudge(LayoutJudge):
    """Judges arrangements of one project."""

    def __init__(self, project: Project, yard: Yard, check: ArrayReachCheck) -> None:
        self._project, self._yard, self._check = project, yard, check
        self._sketch = ReachSketch(check.engines, reach_question(project), yard)

    @override
    def guess(self, arrangement: Arrangement) -> float:
        return self._sketch.guess(arrangement)

    @override
    def judge(self, arrangement: Arrangement) -> Judgement:
        cell = self._yard.arranged(arrangement)
        question = reach_question(replace(self._project, cell=cell))
        answer = self._check.answer(question, is_brief=True)
        report = ReachReport(question=question, answer=answer, verdicts=verdicts(question, answer))
        reached = _reached(answer)
        return Judgement(
            arrangement=arrangement,
            report=report,
            reached=sum(reached.values()) / max(1, len(reached)),
            missing_m=tuple(_missing(question, reached)),
            blocked=tuple(h.robot for h in answer.homes),
        )


def _reached(answer: ReachAnswer) -> dict[str, bool]:
    """Return for each target and operation whether some robot reaches it."""
    things: dict[str, bool] = {}
    for handling in answer.handlings:
        things[handling.target] = things.get(handling.target, False) or bool(handling.ways)
    for operating in answer.operatings:
        name = operating.operation
        things[name] = things.get(name, False) or bool(operating.ways)
    return things


def _missing(question: ReachQuestion, reached: Mapping[str, bool]) -> Iterator[Vector]:
    for target in question.targets:
        if not reached.get(target.id, True):
            yield target.task.world_T_target.position_m
        for spot in target.task.spots:
            if not reached.get(spot.operation, True):
                yield spot.world_T_operation.position_m
