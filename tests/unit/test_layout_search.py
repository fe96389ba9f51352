"""The search for places, with a judge that knows what is best."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import pytest
from typing_extensions import override

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import translation
from sitewright.planning_twin.layout.floor import Floor, Footprint
from sitewright.planning_twin.layout.judging import Judgement, LayoutJudge
from sitewright.planning_twin.layout.movables import (
    Arrangement,
    Movable,
    MovableKind,
    Shift,
    Yard,
)
from sitewright.planning_twin.layout.search import LayoutSearch
from sitewright.planning_twin.reachability.answer import ReachAnswer
from sitewright.planning_twin.reachability.question import ReachQuestion
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.planning_twin.reachability.verdict import Standing, TargetVerdict
from sitewright.robot_team.cell import Cell

CELL = Cell(robot_by_id={}, end_effector_by_id={})
ROBOT = Movable(id="r", kind=MovableKind.ROBOT, world_T_start=translation(0.0, 0.0, 0.0))
STOCK = Movable(id="s", kind=MovableKind.STOCK, world_T_start=translation(0.0, 2.0, 0.0))
SQUARE = ((-0.3, -0.3), (0.3, -0.3), (0.3, 0.3), (-0.3, 0.3))


@dataclass
class Wishes(LayoutJudge):
    """Ten targets; each is built if the robot stands near enough to where it would have it."""

    wish: tuple[float, float] = (1.5, -1.0)
    stock_may_move: bool = True
    checks: list[Arrangement] = field(default_factory=list)

    @override
    def guess(self, arrangement: Arrangement) -> float:
        return self._built(arrangement) / 10.0

    @override
    def judge(self, arrangement: Arrangement) -> Judgement:
        self.checks.append(dict(arrangement))
        built = self._built(arrangement)
        found = tuple(
            TargetVerdict(
                target=ComponentId(f"t{k}"),
                standing=Standing.BUILDABLE if k < built else Standing.NOT_FOUND,
            )
            for k in range(10)
        )
        report = ReachReport(
            question=ReachQuestion(cell=CELL, bodies=(), targets=()),
            answer=ReachAnswer(),
            verdicts=found,
        )
        missing = () if built == 10 else ((*self.wish, 0.0),)
        return Judgement(
            arrangement=arrangement, report=report, reached=built / 10.0, missing_m=missing
        )

    def _built(self, arrangement: Arrangement) -> int:
        shift = arrangement.get("r", Shift())
        away_m = math.dist((shift.x_m, shift.y_m), self.wish)
        return max(0, min(10, 12 - int(away_m / 0.15)))


def floor() -> Floor:
    yard = Yard(cell=CELL, movables=(ROBOT, STOCK))
    prints = {
        "r": Footprint(SQUARE, 0.0, 1.0),
        "s": Footprint(tuple((x, y + 2.0) for x, y in SQUARE), 0.0, 1.0),
    }
    return Floor(area_m=((-3.0, -3.0), (3.0, 3.0)), yard=yard, footprints=prints, fixed=())


def test_it_finds_where_everything_can_be_built() -> None:
    search = LayoutSearch(floor=floor(), judge=Wishes(), seed=3, budget=30)
    before, after = search.run()
    assert before.report.share < 1.0 == after.report.share
    shift = after.arrangement["r"]
    assert math.dist((shift.x_m, shift.y_m), (1.5, -1.0)) < 0.5


def test_what_need_not_move_is_put_back() -> None:
    _, after = LayoutSearch(floor=floor(), judge=Wishes(), seed=3, budget=40).run()
    assert after.arrangement.get("s", Shift()) == Shift()
    assert after.arrangement["r"].yaw_rad == 0.0


def test_a_perfect_cell_is_left_alone_after_one_look() -> None:
    judge = Wishes(wish=(0.0, 0.0))
    before, after = LayoutSearch(floor=floor(), judge=judge, budget=30).run()
    assert before is after
    assert judge.checks == [{}]


@pytest.mark.parametrize("seed", [0, 1])
def test_the_same_seed_judges_the_same_arrangements(seed: int) -> None:
    judges = [Wishes(wish=(2.0, 2.2)), Wishes(wish=(2.0, 2.2))]
    for judge in judges:
        LayoutSearch(floor=floor(), judge=judge, seed=seed, budget=15).run()
    assert judges[0].checks == judges[1].checks


def test_another_seed_judges_others() -> None:
    judges = [Wishes(wish=(2.0, 2.2)), Wishes(wish=(2.0, 2.2))]
    for seed, judge in enumerate(judges):
        LayoutSearch(floor=floor(), judge=judge, seed=seed, budget=15).run()
    assert judges[0].checks != judges[1].checks


@pytest.mark.parametrize("budget", [1, 7, 20])
def test_the_budget_is_never_exceeded_and_nothing_stands_in_the_way(budget: int) -> None:
    judge, where = Wishes(wish=(9.0, 9.0)), floor()
    LayoutSearch(floor=where, judge=judge, budget=budget).run()
    assert 1 <= len(judge.checks) <= budget
    assert all(where.is_free(a) for a in judge.checks)


def test_shifts_are_whole_centimetres_and_degrees() -> None:
    judge = Wishes(wish=(2.0, 2.0))
    LayoutSearch(floor=floor(), judge=judge, budget=25).run()
    for arrangement in judge.checks:
        for shift in arrangement.values():
            for value in (shift.x_m * 100.0, shift.y_m * 100.0, math.degrees(shift.yaw_rad)):
                assert value == pytest.approx(round(value), abs=1e-6)
