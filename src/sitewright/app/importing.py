"""Makes a project of a file of another program: read, infer what a timber frame lacks, write."""

from __future__ import annotations

import math
import os
import shutil
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field, replace
from importlib.util import find_spec
from pathlib import Path

from sitewright.app.framing_cell import framing_cell
from sitewright.app.import_building import built_flat, only_group
from sitewright.app.import_notes import notes_file
from sitewright.app.import_options import ImportOptionError, demand_meaning
from sitewright.app.import_records import IMPORTS, with_record
from sitewright.app.project import BUILDING, CELL, ProjectError, example_folder
from sitewright.app.two_arm_cell import two_arm_cell
from sitewright.building_model.component import Source
from sitewright.building_model.formats.cut_joints import cut_joints
from sitewright.building_model.formats.detect import (
    FileKind,
    kind_of,
    looks_like,
    read_limited,
    refused,
)
from sitewright.building_model.formats.foreign_files import IMPORT_LIMITS, READERS, read_foreign
from sitewright.building_model.formats.from_neutral import model_of, targets_in
from sitewright.building_model.formats.import_map import ImportMap, read_map
from sitewright.building_model.formats.import_process import Limits
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.formats.to_file import document_of
from sitewright.building_model.inference.assembly import infer_assembly
from sitewright.building_model.model import BuildingModel
from sitewright.errors import BackendMissingError, Problem
from sitewright.foundation.canonical import Json, sha256_hex
from sitewright.foundation.json_layout import laid_out
from sitewright.journal.blobs import write_whole

REPAIRS = ("hull",)
_CELL_EXAMPLE = "frame_house"
_TIMBER_FRAMES = frozenset({FileKind.COMPAS_TIMBER, FileKind.BTLX})
"""Frames of sawn beams: what they lack is inferred at once."""
_EXTRAS: Mapping[FileKind, tuple[str, str]] = {
    FileKind.RHINO: ("rhino3dm", "rhino"),
    FileKind.IFC: ("ifcopenshell", "ifc"),
    FileKind.COMPAS_TIMBER: ("compas_timber", "timber"),
}
"""What must be installed for a kind of file: package and extra."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportOptions:
    """How a file is to be taken.

    Attributes:
        unit: Length unit of its numbers (``mm``, ``m`` ...), if the file states none.
        map_file: An ``import.toml`` that says what foreign keys and layers mean.
        repair: ``hull`` closes open meshes by their convex hull.
        is_split: Parts of several bodies become several components.
        group: Only this group is built; everything else is drawn only.
        lays_flat: It is drawn standing and built lying flat.
        is_turned_over: Laid flat on its other face.
        reader_gb: Memory that the reader may use, in GB (1024**3 bytes).
        reader_s: Time that the reader may take, processor or clock, in seconds.
    """

    unit: str | None = None
    map_file: Path | None = None
    repair: str | None = None
    is_split: bool = False
    group: str | None = None
    lays_flat: bool = False
    is_turned_over: bool = False
    reader_gb: float | None = None
    reader_s: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportResult:
    """A project that was made of a file.

    Attributes:
        kind: What kind of file it was, told by its content.
        problems: Warnings, and what could not be inferred.
        has_new_cell: The folder had no cell; it got one laid out for what was read.
        is_inferred: Order, supports and stock were inferred, not only read.
        is_laid_flat: It is a panel that is built lying.
    """

    folder: Path
    kind: str
    targets_total: int
    problems: tuple[Problem, ...] = field(default=())
    has_new_cell: bool = False
    is_inferred: bool = False
    is_laid_flat: bool = False


def import_file(file: Path, out: Path, options: ImportOptions | None = None) -> ImportResult:
    """Read a design of any known kind and write a project; nothing is left if that fails.

    What was read is kept beside the building, so that a changed file can be merged into it.

    Args:
        file: The design; its kind is told by its content.
        out: Project folder; a building that is there already is not overwritten.
        options: How to take it.

    Raises:
        ModelRejectedError: The file or the map cannot be read, or parts of it are wrong.
        BackendMissingError: The extra for this kind of file is not installed.
        ProjectError: The folder holds a building already.
    """
    options = options or ImportOptions()
    if (out / BUILDING).exists():
        raise ProjectError(f"{out} has a {BUILDING} already; name a new folder.")
    kind, model, problems = read_design(file, options)
    model, kept = keeping_record(model, options)
    is_inferred = kind in _TIMBER_FRAMES
    if is_inferred:
        model, open_points = infer_assembly(model)
        problems = [*problems, *open_points]
    has_new_cell = not (out / CELL).exists()
    if has_new_cell:
        kept[CELL] = _cell_for(model, options)
    kept |= notes_file(problems)
    write_project(out, {**kept, BUILDING: laid_out(document_of(model)).encode()})
    return ImportResult(
        folder=out,
        kind=str(kind),
        targets_total=targets_in(model),
        problems=tuple(problems),
        has_new_cell=has_new_cell,
        is_inferred=is_inferred,
        is_laid_flat=options.lays_flat,
    )


def _cell_for(model: BuildingModel, options: ImportOptions) -> bytes:
    if options.lays_flat:
        return framing_cell(model).encode()
    return two_arm_cell(model, example_folder(_CELL_EXAMPLE) / CELL).encode()


def keeping_record(
    model: BuildingModel, options: ImportOptions
) -> tuple[BuildingModel, dict[str, bytes]]:
    """Return a model that names the record of its import, and the files to keep, by path."""
    told: dict[str, Json] = {**asdict(options), "map_file": None}
    kept: dict[str, bytes] = {}
    if options.map_file is not None:
        words = options.map_file.read_bytes()
        path = f"{IMPORTS}/{sha256_hex(words)}.toml"
        told["map_file"], kept[path] = path, words
    model, record = with_record(model, told)
    return model, {**kept, **record}


def write_project(folder: Path, content: Mapping[str, bytes]) -> None:
    """Write the files of a project, the last one last; a new folder is there whole or not at all.

    Args:
        folder: New, or with files of the user's, which stay.
        content: What to write, by path in the folder.

    Raises:
        ProjectError: The place cannot be written.
    """
    try:
        _write(folder, content)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ProjectError(f"{folder} cannot be written: {reason}. Name another folder.") from error


def _write(folder: Path, content: Mapping[str, bytes]) -> None:
    if folder.exists():
        _write_into(folder, content)
        return
    folder.parent.mkdir(parents=True, exist_ok=True)
    draft = folder.with_name(f".{folder.name}.{os.getpid()}.tmp")
    try:
        draft.mkdir()
        _write_into(draft, content)
        draft.rename(folder)
    except BaseException:
        shutil.rmtree(draft, ignore_errors=True)
        raise


def _write_into(folder: Path, content: Mapping[str, bytes]) -> None:
    for path, data in content.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        write_whole(folder / path, data)


def read_design(
    file: Path, options: ImportOptions
) -> tuple[FileKind, BuildingModel, list[Problem]]:
    """Return what a design file holds; nothing is inferred but the joints of a BTLx file.

    Raises:
        ImportOptionError: An option means nothing for this file.
        ModelRejectedError: The file or the map cannot be read, or parts of it are wrong.
        BackendMissingError: The extra for this kind of file is not installed.
    """
    content = read_limited(file)
    kind = kind_of(content)
    demand_meaning(kind, _given(options))
    _demand_extra(kind)
    if kind is FileKind.NATIVE:
        return kind, _native(file), []
    if kind not in READERS:
        message = f"this is no design that Sitewright reads (it looks like: {looks_like(content)})."
        known = "Rhino .3dm, IFC, BTLx, OBJ, compas_timber, compas_assembly or bar-frame JSON"
        raise refused(file, "E3", message, f"Give it one of: {known}.")
    words = ImportMap() if options.map_file is None else read_map(options.map_file)
    model, problems = model_of(
        read_foreign(file, kind, limits=_limits(options)),
        file,
        unit=options.unit,
        mapping=words,
        repair=options.repair,
        split=options.is_split,
    )
    if kind is FileKind.BTLX:
        model = replace(model, relations=(*model.relations, *cut_joints(model)))
    return kind, _as_built_here(model, options), problems


def _limits(options: ImportOptions) -> Limits:
    limits = IMPORT_LIMITS
    if options.reader_gb is not None:
        limits = replace(limits, memory_bytes=int(options.reader_gb * 1024**3))
    if options.reader_s is not None:
        limits = replace(limits, cpu_s=math.ceil(options.reader_s), wall_s=options.reader_s)
    return limits


def _as_built_here(model: BuildingModel, options: ImportOptions) -> BuildingModel:
    if options.group is not None:
        model = only_group(model, options.group)
    if options.lays_flat:
        model = built_flat(model, is_turned_over=options.is_turned_over)
    elif options.is_turned_over:
        raise ImportOptionError("--turn-over says how to lay flat; add --lay-flat.")
    return model


def _native(file: Path) -> BuildingModel:
    """Return a building with this file as its last source."""
    model = read_building(file)
    own = Source(
        file=file.name, kind=str(FileKind.NATIVE), id="", sha256=sha256_hex(file.read_bytes())
    )
    return replace(model, sources=(*model.sources, own))


def _given(options: ImportOptions) -> Iterator[str]:
    for name, value in (
        ("--unit", options.unit),
        ("--map", options.map_file),
        ("--repair", options.repair),
        ("--split", options.is_split),
        ("--group", options.group),
        ("--lay-flat", options.lays_flat),
        ("--turn-over", options.is_turned_over),
        ("--reader-gb", options.reader_gb),
        ("--reader-s", options.reader_s),
    ):
        if value:
            yield name


def _demand_extra(kind: FileKind) -> None:
    package, extra = _EXTRAS.get(kind, ("", ""))
    if package and find_spec(package) is None:
        installed = (p for p, _ in _EXTRAS.values() if find_spec(p) is not None)
        raise BackendMissingError(
            "reader", package, available=installed, install=f"pip install 'sitewright[{extra}]'"
        )
