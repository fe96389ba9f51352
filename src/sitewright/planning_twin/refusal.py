"""Refusals: a planner's "no" as a value, with its reason and who is in the way."""

from __future__ import annotations

from dataclasses import dataclass, field

from sitewright.foundation.ids import OperationId, RobotId
from sitewright.planning_twin.moment import Moment
from sitewright.planning_twin.scene import Pair
from sitewright.robot_team.description import Joints


@dataclass(frozen=True, slots=True, kw_only=True)
class NoIk:
    """No joint position puts the tip there.

    Attributes:
        is_proven: Out of reach for certain; False if a search budget ended.
        extension_m: How far outside the reachable shell, if known (0 = inside).
        tried: Freedoms that were tried (tilts, grasps ...).
    """

    is_proven: bool
    extension_m: float = 0.0
    tried: int = 1
    reason: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class BlockedBy:
    """Every joint position for the pose collides.

    Attributes:
        pairs: Those of the joint position that the fewest things are in the way of.
        removals: Smallest sets of bodies and robots whose removal frees a joint position.
        moment: Where the first of the pairs was seen.
    """

    pairs: tuple[Pair, ...]
    removals: tuple[tuple[str, ...], ...] = ()
    reason: str = ""
    moment: Moment | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class NoPath:
    """The search budget ended without a path; never a proof."""

    nodes: int
    seeds: tuple[int, ...]
    is_reproducible: bool = True
    reason: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class NotClear:
    """A path exists but could not be certified: this pair comes nearer than it may."""

    pair: Pair
    q_rad: Joints
    distance_m: float
    threshold_m: float
    segment: int
    moment: Moment | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Disagreement:
    """The independent engine saw a violation where the certificate saw none."""

    pair: Pair
    q_rad: Joints
    distance_m: float
    threshold_m: float
    moment: Moment | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class HeldFreedoms:
    """Over what it is proven that a piece cannot be fastened while it is held.

    Attributes:
        grasps: So many grasps, in every posture of the arm.
        ways: So many ways to hold the piece are left: grasps times postures in which the arm
            meets neither itself nor what stands there for good.
        tool_poses: So many poses of tools for each fastener at most: leans and quarter turns.
        robots: Who might drive them.
        blocked: Fasteners that could be driven if nobody held the piece, each with who is too
            near to whom in the cheapest way to hold that it is blocked in.
    """

    grasps: int
    ways: int
    tool_poses: int
    robots: tuple[RobotId, ...]
    blocked: tuple[tuple[OperationId, BlockedBy], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class NoGrasp:
    """No grasp serves pick, carry, place and steadying.

    Attributes:
        dropped_by: How many candidates each of the lists dropped.
        removals: Smallest sets of bodies and robots without which a grasp might serve.
        nearest: What kept the cheapest grasp that something is in the way of, if one was looked at.
        freedoms: What a proof by collisions went through; None if it is no such proof.
    """

    is_proven: bool
    candidates: int
    dropped_by: tuple[tuple[str, int], ...] = ()
    removals: tuple[tuple[str, ...], ...] = ()
    reason: str = ""
    nearest: BlockedBy | None = field(default=None, compare=False)
    freedoms: HeldFreedoms | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class PayloadExceeded:
    """Too heavy, for every grasp."""

    mass_kg: float
    payload_kg: float
    moment_nm: float = 0.0
    moment_limit_nm: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class WorkerFailed:
    """The planning process died or ran out of memory."""

    task: str
    exit_status: int


@dataclass(frozen=True, slots=True, kw_only=True)
class StaleCertificate:
    """At execution: the same trajectory is not clear on the scene as sensed."""

    cause: NotClear


Refusal = (
    NoIk | BlockedBy | NoPath | NotClear | Disagreement | NoGrasp | PayloadExceeded | WorkerFailed
)


def pair_of(refusal: Refusal) -> tuple[str, ...]:
    """Return two bodies that come too near to each other, if that is what a refusal is about."""
    match refusal:
        case BlockedBy(pairs=(first, *_)):
            return first
        case NotClear(pair=pair) | Disagreement(pair=pair):
            return pair
        case NoGrasp(nearest=BlockedBy() as nearest):
            return pair_of(nearest)
        case _:
            return ()


def seen_at(refusal: Refusal) -> Moment | None:
    """Return the moment in which the pair of `pair_of` is too near, if it is known."""
    match refusal:
        case BlockedBy(moment=moment) | NotClear(moment=moment) | Disagreement(moment=moment):
            return moment
        case NoGrasp(nearest=BlockedBy(moment=moment)):
            return moment
        case _:
            return None
