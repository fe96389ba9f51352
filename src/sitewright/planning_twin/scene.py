"""The jobsite as the planning twin sees it: robots, bodies, and who carries what."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

from sitewright.foundation.canonical import Json, canonical_json, sha256_hex
from sitewright.foundation.ids import BodyId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Box, ConvexPart, Hull, Shape
from sitewright.robot_team.description import Description, Joints

Pair = tuple[str, str]
"""Two colliding things by name, sorted: a body id, or ``robot/link`` for a robot's own link."""


def pair_of(a: str, b: str) -> Pair:
    """Return the two names in the order in which every table keeps them."""
    return (a, b) if a <= b else (b, a)


def link_name(robot: RobotId, link: str) -> str:
    """Return the name of a robot's link in pairs."""
    return f"{robot}/{link}"


@dataclass(frozen=True, slots=True)
class Attachment:
    """A body that moves with a robot's tip link (tool0)."""

    robot: RobotId
    tip_T_body: Pose


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """A rigid body: component, fixture, zone, end effector or one of its fingers.

    Attributes:
        shape: Convex pieces in the body frame.
        placement: Where it stands in the world, or which robot carries it.
    """

    id: BodyId
    shape: Shape
    placement: Pose | Attachment


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotInScene:
    """An arm with its posture."""

    description: Description
    world_T_base: Pose
    q_rad: Joints


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneSnapshot:
    """An immutable, picklable picture of the whole cell at one moment.

    Two bodies that stand still never collide with each other here, and bodies carried by the
    same robot are rigid to one another and to its tip link; all other pairs count.

    Attributes:
        clearance_m: Distance kept by every pair that no segment declares as a contact.
    """

    robots: Mapping[RobotId, RobotInScene]
    bodies: Mapping[BodyId, Body]
    clearance_m: float = 0.010

    def with_joints(self, robot: RobotId, q_rad: Joints) -> SceneSnapshot:
        """Return the scene with one robot in another posture."""
        changed = replace(self.robots[robot], q_rad=q_rad)
        return replace(self, robots={**self.robots, robot: changed})

    def with_body(self, body: Body) -> SceneSnapshot:
        """Return the scene with a body added, or replaced if its id is there."""
        return replace(self, bodies={**self.bodies, body.id: body})

    def without(self, *bodies: BodyId) -> SceneSnapshot:
        """Return the scene without some bodies; unknown ids are no error."""
        return replace(self, bodies={i: b for i, b in self.bodies.items() if i not in bodies})

    def placed(self, body: BodyId, placement: Pose | Attachment) -> SceneSnapshot:
        """Return the scene with a body moved, attached or set down."""
        return self.with_body(replace(self.bodies[body], placement=placement))

    def revision(self) -> str:
        """SHA-256 over shapes, placements, joints and clearance."""
        return sha256_hex(scene_text(self))


def owner_of(scene: SceneSnapshot, name: str) -> RobotId | None:
    """Return the robot that a link belongs to or that carries a body."""
    body = scene.bodies.get(BodyId(name))
    if body is not None:
        return body.placement.robot if isinstance(body.placement, Attachment) else None
    robot = RobotId(name.split("/", maxsplit=1)[0])
    return robot if robot in scene.robots else None


def scene_text(scene: SceneSnapshot) -> str:
    """Return the text whose hash is the scene's revision; it names shapes and arms by hash."""
    robots: dict[str, Json] = {
        robot: [
            _description_hash(arm.description),
            _numbers(arm.world_T_base),
            _same_text(arm.q_rad),
        ]
        for robot, arm in scene.robots.items()
    }
    bodies: dict[str, Json] = {
        i: [shape_hash(b.shape), _placement(b.placement)] for i, b in scene.bodies.items()
    }
    return canonical_json({"robots": robots, "bodies": bodies, "clearance_m": scene.clearance_m})


def _placement(placement: Pose | Attachment) -> Json:
    match placement:
        case Attachment(robot=robot, tip_T_body=pose):
            return [robot, *_numbers(pose)]
        case _:
            return _numbers(placement)


def _numbers(pose: Pose) -> list[float]:
    return _same_text((*pose.position_m, *pose.quaternion_wxyz))


def _same_text(numbers: Iterable[float]) -> list[float]:
    """Return numbers so that equal ones are written alike: 1 as 1.0, -0.0 as 0.0."""
    return [float(n) + 0.0 for n in numbers]


@lru_cache(maxsize=1024)
def shape_hash(shape: Shape) -> str:
    """Return the SHA-256 of a shape; equal shapes have equal hashes."""
    return sha256_hex(shape_text(shape))


def shape_text(shape: Shape) -> str:
    """Return the text whose hash is the shape's."""
    return canonical_json([_plain_part(part) for part in shape])


def _plain_part(part: ConvexPart) -> Json:
    match part:
        case Box(size_m=size, body_T_box=pose):
            return ["box", _same_text(size), _numbers(pose)]
        case Hull(points_m=points):
            return ["hull", [_same_text(p) for p in points]]


@lru_cache(maxsize=64)
def _description_hash(description: Description) -> str:
    return sha256_hex(arm_text(description))


def arm_text(description: Description) -> str:
    """Return the text of all that a scene's revision says about an arm; shapes are hashes."""
    links: list[Json] = [[link.name, shape_hash(link.shape)] for link in description.links]
    joints: list[Json] = [
        [j.name, j.kind, j.parent, j.child, _numbers(j.parent_T_joint), _same_text(j.axis)]
        for j in description.joints
    ]
    limits: list[Json] = [_same_text((j.lower_rad, j.upper_rad)) for j in description.joints]
    return canonical_json([description.root, description.tip, links, joints, limits])
