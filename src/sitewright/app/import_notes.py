"""What an import said of a file that nothing in the model tells any more, kept for `check`."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from sitewright.app.import_records import IMPORTS
from sitewright.app.project import ProjectError
from sitewright.errors import Problem
from sitewright.foundation.canonical import Json
from sitewright.foundation.json_layout import laid_out

NOTES = f"{IMPORTS}/notes.json"
SCHEMA = "sitewright.import-notes/1"
_LOST = frozenset({"G2", "G3", "G4", "G6", "G7", "O1", "T1", "U2"})
"""Codes about the file, not the model; all others are found in the model itself."""
_KEYS = ("code", "severity", "where", "message", "fix", "source_id")


def notes_file(problems: Iterable[Problem]) -> dict[str, bytes]:
    """Return the file of an import's warnings by its path in the project; nothing without any."""
    kept: list[Json] = [
        {k: getattr(p, k) for k in _KEYS} for p in problems if p.code in _LOST and p.severity == "W"
    ]
    return {NOTES: laid_out({"schema": SCHEMA, "problems": kept}).encode()} if kept else {}


def notes_for(folder: Path, found: Sequence[Problem]) -> list[Problem]:
    """Return what the import of a project said, less what is said already.

    Raises:
        ProjectError: The file of notes cannot be read.
    """
    file = folder / NOTES
    if not file.exists():
        return []
    try:
        document = json.loads(file.read_text(encoding="utf-8"))
        notes = [_note(note) for note in document["problems"]]
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise ProjectError(f"{file}: {error}. Remove it, or import anew.") from error
    said = {(p.code, p.where) for p in found}
    has_scale = {p.code for p in found} & {"U2"}
    return [n for n in notes if (n.code, n.where) not in said and n.code not in has_scale]


def _note(entry: Mapping[str, Any]) -> Problem:
    return Problem(
        code=str(entry["code"]),
        severity=str(entry["severity"]),
        where=str(entry["where"]),
        message=str(entry["message"]),
        fix=str(entry["fix"]),
        source_id=str(entry["source_id"]),
    )
