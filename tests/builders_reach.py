"""Reach checks held against plans of the same project: what one planned the other must allow."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.app.clock import SystemClock
from sitewright.app.planning import PlanReport
from sitewright.app.project import Project
from sitewright.app.reach import reach_of
from sitewright.central_controller.proposal import ProposedStep
from sitewright.planning_twin.reachability.answer import Refused
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.planning_twin.reachability.verdict import Standing
from sitewright.planning_twin.wording import is_proof
from sitewright.robot_team.skill import Skill


def checked(project: Project) -> ReachReport:
    """Return the reach check of a project."""
    return reach_of(project, SystemClock())


def contradictions(reach: ReachReport, plan: PlanReport) -> list[str]:
    """Return what was planned with certified motions and yet called impossible, robot by robot."""
    planned = {p.proposal.target for p in plan.planned}
    whole = [
        f"{v.target} was planned and is called impossible: {v.reasons}"
        for v in reach.verdicts
        if v.target in planned and v.standing is Standing.IMPOSSIBLE
    ]
    steps = ((p.proposal.target, s) for p in plan.planned for s in p.proposal.steps)
    return [*whole, *(no for target, step in steps for no in _denied(reach, target, step))]


def missed(reach: ReachReport, plan: PlanReport) -> list[str]:
    """Return the targets that were planned though no way was found for them."""
    planned = {p.proposal.target for p in plan.planned}
    return [v.target for v in reach.verdicts if v.target in planned and v.reasons]


def _denied(reach: ReachReport, target: str, step: ProposedStep) -> Iterator[str]:
    """Yield that the very thing that a step does was called impossible for its robot."""
    call, answer = step.call, reach.answer
    mine = [h for h in answer.handlings if (h.robot, h.target) == (call.robot, target)]
    if call.skill == Skill.POSITION and any(h.never_at_target for h in mine):
        yield f"{call.robot} placed {target}"
    if call.skill == Skill.GRASP and mine and all(h.never_at_stock for h in mine):
        yield f"{call.robot} picked {call.arguments[0]} for {target}"
    for operating in answer.operatings:
        is_it = (operating.robot, operating.operation) == (call.robot, call.arguments[0])
        if is_it and _is_proven(operating.refused):
            yield f"{call.robot} did {operating.operation}"


def _is_proven(refused: Refused | None) -> bool:
    return refused is not None and is_proof(refused.refusal)
