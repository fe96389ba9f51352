"""What every importer hands over: parts as the source file has them, nothing decided yet."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.building_model.component import PlaneCut
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose, Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class BoxSolid:
    """A box centred on its frame; x runs along the grain if the source says so."""

    file_T_box: Pose
    size: Vector
    has_grain: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class ExtrusionSolid:
    """A profile in the frame's x-y plane pulled along +z."""

    file_T_profile: Pose
    profile: tuple[tuple[float, float], ...]
    depth: float
    holes: tuple[tuple[tuple[float, float], ...], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class FacesSolid:
    """A closed surface of polygons (seen from outside counter-clockwise)."""

    vertices: tuple[Vector, ...]
    faces: tuple[tuple[int, ...], ...]


NeutralSolid = BoxSolid | ExtrusionSolid | FacesSolid


@dataclass(frozen=True, slots=True, kw_only=True)
class NeutralPart:
    """One thing of a source file that may become a component.

    Attributes:
        source_id: Its own id in the file; unique there.
        layer_path: Layers from the root, ``Storey 1::Studs``; empty if the format has none.
        parents: Ids or names of what it rests on, if the file says so.
        cuts: Saw cuts in the frame of the solid (box and extrusion only).
        user_text: Attributes as text, by key, unknown ones too.
        raw: Further attributes that are not text.
        problems: Sentences about what could not be read of it: (code, message, fix).
    """

    source_id: str
    kind: str
    name: str = ""
    layer_path: str = ""
    type: str = ""
    material: str = ""
    group: str = ""
    order: int | None = None
    parents: tuple[str, ...] = ()
    is_ground: bool = False
    solids: tuple[NeutralSolid, ...] = ()
    cuts: tuple[PlaneCut, ...] = ()
    user_text: Mapping[str, str] = field(default_factory=dict)
    raw: Mapping[str, Json] = field(default_factory=dict)
    problems: tuple[tuple[str, str, str], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class NeutralRelation:
    """A fact of the file about two parts, by source id."""

    kind: str
    a: str
    b: str
    data: Mapping[str, Json] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class NeutralFile:
    """A whole file, in its own length unit.

    Attributes:
        metres_per_unit: None if the file states no unit.
        notes: Sentences about the file as a whole, for instance what was left out.
        raw: Facts of the file as a whole that are kept, e.g. ``survey``: where it lies on Earth.
    """

    kind: str
    metres_per_unit: float | None
    parts: tuple[NeutralPart, ...]
    relations: tuple[NeutralRelation, ...] = ()
    notes: tuple[str, ...] = ()
    raw: Mapping[str, Json] = field(default_factory=dict)
