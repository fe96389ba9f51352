"""Neutral records as JSON: how a reading child process hands them over."""

from __future__ import annotations

from sitewright.building_model.formats.neutral import (
    BoxSolid,
    ExtrusionSolid,
    FacesSolid,
    NeutralFile,
    NeutralPart,
    NeutralSolid,
)
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose


def document_of(file: NeutralFile) -> Json:
    """Return a file's records; `neutral_records.neutral_of` takes them back."""
    return {
        "kind": file.kind,
        "metres_per_unit": file.metres_per_unit,
        "parts": [_part(p) for p in file.parts],
        "relations": [
            {"kind": r.kind, "a": r.a, "b": r.b, "data": dict(r.data)} for r in file.relations
        ],
        "notes": list(file.notes),
        "raw": dict(file.raw),
    }


def _part(part: NeutralPart) -> Json:
    return {
        "source_id": part.source_id,
        "kind": part.kind,
        "name": part.name,
        "layer_path": part.layer_path,
        "type": part.type,
        "material": part.material,
        "group": part.group,
        "order": part.order,
        "parents": list(part.parents),
        "is_ground": part.is_ground,
        "solids": [_solid(s) for s in part.solids],
        "cuts": [{"point": list(c.point_m), "normal": list(c.normal)} for c in part.cuts],
        "user_text": dict(part.user_text),
        "raw": dict(part.raw),
        "problems": [list(p) for p in part.problems],
    }


def _solid(solid: NeutralSolid) -> Json:
    match solid:
        case BoxSolid():
            return {
                "kind": "box",
                "pose": _pose(solid.file_T_box),
                "size": list(solid.size),
                "has_grain": solid.has_grain,
            }
        case ExtrusionSolid():
            return {
                "kind": "extrusion",
                "pose": _pose(solid.file_T_profile),
                "profile": [list(p) for p in solid.profile],
                "depth": solid.depth,
                "holes": [[list(p) for p in hole] for hole in solid.holes],
            }
        case FacesSolid():
            return {
                "kind": "faces",
                "vertices": [list(v) for v in solid.vertices],
                "faces": [list(f) for f in solid.faces],
            }


def _pose(pose: Pose) -> Json:
    return {"p": list(pose.position_m), "q": list(pose.quaternion_wxyz)}
