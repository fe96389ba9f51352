"""Writes a state of a project's building for other programs: a table, a model, or onto a copy."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from sitewright.app.built_state import BuiltState
from sitewright.app.clock import SystemClock
from sitewright.app.import_records import layer_names
from sitewright.app.installing import iso_time
from sitewright.app.project import BUILDING, ProjectError
from sitewright.building_model.as_built_table import as_built_csv
from sitewright.building_model.component import Source
from sitewright.building_model.formats.detect import FileKind
from sitewright.building_model.formats.to_file import document_of
from sitewright.building_model.object_states import CONSUMED, ObjectState, status_document
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.json_layout import laid_out
from sitewright.journal.blobs import write_whole

STATUS = "status.json"
_COPY_SUFFIX = {FileKind.IFC: ".ifc", FileKind.RHINO: ".3dm"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Export:
    """What was written.

    Attributes:
        files: Every file, the main one first.
        installed: How many components of the state were built by the team.
        notes: What a reader should know, and what could not be carried over, one sentence each.
    """

    files: tuple[Path, ...]
    installed: int
    notes: tuple[str, ...] = ()


def export_as(
    kind: str, state: BuiltState, *, original: Path | None = None, out: Path | None = None
) -> Export:
    """Write a state as ``json``, ``csv``, ``glb``, or as a patch: ``ifc``, ``rhino``.

    Args:
        kind: What to write.
        state: What of.
        original: The imported file, for a patch; found by its name if it is left out.
        out: The file to write; the usual name in the project, or beside the original, by default.
    """
    if kind in _PATCHES:
        source = original or original_of(state, FileKind(kind))
        return _PATCHES[kind](state, source, out or copy_of(source, FileKind(kind)))
    return _WHOLE[kind](state, out or state.folder / f"{state.name}.{kind}")


def export_json(state: BuiltState, out: Path) -> Export:
    """Write the model in the native schema."""
    _require_goal(state, out)
    write_whole(out, laid_out(document_of(state.as_built)).encode())
    return Export(files=(out,), installed=state.installed, notes=state.notes)


def export_csv(state: BuiltState, out: Path) -> Export:
    """Write a table of components, and `status.json` beside it if they have source ids."""
    _require_goal(state, out)
    write_whole(out, as_built_csv(state.as_built, state.world_T_model).encode())
    files = (out, *_status_file(state.objects, out))
    return Export(files=files, installed=state.installed, notes=state.notes)


def export_gltf(state: BuiltState, out: Path) -> Export:
    """Write all that stands, lies or is drawn as one binary glTF file."""
    from sitewright.app.drawn_scene import drawn_scene
    from sitewright.building_model.formats.gltf import glb_of

    _require_goal(state, out)
    scene, left_out = drawn_scene(state)
    write_whole(out, glb_of(scene))
    return Export(files=(out,), installed=state.installed, notes=(*state.notes, *left_out))


def export_ifc(state: BuiltState, original: Path, out: Path) -> Export:
    """Write the state as added lines on a copy of the original IFC file.

    Raises:
        BackendMissingError: The extra ``[ifc]`` is not installed.
        ModelRejectedError: The original cannot be read.
    """
    from sitewright.building_model.formats import ifc_export

    _require_goal(state, out)
    objects = state.objects
    now = iso_time(SystemClock().utc_ns())
    patch = ifc_export.export_ifc(original, objects, out, written_at=now)
    said = (f"{patch.lines_added} lines added, none removed.", *_used(objects))
    return _copy(state, original, patch.path, patch.not_found, said)


def export_rhino(state: BuiltState, original: Path, out: Path) -> Export:
    """Write the state onto a copy of the original Rhino file, and tell what it loses.

    Raises:
        BackendMissingError: The extra ``[rhino]`` is not installed.
        ModelRejectedError: The original cannot be read.
    """
    from sitewright.building_model.formats import rhino_export

    _require_goal(state, out)
    objects = state.objects
    names = layer_names(state.folder, state.design)
    copy = rhino_export.export_rhino(original, objects, out, names=names)
    said = (*copy.losses, *_used(objects, " Its layer Consumed is switched off."))
    return _copy(state, original, copy.path, copy.not_found, said)


_WHOLE: Mapping[str, Callable[[BuiltState, Path], Export]] = {
    "json": export_json,
    "csv": export_csv,
    "glb": export_gltf,
}
_PATCHES: Mapping[str, Callable[[BuiltState, Path, Path], Export]] = {
    FileKind.IFC: export_ifc,
    FileKind.RHINO: export_rhino,
}


def original_of(state: BuiltState, kind: FileKind) -> Path:
    """Return the file that a project was imported from.

    Raises:
        ProjectError: Nothing of the model comes from a file of that kind, or it is gone.
    """
    others = sorted({s.kind for s in state.as_built.sources} - {str(kind)})
    if others and not any(True for _ in _sources(state, kind)):
        raise ProjectError(
            f"{state.folder} was imported from {', '.join(others)}, not from {kind}: there is no "
            "file of that kind to write onto. Export --gltf, --csv or --json-model."
        )
    names = {s.file for s in _sources(state, kind) if s.file}
    found = [p for n in sorted(names) for p in (Path(n), state.folder / n) if p.exists()]
    if not found:
        listed = f" ({', '.join(sorted(names))})" if names else ""
        raise ProjectError(
            f"The {kind} file that {state.folder} was imported from is not there{listed}. "
            "Name it with --original."
        )
    return found[0]


def copy_of(original: Path, kind: FileKind) -> Path:
    """Return the usual name of a patched copy."""
    return original.with_name(f"{original.stem}_asbuilt{_COPY_SUFFIX[kind]}")


def _copy(
    state: BuiltState,
    original: Path,
    copy: Path,
    not_found: tuple[str, ...],
    said: tuple[str, ...],
) -> Export:
    missing = (f"{i} is not in {original.name}; nothing was written of it." for i in not_found)
    return Export(
        files=(copy, *_status_file(state.objects, copy)),
        installed=state.installed,
        notes=(*state.notes, *_other_content(state, original), *said, *missing),
    )


def _other_content(state: BuiltState, original: Path) -> list[str]:
    """Tell if the original is not, byte for byte, what was imported."""
    known = {s.sha256 for s in state.design.sources if s.sha256}
    if not known or sha256_hex(original.read_bytes()) in known:
        return []
    return [f"{original.name} was changed since it was imported; its ids were looked up as it is."]


def _used(objects: dict[str, ObjectState], more: str = "") -> list[str]:
    count = sum(s.status == CONSUMED for s in objects.values())
    return [f"Stock that was used is marked {CONSUMED} (pieces: {count}).{more}"] if count else []


def _sources(state: BuiltState, kind: FileKind) -> list[Source]:
    of_components = [c.source for c in state.design.component_by_id.values()]
    found = [*state.design.sources, *(s for s in of_components if s is not None)]
    return [s for s in found if s.kind.startswith(kind)]


def _require_goal(state: BuiltState, out: Path) -> None:
    """Refuse to write where no folder is, or over the design."""
    if not out.parent.is_dir():
        raise ProjectError(f"{out.parent} is no folder. Make it, or name another file.")
    if out.resolve() == (state.folder / BUILDING).resolve():
        raise ProjectError(f"{out} is the design; an export never replaces it. Name another file.")


def _status_file(objects: dict[str, ObjectState], beside: Path) -> tuple[Path, ...]:
    if not objects:
        return ()
    path = beside.with_name(STATUS)
    write_whole(path, laid_out(status_document(objects)).encode())
    return (path,)
