"""The search for better places: seeded steps by guesses, then the reach check on the best."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from random import Random

from sitewright.planning_twin.layout.floor import Floor
from sitewright.planning_twin.layout.judging import Judgement, LayoutJudge
from sitewright.planning_twin.layout.movables import Arrangement, Movable, MovableKind, Shift

_GUESSES_PER_CHECK = 40
_WALKS = ((0.3, True), (1.2, True), (1.2, False), (1.2, False))
"""Length of the first step, and whether the walk starts from the cell as it is."""
_KEPT = 3
"""So many of the best guesses of each start go to the reach check."""
_DIFFERENT_M = 0.25
_LAST_STEP_M = 0.08
_FIRST_HEAT, _LAST_HEAT = 0.03, 0.001
_QUARTER = math.pi / 2.0
_REFINED_STEPS_M = (0.08, 0.2, 0.5)
_PER_METRE = 0.01
"""What a metre of moving costs in a guess, so that nothing moves for nothing."""
_TRIES = 60
_AT_RANDOM = 0.5
_PER_MOVABLE = 2
"""So many checks of the budget are kept for putting each movable back."""


@dataclass(slots=True)
class LayoutSearch:
    """Finds an arrangement in which more can be built; the same seed finds the same.

    Attributes:
        budget: How many reach checks may be made.
        on_check: Told each judgement as it is made.
    """

    floor: Floor
    judge: LayoutJudge
    seed: int = 0
    budget: int = 40
    on_check: Callable[[Judgement], None] = field(default=lambda _: None)
    _checks: int = 0

    def run(self) -> tuple[Judgement, Judgement]:
        """Return the judgements of the cell as it is, and of the best arrangement."""
        start = best = self._check({})
        dice = Random(self.seed)  # noqa: S311 - the same seed must find the same
        for arrangement in self._promising(dice):
            if best.is_perfect or self._checks >= self.budget:
                break
            best = max(best, self._check(arrangement), key=lambda j: j.value)
        best = self._refined(best, dice)
        return start, self._undone(best)

    def _check(self, arrangement: Arrangement) -> Judgement:
        self._checks += 1
        judgement = self.judge.judge(arrangement)
        self.on_check(judgement)
        return judgement

    def _promising(self, dice: Random) -> Iterator[Arrangement]:
        """Yield the best guesses of several walks, the best of all first.

        Two walks start from the cell as it is, one of them with small steps.
        """
        found: list[tuple[float, int, Arrangement]] = []
        steps = self.budget * _GUESSES_PER_CHECK // len(_WALKS)
        for first_step_m, is_here in _WALKS:
            first: Arrangement = {} if is_here else self._anywhere(dice)
            for value, arrangement in self._walk(first, steps, first_step_m, dice):
                found.append((value, len(found), arrangement))
        for _, _, arrangement in sorted(found, key=lambda f: (-f[0], f[1])):
            if any(s != Shift() for s in arrangement.values()):
                yield arrangement

    def _walk(
        self, first: Arrangement, steps: int, first_step_m: float, dice: Random
    ) -> list[tuple[float, Arrangement]]:
        """Return the best different arrangements of a walk that cools down."""
        here, value = first, self._guess(first)
        best = [(value, here)]
        for k in range(steps):
            share = k / max(1, steps - 1)
            step_m = first_step_m * (_LAST_STEP_M / first_step_m) ** share
            heat = _FIRST_HEAT * (_LAST_HEAT / _FIRST_HEAT) ** share
            there = self._next(here, step_m, dice)
            if there is None:
                continue
            other = self._guess(there)
            if other >= value or dice.random() < math.exp((other - value) / heat):
                here, value = there, other
                best = _kept(best, (value, here))
        return best

    def _guess(self, arrangement: Arrangement) -> float:
        moved_m = sum(s.length_m for s in arrangement.values())
        return self.judge.guess(arrangement) - _PER_METRE * moved_m

    def _next(self, here: Arrangement, step_m: float, dice: Random) -> Arrangement | None:
        """Return a neighbour in which nothing stands in another's way."""
        for _ in range(_TRIES):
            movable = dice.choice(self.floor.yard.movables)
            shift = here.get(movable.id, Shift())
            turn_rad = _turn(movable, dice)
            there = {
                **here,
                movable.id: _rounded(
                    shift.x_m + dice.gauss(0.0, step_m),
                    shift.y_m + dice.gauss(0.0, step_m),
                    shift.yaw_rad + turn_rad,
                ),
            }
            if self.floor.is_free(there):
                return there
        return None

    def _anywhere(self, dice: Random) -> Arrangement:
        """Return an arrangement in which things stand anywhere on the floor."""
        here: dict[str, Shift] = {}
        (low_x, low_y), (high_x, high_y) = self.floor.area_m
        for movable in self.floor.yard.movables:
            x, y, _ = movable.world_T_start.position_m
            for _ in range(_TRIES):
                shift = _rounded(
                    dice.uniform(low_x, high_x) - x,
                    dice.uniform(low_y, high_y) - y,
                    _turn(movable, dice),
                )
                if self.floor.is_free({**here, movable.id: shift}):
                    here[movable.id] = shift
                    break
        return here if self.floor.is_free(here) else {}

    def _refined(self, best: Judgement, dice: Random) -> Judgement:
        """Step away from the best while there is budget, and keep what the reach check prefers."""
        least = self.judge.guess(best.arrangement) - _FIRST_HEAT
        tries = 0
        last = self.budget - _PER_MOVABLE * len(self.floor.yard.movables)
        while not best.is_perfect and self._checks < last and tries < _TRIES * self.budget:
            tries += 1
            there = self._step(best, dice)
            if there is None or self.judge.guess(there) < least:
                continue
            best = max(best, self._check(there), key=lambda j: j.value)
        return best

    def _step(self, best: Judgement, dice: Random) -> Arrangement | None:
        """Return a neighbour: any, or one with a robot nearer to what it misses, or further off."""
        step_m = dice.choice(_REFINED_STEPS_M)
        robots = [m for m in self.floor.yard.movables if m.kind is MovableKind.ROBOT]
        if not best.missing_m or not robots or dice.random() < _AT_RANDOM:
            return self._next(best.arrangement, step_m, dice)
        robot, (x, y, _) = dice.choice(robots), dice.choice(best.missing_m)
        shift = best.arrangement.get(robot.id, Shift())
        here_x, here_y, _ = robot.world_T_start.position_m
        way = (x - here_x - shift.x_m, y - here_y - shift.y_m)
        share = dice.choice((1.0, -1.0)) * step_m / max(math.hypot(*way), step_m)
        moved = _rounded(shift.x_m + share * way[0], shift.y_m + share * way[1], shift.yaw_rad)
        there = {**best.arrangement, robot.id: moved}
        return there if self.floor.is_free(there) else None

    def _undone(self, best: Judgement) -> Judgement:
        """Put back, turn back, or move half as far, what was moved without need."""
        for movable in self.floor.yard.movables:
            for less in _lesser(best.arrangement.get(movable.id, Shift())):
                there = {**best.arrangement, movable.id: less}
                if self._checks >= self.budget:
                    return best
                if self.floor.is_free(there) and (j := self._check(there)).value >= best.value:
                    best = j
                    break
        return best


def _lesser(shift: Shift) -> Iterator[Shift]:
    """Yield shifts that are less than one, the least first."""
    if shift != Shift():
        yield Shift()
        if shift.yaw_rad and shift.length_m:
            yield replace(shift, yaw_rad=0.0)
        yield _rounded(shift.x_m / 2.0, shift.y_m / 2.0, shift.yaw_rad)


def _rounded(x_m: float, y_m: float, yaw_rad: float) -> Shift:
    """Return a shift in whole centimetres and degrees."""
    yaw_deg = round(math.degrees(math.remainder(yaw_rad, math.tau)))
    return Shift(round(x_m, 2) + 0.0, round(y_m, 2) + 0.0, math.radians(yaw_deg) + 0.0)


def _turn(movable: Movable, dice: Random) -> float:
    """Return a turn: of a robot any; of stock, which lies along the axes, a quarter or none."""
    if movable.kind is MovableKind.ROBOT:
        return dice.gauss(0.0, 0.3)
    return dice.choice((0.0, 0.0, 0.0, _QUARTER, -_QUARTER))


def _kept(
    best: list[tuple[float, Arrangement]], new: tuple[float, Arrangement]
) -> list[tuple[float, Arrangement]]:
    """Return the best arrangements that differ, with a new one among them if it is good enough."""
    near = [b for b in best if _apart_m(b[1], new[1]) < _DIFFERENT_M]
    if any(b[0] >= new[0] for b in near):
        return best
    others = [b for b in best if all(b is not n for n in near)]
    return sorted([*others, new], key=lambda b: -b[0])[:_KEPT]


def _apart_m(a: Arrangement, b: Arrangement) -> float:
    ids = a.keys() | b.keys()
    pairs = [(a.get(i, Shift()), b.get(i, Shift())) for i in ids]
    return max((math.hypot(p.x_m - q.x_m, p.y_m - q.y_m) for p, q in pairs), default=0.0)
