"""Which fasteners can be driven while the piece is still held."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from sitewright.foundation.ids import ComponentId, OperationId, RobotId
from sitewright.planning_twin.driving import DrivingWays
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.grasps import Grasp
from sitewright.planning_twin.jobsite import Jobsite, tool_for
from sitewright.planning_twin.task import Task, TwinContext
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.kinematics import without_turns


@dataclass(frozen=True, slots=True, kw_only=True)
class Holding:
    """How one robot takes one piece, places it and holds it.

    Attributes:
        hold_rad: Posture while the piece stands at its target and is held.
        pick_rad: Posture in which it is taken; None if it is in hand already.
        rank: Place of the grasp among the candidates, to go on searching from there.
        insertion: Number of the task's insertion that is used.
        tacks: Fasteners that a finisher can drive meanwhile, in order.
        passed_over: Which test dropped how many cheaper grasps.
    """

    robot: RobotId
    piece: ComponentId
    grasp: Grasp
    hold_rad: Joints
    pick_rad: Joints | None = None
    rank: int = 0
    insertion: int = 0
    tacks: tuple[OperationId, ...] = ()
    passed_over: tuple[tuple[str, int], ...] = ()


def with_tacks(context: TwinContext, holding: Holding, gripper: EndEffector) -> Holding:
    """Return the holding with the fasteners that can be driven during it."""
    return replace(holding, tacks=drivable_while_held(context, holding, gripper))


def tacks_needed(task: Task) -> int:
    """Return how many fasteners must be driven before the piece may be let go."""
    return max(task.hold_until, len(forced_tacks(task)))


def forced_tacks(task: Task) -> tuple[OperationId, ...]:
    """Return the fasteners that the design wants driven while the piece is held."""
    return tuple(s.operation for s in task.spots if s.fastener is not None and s.needs_hold)


def is_enough(task: Task, tacks: tuple[OperationId, ...]) -> bool:
    """Tell whether a piece may be let go once these fasteners are driven."""
    return len(tacks) >= tacks_needed(task) and set(forced_tacks(task)) <= set(tacks)


def owed_tacks(task: Task, drivable: tuple[OperationId, ...]) -> tuple[OperationId, ...]:
    """Return what must be driven before a piece that is held already is let go.

    If too few are drivable, the rest is owed all the same: the piece would fall. Then no plan
    exists until somebody makes room.
    """
    if is_enough(task, drivable):
        return drivable
    wanted = [s.operation for s in _most_wanted_first(task)]
    first = dict.fromkeys((*forced_tacks(task), *drivable, *wanted))
    return tuple(first)[: tacks_needed(task)]


def _most_wanted_first(task: Task) -> list[Spot]:
    fasteners = [s for s in task.spots if s.fastener is not None]
    return sorted(fasteners, key=lambda s: not s.needs_hold)


class Tacking:
    """Which fasteners can be driven while a robot holds a piece, one way of holding after another.

    Attributes:
        most: The most that could be driven in any way that was asked for.
        insufficient: So many ways let too few be driven.
    """

    def __init__(
        self, context: TwinContext, robot: RobotId, piece: ComponentId, gripper: EndEffector
    ) -> None:
        """Look at one robot and piece of a task."""
        self.context, self.robot, self.piece, self.gripper = context, robot, piece, gripper
        self.ways = DrivingWays(context, piece)
        self.most: tuple[OperationId, ...] = ()
        self.insufficient = 0

    def of(self, grasp: Grasp) -> GraspTacks:
        """Return the answers for one grasp."""
        return GraspTacks(self, grasp)

    def note(self, tacks: tuple[OperationId, ...]) -> bool:
        """Note what one more way of holding allows; tell whether it is enough."""
        if is_enough(self.context.task, tacks):
            return True
        self.insufficient += 1
        self.most = max(self.most, tacks, key=len)
        return False

    def hindered(self) -> tuple[OperationId, ...]:
        """Return the fasteners beyond `most` that could be driven if nobody held the piece."""
        fasteners = (
            s for s in _most_wanted_first(self.context.task) if s.operation not in self.most
        )
        return tuple(s.operation for s in fasteners if self.ways.is_free_alone(s.operation))


@dataclass(slots=True)
class GraspTacks:
    """The answers for one grasp, by the posture that the piece is held in."""

    _tacking: Tacking
    _grasp: Grasp
    _known: dict[Joints, tuple[tuple[OperationId, ...], bool]] = field(default_factory=dict)

    @property
    def asked(self) -> int:
        """How many postures were asked for, whole turns left out."""
        return len(self._known)

    def suffice(self, hold_rad: Joints) -> bool:
        """Tell whether enough can be driven while the piece is held in a posture."""
        return self._at(hold_rad)[1]

    def while_at(self, hold_rad: Joints) -> tuple[OperationId, ...]:
        """Return what can be driven while the piece is held in a posture."""
        return self._at(hold_rad)[0]

    def _at(self, hold_rad: Joints) -> tuple[tuple[OperationId, ...], bool]:
        about = self._tacking
        arm = about.context.cell.robot_by_id[about.robot].description
        shape = without_turns(arm, hold_rad)
        if shape not in self._known:
            holding = Holding(
                robot=about.robot, piece=about.piece, grasp=self._grasp, hold_rad=hold_rad
            )
            tacks = drivable_while_held(about.context, holding, about.gripper, about.ways)
            self._known[shape] = (tacks, about.note(tacks))
        return self._known[shape]


def drivable_while_held(
    context: TwinContext,
    holding: Holding,
    gripper: EndEffector,
    ways: DrivingWays | None = None,
) -> tuple[OperationId, ...]:
    """Return the fasteners that some other robot can drive while this one holds the piece.

    Those that must be driven while it is held come first; then as many as have to be. One of
    them that cannot be driven ends the search: this way of holding will not do.

    Args:
        context: Engines, site and task.
        holding: Who holds which piece, and how.
        gripper: What it is held with.
        ways: Of the same context and piece; asked again for each way of holding.
    """
    count = tacks_needed(context.task)
    if not count:
        return ()
    site = held_site(context, holding, gripper)
    ways = ways or DrivingWays(context, holding.piece)
    found: list[OperationId] = []
    for spot in _most_wanted_first(context.task):
        if len(found) >= count:
            break
        drivers = (r for r in _drivers(context, spot) if r.id != holding.robot)
        if any(ways.can_drive(site, r, spot) for r in drivers):
            found.append(spot.operation)
        elif spot.needs_hold:
            break
    return tuple(found)


def held_site(context: TwinContext, holding: Holding, gripper: EndEffector) -> Jobsite:
    """Return the whole site while a robot steadies the piece at its target."""
    task, site = context.task, context.site
    arm = replace(
        site.arms[holding.robot],
        q_rad=holding.hold_rad,
        held=holding.piece,
        tip_T_held=holding.grasp.tip_T_piece(gripper),
        aperture_m=holding.grasp.width_m,
    )
    return replace(
        site,
        arms={**site.arms, holding.robot: arm},
        world_T_piece={**site.world_T_piece, holding.piece: task.world_T_target},
        steadied={**site.steadied, holding.piece: holding.robot},
    )


def _drivers(context: TwinContext, spot: Spot) -> list[Robot]:
    robots = context.cell.robot_by_id.values()
    return [r for r in robots if tool_for(context.site, r, spot) is not None]
