"""What holds what in the simulated cell: tools on flanges, grips, nails, paint."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from sitewright.foundation.ids import ComponentId, EndEffectorId, OperationId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.driver import FastenerObservation


@dataclass(frozen=True, slots=True, kw_only=True)
class Grip:
    """A piece that is held: the result of a grasp that was measured.

    Attributes:
        tool_T_piece: Pose of the piece in the gripper's mount frame when it was gripped.
        since_s: Clock of the cell when it was gripped.
        number: Counts all grips from 1.
        taken_at_m: Where the piece was then, in the world; logs of older cells do not tell.
    """

    piece: ComponentId
    tool_T_piece: Pose
    since_s: float
    number: int
    taken_at_m: tuple[float, float, float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Connection:
    """Two bodies joined by fasteners, at the pose they had when the first one was driven."""

    through: ComponentId
    into: str
    through_T_into: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class Fixings:
    """Everything that changes which body is fixed to which; a value.

    Attributes:
        mounted: End effector on each flange.
        world_T_docked: Mount pose of each end effector that is on no robot.
        grips: Held piece by robot.
        fasteners: Every nail and screw that sits in wood.
        coverage: Covered share of each painted patch.
        shots: Fasteners that were shot so far, missed ones too.
        grip_count: Grips so far.
        faults_done: Faults on demand that have happened; they happen once.
    """

    mounted: Mapping[RobotId, EndEffectorId]
    world_T_docked: Mapping[EndEffectorId, Pose]
    grips: Mapping[RobotId, Grip] = field(default_factory=dict)
    connections: tuple[Connection, ...] = ()
    fasteners: tuple[FastenerObservation, ...] = ()
    coverage: Mapping[OperationId, float] = field(default_factory=dict)
    shots: int = 0
    grip_count: int = 0
    faults_done: tuple[str, ...] = ()

    def gripped(self, robot: RobotId, grip: Grip) -> Fixings:
        """Return them with a piece held by a robot."""
        return replace(self, grips={**self.grips, robot: grip}, grip_count=grip.number)

    def let_go(self, robot: RobotId) -> Fixings:
        """Return them without a robot's grip; none held is no error."""
        return replace(self, grips={r: g for r, g in self.grips.items() if r != robot})

    def fastened(self, fastener: FastenerObservation, through_T_into: Pose) -> Fixings:
        """Return them with one more fastener; the first of a pair joins the two."""
        joined = any(
            (c.through, c.into) == (fastener.through, fastener.into) for c in self.connections
        )
        new = Connection(
            through=fastener.through, into=fastener.into, through_T_into=through_T_into
        )
        return replace(
            self,
            fasteners=(*self.fasteners, fastener),
            connections=self.connections if joined else (*self.connections, new),
        )

    def painted(self, operation: OperationId, share: float) -> Fixings:
        """Return them with the covered share of a patch; paint never leaves."""
        best = max(share, self.coverage.get(operation, 0.0))
        return replace(self, coverage={**self.coverage, operation: best})

    def docked(self, robot: RobotId, world_T_mount: Pose) -> Fixings:
        """Return them with a robot's end effector left where it stands."""
        tool = self.mounted[robot]
        return replace(
            self,
            mounted={r: t for r, t in self.mounted.items() if r != robot},
            world_T_docked={**self.world_T_docked, tool: world_T_mount},
        )

    def taken(self, robot: RobotId, tool: EndEffectorId) -> Fixings:
        """Return them with a docked end effector locked onto a robot's flange."""
        return replace(
            self,
            mounted={**self.mounted, robot: tool},
            world_T_docked={t: p for t, p in self.world_T_docked.items() if t != tool},
        )

    def fault_done(self, fault: str) -> Fixings:
        """Return them with a fault on demand noted."""
        return replace(self, faults_done=(*self.faults_done, fault))


def first_fixings(cell: Cell) -> Fixings:
    """Return the start state of a cell: tools mounted or in their docks."""
    mounted = {r.id: r.mounted for r in cell.robot_by_id.values() if r.mounted is not None}
    docked = {
        tool.id: cell.station_by_id[tool.station].world_T_station @ tool.station_T_mount
        for tool in cell.end_effector_by_id.values()
        if tool.station is not None and tool.id not in mounted.values()
    }
    return Fixings(mounted=mounted, world_T_docked=docked)
