"""The straight last part of a motion: from a pre-pose to contact, and its way back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.blockers import blocked_by
from sitewright.planning_twin.jobsite import lifted
from sitewright.planning_twin.motion import PathSegment, PlanningBackends
from sitewright.planning_twin.refusal import BlockedBy, NoIk
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.planning_twin.straight import straight_line
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.kinematics import without_turns

NEAR_M = 0.030
"""Declared contacts may be touched only on the last (first) stretch of this length."""
PRE_M = 0.120
"""The pre-pose stands this far off the contact pose."""
CONTACT_M = -0.001
"""Threshold of a declared contact: sensed poses may overlap by this much."""
NEIGHBOUR_M = 0.001
"""Threshold of a declared neighbour: near, but never touching."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Touch:
    """A tip pose in contact, and how the robot comes to it.

    Attributes:
        world_T_tip: Pose of the robot's tip (tool0) in contact.
        back_off: World direction, from contact to pre-pose.
        near_m: Thresholds on the last stretch: declared contacts and neighbours.
        free_m: Thresholds on the rest: contacts that do not move, if any.
        distance_m: From contact to pre-pose.
        near_length_m: Length of the last stretch; longer where a piece slides between others.
        label: Freedoms chosen, for people: ``tilt 2.5 deg to +x``.
    """

    world_T_tip: Pose
    back_off: Vector
    near_m: Mapping[Pair, float] = field(default_factory=dict)
    free_m: Mapping[Pair, float] = field(default_factory=dict)
    distance_m: float = PRE_M
    near_length_m: float = NEAR_M
    label: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Approach:
    """Joint-space lines from the pre-pose to the contact posture.

    Attributes:
        segments: From the pre-pose inwards: free stretch, near stretch.
    """

    touch: Touch
    segments: tuple[PathSegment, ...]

    @property
    def pre_rad(self) -> Joints:
        """Posture at the pre-pose."""
        return self.segments[0].waypoints_rad[0]

    @property
    def contact_rad(self) -> Joints:
        """Posture in contact."""
        return self.segments[-1].waypoints_rad[-1]

    def outwards(self) -> tuple[PathSegment, ...]:
        """Return the same lines from contact to pre-pose."""
        return tuple(
            PathSegment(waypoints_rad=s.waypoints_rad[::-1], threshold_m=s.threshold_m)
            for s in reversed(self.segments)
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Reaching:
    """Who reaches, in which scene, and with what."""

    backends: PlanningBackends
    scene: SceneSnapshot
    robot: RobotId

    @property
    def description(self) -> Description:
        """The arm that reaches."""
        return self.scene.robots[self.robot].description

    def solve(self, world_T_tip: Pose, near_rad: Joints) -> tuple[Joints, ...] | NoIk:
        """Return all postures for a tip pose, the nearest first."""
        arm = self.scene.robots[self.robot]
        base_T_tip = arm.world_T_base.inverse() @ world_T_tip
        return self.backends.kinematics.solve(arm.description, base_T_tip, near_rad)

    def violations(
        self, q_rad: Joints, threshold_m: Mapping[Pair, float], *, is_padded: bool = False
    ) -> tuple[Pair, ...]:
        """Return the pairs that are too near at a posture."""
        return self.backends.collision.violations(
            self.scene, self.robot, q_rad, threshold_m, is_padded=is_padded
        )

    def is_clear(
        self, q_rad: Joints, threshold_m: Mapping[Pair, float], *, is_padded: bool = False
    ) -> bool:
        """Tell whether nothing is too near at a posture; quicker than to name what is."""
        return self.backends.collision.is_clear(
            self.scene, self.robot, q_rad, threshold_m, is_padded=is_padded
        )

    def line(self, start: Pose, end: Pose, near_rad: Joints) -> tuple[Joints, ...] | NoIk:
        """Return a straight tip line as joint waypoints, from `start` at `near_rad`."""
        return straight_line(
            self.backends.kinematics, self.scene.robots[self.robot], start, end, near_rad
        )


@dataclass(frozen=True, slots=True)
class _Blocked:
    """A posture in which something is too near; what it is, is looked at only when asked for."""

    q_rad: Joints
    threshold_m: Mapping[Pair, float]
    is_padded: bool

    def pairs(self, reaching: Reaching) -> tuple[Pair, ...]:
        """Return what is too near."""
        return reaching.violations(self.q_rad, self.threshold_m, is_padded=self.is_padded)


@dataclass(slots=True)
class Approaches:
    """The clear approaches to a touch, looked for one at a time, the nearest posture first.

    Attributes:
        reaching: Robot, scene and backends.
        touch: The contact pose with its freedoms fixed.
        near_rad: Posture that the motion comes from.
        found: How many were found so far.
    """

    reaching: Reaching
    touch: Touch
    near_rad: Joints
    found: int = 0
    _blocked: dict[Joints, _Blocked] = field(default_factory=dict)
    _blocked_contacts: list[Joints] = field(default_factory=list)
    _lost: NoIk | None = None

    def __iter__(self) -> Iterator[Approach]:
        """Yield the approaches whose ends are clear; their lines are not proven yet."""
        postures = self.reaching.solve(self.touch.world_T_tip, self.near_rad)
        if isinstance(postures, NoIk):
            self._lost = postures
            return
        for contact_rad in postures:
            approach = self._approach(contact_rad)
            if approach is not None:
                self.found += 1
                yield approach

    def why_none_serves(self, wanted_rad: Joints | None) -> NoIk | BlockedBy:
        """Return why none of those that were found serves what follows.

        Args:
            wanted_rad: The only posture in contact that would; None if it is not known.
        """
        shape = wanted_rad and without_turns(self.reaching.description, wanted_rad)
        blocked = self._blocked.get(shape) if shape else None
        if blocked is not None and (pairs := blocked.pairs(self.reaching)):
            return blocked_by(self.reaching.scene, self.reaching.robot, [(blocked.q_rad, pairs)])
        return NoIk(is_proven=False, reason=Sentence("no posture serves what follows"))

    def why_not(self) -> NoIk | BlockedBy:
        """Return why there is none, once all were looked for.

        What is in the way is told for both ends of each approach, so that an approach is there
        once any of the `removals` is gone.
        """
        both = [self._pairs_at_both_ends(contact) for contact in self._blocked_contacts]
        if found := [(q_rad, pairs) for q_rad, pairs in both if pairs]:
            return blocked_by(self.reaching.scene, self.reaching.robot, found)
        named = [(b.q_rad, b.pairs(self.reaching)) for b in self._blocked.values()]
        if found := [(q_rad, pairs) for q_rad, pairs in named if pairs]:
            return blocked_by(self.reaching.scene, self.reaching.robot, found)
        return self._lost or NoIk(
            is_proven=False, reason=Sentence("no branch of the inverse kinematics holds")
        )

    def _pairs_at_both_ends(self, contact_rad: Joints) -> tuple[Joints, tuple[Pair, ...]]:
        """Return what is too near in contact or before it, and the end where the first pair is.

        Nothing if no line joins the two.
        """
        approach = straight_approach(self.reaching, self.touch, contact_rad)
        if isinstance(approach, NoIk):
            return contact_rad, ()
        at_contact = self.reaching.violations(contact_rad, self.touch.near_m)
        before = self.reaching.violations(approach.pre_rad, self.touch.free_m, is_padded=True)
        q_rad = contact_rad if at_contact else approach.pre_rad
        return q_rad, tuple(dict.fromkeys((*at_contact, *before)))

    def _approach(self, contact_rad: Joints) -> Approach | None:
        shape = without_turns(self.reaching.description, contact_rad)
        if shape in self._blocked:
            return None
        if self._is_blocked(shape, contact_rad, self.touch.near_m):
            self._blocked_contacts.append(contact_rad)
            return None
        approach = straight_approach(self.reaching, self.touch, contact_rad)
        if isinstance(approach, NoIk):
            self._lost = approach
            return None
        if self._is_blocked(shape, approach.pre_rad, self.touch.free_m, is_padded=True):
            self._blocked_contacts.append(contact_rad)
            return None
        return approach

    def _is_blocked(
        self,
        shape: Joints,
        q_rad: Joints,
        threshold_m: Mapping[Pair, float],
        *,
        is_padded: bool = False,
    ) -> bool:
        if self.reaching.is_clear(q_rad, threshold_m, is_padded=is_padded):
            return False
        self._blocked[shape] = _Blocked(q_rad, threshold_m, is_padded)
        return True


def different(reaching: Reaching, postures: Iterable[Joints]) -> Iterator[Joints]:
    """Yield the postures that differ in more than whole turns of their joints."""
    shapes: set[Joints] = set()
    for q_rad in postures:
        shape = without_turns(reaching.description, q_rad)
        if shape not in shapes:
            shapes.add(shape)
            yield q_rad


def straight_approach(reaching: Reaching, touch: Touch, contact_rad: Joints) -> Approach | NoIk:
    """Return the line from the pre-pose into one contact posture; collisions are not looked at."""
    near_length_m = min(touch.near_length_m, touch.distance_m)
    near_pose = lifted(touch.world_T_tip, touch.back_off, near_length_m)
    near = reaching.line(touch.world_T_tip, near_pose, contact_rad)
    if isinstance(near, NoIk):
        return near
    segments = [PathSegment(waypoints_rad=near[::-1], threshold_m=dict(touch.near_m))]
    if touch.distance_m > near_length_m:
        pre_pose = lifted(touch.world_T_tip, touch.back_off, touch.distance_m)
        free = reaching.line(near_pose, pre_pose, near[-1])
        if isinstance(free, NoIk):
            return free
        segments.insert(0, PathSegment(waypoints_rad=free[::-1], threshold_m=dict(touch.free_m)))
    return Approach(touch=touch, segments=tuple(segments))
