"""OMPL's planners on our checker: the same scene, margin, steps and limits."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from benchmarks.motion.query import MotionQuery
from benchmarks.motion.solvers.answer import BUDGET_S, Answer, Solver, joints
from typing_extensions import override

from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.search_space import SearchSpace
from sitewright.planning_twin.backends.two_trees import TwoTrees
from sitewright.planning_twin.refusal import BlockedBy
from sitewright.robot_team.description import Joints


class Ompl(Solver):
    """One of OMPL's planners, until its first path; then OMPL's own shortening.

    BIT* tells of no path before its time is over; it goes on with what it has, and needs no more.
    """

    def __init__(self, planner: str) -> None:
        import ompl.base
        import ompl.geometric
        import ompl.util

        self._base: Any = ompl.base
        self._geometric: Any = ompl.geometric
        self._planner = planner
        self._ours = TwoTrees(ProofScenes())
        ompl.util.setLogLevel(ompl.util.LogLevel.LOG_NONE)
        ompl.util.RNG.setSeed(1)

    @property
    @override
    def name(self) -> str:
        return f"ompl {self._planner}"

    @override
    def solve(self, query: MotionQuery, seed: int) -> Answer:
        start = time.process_time()
        question = self._ours.asked(query.scene, query.request())
        if isinstance(question, BlockedBy):
            return Answer(spent_s=time.process_time() - start, reason=str(question.pairs))
        setup = self._setup(question.space)
        ends = [self._state(setup, q) for q in (question.ends.start, question.ends.goals[0])]
        setup.setStartAndGoalStates(*ends)

        def is_over() -> bool:
            return setup.haveExactSolutionPath() or time.process_time() - start > BUDGET_S

        setup.solve(self._base.PlannerTerminationCondition(is_over))
        if not setup.haveExactSolutionPath():
            return Answer(spent_s=time.process_time() - start, reason="no path in time")
        found = self._waypoints(setup)
        left_s = BUDGET_S - (time.process_time() - start)
        if left_s > 0.0:
            setup.simplifySolution(left_s)
        return Answer(
            waypoints_rad=self._waypoints(setup),
            otherwise_rad=found,
            spent_s=time.process_time() - start,
        )

    def _setup(self, space: SearchSpace) -> Any:  # noqa: ANN401 - OMPL's
        base = self._base
        count = len(space.lower)
        states = base.RealVectorStateSpace(count)
        bounds = base.RealVectorBounds(count)
        for k in range(count):
            bounds.setLow(k, float(space.lower[k]))
            bounds.setHigh(k, float(space.upper[k]))
        states.setBounds(bounds)
        setup = self._geometric.SimpleSetup(states)
        information = setup.getSpaceInformation()

        def posture(state: Any) -> Any:  # noqa: ANN401 - OMPL's
            return np.array([state[k] for k in range(count)])

        class Lines(base.MotionValidator):  # type: ignore[misc,name-defined]
            def checkMotion(self, a: Any, b: Any) -> bool:  # noqa: ANN401 - OMPL's
                return space.is_free_line(posture(a), posture(b))

        self._kept = Lines(information)
        information.setMotionValidator(self._kept)
        setup.setStateValidityChecker(lambda state: space.is_free(posture(state)))
        setup.setPlanner(getattr(self._geometric, self._planner)(information))
        return setup

    def _state(self, setup: Any, q: Joints) -> Any:  # noqa: ANN401 - OMPL's
        state = setup.getStateSpace().allocState()
        for k, value in enumerate(q):
            state[k] = value
        return state

    def _waypoints(self, setup: Any) -> tuple[Joints, ...]:  # noqa: ANN401 - OMPL's
        count = setup.getStateSpace().getDimension()
        return tuple(
            joints([state[k] for k in range(count)])
            for state in setup.getSolutionPath().getStates()
        )
