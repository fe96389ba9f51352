"""Whether it is proven that a piece cannot be fastened while it is held, whatever else is done.

A collision proves nothing as long as what is in the way might go away. Here only those bodies
are looked at that the act itself needs: the arm that holds, its gripper and the piece, what
carries the piece and therefore stands, the fixtures of the cell, and one other robot with its
tool. If, among them alone, each way to hold leaves too few fasteners that any robot could drive,
then no order, no parking and no other piece helps.

All freedoms that the planner has are gone through, none in strides and none within a budget:
every grasp in every posture (whole turns of a joint change nothing), and for each fastener every
robot, tool and lean, each turned by quarters about the tool's axis besides, in every posture.
Looked at is the posture in contact, at the thresholds of its certificate and without pads.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

from sitewright.foundation.ids import ComponentId, OperationId, RobotId
from sitewright.planning_twin.approach import Reaching, Touch, different
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.grasp_trial import alone, with_held
from sitewright.planning_twin.grasps import Grasp
from sitewright.planning_twin.jobsite import Jobsite, drives, scene_of, with_tool
from sitewright.planning_twin.moment import moment_of
from sitewright.planning_twin.refusal import BlockedBy, HeldFreedoms, NoIk
from sitewright.planning_twin.scene import Attachment, SceneSnapshot
from sitewright.planning_twin.tacking import Holding, held_site, is_enough
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.touches import place_touch, spot_touch
from sitewright.robot_team.cell import EndEffector, EndEffectorKind, Robot
from sitewright.robot_team.description import Joints


def proof_of_too_few(
    context: TwinContext,
    robot: Robot,
    gripper: EndEffector,
    piece: ComponentId,
    grasps: list[Grasp],
) -> HeldFreedoms | None:
    """Return the freedoms over which it is proven that too few fasteners can be driven.

    Args:
        context: Engines, site and task.
        robot: Who would hold the piece.
        gripper: What it would be held with.
        piece: A candidate of the task.
        grasps: All candidates.

    Returns:
        None if it is not proven: some way to hold leaves enough fasteners that nothing of the act
        itself is in the way of, or not all postures of an arm are known, or a robot might hold
        the piece with a gripper that it has not mounted.
    """
    if not _are_all_grippers_mounted(context):
        return None
    act = replace(context, site=_lasting(context, piece))
    ways = _ways_to_hold(act, robot, gripper, piece, grasps)
    drivers = None if ways is None else _Drivers.of(act, robot.id, piece)
    if ways is None or drivers is None:
        return None
    for way in ways:
        if not drivers.too_few_while(held_site(act, way, gripper), robot.id):
            return None
    return HeldFreedoms(
        grasps=len(grasps),
        ways=len(ways),
        tool_poses=drivers.most_poses,
        robots=drivers.robots,
        blocked=drivers.blocked_by_holder(robot.id),
    )


def _are_all_grippers_mounted(context: TwinContext) -> bool:
    """Tell whether no robot could change to another gripper, which nobody has looked at."""
    tools = context.cell.end_effector_by_id
    return all(
        tools[i].kind is not EndEffectorKind.GRIPPER or i == context.site.arms[robot.id].mounted
        for robot in context.cell.robot_by_id.values()
        for i in robot.end_effectors
    )


def _lasting(context: TwinContext, piece: ComponentId) -> Jobsite:
    """Return the site with nothing but what the act itself needs, and the fixtures of the cell.

    Zones come and go with people; other pieces, docked tools and obstacles are left out too.
    """
    site = context.site
    kept = {piece, *context.task.rests_on}
    arms = {r: replace(a, held=None) for r, a in site.arms.items()}
    return replace(
        site,
        cell=replace(site.cell, zone_by_id={}),
        pieces={i: shape for i, shape in site.pieces.items() if i in kept},
        world_T_piece={i: pose for i, pose in site.world_T_piece.items() if i in kept},
        arms=arms,
        docked={},
        obstacles={},
        steadied={},
    )


def _ways_to_hold(
    act: TwinContext, robot: Robot, gripper: EndEffector, piece: ComponentId, grasps: list[Grasp]
) -> list[Holding] | None:
    """Return every way to hold the piece at its target; None if some might be missing."""
    found: list[Holding] = []
    for grasp in grasps:
        held = with_held(act.site, robot.id, piece, grasp, gripper)
        reaching = Reaching(
            backends=act.backends, scene=alone(scene_of(held), robot.id), robot=robot.id
        )
        touch = place_touch(act.task, gripper, piece, grasp, act.task.insertions[0])
        postures = _all_clear(reaching, touch, robot)
        if postures is None:
            return None
        found += [
            Holding(robot=robot.id, piece=piece, grasp=grasp, hold_rad=q_rad) for q_rad in postures
        ]
    return found


def _all_clear(reaching: Reaching, touch: Touch, robot: Robot) -> list[Joints] | None:
    """Return all postures of a contact that nothing is in the way of; None if some may be missing.

    Whole turns of a joint are left out.
    """
    base_T_tip = robot.world_T_base.inverse() @ touch.world_T_tip
    if not reaching.backends.kinematics.has_all(robot.description, base_T_tip):
        return None
    postures = reaching.solve(touch.world_T_tip, robot.home_q_rad)
    if isinstance(postures, NoIk):
        return [] if postures.is_proven else None
    return [q for q in different(reaching, postures) if reaching.is_clear(q, touch.near_m)]


@dataclass(frozen=True, slots=True)
class _Post:
    """A posture in which a robot could drive a fastener if nobody held the piece."""

    robot: RobotId
    tool: EndEffector
    touch: Touch
    q_rad: Joints


@dataclass(slots=True)
class _Drivers:
    """From where the fasteners of a task can be driven, if at all.

    Attributes:
        posts: For each fastener all postures in contact, of all robots but the holder.
        most_poses: So many poses of tools were looked at for a fastener, at most.
        robots: Who has a tool for one of them.
    """

    act: TwinContext
    posts: dict[OperationId, list[_Post]]
    most_poses: int
    robots: tuple[RobotId, ...]
    _hits: Counter[OperationId] = field(default_factory=Counter)
    _blocked_first: dict[OperationId, Jobsite] = field(default_factory=dict)

    @classmethod
    def of(cls, act: TwinContext, holder: RobotId, piece: ComponentId) -> _Drivers | None:
        """Look at all fasteners with the piece at its target; None if postures may be missing."""
        at_target = {**act.site.world_T_piece, piece: act.task.world_T_target}
        placed = replace(act.site, world_T_piece=at_target)
        posts: dict[OperationId, list[_Post]] = {}
        most_poses, robots = 0, dict[RobotId, None]()
        for spot in (s for s in act.task.spots if s.fastener is not None):
            posts[spot.operation], poses = [], 0
            for robot, tool in _tools_for(act, holder, spot):
                touches = _touches(spot, tool, piece)
                scene = alone(scene_of(with_tool(placed, robot.id, tool)), robot.id)
                reaching = Reaching(backends=act.backends, scene=scene, robot=robot.id)
                for touch in touches:
                    postures = _all_clear(reaching, touch, robot)
                    if postures is None:
                        return None
                    posts[spot.operation] += [_Post(robot.id, tool, touch, q) for q in postures]
                poses, robots[robot.id] = poses + len(touches), None
            most_poses = max(most_poses, poses)
        return cls(act, posts, most_poses, tuple(robots))

    def too_few_while(self, site: Jobsite, holder: RobotId) -> bool:
        """Tell whether enough fasteners are blocked by the act itself while a piece is held so."""
        task, scene_with = self.act.task, _scenes(site, holder)
        free = dict.fromkeys(self.posts)
        for operation in sorted(self.posts, key=lambda o: -self._hits[o]):
            if not is_enough(task, tuple(free)):
                return True
            if not any(self._is_clear(scene_with, post) for post in self.posts[operation]):
                self._hits[operation] += 1
                self._blocked_first.setdefault(operation, site)
                del free[operation]
        return not is_enough(task, tuple(free))

    def _is_clear(self, scene_with: _SceneWith, post: _Post) -> bool:
        among = Reaching(
            backends=self.act.backends, scene=scene_with(post.robot, post.tool), robot=post.robot
        )
        return among.is_clear(post.q_rad, post.touch.near_m)

    def blocked_by_holder(self, holder: RobotId) -> tuple[tuple[OperationId, BlockedBy], ...]:
        """Return fasteners that could be driven if nobody held the piece, and what is too near.

        Each is told for the cheapest way to hold that it was blocked in.
        """
        return tuple(
            (operation, self._why(site, holder, operation))
            for operation, site in self._blocked_first.items()
            if self.posts[operation]
        )

    def _why(self, site: Jobsite, holder: RobotId, operation: OperationId) -> BlockedBy:
        """Return the pairs of holder and driver in the posture that has the fewest of them."""
        scene_with, found = _scenes(site, holder), list[BlockedBy]()
        for post in self.posts[operation]:
            scene = scene_with(post.robot, post.tool)
            among = Reaching(backends=self.act.backends, scene=scene, robot=post.robot)
            pairs = among.violations(post.q_rad, post.touch.near_m)
            moment = moment_of(scene, {post.robot: post.q_rad}, pairs[0])
            found.append(BlockedBy(pairs=pairs, removals=((holder,),), moment=moment))
        return min(found, key=lambda why: len(why.pairs))


def _tools_for(
    act: TwinContext, holder: RobotId, spot: Spot
) -> Iterator[tuple[Robot, EndEffector]]:
    """Yield every robot but the holder with every tool of it that does an operation.

    Wherever the tool is now: somebody might bring it back.
    """
    for robot in act.cell.robot_by_id.values():
        for tool in (act.cell.end_effector_by_id[i] for i in robot.end_effectors):
            if robot.id != holder and spot.process in tool.processes and drives(tool, spot):
                yield robot, tool


def _touches(spot: Spot, tool: EndEffector, piece: ComponentId) -> list[Touch]:
    """Return all contacts of a tool with a fastener; thresholds are known by their identity."""
    poses = tool_poses(spot, tool, has_yaw=True)
    touches = [spot_touch(tool, spot.body(piece), pose) for pose in poses]
    return [replace(t, near_m=touches[0].near_m, free_m=touches[0].free_m) for t in touches]


_SceneWith = Callable[[RobotId, EndEffector], SceneSnapshot]


def _scenes(site: Jobsite, holder: RobotId) -> _SceneWith:
    """Return the scenes of a site with the holder, and with one other robot and its tool."""
    made: dict[tuple[RobotId, str], SceneSnapshot] = {}

    def scene_with(robot: RobotId, tool: EndEffector) -> SceneSnapshot:
        key = (robot, tool.id)
        if key not in made:
            made[key] = _only(scene_of(with_tool(site, robot, tool)), (holder, robot))
        return made[key]

    return scene_with


def _only(scene: SceneSnapshot, robots: tuple[RobotId, ...]) -> SceneSnapshot:
    """Return the scene without the robots that have no part in it, and what they carry."""
    carried = [
        i
        for i, body in scene.bodies.items()
        if isinstance(body.placement, Attachment) and body.placement.robot not in robots
    ]
    return replace(scene.without(*carried), robots={r: scene.robots[r] for r in robots})
