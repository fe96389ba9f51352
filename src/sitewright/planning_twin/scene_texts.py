"""Scenes as texts named by their hash, so that a proof can be made again from them alone."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Box, ConvexPart, Hull, Shape
from sitewright.planning_twin.scene import (
    Attachment,
    Body,
    RobotInScene,
    SceneSnapshot,
    arm_text,
    scene_text,
    shape_text,
)
from sitewright.robot_team.description import Description, Joint, JointKind, Link

TextOf = Callable[[str], str]
"""Returns the text with a SHA-256."""


class UnreadableSceneError(ValueError):
    """A text has the right hash but is no scene."""


def texts_of(scene: SceneSnapshot) -> dict[str, str]:
    """Return all texts of a scene by their SHA-256: shapes, arms, and last the scene's own.

    The last one's hash is the scene's revision; it names the others by their hashes.
    """
    arms = [robot.description for robot in scene.robots.values()]
    shapes = [
        *(link.shape for arm in arms for link in arm.links),
        *(body.shape for body in scene.bodies.values()),
    ]
    texts = [*map(shape_text, dict.fromkeys(shapes)), *map(arm_text, arms), scene_text(scene)]
    return {sha256_hex(text): text for text in texts}


def read_scene(revision: str, text_of: TextOf) -> SceneSnapshot:
    """Return the scene with a revision from its texts.

    Masses, speeds and files of the arms are no part of a scene's revision, so they are absent.

    Args:
        revision: Hash of the scene's own text.
        text_of: Finds the texts.

    Raises:
        UnreadableSceneError: A text is no scene, arm or shape.
    """
    try:
        return _scene(json.loads(text_of(revision)), _Reader(text_of))
    except UnreadableSceneError:
        raise
    except (ValueError, KeyError, TypeError, IndexError) as error:
        raise UnreadableSceneError(f"{revision[:12]} is no scene: {error}") from error


class _Reader:
    """Reads shapes and arms once each."""

    def __init__(self, text_of: TextOf) -> None:
        self._text_of = text_of
        self._shapes: dict[str, Shape] = {}
        self._arms: dict[str, Description] = {}

    def shape(self, digest: str) -> Shape:
        """Return the shape with a hash."""
        if digest not in self._shapes:
            self._shapes[digest] = tuple(map(_part, json.loads(self._text_of(digest))))
        return self._shapes[digest]

    def arm(self, digest: str) -> Description:
        """Return the arm with a hash."""
        if digest not in self._arms:
            root, tip, links, joints, limits = json.loads(self._text_of(digest))
            self._arms[digest] = Description(
                name=digest[:12],
                links=tuple(Link(name=name, shape=self.shape(shape)) for name, shape in links),
                joints=tuple(map(_joint, joints, limits)),
                root=root,
                tip=tip,
            )
        return self._arms[digest]


def _scene(plain: dict[str, Any], reader: _Reader) -> SceneSnapshot:
    robots = {
        RobotId(robot): RobotInScene(
            description=reader.arm(arm), world_T_base=_pose(base), q_rad=tuple(q_rad)
        )
        for robot, (arm, base, q_rad) in plain["robots"].items()
    }
    bodies = {
        BodyId(body): Body(id=BodyId(body), shape=reader.shape(shape), placement=_placement(where))
        for body, (shape, where) in plain["bodies"].items()
    }
    return SceneSnapshot(robots=robots, bodies=bodies, clearance_m=float(plain["clearance_m"]))


def _placement(plain: list[Any]) -> Pose | Attachment:
    if isinstance(plain[0], str):
        return Attachment(RobotId(plain[0]), _pose(plain[1:]))
    return _pose(plain)


def _pose(numbers: list[float]) -> Pose:
    px, py, pz, w, x, y, z = numbers
    return Pose((px, py, pz), (w, x, y, z))


def _part(plain: list[Any]) -> ConvexPart:
    kind, *rest = plain
    if kind == "box":
        (x, y, z), pose = rest
        return Box((x, y, z), _pose(pose))
    (points,) = rest
    return Hull(tuple((x, y, z) for x, y, z in points))


def _joint(plain: list[Any], limits: list[float]) -> Joint:
    name, kind, parent, child, pose, (x, y, z) = plain
    lower_rad, upper_rad = limits
    return Joint(
        name=name,
        kind=JointKind(kind),
        parent=parent,
        child=child,
        parent_T_joint=_pose(pose),
        axis=(x, y, z),
        lower_rad=lower_rad,
        upper_rad=upper_rad,
    )
