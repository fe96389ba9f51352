"""What the reach check is asked: all targets of a model, and when each body stands in the cell."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.foundation.ids import BodyId, ComponentId, EndEffectorId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.jobsite import PieceShape
from sitewright.planning_twin.task import Task
from sitewright.robot_team.cell import Cell

FOREVER = 1_000_000_000


@dataclass(frozen=True, slots=True, kw_only=True)
class TimedBody:
    """A body that stands in the cell for a part of the time.

    Time is counted in targets: number n is while the n-th target is placed.

    Attributes:
        appears: First number at which it stands there.
        vanishes: First number at which it is gone.
        docked: The end effector that it is a part of: there only while nobody uses that.
    """

    id: BodyId
    shape: Shape
    world_T_body: Pose
    appears: int = 0
    vanishes: int = FOREVER
    docked: EndEffectorId | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ReachTarget:
    """One target with all that the check needs to know of it.

    Attributes:
        number: Its place in construction order.
        shape: Of the component, and of the piece that becomes it.
        task: As a plan of this target would have it, on the site as it stands at its time;
            bodies that were built before have the names of their targets.
        world_T_piece: Where its candidates lie.
        waits_for: Targets that must be built before.
        place: Stock place at which its first candidate lies; empty if there is none.
    """

    number: int
    shape: PieceShape
    task: Task
    world_T_piece: Mapping[ComponentId, Pose] = field(default_factory=dict)
    waits_for: tuple[ComponentId, ...] = ()
    place: str = ""

    @property
    def id(self) -> ComponentId:
        """The target."""
        return self.task.target


@dataclass(frozen=True, slots=True, kw_only=True)
class ReachQuestion:
    """A whole model in its cell.

    Attributes:
        bodies: Everything that stands still; robots and what they carry are not among them.
        targets: In construction order.
    """

    cell: Cell
    bodies: tuple[TimedBody, ...]
    targets: tuple[ReachTarget, ...]
