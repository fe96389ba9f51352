"""What is done to a BTLx part: planes of saw cuts, axes of drillings, the rest as it stands."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.building_model.component import PlaneCut
from sitewright.building_model.formats.btlx_values import element_number, number, whole
from sitewright.building_model.formats.xml_tree import XmlNode
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector, rotation, scale

_NOT_DONE = "no"
_AXES: Mapping[int, Vector] = {
    1: (0.0, 0.0, 1.0),
    2: (0.0, -1.0, 0.0),
    3: (0.0, 0.0, -1.0),
    4: (0.0, 1.0, 0.0),
}
"""Direction of y on the four long sides; x runs along the part."""
_MILLIMETRES = 0.001


@dataclass(slots=True)
class Processings:
    """Everything that is done to one part, in the frame of its corner, in millimetres."""

    cuts: list[PlaneCut] = field(default_factory=list)
    drillings: list[dict[str, Json]] = field(default_factory=list)
    others: list[dict[str, Json]] = field(default_factory=list)
    problems: list[tuple[str, str, str]] = field(default_factory=list)


def processings_of(part: XmlNode, size: Vector) -> Processings:
    """Return the processings of a part.

    Args:
        part: Its element.
        size: Length, height and width.
    """
    work = Processings()
    for holder in part.all("Processings"):
        for node in holder.children:
            _add(work, node, size)
    kinds: dict[str, int] = {}
    for other in work.others:
        kinds[str(other["kind"])] = kinds.get(str(other["kind"]), 0) + 1
    for kind, count in sorted(kinds.items()):
        message = f"Its {kind}{f' ({count} times)' if count > 1 else ''} is kept, but not shaped."
        fix = "Its wood stays; expect it to overlap its neighbour."
        work.problems.append(("G7", message, fix))
    return work


def _add(work: Processings, node: XmlNode, size: Vector) -> None:
    is_done = node.attributes.get("Process", "yes").lower() != _NOT_DONE
    if node.tag == "JackRafterCut" and is_done and (cut := _cut(node, size)):
        work.cuts.append(cut)
    elif node.tag == "Drilling" and is_done and (hole := _drilling(node, size)):
        work.drillings.append(hole)
    else:
        work.others.append(_verbatim(node))


def _cut(node: XmlNode, size: Vector) -> PlaneCut | None:
    """Return the plane of a cut; its normal points to what is sawn off."""
    side = _side(node, size)
    orientation = node.child("Orientation")
    text = orientation.text.strip().lower() if orientation is not None else "start"
    values = [
        element_number(node, tag, default)
        for tag, default in (
            ("StartX", 0.0),
            ("StartY", 0.0),
            ("StartDepth", 0.0),
            ("Angle", 90.0),
            ("Inclination", 90.0),
        )
    ]
    if side is None or text not in {"start", "end"} or not all(map(math.isfinite, values)):
        return None
    x, y, depth, angle, inclination = values
    sign = 1.0 if text == "end" else -1.0
    about_z = rotation((0.0, 0.0, 1.0), sign * math.radians(90.0 - angle))
    about_y = rotation((0.0, 1.0, 0.0), sign * math.radians(90.0 - inclination))
    normal = scale((about_z @ about_y).turn((1.0, 0.0, 0.0)), sign)
    return PlaneCut(side.apply((x, y, -depth)), side.turn(normal))


def _drilling(node: XmlNode, size: Vector) -> dict[str, Json] | None:
    """Return a hole: where it starts and which way it goes, in the component's frame (metres)."""
    side = _side(node, size)
    values = [
        element_number(node, tag, default)
        for tag, default in (
            ("StartX", 0.0),
            ("StartY", 0.0),
            ("Angle", 0.0),
            ("Inclination", 90.0),
            ("Depth", 0.0),
            ("Diameter", math.nan),
        )
    ]
    if side is None or not all(map(math.isfinite, values)):
        return None
    x, y, angle, inclination, depth, diameter = values
    limited = node.child("DepthLimited")
    is_through = limited is not None and limited.text.strip().lower() == _NOT_DONE
    tilt = math.radians(inclination)
    turn = math.radians(angle)
    direction = side.turn(
        (math.cos(tilt) * math.cos(turn), math.cos(tilt) * math.sin(turn), -math.sin(tilt))
    )
    start = side.apply((x, y, 0.0))
    centred = [round((p - s / 2.0) * _MILLIMETRES, 7) for p, s in zip(start, size, strict=True)]
    hole: dict[str, Json] = {
        "start_m": centred,
        "direction": [round(c, 9) for c in direction],
        "diameter_m": round(diameter * _MILLIMETRES, 7),
    }
    if not is_through and depth > 0.0:
        hole["depth_m"] = round(depth * _MILLIMETRES, 7)
    return hole


def _side(node: XmlNode, size: Vector) -> Pose | None:
    """Return the frame of the reference side that a processing counts from."""
    _, height, width = size
    if not all(map(math.isfinite, size)):
        return None
    corner: Mapping[int, Vector] = {
        1: (0.0, 0.0, 0.0),
        2: (0.0, height, 0.0),
        3: (0.0, height, width),
        4: (0.0, 0.0, width),
    }
    side = whole(node.attributes.get("ReferencePlaneID"), default=0) or 0
    if side not in corner:
        return None
    return Pose.from_axes(corner[side], (1.0, 0.0, 0.0), _AXES[side])


def _verbatim(node: XmlNode) -> dict[str, Json]:
    kept: dict[str, Json] = {"kind": node.tag, **{f"@{k}": v for k, v in node.attributes.items()}}
    for child in node.children:
        text = child.text.strip()
        value = number(text)
        kept[child.tag] = value if math.isfinite(value) else text
    return kept
