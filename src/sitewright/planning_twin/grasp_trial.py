"""One grasp put to the test: pick, lift, place, and letting go, each with its straight lines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.planning_twin.approach import (
    Approach,
    Approaches,
    Reaching,
    Touch,
    different,
    straight_approach,
)
from sitewright.planning_twin.grasps import Grasp
from sitewright.planning_twin.jobsite import Jobsite, scene_of, with_aperture
from sitewright.planning_twin.motion import JointPath, PathSegment
from sitewright.planning_twin.refusal import BlockedBy, NoIk
from sitewright.planning_twin.scene import Attachment, SceneSnapshot
from sitewright.planning_twin.task import UP, TwinContext
from sitewright.planning_twin.touches import (
    leave_touch,
    lift_thresholds,
    pick_touch,
    place_touch,
)
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.waiting import home_opposite


@dataclass(frozen=True, slots=True, kw_only=True)
class GraspTrial:
    """A robot that tries one grasp of one piece, alone on the site.

    The other robots are left out: where they stand is a matter of order, which the symbolic plan
    decides.

    Attributes:
        opened: Before the pick: the gripper as wide as the grasp asks for.
        carrying: The piece in the gripper.
    """

    context: TwinContext
    robot: Robot
    tool: EndEffector
    piece: ComponentId
    grasp: Grasp
    opened: Reaching
    carrying: Reaching

    def picks(self) -> Iterator[Approach]:
        """Yield the proven approaches to the piece where it lies, the nearest posture first."""
        task, at = self.context.task, self.context.site.world_T_piece[self.piece]
        touch = pick_touch(task, self.tool, self.piece, at, self.grasp)
        for approach in Approaches(self.opened, touch, self._near_rad(touch)):
            if is_proven(self.opened, approach.segments):
                yield approach

    def can_lift(self, pick: Approach) -> bool:
        """Tell whether the piece can be lifted straight up after a pick."""
        near_m = lift_thresholds(self.context.task, self.tool, self.piece)
        touch = replace(pick.touch, back_off=UP, near_m=near_m, free_m={})
        lift = straight_approach(self.carrying, touch, pick.contact_rad)
        return not isinstance(lift, NoIk) and self._is_way_out(self.carrying, lift)

    def placements(self) -> Iterator[tuple[int, Approach]]:
        """Yield the proven approaches to the target pose, with the number of the way in."""
        task = self.context.task
        for number, insertion in enumerate(task.insertions):
            touch = place_touch(task, self.tool, self.piece, self.grasp, insertion)
            for approach in Approaches(self.carrying, touch, self._near_rad(touch)):
                if is_proven(self.carrying, approach.segments):
                    yield number, approach

    def hold_postures(self) -> Iterator[Joints]:
        """Yield the clear postures with the piece at the target; whole turns are left out."""
        task = self.context.task
        touch = place_touch(task, self.tool, self.piece, self.grasp, task.insertions[0])
        postures = self.carrying.solve(touch.world_T_tip, self._near_rad(touch))
        for q_rad in () if isinstance(postures, NoIk) else different(self.carrying, postures):
            if self.carrying.is_clear(q_rad, touch.near_m):
                yield q_rad

    def in_its_place(self) -> tuple[tuple[str, ...], Joints] | None:
        """Return the pieces, fixtures and zones that are where this piece belongs, and a posture.

        None if this grasp cannot get there.

        It is the same for every posture and every other grasp.
        """
        task, insertion = self.context.task, self.context.task.insertions[0]
        touch = place_touch(task, self.tool, self.piece, self.grasp, insertion)
        postures = self.carrying.solve(touch.world_T_tip, self._near_rad(touch))
        if isinstance(postures, NoIk):
            return None
        pairs = self.carrying.violations(postures[0], touch.near_m)
        names = {other for pair in pairs if self.piece in pair for other in pair} - {self.piece}
        cell = self.context.cell
        known = (self.context.site.world_T_piece, cell.fixture_by_id, cell.zone_by_id)
        return tuple(i for things in known for i in sorted(things) if i in names), postures[0]

    def why_not(self) -> BlockedBy | None:
        """Return what is in the way where the piece lies, else where it belongs, if things are."""
        task, site = self.context.task, self.context.site
        touches = [
            (self.carrying, place_touch(task, self.tool, self.piece, self.grasp, insertion))
            for insertion in task.insertions
        ]
        if site.arms[self.robot.id].held != self.piece:
            at = site.world_T_piece[self.piece]
            touches.insert(
                0, (self.opened, pick_touch(task, self.tool, self.piece, at, self.grasp))
            )
        for reaching, touch in touches:
            search = Approaches(reaching, touch, self.robot.home_q_rad)
            if next(iter(search), None) is None:
                why = search.why_not()
                return why if isinstance(why, BlockedBy) else None
        return None

    def can_leave(self, place: Approach) -> bool:
        """Tell whether the opened gripper gets away from the placed piece."""
        task = self.context.task
        scene = self.opened.scene.placed(BodyId(self.piece), task.world_T_target)
        leaving = replace(self.opened, scene=scene)
        touch = leave_touch(task, self.tool, self.piece, place.touch.world_T_tip)
        if not leaving.is_clear(place.contact_rad, touch.near_m):
            return False
        way_out = straight_approach(leaving, touch, place.contact_rad)
        return not isinstance(way_out, NoIk) and self._is_way_out(leaving, way_out)

    def _near_rad(self, touch: Touch) -> Joints:
        return home_opposite(self.robot, touch.world_T_tip.position_m)

    @staticmethod
    def _is_way_out(reaching: Reaching, way: Approach) -> bool:
        is_free = reaching.is_clear(way.pre_rad, {}, is_padded=True)
        return is_free and is_proven(reaching, way.segments)


def grasp_trial(
    context: TwinContext, robot: Robot, tool: EndEffector, piece: ComponentId, grasp: Grasp
) -> GraspTrial:
    """Return the trial of a grasp on the site as it is."""
    before = with_aperture(alone(scene_of(context.site), robot.id), tool, grasp.open_m)
    held = alone(scene_of(with_held(context.site, robot.id, piece, grasp, tool)), robot.id)
    return GraspTrial(
        context=context,
        robot=robot,
        tool=tool,
        piece=piece,
        grasp=grasp,
        opened=Reaching(backends=context.backends, scene=before, robot=robot.id),
        carrying=Reaching(backends=context.backends, scene=held, robot=robot.id),
    )


def is_proven(reaching: Reaching, segments: tuple[PathSegment, ...]) -> bool:
    """Tell whether straight lines hold their certificate in the scene of a trial."""
    path = JointPath(robot=reaching.robot, segments=segments)
    scene = reaching.scene.with_joints(reaching.robot, path.start_rad)
    return reaching.backends.certifier.objection(scene, path) is None


def alone(scene: SceneSnapshot, robot: RobotId) -> SceneSnapshot:
    """Return the scene without the other robots and what they carry."""
    carried = [
        i
        for i, body in scene.bodies.items()
        if isinstance(body.placement, Attachment) and body.placement.robot != robot
    ]
    return replace(scene.without(*carried), robots={robot: scene.robots[robot]})


def with_held(
    site: Jobsite, robot: RobotId, piece: ComponentId, grasp: Grasp, tool: EndEffector
) -> Jobsite:
    """Return the site with a piece in a robot's gripper."""
    arm = replace(
        site.arms[robot], held=piece, tip_T_held=grasp.tip_T_piece(tool), aperture_m=grasp.width_m
    )
    return replace(site, arms={**site.arms, robot: arm})
