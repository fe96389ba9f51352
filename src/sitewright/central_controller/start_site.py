"""The cell in which a step starts: what its certificates are made against."""

from __future__ import annotations

from sitewright.central_controller.proposal import ProposedStep
from sitewright.planning_twin.jobsite import Jobsite
from sitewright.planning_twin.skill_motions.stage import with_opening
from sitewright.robot_team.skill import Skill


def site_at_start(site: Jobsite, step: ProposedStep) -> Jobsite:
    """Return the cell as sensed, with the gripper opened as the step opens it before it moves."""
    opening = step.params.get("aperture_m") if step.call.skill == Skill.REACH else None
    return with_opening(site, step.call.robot, opening) if isinstance(opening, float) else site
