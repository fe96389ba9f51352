"""Ports of the planning twin, and the values that pass through them. No numpy here."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Protocol

from sitewright.foundation.canonical import canonical_json, sha256_hex
from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.refusal import BlockedBy, Disagreement, NoIk, NoPath, NotClear
from sitewright.planning_twin.scene import Attachment, Pair, SceneSnapshot
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.trajectory import Trajectory


@dataclass(frozen=True, slots=True, kw_only=True)
class PathSegment:
    """A polyline in joint space under one set of thresholds.

    Attributes:
        waypoints_rad: At least two; straight joint-space lines between them.
        threshold_m: Distance that a *declared* pair must keep in this segment: -0.001 for a
            declared contact, +0.001 for a declared neighbour. All other pairs keep the
            scene's clearance. No pair is ever switched off in the proof.
    """

    waypoints_rad: tuple[Joints, ...]
    threshold_m: Mapping[Pair, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class JointPath:
    """One robot's path; each segment starts where the one before ends."""

    robot: RobotId
    segments: tuple[PathSegment, ...]

    @property
    def start_rad(self) -> Joints:
        """First waypoint."""
        return self.segments[0].waypoints_rad[0]

    @property
    def end_rad(self) -> Joints:
        """Last waypoint."""
        return self.segments[-1].waypoints_rad[-1]

    def sha256(self) -> str:
        """Hash of robot, waypoints and thresholds."""
        return _path_hash(self.robot, self.segments)

    @property
    def robots(self) -> tuple[RobotId, ...]:
        """Who moves."""
        return (self.robot,)


def _path_hash(who: str | tuple[str, ...], segments: tuple[PathSegment, ...]) -> str:
    rows = [
        (s.waypoints_rad, sorted((a, b, tau) for (a, b), tau in s.threshold_m.items()))
        for s in segments
    ]
    return sha256_hex(canonical_json([who, rows]))


@dataclass(frozen=True, slots=True, kw_only=True)
class TeamPath:
    """The path of several robots that move in step.

    Attributes:
        robots: Who moves.
        segments: Their waypoints hold the joints of `robots`, one robot after the other.
    """

    robots: tuple[RobotId, ...]
    segments: tuple[PathSegment, ...]

    def sha256(self) -> str:
        """Hash of robots, waypoints and thresholds."""
        return _path_hash(self.robots, self.segments)


@dataclass(frozen=True, slots=True, kw_only=True)
class MotionRequest:
    """Free motion from the scene's posture of a robot, or of several, to a goal posture.

    Attributes:
        threshold_m: As in `PathSegment`: declared contacts that persist in this motion.
        max_nodes: Search budget; nodes, not seconds, so that results repeat.
        pad_m: Every body grows by this in the search scene; None = clearance / 2 + 0.5 mm.
        step_rad: Distance between collision checks along an edge.
        or_goals_rad: Other goals that would do as well.
        partners: Robots that move in step with `robot`; goals then hold the joints of all, one
            robot after the other.
    """

    robot: RobotId
    goal_rad: Joints
    threshold_m: Mapping[Pair, float] = field(default_factory=dict)
    max_nodes: int = 500
    pad_m: float | None = None
    step_rad: float = 0.02
    is_shortcut: bool = True
    or_goals_rad: tuple[Joints, ...] = ()
    partners: tuple[RobotId, ...] = ()

    @property
    def robots(self) -> tuple[RobotId, ...]:
        """Who moves, in the order in which postures hold their joints."""
        return (self.robot, *self.partners)

    @property
    def goals_rad(self) -> tuple[Joints, ...]:
        """All goals, the most welcome first."""
        return (self.goal_rad, *self.or_goals_rad)

    def path(self, segment: PathSegment) -> JointPath | TeamPath:
        """Return a segment as the path of those who move."""
        if self.partners:
            return TeamPath(robots=self.robots, segments=(segment,))
        return JointPath(robot=self.robot, segments=(segment,))


@dataclass(frozen=True, slots=True, kw_only=True)
class JointLimits:
    """Speed and acceleration limits of one robot, and the jerk that follows from them."""

    velocity_rad_s: Joints
    acceleration_rad_s2: Joints
    jerk_rad_s3: Joints


@dataclass(frozen=True, slots=True, kw_only=True)
class TimedPath:
    """A path with its trajectory.

    Attributes:
        segment_ends_s: Time at which each of the path's segments ends.
    """

    path: JointPath
    trajectory: Trajectory
    segment_ends_s: tuple[float, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Certificate:
    """Proof, continuous between samples, that a path keeps its thresholds in a scene.

    Attributes:
        scene_revision: Scene that it was made against.
        path_sha256: Path that it is about.
        closest_distance_m: A distance that no pair goes below on the path, over the pairs that it
            moves and that are not declared in the segment at hand; parts of one arm with a single
            joint between them are proven but left out here. A proven lower bound, as a rule at
            most 3 % (and 1 mm) under the true smallest distance; infinite without such pairs.
        closest_pair: The pair of it.
        closest_at: Segment number and share of the segment, 0..1.
        eps_m: Numerical reserve of the distance engine.
        pairs: How many pairs were proven.
        evaluations: How many distances it took.
        engine: Names and versions of the libraries.
    """

    scene_revision: str
    path_sha256: str
    clearance_m: float
    closest_distance_m: float
    closest_pair: Pair | None
    closest_at: tuple[int, float]
    eps_m: float
    pairs: int
    evaluations: int
    engine: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Agreement:
    """The independent engine found no violation either."""

    samples: int
    closest_distance_m: float
    engine: str


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedMotion:
    """One certified trajectory of a step.

    Attributes:
        scene_edits: What changes in the scene after this motion and before the next one of the
            same step (a tool docked, a tool taken).
    """

    timed: TimedPath
    certificate: Certificate
    agreement: Agreement
    scene_edits: Mapping[BodyId, Pose | Attachment] = field(default_factory=dict)


class InverseKind(StrEnum):
    """How the inverse kinematics of an arm are solved."""

    CLOSED_FORM = "closed form"
    CLOSED_FORM_ON_RAILS = "closed form at sampled positions of its rails"
    ITERATIONS = "iterations"


@dataclass(frozen=True, slots=True, kw_only=True)
class ArmVerdict:
    """How an arm was judged when it was loaded.

    Attributes:
        joints: How many joints move, rails included.
        rails: How many joints slide before the first one that turns.
        fk_error: Largest difference between the closed form and the URDF's own forward
            kinematics that was seen; 0 if there was none to compare.
        reason: Why there is no closed form; empty if there is.
    """

    kind: InverseKind
    joints: int
    rails: int = 0
    fk_error: float = 0.0
    reason: str = ""


class ForwardKinematics(Protocol):
    """Where the tip is."""

    def tip(self, description: Description, q_rad: Joints) -> Pose:
        """Return base_T_tip of a posture."""
        ...


class Kinematics(ForwardKinematics, Protocol):
    """Forward and inverse kinematics of one description."""

    def verdict(self, description: Description) -> ArmVerdict:
        """Return how the arm's inverse kinematics are solved, and why so."""
        ...

    def solve(
        self, description: Description, base_T_tip: Pose, near_rad: Joints
    ) -> tuple[Joints, ...] | NoIk:
        """Return all solutions inside the limits, wraps included, the nearest first.

        Of an arm with more joints than a pose needs: those that were found.
        """
        ...

    def has_all(self, description: Description, base_T_tip: Pose) -> bool:
        """Tell whether `solve` gives every posture for a pose, whole turns aside.

        Not on rails, not by iterations, and not where joints can share a turn freely.
        """
        ...

    def follow(self, description: Description, base_T_tip: Pose, near_rad: Joints) -> Joints | NoIk:
        """Return the solution for a pose a short way on; rails stay where `near_rad` has them."""
        ...


class CollisionCheck(Protocol):
    """Which pairs of a posture are too near."""

    def is_clear(
        self,
        scene: SceneSnapshot,
        robot: RobotId,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
        *,
        is_padded: bool = False,
    ) -> bool:
        """Tell whether there are no `violations`; far quicker than to name them."""
        ...

    def violations(
        self,
        scene: SceneSnapshot,
        robot: RobotId,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
        *,
        is_padded: bool = False,
    ) -> tuple[Pair, ...]:
        """Return the pairs of `robot` (with what it carries) under their thresholds at `q_rad`.

        Args:
            scene: All bodies and the other robots' postures.
            robot: The robot that is put at `q_rad`.
            q_rad: Posture to look at.
            threshold_m: Declared pairs; all others must keep the scene's clearance.
            is_padded: Ask as the padded search scene does: undeclared pairs keep
                clearance + 1 mm, declared contacts (threshold < 0) are off.
        """
        ...


class MotionPlanner(Protocol):
    """Finds free paths; a pure function of its arguments."""

    def plan(
        self, scene: SceneSnapshot, request: MotionRequest, *, seed: int
    ) -> tuple[Joints, ...] | BlockedBy | NoPath:
        """Return waypoints from the robot's posture in `scene` to the goal, or why not."""
        ...


class Certifier(Protocol):
    """Proves paths clear by conservative advancement."""

    def certify(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> Certificate | NotClear:
        """Prove every segment of `path` in `scene`, whose other robots stand still."""
        ...

    def objection(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> NotClear | None:
        """Return what the proof would object to; quicker than a certificate, and none."""
        ...


class Timer(Protocol):
    """Times a path without leaving it."""

    def time(self, path: JointPath, limits: JointLimits) -> TimedPath:
        """Return a jerk-limited trajectory, at rest at every waypoint."""
        ...


class CrossCheck(Protocol):
    """Second opinion of an independent engine on the timed trajectory."""

    def check(self, scene: SceneSnapshot, timed: TimedPath) -> Agreement | Disagreement:
        """Sample the trajectory every 0.005 rad and 10 ms and compare distances with thresholds."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanningBackends:
    """The engines behind the ports, as one value to pass around."""

    kinematics: Kinematics
    collision: CollisionCheck
    planner: MotionPlanner
    certifier: Certifier
    timer: Timer
    cross_check: CrossCheck
