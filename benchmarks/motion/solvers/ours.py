"""Our planner through its own port and budgets; the proof is part of its time."""

from __future__ import annotations

import time

from benchmarks.motion.query import MotionQuery
from benchmarks.motion.solvers.answer import Answer, Solver
from typing_extensions import override

from sitewright.planning_twin.backends.twin import make_backends
from sitewright.planning_twin.free_motion import fulfilled
from sitewright.planning_twin.motion import PathSegment


class Sitewright(Solver):
    """Free motion as planning asks for it; arms are compiled once, as for a cell."""

    def __init__(self) -> None:
        self._backends = make_backends()

    @property
    @override
    def name(self) -> str:
        return "sitewright"

    @override
    def solve(self, query: MotionQuery, seed: int) -> Answer:
        start = time.process_time()
        found = fulfilled(self._backends, query.scene, query.request(), seed=seed)
        spent_s = time.process_time() - start
        if isinstance(found, PathSegment):
            return Answer(waypoints_rad=found.waypoints_rad, spent_s=spent_s)
        return Answer(spent_s=spent_s, reason=type(found).__name__)
