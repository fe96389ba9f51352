"""What the reach check found: who can do what, in which way, and why not."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from sitewright.foundation.ids import ComponentId, EndEffectorId, OperationId, RobotId
from sitewright.foundation.pose import Vector
from sitewright.planning_twin.reachability.question import ReachQuestion
from sitewright.planning_twin.refusal import Refusal
from sitewright.planning_twin.scene import Pair


@dataclass(frozen=True, slots=True, kw_only=True)
class GraspWay:
    """A kind of grasp that serves at the stock and at the target.

    Attributes:
        face: Face of the piece that the gripper comes from, in the component frame: ``+z``.
        pitch_deg: Lean about the axis along which the fingers close.
        is_turned: The gripper is turned by 180 degrees about its own axis.
        offset_m: Of the cheapest such grasp, along the component from its middle.
        insertion: Number of the task's way in.
    """

    face: str
    pitch_deg: float
    is_turned: bool
    offset_m: float
    insertion: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Refused:
    """Why something cannot be done, and at which end.

    Attributes:
        where: ``stock`` or ``target``, or ``both`` if it is about the piece.
    """

    where: str
    refusal: Refusal


@dataclass(frozen=True, slots=True, kw_only=True)
class Handling:
    """One robot, one end effector and one target: picking a piece and placing it.

    Attributes:
        piece: The candidate that it is about; None if the stock has none.
        ways: Kinds of grasps that serve both ends, the cheapest first.
        refused: Why there are no ways; None if there are some.
        never_at_target: It is proven that no grasp at all brings the piece to the target.
        never_at_stock: It is proven that no grasp takes any of the candidates.
    """

    robot: RobotId
    end_effector: EndEffectorId
    target: ComponentId
    piece: ComponentId | None
    ways: tuple[GraspWay, ...] = ()
    refused: Refused | None = None
    never_at_target: bool = False
    never_at_stock: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Operating:
    """One robot, one end effector and one operation of a placed target.

    Attributes:
        ways: Leans of the tool that serve, of the smallest tilt that has any.
        refused: Why there are none.
    """

    robot: RobotId
    end_effector: EndEffectorId
    target: ComponentId
    operation: OperationId
    ways: tuple[str, ...] = ()
    refused: Refused | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Steadying:
    """Which operations can be done while a robot holds the piece that needs it.

    Attributes:
        needed: So many fasteners must be driven before it is let go.
        robot: Who holds it in the best way that was looked at; None if nobody can place it.
        done: Operations that another robot reaches meanwhile.
        ways: How many ways to hold were looked at.
    """

    target: ComponentId
    needed: int
    robot: RobotId | None
    done: tuple[OperationId, ...] = ()
    ways: int = 0
    is_enough: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class ReachSphere:
    """Where the wrist of an arm can be at most.

    Attributes:
        centres_m: World points of the shoulder; more than one if rails carry it.
    """

    robot: RobotId
    centres_m: tuple[Vector, ...]
    radius_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class BlockedHome:
    """A robot whose home, or every parking posture, is too near to what stands there, ever."""

    robot: RobotId
    pairs: tuple[Pair, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class ReachAnswer:
    """Everything that was found, in construction order."""

    handlings: tuple[Handling, ...] = ()
    operatings: tuple[Operating, ...] = ()
    steadyings: tuple[Steadying, ...] = ()
    spheres: tuple[ReachSphere, ...] = ()
    homes: tuple[BlockedHome, ...] = ()


class ReachCheck(Protocol):
    """Looks at all ends of all motions of a model; no paths are searched."""

    def answer(self, question: ReachQuestion, *, is_brief: bool = False) -> ReachAnswer:
        """Return who can do what in which way.

        Args:
            question: The model in its cell.
            is_brief: Only look for the first way of each thing, and for the first robot that can
                do it; what cannot be done is looked at as thoroughly as ever.
        """
        ...
