"""The whole-cell contact log: every touch that nothing allows."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from sitewright.foundation.canonical import Json
from sitewright.robot_team.drivers.mujoco.physics import Physics

_TOUCH_M = 1e-6
"""Faces that lie against each other without pressing are no contact."""


def sorted_pair(a: str, b: str) -> tuple[str, str]:
    """Return two names in the order in which pairs are kept."""
    return (a, b) if a <= b else (b, a)


@dataclass(slots=True)
class Touch:
    """The worst moment of an unallowed contact during one command."""

    depth_m: float
    time_s: float


@dataclass(slots=True)
class ContactWatch:
    """Looks at all contacts of every step of one command.

    Attributes:
        allowed: Pairs of body names that may touch.
        found: Pairs that touched although they may not.
    """

    allowed: set[tuple[str, str]] = field(default_factory=set)
    found: dict[tuple[str, str], Touch] = field(default_factory=dict)
    _table: NDArray[np.bool_] = field(default_factory=lambda: np.zeros((0, 0), dtype=np.bool_))

    def allow(self, physics: Physics, pairs: Iterable[tuple[str, str]]) -> None:
        """Allow more pairs; names that are no bodies are ignored."""
        self.allowed |= {sorted_pair(a, b) for a, b in pairs}
        self.bind(physics)

    def bind(self, physics: Physics) -> None:
        """Translate names into the numbers of a newly compiled model."""
        count = len(physics.body_names)
        self._table = np.zeros((count, count), dtype=np.bool_)
        for a, b in self.allowed:
            if physics.has_body(a) and physics.has_body(b):
                i, j = physics.body(a), physics.body(b)
                self._table[i, j] = self._table[j, i] = True

    def look(self, physics: Physics) -> None:
        """Note the unallowed contacts of the present instant."""
        d = physics.d
        if not d.ncon:
            return
        bodies = physics.m.geom_bodyid[d.contact.geom]
        bad = ~self._table[bodies[:, 0], bodies[:, 1]] & (d.contact.dist < -_TOUCH_M)
        if bad.any():
            self._note(physics, bodies[bad], -d.contact.dist[bad])

    def _note(
        self, physics: Physics, bodies: NDArray[np.int32], depth_m: NDArray[np.float64]
    ) -> None:
        for (a, b), depth in zip(bodies.tolist(), depth_m.tolist(), strict=True):
            pair = sorted_pair(physics.body_names[a], physics.body_names[b])
            known = self.found.get(pair)
            if known is None or depth > known.depth_m:
                self.found[pair] = Touch(depth, float(physics.d.time))

    def forgive(self, pairs: Iterable[tuple[str, str]]) -> None:
        """Drop pairs that turned out to be the place where the motion was to end."""
        for pair in pairs:
            self.found.pop(sorted_pair(*pair), None)

    def records(self, skill: str, command_id: str) -> list[dict[str, Json]]:
        """Return what was found, for the report."""
        return [
            {
                "pair": list(pair),
                "skill": skill,
                "command_id": command_id,
                "depth_m": touch.depth_m,
                "time_s": touch.time_s,
            }
            for pair, touch in sorted(self.found.items())
        ]
