"""Writes a simulation as MuJoCo's XML (MJCF)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.mjcf.model import Axis, Freedom, Inertial, MjcfModel, Servo, Solid, Weld
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Box, ConvexPart, Hull

_CONTACT = {"solref": "0.005 1", "solimp": "0.95 0.99 0.0005", "condim": "4"}
"""Stiff contacts: a 15 kg stud sinks in by less than 0.1 mm."""
_WELD = {"solref": "0.005 1", "solimp": "0.99 0.999 0.0001"}


def mjcf_text(model: MjcfModel) -> str:
    """Return the model as MJCF; the same model gives the same text."""
    root = Element("mujoco", model=model.name)
    SubElement(root, "compiler", angle="radian", autolimits="true", inertiafromgeom="auto")
    option = SubElement(
        root,
        "option",
        timestep=_number(model.step_s),
        integrator="implicitfast",
        cone="elliptic",
        impratio="10",
    )
    SubElement(option, "flag", sleep="enable")
    SubElement(SubElement(root, "default"), "geom", _CONTACT)
    assets = _Assets(SubElement(root, "asset"))
    world = SubElement(root, "worldbody")
    for solid in model.solids:
        _add_solid(world, solid, assets)
    _add_all(root, "contact", (_exclude(*pair) for pair in model.excluded))
    equalities = [*map(_weld, model.welds), *(_coupling(*pair) for pair in model.coupled)]
    _add_all(root, "equality", equalities)
    _add_all(root, "actuator", (_servo(s) for s in model.servos))
    indent(root)
    return tostring(root, encoding="unicode")


@dataclass(slots=True)
class _Assets:
    """Hulls of the model, each written once however often it is used."""

    element: Element
    names: set[str] = field(default_factory=set)

    def hull(self, part: Hull) -> str:
        text = _numbers(x for point in part.points_m for x in point)
        name = f"hull-{sha256_hex(text)[:16]}"
        if name not in self.names:
            self.names.add(name)
            SubElement(self.element, "mesh", name=name, vertex=text, inertia="convex")
        return name


def _add_solid(parent: Element, solid: Solid, assets: _Assets) -> None:
    body = SubElement(parent, "body", {"name": solid.name, **_pose(solid.parent_T_body)})
    if solid.is_weightless:
        body.set("gravcomp", "1")
    if solid.axis is not None:
        body.append(_joint(solid.axis))
    if solid.inertial is not None:
        body.append(_inertial(solid.inertial))
    for part in solid.shape:
        body.append(_geom(part, solid, assets))
    for child in solid.children:
        _add_solid(body, child, assets)


def _joint(axis: Axis) -> Element:
    if axis.freedom is Freedom.FREE:
        return Element("freejoint", name=axis.name)
    joint = Element("joint", name=axis.name, type=axis.freedom.value, axis=_numbers(axis.direction))
    if axis.limits is not None:
        joint.set("range", _numbers(axis.limits))
    return joint


def _inertial(inertial: Inertial) -> Element:
    xx, xy, xz, yy, yz, zz = inertial.inertia_kg_m2
    return Element(
        "inertial",
        pos=_numbers(inertial.com_m),
        mass=_number(inertial.mass_kg),
        fullinertia=_numbers((xx, yy, zz, xy, xz, yz)),
    )


def _geom(part: ConvexPart, solid: Solid, assets: _Assets) -> Element:
    common = {"friction": _numbers((solid.friction, 0.01, 0.001))}
    if solid.inertial is None:
        common["density"] = _number(solid.density_kg_m3)
    match part:
        case Box(size_m=size, body_T_box=pose):
            half = _numbers(s / 2.0 for s in size)
            return Element("geom", {"type": "box", "size": half, **_pose(pose), **common})
        case Hull():
            return Element("geom", {"type": "mesh", "mesh": assets.hull(part), **common})


def _weld(weld: Weld) -> Element:
    pose = _numbers((*weld.body_T_other.position_m, *weld.body_T_other.quaternion_wxyz))
    names = {"name": weld.name, "body1": weld.body, "body2": weld.other}
    return Element("weld", {**names, "relpose": pose, **_WELD})


def _coupling(first: str, second: str) -> Element:
    return Element("joint", joint1=first, joint2=second, polycoef="0 1 0 0 0")


def _exclude(first: str, second: str) -> Element:
    return Element("exclude", body1=first, body2=second)


def _servo(servo: Servo) -> Element:
    element = Element(
        "position",
        name=servo.joint,
        joint=servo.joint,
        kp=_number(servo.stiffness),
        dampratio="1",
    )
    if servo.force_limit:
        element.set("forcerange", _numbers((-servo.force_limit, servo.force_limit)))
    return element


def _add_all(root: Element, tag: str, elements: Iterable[Element]) -> None:
    section = SubElement(root, tag)
    for element in elements:
        section.append(element)


def _pose(pose: Pose) -> dict[str, str]:
    if pose == Pose():
        return {}
    return {"pos": _numbers(pose.position_m), "quat": _numbers(pose.quaternion_wxyz)}


def _numbers(values: Iterable[float]) -> str:
    return " ".join(_number(v) for v in values)


def _number(value: float) -> str:
    return repr(float(value))


def solids_below(solids: Iterable[Solid]) -> Iterator[Solid]:
    """Yield every solid, parents before their children."""
    for solid in solids:
        yield solid
        yield from solids_below(solid.children)
