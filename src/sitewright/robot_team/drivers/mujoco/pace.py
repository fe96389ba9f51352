"""The pace of a watched simulation: so many simulated seconds in one of the clock on the wall."""

from __future__ import annotations

import time
from collections.abc import Callable

LONGEST_LAG_S = 0.1
"""A shorter lag is made up for; after a longer one, as between two skills, time counts anew."""
_NOT_WORTH_S = 0.0005


class Pace:
    """Waits by absolute moments, so that what a step costs does not add to what it waits.

    Attributes:
        factor: Simulated seconds per real second; 0 never waits.
    """

    def __init__(
        self,
        factor: float,
        *,
        now_s: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        """Begin to count with the first step.

        Args:
            factor: Simulated seconds per real second; 0 never waits.
            now_s: Clock on the wall.
            sleep: Waits so many real seconds.
        """
        self.factor = factor
        self._now_s, self._sleep = now_s, sleep
        self._at_zero_s: float | None = None

    def keep(self, simulated_s: float) -> None:
        """Wait until it is time for a moment of the simulation."""
        if self.factor <= 0.0:
            return
        now_s, way_s = self._now_s(), simulated_s / self.factor
        ahead_s = 0.0 if self._at_zero_s is None else self._at_zero_s + way_s - now_s
        if self._at_zero_s is None or abs(ahead_s) > LONGEST_LAG_S:
            self._at_zero_s = now_s - way_s
        elif ahead_s > _NOT_WORTH_S:
            self._sleep(ahead_s)
