"""Times of skills: first estimates for the plan's costs, and how long an act itself takes."""

from __future__ import annotations

from collections.abc import Mapping

from sitewright.robot_team.cell import Capability
from sitewright.robot_team.skill import Skill

SKILL_TIME_S: Mapping[str, float] = {
    Capability.GRASPING: 2.0,
    Capability.POSITIONING: 1.5,
    Capability.RELEASING: 1.5,
    Capability.RETRACTING: 1.5,
    Capability.FASTENING: 1.0,
    Capability.FINISHING: 6.0,
    Capability.TOOL_CHANGING: 15.0,
}
"""First estimates, for the plan's costs only; motions are timed exactly afterwards."""

ACT_TIME_S: Mapping[str, float] = {
    Skill.GRASP: 2.0,
    Skill.POSITION: 1.0,
    Skill.SET_DOWN: 1.0,
    Skill.RELEASE: 1.0,
    Skill.FASTEN: 0.5,
}
"""Time of the end effector's act in each skill."""

TYPICAL_REACH_S = 3.0
