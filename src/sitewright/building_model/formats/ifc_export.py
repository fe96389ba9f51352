"""Writes the as-built state into a copy of the IFC file that a model came from.

The copy keeps every byte of the original; new lines stand before the end of its DATA section:
a property set ``Sitewright_Construction`` per built element and per used element of stock, one
work schedule of what was done and a task per built element. Tasks and properties of the designer
are never edited.
"""

from __future__ import annotations

import json
import math
import os
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitewright.building_model.component import AsBuilt
from sitewright.building_model.formats.detect import FileKind, kind_of, read_limited, refused
from sitewright.building_model.formats.import_process import Limits, answer_about
from sitewright.building_model.object_states import ObjectState
from sitewright.errors import BuildingModelError
from sitewright.foundation.canonical import Json, sha256_hex

_PATCH = "sitewright.building_model.formats.ifc_patch:lines_as_asked"
_END_OF_SECTION = b"ENDSEC;"
_DONE = ("verified", "fastened")


class ForeignOriginalError(BuildingModelError):
    """The model was not imported from this file, or the copy would replace it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class IfcPatch:
    """What was written.

    Attributes:
        path: The patched copy.
        lines_added: Lines that the original does not have; none is removed.
        written: GlobalIds of elements with an as-built record.
        not_found: GlobalIds that the model has and the file does not; nothing was written of them.
    """

    path: Path
    lines_added: int
    written: tuple[str, ...]
    not_found: tuple[str, ...]


def export_ifc(
    original: Path,
    states: Mapping[str, ObjectState],
    out: Path,
    *,
    written_at: str,
    limits: Limits | None = None,
) -> IfcPatch:
    """Write `out`: the original and, on top, what was built.

    Args:
        original: The IFC file that the model was imported from; only read.
        states: What became of the file's elements (`object_states`).
        out: The copy; replaced as a whole once it has been read back.
        written_at: Time of writing, ISO 8601; used where no component has a time.
        limits: What the parsing child may use.

    Raises:
        ForeignOriginalError: Nothing of the model comes from this file, or `out` is the original.
        ModelRejectedError: The original cannot be read.
    """
    if out.resolve() == original.resolve():
        raise ForeignOriginalError(f"{out} is the original itself; name another file.")
    content = read_limited(original)
    if kind_of(content) is not FileKind.IFC or _END_OF_SECTION not in content:
        raise refused(original, "E3", "this is no IFC file in STEP format.", "Name the original.")
    records = _records(states)
    request = {"seed": sha256_hex(content), "written_at": written_at}
    limits = limits or Limits()
    answer = _ask(original, {**request, "records": records, "expected": []}, limits)
    lines, missing = _texts(answer["lines"]), _texts(answer["missing"])
    if records and len(missing) == len(records):
        raise ForeignOriginalError(f"{original} holds none of the elements that were built.")
    written = tuple(str(r["source_id"]) for r in records if r["source_id"] not in missing)
    with tempfile.TemporaryDirectory(dir=out.parent, prefix=f".{out.name}.") as folder:
        draft = Path(folder) / out.name
        _write(draft, _spliced(content, lines))
        again = _ask(draft, {**request, "records": [], "expected": list(written)}, limits)
        if again["missing"]:
            raise refused(original, "E3", "its sections are in no usual order.", "Export it again.")
        draft.replace(out)
    return IfcPatch(
        path=out, lines_added=len(lines), written=written, not_found=tuple(sorted(missing))
    )


def _ask(ifc: Path, request: Mapping[str, Json], limits: Limits) -> Mapping[str, Json]:
    with tempfile.TemporaryDirectory() as folder:
        question = Path(folder) / "request.json"
        question.write_text(json.dumps({**request, "ifc": str(ifc.resolve())}), encoding="utf-8")
        return answer_about(ifc, _PATCH, str(question.absolute()), limits=limits)


def _texts(value: Json) -> list[str]:
    return [str(v) for v in value] if isinstance(value, list) else []


def _spliced(content: bytes, lines: Sequence[str]) -> bytes:
    """Return the content with lines before the end of its last section."""
    at = content.rindex(_END_OF_SECTION)
    newline = b"\r\n" if b"\r\n" in content[:4096] else b"\n"
    before, after = content[:at], content[at:]
    gap = b"" if not lines or before.endswith(b"\n") else newline
    added = b"".join(line.encode("ascii") + newline for line in lines)
    return before + gap + added + after


def _write(path: Path, content: bytes) -> None:
    with path.open("wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())


def _records(states: Mapping[str, ObjectState]) -> list[dict[str, Json]]:
    """Return one record per IFC element that became something, in order of time."""
    changed = (s for s in states.values() if s.kind == FileKind.IFC and s.is_changed)
    found = [_record(state) for state in changed]
    return sorted(found, key=lambda r: (str(r["built_at"]), str(r["source_id"])))


def _record(state: ObjectState) -> dict[str, Json]:
    built = state.record
    properties = [
        ["Status", "IfcLabel", state.status],
        ["Layer", "IfcLabel", state.layer.value if state.layer else ""],
        ["Component", "IfcText", ", ".join(state.components)],
        ["UsedFor", "IfcLabel", state.used_for],
        *(_built(built) if built else ()),
        *_measured(state),
    ]
    return {
        "source_id": state.source_id,
        "component": state.components[0],
        "built_at": built.installed_at if built else "",
        "is_task": built is not None,
        "is_done": state.status in _DONE,
        "properties": [list(p) for p in properties if p[2] not in {"", None}],
    }


def _built(record: AsBuilt) -> list[list[Json]]:
    return [
        ["BuiltAt", "IfcLabel", record.installed_at],
        ["Robot", "IfcLabel", record.robot],
        ["MaterialUsed", "IfcLabel", record.material_used],
        ["Operations", "IfcText", "; ".join(f"{o}: {s}" for o, s in record.operations.items())],
    ]


def _measured(state: ObjectState) -> list[list[Json]]:
    if state.deviation is None or state.file_T_component_measured is None:
        return []
    off_m, off_rad = state.deviation
    at = state.file_T_component_measured.position_m
    return [
        ["DeviationMm", "IfcReal", round(1000.0 * off_m, 4)],
        ["DeviationDeg", "IfcReal", round(math.degrees(off_rad), 4)],
        ["MeasuredCentreM", "IfcText", " ".join(f"{v:.6f}" for v in at)],
    ]
