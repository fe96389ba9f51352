"""Read a URDF into a `Description`; all faults of the file are reported together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np

from sitewright.foundation.pose import norm, unit
from sitewright.robot_team.description import Description, Joint, JointKind, Link
from sitewright.robot_team.formats.urdf_shapes import read_shape
from sitewright.robot_team.formats.urdf_tree import (
    check_tree,
    find_root,
    find_tip,
    joints_outwards,
)
from sitewright.robot_team.formats.urdf_xml import Findings, parse_robot

_INERTIA = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_TRIANGLE_SLACK = 1.001


def read_urdf(
    path: Path | str,
    *,
    root: str | None = None,
    tip: str | None = None,
    payload_kg: float | None = None,
) -> Description:
    """Return the robot or end effector of a URDF file.

    Args:
        path: The file; meshes are found relative to it (``package://`` upwards from it).
        root: Root link; by default the link that is nobody's child.
        tip: Tip frame; by default ``tool0``, ``tcp`` or the only link without children.
        payload_kg: What it may carry; by default that of ``<sitewright payload_kg="..."/>``.

    A file with faults is a CellRejectedError that lists all of them.
    """
    file = Path(path).resolve()
    robot = parse_robot(file)
    findings = Findings(str(path))
    links = {
        element.get("name", ""): _read_link(element, file.parent, findings)
        for element in _named(robot, "link", findings)
    }
    joints = [_read_joint(element, findings) for element in _named(robot, "joint", findings)]
    payload = _payload_kg(robot, findings) if payload_kg is None else payload_kg
    root = find_root(links, joints, root, findings)
    check_tree(links, joints, findings)
    findings.raise_if_any()
    ordered = joints_outwards(root, joints)
    kept = {root, *(j.child for j in ordered)}
    tip = find_tip(kept, ordered, tip, findings)
    findings.raise_if_any()
    return Description(
        name=robot.get("name", file.stem),
        links=tuple(link for name, link in links.items() if name in kept),
        joints=ordered,
        root=root,
        tip=tip,
        payload_kg=payload,
        urdf=str(file),
    )


def _named(robot: ET.Element, tag: str, findings: Findings) -> list[ET.Element]:
    """Return the elements of a kind; note those without a name and names used twice."""
    found = robot.findall(tag)
    for name, count in Counter(e.get("name", "") for e in found).items():
        if not name:
            findings.add("R3", f"<{tag}>", f"{count} {tag}(s) have no name.", "Name them.")
        elif count > 1:
            message = f"{count} {tag}s have this name."
            findings.add("R3", f"{tag} {name}", message, "Give each its own name.")
    if tag == "link" and not found:
        findings.add("R3", "<robot>", "It has no links.", "Run xacro first, if it is a macro file.")
    return found


def _read_link(element: ET.Element, folder: Path, findings: Findings) -> Link:
    name = element.get("name", "")
    shape = read_shape(element, folder, findings)
    inertial, where = element.find("inertial"), f"link {name}"
    if inertial is None:
        return Link(name=name, shape=shape)
    link_T_inertia = findings.origin(inertial, where)
    mass = inertial.find("mass")
    mass_kg = 0.0 if mass is None else findings.number(mass, "value", where)
    if mass_kg < 0.0:
        findings.add("R6", where, f"Its mass is {mass_kg} kg.", "Give a mass of 0 or more.")
    tensor = inertial.find("inertia")
    if tensor is None or mass_kg <= 0.0:
        return Link(name=name, shape=shape, mass_kg=mass_kg, com_m=link_T_inertia.position_m)
    values = [findings.number(tensor, key, where, 0.0) for key in _INERTIA]
    if not _is_physical(values):
        fix = "Make the matrix positive definite; no axis may exceed the sum of the other two."
        findings.add("R6", where, "No body can have its inertia.", fix)
    axes = (link_T_inertia.x_axis, link_T_inertia.y_axis, link_T_inertia.z_axis)
    turn = np.array(axes).T
    turned = turn @ _matrix(values) @ turn.T
    return Link(
        name=name,
        shape=shape,
        mass_kg=mass_kg,
        com_m=link_T_inertia.position_m,
        inertia_kg_m2=tuple(float(turned[i, k]) for i in range(3) for k in range(i, 3)),
    )


def _matrix(values: Sequence[float]) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    xx, xy, xz, yy, yz, zz = values
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], dtype=np.float64)


def _is_physical(values: Sequence[float]) -> bool:
    small, middle, large = np.linalg.eigvalsh(_matrix(values))
    return bool(small > 0.0 and large <= _TRIANGLE_SLACK * (small + middle))


def _read_joint(element: ET.Element, findings: Findings) -> Joint:
    name = element.get("name", "")
    where, kind = f"joint {name}", _kind(element, f"joint {name}", findings)
    parent, child = (_link_of(element, end, where, findings) for end in ("parent", "child"))
    origin = findings.origin(element, where)
    if kind is JointKind.FIXED:
        return Joint(name=name, kind=kind, parent=parent, child=child, parent_T_joint=origin)
    lower, upper, velocity = _limits(element, where, findings)
    axis_element = element.find("axis")
    axis = (1.0, 0.0, 0.0)
    if axis_element is not None:
        axis = findings.vector(axis_element, "xyz", where, default=axis)
    if norm(axis) == 0.0:
        findings.add("R4", where, "Its axis is zero.", "Give the direction of its axis.")
        axis = (1.0, 0.0, 0.0)
    return Joint(
        name=name,
        kind=kind,
        parent=parent,
        child=child,
        parent_T_joint=origin,
        axis=unit(axis),
        lower_rad=lower,
        upper_rad=upper,
        velocity_rad_s=velocity,
    )


def _kind(element: ET.Element, where: str, findings: Findings) -> JointKind:
    kind = element.get("type", "")
    if element.find("mimic") is not None:
        fix = "Remove <mimic>; a gripper's fingers are opened together anyway."
        findings.add("R4", where, "It follows another joint, which is not supported.", fix)
    for known in JointKind:
        if kind == known:
            return known
    fix = "Use revolute, prismatic or fixed."
    if kind == "continuous":
        fix = "Make it revolute with the limits that its cables allow."
    findings.add("R4", where, f"Joint type {kind!r} is not supported.", fix)
    return JointKind.FIXED


def _link_of(element: ET.Element, end: str, where: str, findings: Findings) -> str:
    found = element.find(end)
    name = "" if found is None else found.get("link", "")
    if not name:
        findings.add("R3", where, f"It names no {end} link.", f'Add <{end} link="..."/>.')
    return name


def _limits(element: ET.Element, where: str, findings: Findings) -> tuple[float, float, float]:
    limit = element.find("limit")
    if limit is None:
        fix = 'Add <limit lower="..." upper="..." velocity="..."/>.'
        findings.add("R4", where, "It moves but has no limits.", fix)
        return 0.0, 0.0, 0.0
    lower, upper = (findings.number(limit, end, where, 0.0) for end in ("lower", "upper"))
    velocity = findings.number(limit, "velocity", where)
    if not lower < upper:
        fix = "Give a lower limit below the upper one."
        findings.add("R4", where, f"It cannot move between {lower} and {upper}.", fix)
    if velocity <= 0.0:
        findings.add("R4", where, "Its speed limit is not positive.", "Give rad/s or m/s.")
    return lower, upper, velocity


def _payload_kg(robot: ET.Element, findings: Findings) -> float:
    extension = robot.find("sitewright")
    if extension is None:
        return 0.0
    payload_kg = findings.number(extension, "payload_kg", "<sitewright>", 0.0)
    if payload_kg < 0.0:
        findings.add("R2", "<sitewright>", "payload_kg is negative.", "Give kilograms.")
    return payload_kg
