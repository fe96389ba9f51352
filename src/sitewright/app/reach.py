"""Which robot reaches what of a project, in which way: the reach check, asked and judged."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.app.postures import posture_problems
from sitewright.app.project import Project, obstacles_of
from sitewright.app.reach_question import reach_question
from sitewright.foundation.clock import Clock
from sitewright.planning_twin.reachability.answer import ReachCheck
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.planning_twin.reachability.verdict import verdicts

_NS = 1e-9


def reach_check() -> ReachCheck:
    """Return the reach check with its engines."""
    from sitewright.planning_twin.backends.reach.check import ArrayReachCheck

    return ArrayReachCheck()


def reach_of(project: Project, clock: Clock, check: ReachCheck | None = None) -> ReachReport:
    """Return which robot reaches what; nothing moves and no path is searched."""
    start_ns = clock.monotonic_ns()
    question = reach_question(project)
    answer = (check or reach_check()).answer(question)
    return ReachReport(
        question=question,
        answer=answer,
        verdicts=verdicts(question, answer),
        notes=tuple(posture_notes(project)),
        seconds=(clock.monotonic_ns() - start_ns) * _NS,
    )


def posture_notes(project: Project) -> Iterator[str]:
    """Yield which home and parking postures are too near to something."""
    from sitewright.planning_twin.backends.collision_check import CoalCollisionCheck
    from sitewright.planning_twin.backends.proof_scene import ProofScenes

    collision = CoalCollisionCheck(ProofScenes())
    obstacles = obstacles_of(project.model, project.cell)
    for problem in posture_problems(project.cell, obstacles, collision):
        yield f"{problem.where}: {problem.message} {problem.fix}"
