"""Reads BTLx, the timber trade's machine format: blanks, saw cuts, drillings, several places."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path

from sitewright.building_model.component import PlaneCut
from sitewright.building_model.formats.btlx_processings import Processings, processings_of
from sitewright.building_model.formats.btlx_values import number, point, whole
from sitewright.building_model.formats.detect import FileKind, read_limited, refused
from sitewright.building_model.formats.neutral import BoxSolid, NeutralFile, NeutralPart
from sitewright.building_model.formats.xml_tree import XmlNode, read_xml
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector, cross, norm, scale, subtract

NAMESPACE = "https://www.design2machine.com"
_MM = 0.001
_PARALLEL = 1e-6
_FAMILIAR = frozenset({"Length", "Height", "Width", "Count", "Designation", "Material"})
_BAD_GEOMETRY = ("Its place cannot be read.", "Export it again.")


def read_btlx(path: Path) -> NeutralFile:
    """Return the parts of a BTLx file, one per place at which a part stands.

    The format counts in millimetres. A part's box is its blank; its x axis is the part's
    length. `JackRafterCut` becomes a cut and `Drilling` an entry of ``drillings``; every other
    processing is kept under ``processings`` and told.

    Raises:
        ModelRejectedError: It cannot be read, or is of another namespace.
    """
    root = read_xml(path, read_limited(path))
    if root.namespace != NAMESPACE or root.tag != "BTLx":
        stated = f"{root.tag} of namespace {root.namespace!r}"
        message = f"read 0 parts: its root is {stated[:120]}, expected BTLx of {NAMESPACE!r}."
        raise refused(path, "E3", message, "Export it as BTLx 1.1 or later.")
    nodes = list(root.all("Project", "Parts", "Part"))
    parts = [part for place, node in enumerate(nodes, 1) for part in _placed(node, place)]
    return NeutralFile(kind=str(FileKind.BTLX), metres_per_unit=_MM, parts=tuple(parts))


def _placed(node: XmlNode, place: int) -> Iterator[NeutralPart]:
    """Yield a part once per transformation."""
    sizes = tuple(number(node.attributes.get(k)) for k in ("Length", "Height", "Width"))
    work = processings_of(node, (sizes[0], sizes[1], sizes[2]))
    label = node.attributes.get("SingleMemberNumber") or str(place)
    frames = list(node.all("Transformations", "Transformation"))
    for index, frame in enumerate(frames, 1):
        stated = frame.attributes.get("GUID", "").strip("{} ")
        own = stated or (label if len(frames) == 1 else f"{label}.{index}")
        problems = _count_problems(node, label, len(frames)) if index == 1 else ()
        yield _part(node, own, frame, work, problems)
    if not frames:
        yield _part(node, label, None, work, _count_problems(node, label, 0))


def _part(
    node: XmlNode,
    source_id: str,
    frame: XmlNode | None,
    work: Processings,
    problems: tuple[tuple[str, str, str], ...],
) -> NeutralPart:
    attributes = node.attributes
    size = _size(node)
    pose = _pose(frame)
    said = list(problems) + list(work.problems)
    solids: tuple[BoxSolid, ...] = ()
    if size is None:
        said.append(("G6", "Its length, height or width is no size.", "Repair the part."))
    elif pose is None and frame is not None:
        said.append(("G6", *_BAD_GEOMETRY))
    elif size is not None and pose is not None:
        middle = pose.apply(scale(size, 0.5))
        box = Pose(middle, pose.quaternion_wxyz)
        solids = (BoxSolid(file_T_box=box, size=size, has_grain=True),)
    return NeutralPart(
        source_id=source_id,
        kind="part",
        name=_label(attributes, source_id),
        type=attributes.get("Annotation", ""),
        material=attributes.get("Material", ""),
        group=attributes.get("AssemblyNumber", ""),
        solids=solids,
        cuts=tuple(_centred(cut, size) for cut in work.cuts) if size and solids else (),
        user_text=_user_text(node),
        raw=_raw(node, work),
        problems=tuple(said),
    )


def _label(attributes: Mapping[str, str], source_id: str) -> str:
    """Return designation and member number: designations alone are alike in whole frames."""
    member = attributes.get("SingleMemberNumber") or source_id
    return f"{attributes.get('Designation', '')} {member}".strip()


def _size(node: XmlNode) -> Vector | None:
    values = [number(node.attributes.get(key)) for key in ("Length", "Height", "Width")]
    return (values[0], values[1], values[2]) if all(v > 0.0 for v in values) else None


def _pose(frame: XmlNode | None) -> Pose | None:
    """Return the part's frame: x along its length, y along its height, z along its width."""
    position = frame.child("Position") if frame is not None else None
    if position is None:
        return None
    origin, x, y = (point(position.child(tag)) for tag in ("ReferencePoint", "XVector", "YVector"))
    if origin is None or x is None or y is None:
        return None
    skew = norm(cross(x, y))
    if not (math.isfinite(skew) and skew > _PARALLEL * max(norm(x) * norm(y), _PARALLEL)):
        return None
    return Pose.from_axes(origin, x, y)


def _centred(cut: PlaneCut, size: Vector) -> PlaneCut:
    return PlaneCut(subtract(cut.point_m, scale(size, 0.5)), cut.normal)


def _count_problems(node: XmlNode, label: str, places: int) -> tuple[tuple[str, str, str], ...]:
    count = whole(node.attributes.get("Count"), default=1)
    if count == places:
        return ()
    if count is None:
        stated = node.attributes["Count"][:40]
        message = f"Part {label}: its Count {stated!r} is no whole number."
        return (("P5", message, "Correct the count."),)
    if count > places:
        rest = f"{count - places} {'pieces have' if count - places > 1 else 'piece has'} no pose"
    else:
        rest = f"{places - count} more than it counts"
    message = f"Part {label}: Count {count}, {places} placements; {rest}."
    return (("P5", message, "Export every piece with its place, or correct the count."),)


def _user_text(node: XmlNode) -> dict[str, str]:
    texts = {}
    for entry in node.all("UserAttributes", "UserAttribute"):
        name = entry.attributes.get("Name", "")
        if name:
            texts[name] = entry.attributes.get("Value", entry.text.strip())
    return texts


def _raw(node: XmlNode, work: Processings) -> dict[str, Json]:
    raw: dict[str, Json] = {
        key: value for key, value in node.attributes.items() if value and key not in _FAMILIAR
    }
    grain = node.child("GrainDirection")
    if grain is not None:
        raw["GrainDirection"] = dict(grain.attributes)
    if work.drillings:
        raw["drillings"] = list(work.drillings)
    if work.others:
        raw["processings"] = list(work.others)
    return raw
