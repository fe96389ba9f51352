"""Every foreign kind of file: who reads it, and how it is read in a child process."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from pathlib import Path

from sitewright.building_model.formats.detect import FileKind, refused
from sitewright.building_model.formats.import_process import Limits, answer_about
from sitewright.building_model.formats.neutral import NeutralFile
from sitewright.building_model.formats.neutral_json import document_of
from sitewright.building_model.formats.neutral_scale import bound_problems
from sitewright.errors import ModelRejectedError
from sitewright.foundation.canonical import Json

_PACKAGE = "sitewright.building_model.formats"
READERS: Mapping[FileKind, str] = {
    FileKind.RHINO: f"{_PACKAGE}.rhino:read_rhino",
    FileKind.IFC: f"{_PACKAGE}.ifc:read_ifc",
    FileKind.COMPAS_TIMBER: f"{_PACKAGE}.compas_timber:read_compas_timber",
    FileKind.BTLX: f"{_PACKAGE}.btlx:read_btlx",
    FileKind.OBJ: f"{_PACKAGE}.obj:read_obj",
    FileKind.COMPAS_ASSEMBLY: f"{_PACKAGE}.compas_assembly:read_compas_assembly",
    FileKind.BAR_FRAME: f"{_PACKAGE}.bar_frame:read_bar_frame",
}
"""The reader of each kind, a function Path -> NeutralFile; named, since each loads its library."""

IMPORT_LIMITS = Limits(how_to_raise="Or give it more: --reader-gb 8, --reader-s 300.")
"""What a reader may use, unless the user gives it more."""


def read_foreign(path: Path, kind: FileKind, *, limits: Limits | None = None) -> NeutralFile:
    """Return what a foreign file holds; it is read in a child process under limits.

    Args:
        path: The file.
        kind: What it is; one of `READERS`.
        limits: What the child may use; `IMPORT_LIMITS` by default.

    Raises:
        ModelRejectedError: It cannot be read, or whatever read it died (E2).
    """
    from sitewright.building_model.formats.neutral_records import BadRecordsError, neutral_of

    function = f"{_PACKAGE}.foreign_files:answer"
    document = answer_about(
        path, function, str(kind), str(path.absolute()), limits=limits or IMPORT_LIMITS
    )
    try:
        return neutral_of(document)
    except BadRecordsError as error:
        fix = "Repair the model and export it again."
        raise refused(path, "E2", f"{error}.", fix) from None


def answer(kind: str, path: str) -> Json:
    """Return the records of a file; what the child process runs.

    Raises:
        ModelRejectedError: The reader refuses the file, or it is beyond all bounds.
    """
    file = Path(path)
    neutral = reader_of(FileKind(kind))(file)
    if problems := list(bound_problems(neutral, file.name)):
        raise ModelRejectedError(path, problems)
    return document_of(neutral)


def reader_of(kind: FileKind) -> Callable[[Path], NeutralFile]:
    """Return the function that reads a kind, in this process."""
    module, _, name = READERS[kind].partition(":")
    reader: Callable[[Path], NeutralFile] = getattr(import_module(module), name)
    return reader
