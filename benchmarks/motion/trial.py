"""A query while it is made: a cell that grows around a motion, with the motion's proof."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
from benchmarks.motion.query import Kind, MotionQuery, arm, from_plain, rounded, shape_of, to_plain

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.planning_twin.backends.twin import make_backends
from sitewright.planning_twin.motion import PathSegment, PlanningBackends, TeamPath
from sitewright.planning_twin.refusal import NotClear
from sitewright.planning_twin.scene import Attachment, Body, RobotInScene, SceneSnapshot
from sitewright.robot_team.description import Joints

A, B = RobotId("a"), RobotId("b")
HOME: Joints = tuple(math.radians(v) for v in (0.0, -110.0, 110.0, 0.0, 80.0, 0.0))
TABLE_TOP_M = 0.40
CLEARANCE_M = 0.010
_SLACK_M = (0.0015, 0.006)
"""A slot is so much wider than the clearance on each side."""
_HALVINGS = 12


class NotNarrowError(Exception):
    """A trial that came to nothing: the motion is blocked, or what should be narrow is not."""


@lru_cache(maxsize=1)
def shared_backends() -> PlanningBackends:
    """Return the engines, which are made once."""
    return make_backends()


@dataclass
class Trial:
    """A scene, who moves in it, and the witness that everything is built around.

    Attributes:
        slack_m: The witness keeps the clearance and so much more.
    """

    rng: np.random.Generator
    slack_m: float
    scene: SceneSnapshot
    kinds: dict[BodyId, Kind]
    robots: tuple[RobotId, ...] = (A,)
    witness: tuple[Joints, ...] = ()
    backends: PlanningBackends = field(default_factory=shared_backends)

    def put(self, name: str, kind: Kind, placement: Pose | Attachment) -> None:
        """Add a body, or put it elsewhere."""
        self.scene = self.scene.with_body(_body(name, kind, placement))
        self.kinds[BodyId(name)] = kind

    def is_clear(self, scene: SceneSnapshot, waypoints: tuple[Joints, ...]) -> bool:
        """Tell whether waypoints hold a proof with the slack on top of the clearance."""
        wide = replace(scene, clearance_m=CLEARANCE_M + self.slack_m)
        return self._objection(wide, waypoints) is None

    def move_by(self, waypoints: tuple[Joints, ...]) -> None:
        """Let the witness be these waypoints, which must be clear."""
        if not self.is_clear(self.scene, waypoints):
            raise NotNarrowError("the motion is blocked")
        self.witness = waypoints

    def pinch(self, scene_at: Callable[[float], SceneSnapshot]) -> float:
        """Bring something as near to the witness as its slack allows; return how near.

        Args:
            scene_at: The scene for a share: 0 is far off, 1 far too near.
        """
        far, near = 0.0, 1.0
        if not self.is_clear(scene_at(far), self.witness):
            raise NotNarrowError("blocked from the beginning")
        if self.is_clear(scene_at(near), self.witness):
            raise NotNarrowError("never in the way")
        for _ in range(_HALVINGS):
            middle = (far + near) / 2.0
            if self.is_clear(scene_at(middle), self.witness):
                far = middle
            else:
                near = middle
        self.scene = scene_at(far)
        return far

    def pinch_body(self, name: str, kind: Kind, far: Pose, near: Pose) -> None:
        """Bring a body along a straight line as near to the witness as its slack allows."""
        self.put(name, kind, far)
        way = np.subtract(near.position_m, far.position_m)

        def scene_at(share: float) -> SceneSnapshot:
            x, y, z = np.array(far.position_m) + share * way
            pose = Pose((float(x), float(y), float(z)), far.quaternion_wxyz)
            return self.scene.with_body(_body(name, kind, pose))

        self.pinch(scene_at)

    def query(self, family: str, number: int) -> tuple[MotionQuery, tuple[Joints, ...]]:
        """Return the query and its witness as they are stored; both are looked at once more."""
        scene = self.scene
        first = 0
        for robot in self.robots:
            count = len(scene.robots[robot].q_rad)
            scene = scene.with_joints(robot, self.witness[0][first : first + count])
            first += count
        made = MotionQuery(
            name=f"{family}-{number:02}",
            family=family,
            scene=scene,
            kinds=self.kinds,
            robots=self.robots,
            goal_rad=self.witness[-1],
        )
        query, witness = from_plain(to_plain(made)), rounded(self.witness)
        if self.backends.certifier.objection(query.scene, query.path(witness)) is not None:
            raise NotNarrowError("the witness does not hold once it is rounded")
        ends = (witness[0], witness[-1])
        if self.backends.certifier.objection(query.scene, query.path(ends)) is None:
            raise NotNarrowError("a single line would do")
        return query, witness

    def _objection(self, scene: SceneSnapshot, waypoints: tuple[Joints, ...]) -> NotClear | None:
        path = TeamPath(robots=self.robots, segments=(PathSegment(waypoints_rad=waypoints),))
        return self.backends.certifier.objection(scene, path)


def _body(name: str, kind: Kind, placement: Pose | Attachment) -> Body:
    return Body(id=BodyId(name), shape=shape_of(kind), placement=placement)


def two_arms(rng: np.random.Generator) -> Trial:
    """Return a trial in a cell of two arms that face each other, 3.1 to 3.3 m apart."""
    half_m = float(rng.uniform(1.55, 1.65))
    turn = rotation((0.0, 0.0, 1.0), math.pi)
    robots = {
        A: RobotInScene(description=arm(), world_T_base=translation(-half_m, 0.0, 0.0), q_rad=HOME),
        B: RobotInScene(
            description=arm(), world_T_base=translation(half_m, 0.0, 0.0) @ turn, q_rad=HOME
        ),
    }
    trial = Trial(
        rng=rng,
        slack_m=float(rng.uniform(*_SLACK_M)),
        scene=SceneSnapshot(robots=robots, bodies={}, clearance_m=CLEARANCE_M),
        kinds={},
    )
    table = (1.6, 2.6, TABLE_TOP_M)
    trial.put("table", table, translation(0.0, 0.0, TABLE_TOP_M / 2.0))
    return trial


def give_gripper(trial: Trial, robot: RobotId, held: tuple[float, float, float]) -> None:
    """Put a gripper on a robot's flange, closed on a piece whose length lies along the tip's x.

    Args:
        trial: Gets the bodies.
        robot: Who holds.
        held: Length, width between the fingers, height of the piece.
    """
    for part in ("palm", f"left {held[1]}", f"right {held[1]}"):
        trial.put(f"{robot}-{part.split()[0]}", part, Attachment(robot, Pose()))
    trial.put(f"{robot}-held", held, Attachment(robot, translation(0.0, 0.0, 0.26 - held[2] / 2.0)))


def give_nailer(trial: Trial, robot: RobotId) -> None:
    """Put a nail gun on a robot's flange."""
    trial.put(f"{robot}-nailer", "nailer", Attachment(robot, Pose()))
