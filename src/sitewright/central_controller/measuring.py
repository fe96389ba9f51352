"""Where planning time goes: a stopwatch by kind of work, and a certifier that counts its own."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from typing_extensions import override

from sitewright.foundation.clock import Clock
from sitewright.planning_twin.motion import Certificate, Certifier, JointPath, TeamPath
from sitewright.planning_twin.refusal import NotClear
from sitewright.planning_twin.scene import SceneSnapshot

_NS = 1e9


@dataclass(slots=True)
class Stopwatch:
    """Adds up seconds by kind of work."""

    clock: Clock
    spent_s: dict[str, float] = field(default_factory=dict)
    _since_ns: int = 0

    def start(self) -> None:
        """Begin a stretch."""
        self._since_ns = self.clock.monotonic_ns()

    def stop(self, kind: str) -> None:
        """End the stretch and count it."""
        passed = (self.clock.monotonic_ns() - self._since_ns) / _NS
        self.spent_s[kind] = self.spent_s.get(kind, 0.0) + passed

    @contextmanager
    def timed(self, kind: str) -> Iterator[None]:
        """Count the time that a block takes."""
        self.start()
        yield
        self.stop(kind)

    def report(self, certifying_s: float) -> dict[str, float]:
        """Return the times; what proofs took is part of the motion planning and told apart."""
        motion_s = self.spent_s.get("motion", 0.0)
        return {
            "symbolic": self.spent_s.get("symbolic", 0.0),
            "motion": max(0.0, motion_s - certifying_s),
            "certificate": certifying_s,
            "total": sum(self.spent_s.values()),
        }


class MeasuredCertifier(Certifier):
    """Another certifier, with the time that it takes added up."""

    def __init__(self, certifier: Certifier, clock: Clock) -> None:
        """Measure `certifier` by `clock`."""
        self._certifier, self._clock = certifier, clock
        self.spent_s = 0.0

    @override
    def certify(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> Certificate | NotClear:
        with self._measured():
            return self._certifier.certify(scene, path)

    @override
    def objection(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> NotClear | None:
        with self._measured():
            return self._certifier.objection(scene, path)

    @contextmanager
    def _measured(self) -> Iterator[None]:
        start_ns = self._clock.monotonic_ns()
        try:
            yield
        finally:
            self.spent_s += (self._clock.monotonic_ns() - start_ns) / _NS
