"""In which ways a robot reaches a fastener, asked again and again while others hold the piece."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from sitewright.foundation.ids import ComponentId, OperationId, RobotId
from sitewright.planning_twin.approach import Reaching, Touch, different, straight_approach
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.grasp_trial import alone
from sitewright.planning_twin.jobsite import Jobsite, scene_of, tool_for, with_tool
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.touches import spot_touch
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.waiting import home_opposite


class DrivingWays:
    """The approaches of robots to the fasteners of a task, with the piece at its target.

    They are looked for once, without the other robots; whether one of those is in the way is
    asked for each way of holding the piece anew, and takes a hundredth of the time.
    """

    def __init__(self, context: TwinContext, piece: ComponentId) -> None:
        """Look at a task with one piece at its target.

        Args:
            context: Engines, site and task.
            piece: What stands at the target.
        """
        self._context, self._piece = context, piece
        self._ways: dict[tuple[RobotId, OperationId], _Ways] = {}
        self._placed = _placed(context, piece)

    def can_drive(self, site: Jobsite, robot: Robot, spot: Spot) -> bool:
        """Tell whether a robot reaches a fastener, with any tilt that its tool allows.

        Args:
            site: With the piece at the target, and the other robots where they are meanwhile.
            robot: Who drives.
            spot: A fastener of the task.
        """
        tool = tool_for(site, robot, spot)
        if tool is None:
            return False
        known = self._ways.get((robot.id, spot.operation))
        if known is None:
            known = _Ways(self._found(robot, spot, tool))
            self._ways[robot.id, spot.operation] = known
        scene = scene_of(with_tool(site, robot.id, tool))
        among = Reaching(backends=self._context.backends, scene=scene, robot=robot.id)
        return any(way.is_clear(among) for way in known)

    def is_free_alone(self, operation: OperationId) -> bool:
        """Tell whether a robot that was asked for reaches a fastener while nobody holds the piece.

        The posture in contact is looked at, without the other robots.
        """
        known = (ways for (_, o), ways in self._ways.items() if o == operation)
        return any(next(iter(ways), None) is not None for ways in known)

    def _found(self, robot: Robot, spot: Spot, tool: EndEffector) -> Iterator[_Way]:
        scene = alone(scene_of(with_tool(self._placed, robot.id, tool)), robot.id)
        reaching = Reaching(backends=self._context.backends, scene=scene, robot=robot.id)
        poses = tool_poses(spot, tool, has_yaw=False)
        touches = [spot_touch(tool, spot.body(self._piece), pose) for pose in poses]
        # thresholds are known again by their identity: one value for all of a fastener
        same = [replace(t, near_m=touches[0].near_m, free_m=touches[0].free_m) for t in touches]
        for touch in same:
            near_rad = home_opposite(robot, touch.world_T_tip.position_m)
            postures = reaching.solve(touch.world_T_tip, near_rad)
            for q_rad in () if isinstance(postures, NoIk) else different(reaching, postures):
                if reaching.is_clear(q_rad, touch.near_m):
                    yield _Way(reaching, touch, q_rad)


@dataclass(slots=True)
class _Way:
    """A posture in contact that nothing but another robot can be in the way of.

    The straight line into it is looked for when somebody needs it.
    """

    reaching: Reaching
    touch: Touch
    contact_rad: Joints
    _pre_rad: Joints | NoIk | None = None

    def is_clear(self, among: Reaching) -> bool:
        """Tell whether both ends of the way are clear among the other robots."""
        if not among.is_clear(self.contact_rad, self.touch.near_m):
            return False
        pre_rad = self._pre()
        return not isinstance(pre_rad, NoIk) and among.is_clear(
            pre_rad, self.touch.free_m, is_padded=True
        )

    def _pre(self) -> Joints | NoIk:
        if self._pre_rad is None:
            way = straight_approach(self.reaching, self.touch, self.contact_rad)
            self._pre_rad = way if isinstance(way, NoIk) else way.pre_rad
        return self._pre_rad


class _Ways:
    """What an iterator yields, for many readers; it goes on only as far as somebody reads."""

    def __init__(self, rest: Iterator[_Way]) -> None:
        self._rest = rest
        self._known: list[_Way] = []

    def __iter__(self) -> Iterator[_Way]:
        yield from self._known
        for way in self._rest:
            self._known.append(way)
            yield way


def _placed(context: TwinContext, piece: ComponentId) -> Jobsite:
    """Return the site with a piece at the target and in nobody's gripper."""
    site = context.site
    arms = {r: replace(a, held=None) if a.held == piece else a for r, a in site.arms.items()}
    return replace(
        site,
        arms=arms,
        world_T_piece={**site.world_T_piece, piece: context.task.world_T_target},
    )
