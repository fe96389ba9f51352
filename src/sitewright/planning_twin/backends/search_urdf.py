"""The search scene's robots, with what they carry, as one URDF of padded convex parts."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.shapes import Box, Hull, Shape
from sitewright.planning_twin.backends.padding import padded, surface
from sitewright.planning_twin.scene import Attachment, SceneSnapshot, link_name
from sitewright.robot_team.description import Joint, JointKind

WORLD = "world"
_MESHES_REMEMBERED = 1024


@dataclass(frozen=True, slots=True, kw_only=True)
class SearchRobots:
    """The URDF and the names in it.

    Attributes:
        link_by_name: Name in the URDF of every link and every body in it that can collide.
        joints_of: Names of each robot's joints in the order of its postures.
    """

    xml: str
    link_by_name: Mapping[str, str]
    joints_of: Mapping[RobotId, tuple[str, ...]]


class SearchUrdf:
    """Writes one URDF; meshes go to a folder that must live until it is loaded."""

    def __init__(self, folder: Path, pad_m: float) -> None:
        self._folder, self._pad_m = folder, pad_m
        self._root = ET.Element("robot", name="cell")
        self._meshes = 0
        self._link_by_name: dict[str, str] = {}
        ET.SubElement(self._root, "link", name=WORLD)

    def write(self, scene: SceneSnapshot, still: Iterable[str]) -> SearchRobots:
        """Return the URDF of all robots, of what they carry, and of some bodies that stand."""
        joints_of = {robot: self._add_robot(scene, robot) for robot in scene.robots}
        for body in (scene.bodies[i] for i in scene.bodies):
            placement = body.placement
            if isinstance(placement, Attachment):
                tip = scene.robots[placement.robot].description.tip
                self._add_body(
                    body.id, body.shape, f"{placement.robot}.{tip}", placement.tip_T_body
                )
            elif body.id in still:
                self._add_body(body.id, body.shape, WORLD, placement)
        return SearchRobots(
            xml=ET.tostring(self._root, encoding="unicode"),
            link_by_name=self._link_by_name,
            joints_of=joints_of,
        )

    def _add_robot(self, scene: SceneSnapshot, robot: RobotId) -> tuple[str, ...]:
        state = scene.robots[robot]
        description = state.description
        for link in description.links:
            self._add_link(f"{robot}.{link.name}", link.shape)
            if link.shape:
                self._link_by_name[link_name(robot, link.name)] = f"{robot}.{link.name}"
        self._add_fixed(WORLD, f"{robot}.{description.root}", state.world_T_base)
        for joint in description.joints:
            self._add_joint(robot, joint)
        return tuple(f"{robot}.{j.name}" for j in description.movable_joints)

    def _add_body(self, name: str, shape: Shape, parent: str, parent_T_body: Pose) -> None:
        link = f"body.{name}"
        self._add_link(link, shape)
        self._add_fixed(parent, link, parent_T_body)
        self._link_by_name[name] = link

    def _add_link(self, name: str, shape: Shape) -> None:
        link = ET.SubElement(self._root, "link", name=name)
        checking = ET.SubElement(link, "collision_checking")
        for number, part in enumerate(shape):
            grown = padded(part, self._pad_m)
            collision = ET.SubElement(link, "collision", name=f"{name}.{number}")
            geometry = ET.SubElement(collision, "geometry")
            match grown:
                case Box(size_m=size_m, body_T_box=body_T_box):
                    collision.append(_origin(body_T_box))
                    ET.SubElement(geometry, "box", size=_text(size_m))
                case Hull(points_m=points_m):
                    mesh = self._write_mesh(points_m)
                    ET.SubElement(geometry, "mesh", filename=str(mesh))
                    ET.SubElement(checking, "convex", name=f"{name}.{number}")

    def _add_fixed(self, parent: str, child: str, parent_T_child: Pose) -> None:
        joint = ET.SubElement(self._root, "joint", name=f"to.{child}", type="fixed")
        joint.append(_origin(parent_T_child))
        ET.SubElement(joint, "parent", link=parent)
        ET.SubElement(joint, "child", link=child)

    def _add_joint(self, robot: RobotId, joint: Joint) -> None:
        element = ET.SubElement(
            self._root, "joint", name=f"{robot}.{joint.name}", type=joint.kind.value
        )
        element.append(_origin(joint.parent_T_joint))
        ET.SubElement(element, "parent", link=f"{robot}.{joint.parent}")
        ET.SubElement(element, "child", link=f"{robot}.{joint.child}")
        if joint.kind is not JointKind.FIXED:
            ET.SubElement(element, "axis", xyz=_text(joint.axis))
            limits = {
                "lower": repr(joint.lower_rad),
                "upper": repr(joint.upper_rad),
                "velocity": repr(joint.velocity_rad_s or 1.0),
                "effort": "1",
            }
            ET.SubElement(element, "limit", limits)

    def _write_mesh(self, points_m: tuple[Vector, ...]) -> Path:
        path = self._folder / f"part{self._meshes}.obj"
        self._meshes += 1
        path.write_text(_mesh_text(points_m))
        return path


@lru_cache(maxsize=_MESHES_REMEMBERED)
def _mesh_text(points_m: tuple[Vector, ...]) -> str:
    """Return the hull's surface; roboplan takes its triangles as the neighbourhood of corners."""
    corners, triangles = surface(np.array(points_m, dtype=np.float64))
    rows = [
        *(f"v {_text(c)}" for c in corners.tolist()),
        *(f"f {a} {b} {c}" for a, b, c in (triangles + 1).tolist()),
    ]
    return "\n".join([*rows, ""])


def _origin(pose: Pose) -> ET.Element:
    return ET.Element("origin", xyz=_text(pose.position_m), rpy=_text(_roll_pitch_yaw(pose)))


def _text(numbers: Iterable[float]) -> str:
    return " ".join(repr(float(n)) for n in numbers)


def _roll_pitch_yaw(pose: Pose) -> tuple[float, float, float]:
    (r00, r01, _, _), (r10, r11, _, _), (r20, r21, r22, _), _ = pose.matrix()
    level = math.hypot(r00, r10)
    pitch = math.atan2(-r20, level)
    if level < 1e-12:  # noqa: PLR2004 - straight up or down: yaw and roll are one turn
        return 0.0, pitch, math.atan2(-r01, r11)
    return math.atan2(r21, r22), pitch, math.atan2(r10, r00)
