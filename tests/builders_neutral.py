"""Neutral records for tests: boxes, surfaces and parts as a reader hands them over."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product
from pathlib import Path
from typing import Any

from sitewright.building_model.component import Component
from sitewright.building_model.formats.from_neutral import model_of
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    FacesSolid,
    NeutralFile,
    NeutralPart,
    NeutralSolid,
)
from sitewright.building_model.model import BuildingModel
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.pose import Pose, Vector, add

QUADS = (
    (0, 1, 3, 2),
    (4, 6, 7, 5),
    (0, 4, 5, 1),
    (2, 3, 7, 6),
    (0, 2, 6, 4),
    (1, 5, 7, 3),
)


def box_surface(size: Vector, pose: Pose | None = None) -> FacesSolid:
    """Return the six faces of a box centred on a pose."""
    pose = pose or Pose()
    corners = product(*((-s / 2.0, s / 2.0) for s in size))
    return FacesSolid(vertices=tuple(pose.apply((x, y, z)) for x, y, z in corners), faces=QUADS)


def together(*solids: FacesSolid) -> FacesSolid:
    """Return several surfaces as one."""
    vertices: list[Vector] = []
    faces: list[tuple[int, ...]] = []
    for solid in solids:
        start = len(vertices)
        vertices += solid.vertices
        faces += [tuple(i + start for i in face) for face in solid.faces]
    return FacesSolid(vertices=tuple(vertices), faces=tuple(faces))


def shifted(solid: FacesSolid, by: Vector) -> FacesSolid:
    return FacesSolid(vertices=tuple(add(v, by) for v in solid.vertices), faces=solid.faces)


def box(at: Vector = (0.0, 0.0, 0.0), size: Vector = (2.0, 0.1, 0.2)) -> BoxSolid:
    return BoxSolid(file_T_box=Pose(at), size=size, has_grain=True)


def part(
    source_id: str, *solids: NeutralSolid, text: Mapping[str, str] | None = None, **more: Any
) -> NeutralPart:
    return NeutralPart(
        source_id=source_id,
        kind=more.pop("kind", "object"),
        solids=solids or (box(),),
        user_text={f"sitewright.{k}": v for k, v in (text or {}).items()} | more.pop("other", {}),
        **more,
    )


def read(
    parts: Sequence[NeutralPart], *, metres: float | None = 1.0, kind: str = "rhino", **more: Any
) -> tuple[BuildingModel, list[Problem]]:
    relations = more.pop("relations", ())
    file = NeutralFile(kind=kind, metres_per_unit=metres, parts=tuple(parts), relations=relations)
    return model_of(file, Path("house.x"), **more)


def one(source_id: str = "a", *solids: NeutralSolid, **more: Any) -> Component:
    """Return the component of a file of one part."""
    model, _ = read([part(source_id, *solids, **more)])
    (component,) = model.component_by_id.values()
    return component


def refusals(parts: Sequence[NeutralPart], **more: Any) -> list[Problem]:
    """Return the errors that a file is refused for."""
    try:
        read(parts, **more)
    except ModelRejectedError as rejected:
        return [p for p in rejected.problems if p.severity == "E"]
    return []
