"""The driver port: commands go out, what was sensed comes back.

Parameters by skill (`SkillCommand.params`; ids are those of physical pieces, i.e. of the
material component, also after installation; poses are ``{"p_m": [..], "q_wxyz": [..]}``):

any skill             ``contacts``: pairs of names that may touch; any other contact is reported.
reach, retract        ``aperture_m``: the empty gripper opens to it first (optional); one
                      trajectory, or none where the robot leaves a place without contact.
grasp                 ``piece``, ``width_m`` expected aperture, ``tolerance_m``.
position              ``piece``, ``world_T_piece`` wanted, ``tolerance_m``, ``tolerance_rad``,
                      ``rests_on``: pieces or fixtures that it must touch. Nothing moves; the
                      piece is sensed at its place while the robot keeps steadying it.
set-down              ``piece``, ``world_T_piece``, tolerances, ``aperture_m`` to open to.
release               ``piece``, ``aperture_m`` to open to.
fasten                ``operation``, ``through`` piece, ``into`` piece or fixture,
                      ``fastener`` {type, d_m, l_m}, ``penetration_m`` required in ``into``.
apply-finish          ``operation``, ``piece``, ``world_T_patch``, ``size_m``, ``standoff_m``,
                      ``width_m``, ``coverage`` required share; one trajectory, sprayed all along.
change-end-effector   ``old``, ``new`` (null = bare flange), ``station``; three trajectories:
                      to the old one's dock, from there to the new one's dock, and away. With a
                      null `old` or `new` the first or the second to last is missing.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Protocol

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import (
    CommandId,
    ComponentId,
    EndEffectorId,
    OperationId,
    RobotId,
    StationId,
)
from sitewright.foundation.pose import Pose
from sitewright.robot_team.description import Joints
from sitewright.robot_team.skill import SkillCommand


class CommandState(StrEnum):
    """What a driver's ledger knows of a command."""

    NEVER = "never"
    """Not in the ledger: it never started and never will with an older epoch."""
    RUNNING = "running"
    """It is being executed right now; its outcome will come, so ask again."""
    ACCEPTED = "accepted"
    """Started by a driver that died since; its end is not recorded and never will be."""
    ENDED = "ended"


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillReport:
    """How a command ended, as sensed.

    Attributes:
        is_done: The physical effect was sensed.
        reason: Empty if done, else a word: ``grasp-failed``, ``missed``, ``dropped``,
            ``position-failed``, ``coverage-short``, ``dock-failed``, ``tracking``, ``held``.
        evidence: What was measured.
        duration_s: Time that it took on the cell's clock.
    """

    is_done: bool
    reason: str = ""
    evidence: Mapping[str, Json] = field(default_factory=dict)
    duration_s: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class CommandStatus:
    """Answer of the ledger."""

    state: CommandState
    report: SkillReport | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotObservation:
    """One robot as sensed.

    Attributes:
        mounted: End effector on the flange, by the changer's own sensor.
        aperture_m: Opening of the gripper; 0 without one.
        gripped: Piece between both pads, by contact; None if there is none.
    """

    q_rad: Joints
    velocity_rad_s: Joints
    mounted: EndEffectorId | None
    aperture_m: float = 0.0
    gripped: ComponentId | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class FastenerObservation:
    """A fastener that sits in the wood."""

    operation: OperationId
    through: ComponentId
    into: str
    penetration_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Observation:
    """The cell as sensed, all at one time.

    Attributes:
        time_s: Clock of the cell.
        world_T_piece: Pose of every piece that is seen.
        docked: Station of every end effector that is on no robot.
        coverage: Share of each painted patch that is covered.
    """

    time_s: float
    robots: Mapping[RobotId, RobotObservation]
    world_T_piece: Mapping[ComponentId, Pose]
    fasteners: tuple[FastenerObservation, ...] = ()
    coverage: Mapping[OperationId, float] = field(default_factory=dict)
    docked: Mapping[EndEffectorId, StationId] = field(default_factory=dict)


class CellDriver(Protocol):
    """All robots of a cell behind one connection.

    A call raises `sitewright.errors.BackendError` when the cell cannot be reached.
    """

    def new_epoch(self) -> int:
        """Raise the epoch, so that late commands of an older controller are refused."""
        ...

    def observe(self) -> Observation:
        """Return what is sensed now."""
        ...

    def status(self, command_id: CommandId) -> CommandStatus:
        """Ask the ledger about a command."""
        ...

    def execute(self, command: SkillCommand) -> SkillReport:
        """Run a command to its end; a known id returns its outcome and moves nothing."""
        ...

    def hold(self) -> None:
        """Stop all motion on the path."""
        ...

    def close(self) -> None:
        """Let the connection go; the cell lives on."""
        ...
