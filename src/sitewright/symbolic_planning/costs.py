"""What skills cost: estimated times in whole tenths of a second, at least one."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sitewright.foundation.ids import RobotId
from sitewright.robot_team.cell import Capability
from sitewright.robot_team.skill import Skill
from sitewright.symbolic_planning.site_index import SiteIndex

DEFAULT_REACH_S = 4.0
DEFAULT_SKILL_S: Mapping[str, float] = {
    Capability.RETRACTING: 3.0,
    Capability.GRASPING: 2.0,
    Capability.POSITIONING: 3.0,
    Capability.RELEASING: 2.0,
    Capability.FASTENING: 3.0,
    Capability.FINISHING: 10.0,
    Capability.TOOL_CHANGING: 20.0,
}
"""Used until the planning twin has measured a motion of that kind."""

_SKILL_OF: Mapping[str, Skill] = {
    Capability.RETRACTING: Skill.RETRACT,
    Capability.GRASPING: Skill.GRASP,
    Capability.POSITIONING: Skill.POSITION,
    Capability.RELEASING: Skill.RELEASE,
    Capability.FASTENING: Skill.FASTEN,
    Capability.FINISHING: Skill.APPLY_FINISH,
    Capability.TOOL_CHANGING: Skill.CHANGE_END_EFFECTOR,
}


@dataclass(frozen=True, slots=True)
class CostFunction:
    """A numeric function of the domain.

    Attributes:
        types: Types of its arguments.
        tenths: Its value in tenths of a second; None for the total, which is counted.
    """

    types: tuple[str, ...]
    tenths: Callable[[tuple[str, ...], SiteIndex], int] | None


def tenths(time_s: float) -> int:
    """Return a time as a cost."""
    return max(1, round(time_s * 10.0))


def _reach_time(args: tuple[str, ...], site: SiteIndex) -> int:
    times = site.view.geometry.reach_time_s
    return tenths(times.get((RobotId(args[0]), args[1]), DEFAULT_REACH_S))


def _skill_time(args: tuple[str, ...], site: SiteIndex) -> int:
    """Times may be given by capability (``grasping``) or by skill (``grasp``)."""
    robot, capability = RobotId(args[0]), args[1]
    times = site.view.geometry.skill_time_s
    by_skill = times.get((robot, _SKILL_OF[capability]), DEFAULT_SKILL_S[capability])
    return tenths(times.get((robot, capability), by_skill))


FUNCTIONS: Mapping[str, CostFunction] = {
    "total-cost": CostFunction((), None),
    "reach-time": CostFunction(("robot", "place"), _reach_time),
    "skill-time": CostFunction(("robot", "skill"), _skill_time),
}
"""Every function that a domain file may use."""
