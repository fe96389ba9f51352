"""How long the engines of the planning twin take: medians and 95 % in CPU milliseconds.

    python benchmarks/bench_motion.py

Two arms with tools, a table, a growing frame, two stacks, a held stud (tests/motion_scenes.py).
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TypeVar

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

import numpy as np

from motion_scenes import HOME, A, held_stud, kr120, two_arms
from sitewright.planning_twin.backends.twin import make_backends
from sitewright.planning_twin.motion import (
    Agreement,
    Certificate,
    CollisionCheck,
    JointLimits,
    JointPath,
    MotionRequest,
    PathSegment,
    PlanningBackends,
)
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.description import Joints

GOALS = 40
AIM_CERTIFICATE_P50_MS = 12.0
AIM_CERTIFICATE_P95_MS = 50.0
Value = TypeVar("Value")


class Times:
    """CPU times by name."""

    def __init__(self) -> None:
        self.ms: dict[str, list[float]] = {}

    def of(self, name: str, call: Callable[[], Value]) -> Value:
        """Return what a call returns and note how long it took."""
        start = time.process_time()
        value = call()
        self.ms.setdefault(name, []).append((time.process_time() - start) * 1e3)
        return value

    def p95(self, name: str) -> float:
        """Return the 95 % point."""
        return float(np.percentile(self.ms[name], 95))


def main() -> int:
    """Plan, prove, time and cross-check motions to random free goals."""
    backends, times = make_backends(), Times()
    first = two_arms(held_stud())
    times.of("proof scene, first", lambda: backends.collision.violations(first, A, HOME, {}))
    outcomes: dict[str, int] = {}
    for seed, goal in enumerate(_goals(backends.collision, times)):
        # a new snapshot each time, as after every sensed change
        scene = first.with_joints(A, (HOME[0] + 1e-4 * seed, *HOME[1:]))
        outcome = _motion(backends, times, scene, goal, seed)
        outcomes[outcome] = outcomes.get(outcome, 0) + 1
    for name, values in times.ms.items():
        print(f"{name:28} p50 {statistics.median(values):7.2f}  p95 {times.p95(name):7.2f} ms")
    print(f"outcomes: {outcomes}")
    is_quick = (
        statistics.median(times.ms["certificate"]) <= AIM_CERTIFICATE_P50_MS
        and times.p95("certificate") <= AIM_CERTIFICATE_P95_MS
    )
    return 0 if is_quick else 1


def _goals(check: CollisionCheck, times: Times) -> list[Joints]:
    rng = np.random.default_rng(0)
    scene = two_arms(held_stud())
    lower = [max(j.lower_rad, -2.2) for j in kr120().movable_joints]
    upper = [min(j.upper_rad, 2.2) for j in kr120().movable_joints]
    goals: list[Joints] = []
    while len(goals) < GOALS:
        q = tuple(rng.uniform(lower, upper).tolist())
        question = partial(check.violations, scene, A, q, {}, is_padded=True)
        pairs = times.of("collision check", question)
        if not pairs:
            goals.append(q)
    return goals


def _motion(
    backends: PlanningBackends, times: Times, scene: SceneSnapshot, goal: Joints, seed: int
) -> str:
    tip = times.of("forward kinematics", lambda: backends.kinematics.tip(kr120(), goal))
    times.of("all postures of a pose", lambda: backends.kinematics.solve(kr120(), tip, HOME))
    request = MotionRequest(robot=A, goal_rad=goal)
    found = times.of("search", lambda: backends.planner.plan(scene, request, seed=seed))
    if not isinstance(found, tuple):
        return type(found).__name__
    path = JointPath(robot=A, segments=(PathSegment(waypoints_rad=found),))
    certificate = times.of("certificate", lambda: backends.certifier.certify(scene, path))
    if not isinstance(certificate, Certificate):
        return type(certificate).__name__
    timed = times.of("timing", lambda: backends.timer.time(path, _limits()))
    opinion = times.of("cross-check", lambda: backends.cross_check.check(scene, timed))
    return "confirmed" if isinstance(opinion, Agreement) else type(opinion).__name__


def _limits() -> JointLimits:
    velocity = tuple(j.velocity_rad_s for j in kr120().movable_joints)
    return JointLimits(
        velocity_rad_s=velocity,
        acceleration_rad_s2=tuple(2.0 * v for v in velocity),
        jerk_rad_s3=tuple(20.0 * v for v in velocity),
    )


if __name__ == "__main__":
    sys.exit(main())
