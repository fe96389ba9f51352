"""Solves the hard set with our planner and with others, side by side.

    python -m benchmarks.motion.environments   # once
    python -m benchmarks.motion.run [--seeds N] [--only NAME ...] [--family NAME ...] [--json FILE]

A query counts as solved if its path is proven at the clearance and took at most two seconds of CPU
time. For ours the proof is part of the time, for the others it is not.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from benchmarks.motion.environments import mplib_python, ompl_folder
from benchmarks.motion.hard_set import stored_queries
from benchmarks.motion.query import MotionQuery, arm
from benchmarks.motion.solvers.answer import BUDGET_S, Answer, Solver
from benchmarks.motion.solvers.mplib_pipeline import Mplib
from benchmarks.motion.solvers.ompl_planners import Ompl
from benchmarks.motion.solvers.ours import Sitewright
from benchmarks.motion.table import printed
from benchmarks.motion.trial import shared_backends

from sitewright.planning_twin.motion import JointLimits, JointPath, PathSegment
from sitewright.robot_team.description import Joints

_HARDLY_MORE = 1.1
"""OMPL looks at its clock between two steps, some of which take long."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcome:
    """What came of one query with one solver and one seed.

    Attributes:
        is_solved: A proven path in time.
        length_rad: Of the path in joint space.
        motion_s: How long the path takes with our time parametrisation.
    """

    solver: str
    query: str
    family: str
    seed: int
    is_found: bool
    is_solved: bool
    spent_s: float
    length_rad: float | None = None
    motion_s: float | None = None
    reason: str = ""


def judged(solver: Solver, query: MotionQuery, seed: int) -> Outcome:
    """Return what came of a query."""
    answer = solver.solve(query, seed)
    path = _proven(query, answer)
    is_solved = path is not None and answer.spent_s <= BUDGET_S * _HARDLY_MORE
    outcome = Outcome(
        solver=solver.name,
        query=query.name,
        family=query.family,
        seed=seed,
        is_found=bool(answer.waypoints_rad),
        is_solved=is_solved,
        spent_s=answer.spent_s,
        reason=answer.reason,
    )
    if path is None or not is_solved:
        return outcome
    steps = np.diff(np.array(path), axis=0)
    length_rad = float(np.linalg.norm(steps, axis=1).sum())
    return replace(outcome, length_rad=length_rad, motion_s=_motion_s(query, path))


def _proven(query: MotionQuery, answer: Answer) -> tuple[Joints, ...] | None:
    for waypoints in (answer.waypoints_rad, answer.otherwise_rad):
        path = tuple(b for a, b in pairwise(((), *waypoints)) if a != b)
        if len(path) < 2 or not _joins(query, path):  # noqa: PLR2004 - two ends
            continue
        if shared_backends().certifier.objection(query.scene, query.path(path)) is None:
            return path
    return None


def _joins(query: MotionQuery, path: tuple[Joints, ...]) -> bool:
    ends = ((path[0], query.start_rad), (path[-1], query.goal_rad))
    return all(np.allclose(found, asked, rtol=0.0, atol=1e-9) for found, asked in ends)


def _motion_s(query: MotionQuery, path: tuple[Joints, ...]) -> float:
    speeds = tuple(j.velocity_rad_s for j in arm().movable_joints) * len(query.robots)
    limits = JointLimits(
        velocity_rad_s=speeds,
        acceleration_rad_s2=tuple(2.0 * v for v in speeds),
        jerk_rad_s3=tuple(20.0 * v for v in speeds),
    )
    timed = shared_backends().timer.time(
        JointPath(robot=query.robots[0], segments=(PathSegment(waypoints_rad=path),)), limits
    )
    return timed.trajectory.times_s[-1]


def _solvers(only: list[str]) -> Iterator[Solver]:
    if not only or "sitewright" in only:
        yield Sitewright()
    sys.path.append(str(ompl_folder()))
    for planner in ("RRTConnect", "BITstar"):
        if not only or planner in only:
            yield Ompl(planner)
    if not only or "mplib" in only:
        yield Mplib(mplib_python())


def main() -> int:
    """Print the table and write all outcomes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--family", nargs="*", default=[])
    parser.add_argument("--json", type=Path, default=None)
    asked = parser.parse_args()
    queries = stored_queries(*asked.family)
    outcomes: list[Outcome] = []
    for solver in _solvers(asked.only):
        judged(solver, queries[0], seed=99)  # loads libraries
        for query in queries:
            outcomes += [judged(solver, query, seed) for seed in range(asked.seeds)]
        print(printed([o for o in outcomes if o.solver == solver.name]), flush=True)
    if asked.json is not None:
        rows = [{f: getattr(o, f) for f in Outcome.__slots__} for o in outcomes]
        asked.json.write_text(json.dumps(rows, indent=1) + "\n", "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
