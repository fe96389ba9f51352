"""Reads Rhino .3dm files: solids with their layers, user text, groups and blocks.

What the library says (`rhino_reader`) is checked here and becomes neutral records.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Annotated

from pydantic import Field, JsonValue, ValidationError

from sitewright.building_model.formats.detect import FileKind, kind_of, read_limited, refused
from sitewright.building_model.formats.neutral import NeutralFile, NeutralPart
from sitewright.building_model.formats.rhino_chunks import CutOffError, table_sizes
from sitewright.building_model.formats.rhino_reader import read
from sitewright.building_model.formats.rhino_units import METRES_PER_RHINO_UNIT
from sitewright.building_model.formats.solid_records import Record, SolidRecord, solid_of_record
from sitewright.building_model.formats.unreadable import UnreadableError
from sitewright.errors import ModelRejectedError, Problem

_NO_ID = "00000000-0000-0000-0000-000000000000"


class _Part(Record):
    source_id: str = Field(pattern=r"^[0-9a-f-]{36}$")
    is_block: bool
    name: str
    layer_path: str
    type: str
    group: str
    solids: list[SolidRecord]
    user_text: dict[str, str]
    raw: dict[str, JsonValue]
    problems: list[Annotated[list[str], Field(min_length=3, max_length=3)]]


class _Records(Record):
    unit: str
    parts: list[_Part]
    notes: list[str]


def read_rhino(path: Path) -> NeutralFile:
    """Return what a .3dm file holds, in its own unit, nothing decided yet.

    Args:
        path: A file saved by Rhino, version 2 or newer.

    Raises:
        ModelRejectedError: It cannot be read as a whole (E2), is something else or holds nothing
            to build (E3), is cut off (E4), or two objects share an id (D1).
    """
    demand_whole(path)
    records = _records(path)
    if not records.parts:
        said = " ".join(records.notes) or "It holds no objects."
        raise refused(path, "E3", f"read 0 parts. {said}", "Save solids with it.")
    _demand_own_ids(path, records)
    return NeutralFile(
        kind=str(FileKind.RHINO),
        metres_per_unit=METRES_PER_RHINO_UNIT.get(records.unit),
        parts=tuple(_part(p) for p in records.parts),
        notes=tuple(records.notes),
    )


def demand_whole(path: Path) -> dict[str, int]:
    """Return the sizes of a .3dm file's tables, in bytes.

    Raises:
        ModelRejectedError: It is no .3dm file (E3), or cut off (E4).
    """
    content = read_limited(path)
    if kind_of(content) is not FileKind.RHINO:
        message = f"this is no Rhino file (it looks like: {kind_of(content)})."
        raise refused(path, "E3", message, "Save it from Rhino as .3dm.")
    try:
        return table_sizes(content)
    except CutOffError as error:
        fix = "Copy or save it again."
        raise refused(path, "E4", f"it is cut off ({error}).", fix) from None


def _records(path: Path) -> _Records:
    try:
        return _Records.model_validate(read(str(path)))
    except UnreadableError as error:
        raise error.of(path) from None
    except ValidationError as error:
        first = error.errors()[0]
        place = ".".join(str(p) for p in first["loc"])
        raise refused(path, "E2", f"{place}: {first['msg']}.", "Repair the model.") from None


def _demand_own_ids(path: Path, records: _Records) -> None:
    count = Counter(p.source_id for p in records.parts)
    problems = [
        Problem(
            code="D1",
            severity="E",
            where=identity,
            message=f"{n} objects have this id.",
            fix="In Rhino: run Audit, save it again.",
            source_id=identity,
        )
        for identity, n in sorted(count.items())
        if n > 1 or identity == _NO_ID
    ]
    if problems:
        raise ModelRejectedError(str(path), problems)


def _part(part: _Part) -> NeutralPart:
    return NeutralPart(
        source_id=part.source_id,
        kind=f"{FileKind.RHINO} block" if part.is_block else str(FileKind.RHINO),
        name=part.name,
        layer_path=part.layer_path,
        type=part.type,
        group=part.group,
        solids=tuple(solid_of_record(s) for s in part.solids),
        user_text=part.user_text,
        raw=part.raw,
        problems=tuple((code, said, fix) for code, said, fix in part.problems),
    )
