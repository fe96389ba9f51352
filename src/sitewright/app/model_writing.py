"""Writes a changed model into the author's file: whole, with the old one kept, never in a run."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

from sitewright.app.locks import locked
from sitewright.app.model_changes import changes_between, patched
from sitewright.app.project import BUILDING, ProjectError
from sitewright.app.run import fold_of, newest_run
from sitewright.app.run_folder import chain_of
from sitewright.building_model.formats.native import read_as_written
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.site_state import site_of
from sitewright.errors import SitewrightError
from sitewright.foundation.json_layout import laid_out
from sitewright.journal.blobs import write_whole

BACKUP = f"{BUILDING}.bak"


class OpenRunError(SitewrightError):
    """The design cannot change while a run builds it."""

    exit_code = 9


def write_changed(folder: Path, data: bytes, before: BuildingModel, after: BuildingModel) -> None:
    """Change the file in one step, with the old one beside it, unless a run is open.

    Args:
        folder: The project.
        data: What its building file held when `before` was read.
        before: The model of the file.
        after: What is to be written; only what differs from `before` is changed in the file.

    Raises:
        OpenRunError: A run is not finished.
        ProjectError: The file was changed meanwhile.
        SitewrightError: The changed model does not survive writing.
    """
    file = folder / BUILDING
    document = patched(json.loads(data.decode("utf-8-sig")), before, after)
    text = laid_out(document)
    require_readable(text, after)
    with locked(folder / "runs" / "lock", "The project"):
        refuse_open_run(folder, before)
        if file.read_bytes() != data:
            raise ProjectError(f"{file} was changed meanwhile. Try again.")
        write_whole(folder / BACKUP, data)
        write_whole(file, text.encode())


def require_readable(text: str, expected: BuildingModel) -> None:
    """Read the new text back before anything is written; it must mean what was inferred."""
    with tempfile.TemporaryDirectory(prefix="sitewright-") as scratch:
        trial = Path(scratch) / BUILDING
        trial.write_text(text, encoding="utf-8")
        again, _ = read_as_written(trial)
    if differing := changes_between(again, expected):
        where = ", ".join(f"{c.where}.{c.key}".strip(".") for c in differing[:3])
        raise SitewrightError(f"The completed model does not survive writing: {where}.")


def refuse_open_run(folder: Path, design: BuildingModel) -> None:
    """Raise `OpenRunError` if a run of the project is not finished."""
    newest = newest_run(folder / "runs")
    if newest is None:
        return
    state, _ = fold_of(chain_of(newest), site_of(design))
    if state.finished is None:
        raise OpenRunError(
            f"Run {newest.run} is open, so its design must not change. "
            f"Finish it first: sitewright run {folder}"
        )
