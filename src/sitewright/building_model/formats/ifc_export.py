"""Writes the as-built state into a copy of the IFC file that a model came from.

The copy keeps every byte of the original; new lines stand before the end of its DATA section:
a property set ``Sitewright_Construction`` per built element, one work schedule of what was done
and a task per element. Tasks and properties of the designer are never edited.
"""

from __future__ import annotations

import json
import math
import os
import tempfile
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitewright.building_model.component import AsBuilt, Component
from sitewright.building_model.formats.detect import FileKind, kind_of, read_limited, refused
from sitewright.building_model.formats.import_process import Limits, answer_about
from sitewright.building_model.model import BuildingModel
from sitewright.errors import BuildingModelError
from sitewright.foundation.canonical import Json, sha256_hex
from sitewright.foundation.pose import Pose, Vector, add

_PATCH = "sitewright.building_model.formats.ifc_patch:lines_as_asked"
_END_OF_SECTION = b"ENDSEC;"
_DONE = ("verified", "fastened", "placed")
_PARTLY = "partly"


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
    as_built: BuildingModel,
    out: Path,
    *,
    written_at: str,
    world_T_model: Pose | None = None,
    limits: Limits | None = None,
) -> IfcPatch:
    """Write `out`: the original and, on top, what was built.

    Args:
        original: The IFC file that the model was imported from; only read.
        as_built: The model with as-built records folded in.
        out: The copy; replaced as a whole once it has been read back.
        written_at: Time of writing, ISO 8601; used where no component has a time.
        world_T_model: Places the model in the cell that measured it; the identity if missing.
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
    records = _records(as_built, world_T_model or Pose())
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


def _records(model: BuildingModel, world_T_model: Pose) -> list[dict[str, Json]]:
    """Return one record per IFC element with something built, in order of time.

    A component that is one body of an element has the element's id and a number behind a dot.
    """
    by_source: dict[str, list[Component]] = defaultdict(list)
    for component in model.component_by_id.values():
        if component.source is not None and component.source.kind == FileKind.IFC:
            by_source[component.source.id.partition(".")[0]].append(component)
    found = [
        _record(source, components, world_T_model.inverse(), model.origin_shift_m)
        for source, components in sorted(by_source.items())
        if any(c.as_built is not None for c in components)
    ]
    return sorted(found, key=lambda r: (str(r["built_at"]), str(r["source_id"])))


def _record(
    source: str, components: Sequence[Component], model_T_world: Pose, shift: Vector
) -> dict[str, Json]:
    built = [(c, c.as_built) for c in components if c.as_built is not None]
    component, state = max(built, key=lambda pair: (pair[1].installed_at, pair[0].id))
    is_whole = len(built) == len(components) and len({s.status for _, s in built}) == 1
    status = state.status if is_whole else _PARTLY
    properties = [
        ["Status", "IfcLabel", status],
        ["Layer", "IfcLabel", str(component.layer)] if is_whole else None,
        ["Component", "IfcText", ", ".join(c.id for c, _ in built)],
        ["BuiltAt", "IfcLabel", state.installed_at],
        ["Robot", "IfcLabel", state.robot],
        ["MaterialUsed", "IfcLabel", state.material_used],
        ["Operations", "IfcText", "; ".join(f"{o}: {s}" for o, s in state.operations.items())],
        *_measured(component, state, model_T_world, shift),
    ]
    return {
        "source_id": source,
        "component": component.id,
        "built_at": state.installed_at,
        "is_done": status in _DONE,
        "properties": [list(p) for p in properties if p is not None and p[2] not in {"", None}],
    }


def _measured(
    component: Component, state: AsBuilt, model_T_world: Pose, shift: Vector
) -> list[list[Json]]:
    if state.world_T_component_measured is None:
        return []
    measured = model_T_world @ state.world_T_component_measured
    design = component.world_T_component
    at = add(measured.position_m, shift)
    return [
        ["DeviationMm", "IfcReal", round(1000.0 * design.distance_to_m(measured), 4)],
        ["DeviationDeg", "IfcReal", round(math.degrees(design.angle_to_rad(measured)), 4)],
        ["MeasuredCentreM", "IfcText", " ".join(f"{v:.6f}" for v in at)],
    ]
