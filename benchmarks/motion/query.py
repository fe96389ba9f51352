"""A query of the hard set: a scene, who moves, where to; and its text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, cast

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose, Quaternion, Vector
from sitewright.foundation.shapes import Box, Shape
from sitewright.planning_twin.motion import JointPath, MotionRequest, PathSegment, TeamPath
from sitewright.planning_twin.scene import Attachment, Body, RobotInScene, SceneSnapshot
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.formats.urdf import read_urdf
from sitewright.robot_team.gripper import finger_parts, palm_shape, shape_at
from sitewright.robot_team.models.catalogue import builtin_end_effector, builtin_robot

_DIGITS = 6
Kind = tuple[float, float, float] | str
"""Edges of a box, or a part of a tool: ``palm``, ``left 0.09``, ``right 0.09`` or ``nailer``."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MotionQuery:
    """One question to a planner.

    Attributes:
        name: Family and number.
        scene: Robots stand where the motion starts.
        kinds: What each body is; the scene's shapes follow from it.
        robots: Who moves; several move in step.
        goal_rad: The joints of those who move, one robot after the other.
    """

    name: str
    family: str
    scene: SceneSnapshot
    kinds: Mapping[BodyId, Kind]
    robots: tuple[RobotId, ...]
    goal_rad: Joints

    @property
    def start_rad(self) -> Joints:
        """The joints of those who move at the start."""
        return tuple(q for r in self.robots for q in self.scene.robots[r].q_rad)

    def request(self) -> MotionRequest:
        """Return the query as our planner is asked."""
        first, *others = self.robots
        return MotionRequest(robot=first, goal_rad=self.goal_rad, partners=tuple(others))

    def path(self, waypoints: tuple[Joints, ...]) -> JointPath | TeamPath:
        """Return waypoints as the path of those who move."""
        return self.request().path(PathSegment(waypoints_rad=waypoints))


@lru_cache(maxsize=1)
def arm() -> Description:
    """Return the arm of every query."""
    return read_urdf(builtin_robot("kuka-kr120-r2500-pro"))


@lru_cache(maxsize=2)
def tool(name: str) -> Description:
    """Return a built-in end effector."""
    return read_urdf(builtin_end_effector(name))


@lru_cache(maxsize=1024)
def shape_of(kind: Kind) -> Shape:
    """Return the shape of a kind of body."""
    if not isinstance(kind, str):
        return (Box(kind),)
    part, *aperture = kind.split()
    if part == "nailer":
        return shape_at(tool("builtin:nail-gun"), 0.0)
    if part == "palm":
        return palm_shape(tool("builtin:parallel-gripper"))
    return finger_parts(tool("builtin:parallel-gripper"), float(aperture[0]))[part]


def to_plain(query: MotionQuery) -> dict[str, Any]:
    """Return a query as plain JSON, rounded to micrometres and microradians."""
    robots = {
        r: {"base": _pose_numbers(s.world_T_base), "q": _rounded(s.q_rad)}
        for r, s in query.scene.robots.items()
    }
    bodies = {b: [query.kinds[b], *_placement(body)] for b, body in query.scene.bodies.items()}
    return {
        "name": query.name,
        "family": query.family,
        "clearance_m": query.scene.clearance_m,
        "moves": list(query.robots),
        "goal": _rounded(query.goal_rad),
        "robots": robots,
        "bodies": bodies,
    }


def from_plain(plain: Mapping[str, Any]) -> MotionQuery:
    """Return the query that `to_plain` wrote."""
    kinds: dict[BodyId, Kind] = {
        BodyId(name): kind if isinstance(kind, str) else cast("Kind", tuple(kind))
        for name, (kind, *_) in plain["bodies"].items()
    }
    bodies = {
        i: Body(id=i, shape=shape_of(kind), placement=_read_placement(*plain["bodies"][i][1:]))
        for i, kind in kinds.items()
    }
    robots = {
        RobotId(r): RobotInScene(
            description=arm(), world_T_base=_read_pose(s["base"]), q_rad=tuple(s["q"])
        )
        for r, s in plain["robots"].items()
    }
    return MotionQuery(
        name=plain["name"],
        family=plain["family"],
        scene=SceneSnapshot(robots=robots, bodies=bodies, clearance_m=plain["clearance_m"]),
        kinds=kinds,
        robots=tuple(RobotId(r) for r in plain["moves"]),
        goal_rad=tuple(plain["goal"]),
    )


def rounded(waypoints: tuple[Joints, ...]) -> tuple[Joints, ...]:
    """Return waypoints as they are stored."""
    return tuple(tuple(_rounded(q)) for q in waypoints)


def _placement(body: Body) -> list[Any]:
    placement = body.placement
    if isinstance(placement, Attachment):
        return [_pose_numbers(placement.tip_T_body), placement.robot]
    return [_pose_numbers(placement)]


def _read_placement(numbers: list[float], carrier: str | None = None) -> Pose | Attachment:
    pose = _read_pose(numbers)
    return pose if carrier is None else Attachment(RobotId(carrier), pose)


def _pose_numbers(pose: Pose) -> list[float]:
    quaternion = [round(v, 12) for v in pose.quaternion_wxyz]
    return [*_rounded(pose.position_m), *quaternion]


def _read_pose(numbers: list[float]) -> Pose:
    return Pose(cast("Vector", tuple(numbers[:3])), cast("Quaternion", tuple(numbers[3:])))


def _rounded(values: tuple[float, ...]) -> list[float]:
    return [round(float(v), _DIGITS) + 0.0 for v in values]
