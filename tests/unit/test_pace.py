"""A watched simulation keeps to real time, and pictures of it come on an even beat."""

from __future__ import annotations

from dataclasses import dataclass, field

import pytest

from sitewright.app.serving.live_feed import PERIOD_S, next_look_s
from sitewright.robot_team.drivers.mujoco.pace import LONGEST_LAG_S, Pace

STEP_S = 0.002


@dataclass
class Wall:
    """A clock that goes on only by what is waited and worked."""

    at_s: float = 100.0
    waits: list[float] = field(default_factory=list)

    def now_s(self) -> float:
        return self.at_s

    def sleep(self, seconds: float) -> None:
        self.waits.append(seconds)
        self.at_s += seconds + 0.0002  # a machine wakes a little late

    def simulate(self, pace: Pace, *, start_s: float, seconds: float, costs_s: float) -> float:
        """Step for some simulated time; return how long it took on the wall."""
        begun_s = self.at_s
        for n in range(round(seconds / STEP_S)):
            self.at_s += costs_s
            pace.keep(start_s + (n + 1) * STEP_S)
        return self.at_s - begun_s


def pace_on(wall: Wall, factor: float) -> Pace:
    return Pace(factor, now_s=wall.now_s, sleep=wall.sleep)


@pytest.mark.parametrize("factor", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("costs_s", [0.0, 0.0003, 0.0009])
def test_what_a_step_costs_does_not_slow_the_simulation_down(factor: float, costs_s: float) -> None:
    wall = Wall()
    took_s = wall.simulate(pace_on(wall, factor), start_s=5.0, seconds=4.0, costs_s=costs_s)
    assert took_s == pytest.approx(4.0 / factor, abs=0.005)


def test_a_rest_between_two_skills_is_not_made_up_for() -> None:
    wall = Wall()
    pace = pace_on(wall, 1.0)
    wall.simulate(pace, start_s=0.0, seconds=1.0, costs_s=0.0003)
    wall.at_s += 60.0
    took_s = wall.simulate(pace, start_s=1.0, seconds=1.0, costs_s=0.0003)
    assert took_s == pytest.approx(1.0, abs=0.005)


def test_a_short_hitch_is_made_up_for() -> None:
    wall = Wall()
    pace = pace_on(wall, 1.0)
    wall.simulate(pace, start_s=0.0, seconds=1.0, costs_s=0.0003)
    wall.at_s += 0.5 * LONGEST_LAG_S
    took_s = wall.simulate(pace, start_s=1.0, seconds=1.0, costs_s=0.0003)
    assert took_s == pytest.approx(1.0 - 0.5 * LONGEST_LAG_S, abs=0.005)


def test_a_clock_that_was_set_back_stops_nothing() -> None:
    wall = Wall()
    pace = pace_on(wall, 1.0)
    wall.simulate(pace, start_s=50.0, seconds=0.1, costs_s=0.0)
    took_s = wall.simulate(pace, start_s=0.0, seconds=1.0, costs_s=0.0)
    assert took_s == pytest.approx(1.0, abs=0.005)


def test_a_simulation_that_nobody_watches_never_waits() -> None:
    wall = Wall()
    wall.simulate(pace_on(wall, 0.0), start_s=0.0, seconds=1.0, costs_s=0.0001)
    assert wall.waits == []


def test_pictures_come_on_an_even_beat_whatever_one_takes() -> None:
    now_s = due_s = 7.0
    dues = []
    for took_s in (0.002, 0.004, 0.02, 0.001, 0.03):
        now_s = due_s + took_s
        due_s = next_look_s(due_s, now_s)
        dues.append(due_s)
    assert dues == [pytest.approx(7.0 + n * PERIOD_S) for n in range(1, 6)]


def test_a_beat_that_is_missed_is_left_out_and_not_made_up_for() -> None:
    assert next_look_s(7.0, 7.5) == pytest.approx(7.5 + PERIOD_S)
