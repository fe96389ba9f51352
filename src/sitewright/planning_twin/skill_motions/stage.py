"""Where a plan stands while it is being turned into motion, and what a skill's planner returns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.approach import Reaching
from sitewright.planning_twin.jobsite import Jobsite, scene_of
from sitewright.planning_twin.motion import PlannedMotion
from sitewright.planning_twin.refusal import Refusal
from sitewright.planning_twin.scene import Pair
from sitewright.planning_twin.study import Study
from sitewright.planning_twin.tacking import Holding
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.skill import SkillCall
from sitewright.robot_team.waiting import waiting_postures


@dataclass(frozen=True, slots=True, kw_only=True)
class Stage:
    """The site at one point of a plan, and what comes next.

    Attributes:
        upcoming: The calls after the one that is planned now.
        detour: How often the way of this call was called unsafe.
        parking: Which parking posture a robot takes when it just has to go away.
        resting_of: What was found to rest while a robot moves, remembered as long as the stage.
    """

    context: TwinContext
    study: Study
    upcoming: tuple[SkillCall, ...] = ()
    detour: int = 0
    parking: Mapping[RobotId, int] = field(default_factory=dict)
    resting_of: dict[RobotId, dict[Pair, float]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    @property
    def site(self) -> Jobsite:
        """The site at this point."""
        return self.context.site

    def at(self, site: Jobsite) -> Stage:
        """Return the stage with another site."""
        return replace(self, context=replace(self.context, site=site))

    def robot(self, robot: RobotId) -> Robot:
        """Return a robot of the cell."""
        return self.context.cell.robot_by_id[robot]

    def tool(self, robot: RobotId) -> EndEffector:
        """Return the end effector of a robot that must have one."""
        tool = self.context.tool_of(robot)
        if tool is None:
            raise ValueError(f"{robot} has a bare flange; the plan should have given it a tool")
        return tool

    def holding(self, robot: RobotId, piece: ComponentId) -> Holding | None:
        """Return the grasp that was studied for a robot and a piece."""
        return self.study.holdings.get((robot, piece))

    def q_rad(self, robot: RobotId) -> Joints:
        """Return a robot's posture at this point."""
        return self.site.arms[robot].q_rad

    def out_of_the_way(self, robot: RobotId, declared: tuple[Joints, ...]) -> tuple[Joints, ...]:
        """Return where a robot may wait, beside the target if its rails lead there."""
        work_m = self.context.task.world_T_target.position_m
        return waiting_postures(self.robot(robot), declared, self.q_rad(robot), work_m)

    def parking_postures(self, robot: RobotId) -> tuple[Joints, ...]:
        """Return where a robot that just has to go away may go, in order of preference."""
        parking = self.out_of_the_way(robot, self.robot(robot).parking_q_rad)
        return (*parking, self.robot(robot).home_q_rad)

    def reaching(self, robot: RobotId) -> Reaching:
        """Return the means to look for postures of a robot in this scene."""
        return Reaching(backends=self.context.backends, scene=scene_of(self.site), robot=robot)

    def tip(self, robot: RobotId) -> Pose:
        """Return the world pose of a robot's tip."""
        arm = self.robot(robot)
        base_T_tip = self.context.backends.kinematics.tip(arm.description, self.q_rad(robot))
        return arm.world_T_base @ base_T_tip


@dataclass(frozen=True, slots=True, kw_only=True)
class Chosen:
    """A freedom of a contact pose that was taken because the first choice would not do.

    Attributes:
        label: For people: ``tilt 2.5 deg about 90 deg``.
        refusal: Why the first choice would not do.
    """

    label: str
    refusal: Refusal


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedSkill:
    """A skill call with its motion.

    Attributes:
        site_after: The site as it is expected afterwards.
        act_s: Time of the end effector's act, on top of the motions.
        contacts: Pairs that the act itself lets touch; those of motions are in their paths.
        chosen: Freedom that was chosen, if it is not the first one, and why that one would not do.
    """

    motions: tuple[PlannedMotion, ...]
    params: Mapping[str, Json]
    site_after: Jobsite
    act_s: float = 0.0
    contacts: tuple[Pair, ...] = ()
    chosen: Chosen | None = None

    def declared_contacts(self) -> tuple[Pair, ...]:
        """Return all pairs that may touch during the skill, in order of name."""
        moving = {
            pair
            for motion in self.motions
            for segment in motion.timed.path.segments
            for pair, threshold_m in segment.threshold_m.items()
            if threshold_m < 0.0
        }
        return tuple(sorted(moving | set(self.contacts)))


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillRefusal:
    """A skill call that geometry does not allow, with why."""

    call: SkillCall
    refusal: Refusal


def with_joints(site: Jobsite, robot: RobotId, q_rad: Joints) -> Jobsite:
    """Return the site with a robot in another posture, a carried piece moved along."""
    arm = replace(site.arms[robot], q_rad=q_rad)
    return replace(site, arms={**site.arms, robot: arm})


def with_opening(site: Jobsite, robot: RobotId, aperture_m: float) -> Jobsite:
    """Return the site with a robot's gripper opened or closed."""
    arm = replace(site.arms[robot], aperture_m=aperture_m)
    return replace(site, arms={**site.arms, robot: arm})


def pose_json(pose: Pose) -> Json:
    """Return a pose as the driver's parameters have it."""
    return {"p_m": list(pose.position_m), "q_wxyz": list(pose.quaternion_wxyz)}
