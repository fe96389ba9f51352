"""Skills, skill calls and what goes to a driver."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import CommandId, RobotId
from sitewright.robot_team.trajectory import Trajectory


class Skill(StrEnum):
    """The built-in skills; the names are those of the PDDL actions."""

    REACH = "reach"
    RETRACT = "retract"
    GRASP = "grasp"
    POSITION = "position"
    SET_DOWN = "set-down"
    RELEASE = "release"
    FASTEN = "fasten"
    APPLY_FINISH = "apply-finish"
    CHANGE_END_EFFECTOR = "change-end-effector"


class SkillClass(StrEnum):
    """What an unknown outcome means for a skill (reliability note, section 3)."""

    ABSOLUTE = "absolute"
    """Plan anew from the sensed state."""
    SENSABLE = "sensable"
    """Evidence for and against can be sensed."""
    ONCE = "once"
    """Only a person can say whether it happened."""


SKILL_CLASS: Mapping[str, SkillClass] = {
    Skill.REACH: SkillClass.ABSOLUTE,
    Skill.RETRACT: SkillClass.ABSOLUTE,
    Skill.GRASP: SkillClass.SENSABLE,
    Skill.POSITION: SkillClass.SENSABLE,
    Skill.SET_DOWN: SkillClass.SENSABLE,
    Skill.RELEASE: SkillClass.SENSABLE,
    Skill.CHANGE_END_EFFECTOR: SkillClass.SENSABLE,
    Skill.FASTEN: SkillClass.ONCE,
    Skill.APPLY_FINISH: SkillClass.ONCE,
}


@dataclass(frozen=True, slots=True)
class SkillCall:
    """One action of a plan in the ids of the site, not of the PDDL text.

    Attributes:
        skill: Name of the skill; a PDDL action name.
        robot: The robot that does it.
        arguments: The action's other arguments in order, as site ids: component, operation,
            stock place, station, end effector. The target appears as its component id, a
            fastener or finish spot as its operation id.
    """

    skill: str
    robot: RobotId
    arguments: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillCommand:
    """What a driver gets: everything the skill needs, checked and approved before.

    Attributes:
        command_id: Unique for ever; a driver never executes the same one twice.
        epoch: A driver refuses commands of an older epoch than it has seen.
        trajectories: Motions in the order in which they are made.
        params: By skill; see `sitewright.robot_team.driver`.
    """

    command_id: CommandId
    epoch: int
    skill: str
    robot: RobotId
    trajectories: tuple[Trajectory, ...] = ()
    params: Mapping[str, Json] = field(default_factory=dict)
