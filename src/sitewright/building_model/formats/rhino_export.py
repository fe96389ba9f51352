"""Writes the as-built state into a copy of the .3dm file that a model came from.

The copy is written by rhino3dm, which does not keep all that Rhino saves; everything lost is
reported. Inside Rhino, ``docs/rhino/apply_status.py`` does the same without a loss.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from sitewright.building_model.formats.detect import FileKind
from sitewright.building_model.formats.import_process import Limits, answer_about
from sitewright.building_model.formats.layer_rules import LayerNames
from sitewright.building_model.formats.rhino import demand_whole
from sitewright.building_model.object_states import ObjectState, status_document
from sitewright.errors import BuildingModelError
from sitewright.foundation.canonical import Json

_PATCH = "sitewright.building_model.formats.rhino_patch:patch_as_asked"
_ROOM_BYTES = 50_000_000


class ForeignDrawingError(BuildingModelError):
    """The model was not imported from this file, or the copy would replace it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RhinoCopy:
    """What was written.

    Attributes:
        path: The copy.
        written: Ids of objects that carry a status now.
        not_found: Ids that the model has and the file does not; nothing was written of them.
        losses: What the original holds and the copy does not, one sentence each.
    """

    path: Path
    written: tuple[str, ...]
    not_found: tuple[str, ...]
    losses: tuple[str, ...]


def asbuilt_path(original: Path) -> Path:
    """Return the usual name of the copy."""
    return original.with_name(f"{original.stem}_asbuilt.3dm")


def export_rhino(
    original: Path,
    states: Mapping[str, ObjectState],
    out: Path,
    *,
    names: LayerNames | None = None,
    limits: Limits | None = None,
) -> RhinoCopy:
    """Write `out`: the original with layers and user text of what was built.

    Args:
        original: The .3dm file that the model was imported from; only read.
        states: What became of the file's objects (`object_states`).
        out: The copy; replaced as a whole once it has been read back.
        names: The user's own names of our layers, as at the import.
        limits: What the writing child may use.

    Raises:
        ForeignDrawingError: Nothing of the model comes from this file, or `out` is the original.
        ModelRejectedError: The original cannot be read, or the copy cannot be written.
    """
    if out.resolve() == original.resolve():
        raise ForeignDrawingError(f"{out} is the original itself; name another file.")
    before = demand_whole(original)
    limits = limits or Limits()
    room = max(limits.written_bytes, 2 * original.stat().st_size + _ROOM_BYTES)
    with tempfile.TemporaryDirectory(dir=out.parent, prefix=f".{out.name}.") as folder:
        draft, request = Path(folder) / out.name, Path(folder) / "request.json"
        changed = {i: s for i, s in states.items() if s.kind == FileKind.RHINO and s.is_changed}
        question = _question(original, draft, changed, names or LayerNames())
        request.write_text(json.dumps(question), encoding="utf-8")
        allowed = replace(limits, written_bytes=room)
        answer = answer_about(original, _PATCH, str(request.absolute()), limits=allowed)
        written, missing = _texts(answer, "written"), _texts(answer, "missing")
        if changed and not written:
            raise ForeignDrawingError(f"{original} holds none of the objects that were built.")
        losses = (*_texts(answer, "losses"), *_shrunk(before, demand_whole(draft)))
        draft.replace(out)
    return RhinoCopy(path=out, written=written, not_found=missing, losses=losses)


def _question(
    original: Path, draft: Path, changed: Mapping[str, ObjectState], names: LayerNames
) -> dict[str, Json]:
    return {
        "original": str(original.resolve()),
        "copy": str(draft.resolve()),
        "status": status_document(changed),
        "role_by_name": {word: role.value for word, role in names.role_by_name.items()},
    }


def _shrunk(before: Mapping[str, int], after: Mapping[str, int]) -> list[str]:
    """Return a sentence for each table of the file that has less bytes in the copy."""
    return [
        f"The file's {name}: {size} bytes before, {after.get(name, 0)} in the copy."
        for name, size in before.items()
        if after.get(name, 0) < size
    ]


def _texts(answer: Mapping[str, Json], key: str) -> tuple[str, ...]:
    value = answer.get(key)
    return tuple(str(v) for v in value) if isinstance(value, list) else ()
