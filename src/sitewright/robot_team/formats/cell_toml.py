"""Reads a cell file, `cell.toml`."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

from pydantic import ValidationError

from sitewright.errors import CellRejectedError, Problem
from sitewright.foundation.border import problems_from
from sitewright.foundation.canonical import Json
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.formats.cell_check import fit_problems, problem
from sitewright.robot_team.formats.cell_file import CellFile, FileModel
from sitewright.robot_team.formats.cell_from_file import CellBuilder

MAX_BYTES = 5_000_000


def read_cell(path: Path | str) -> Cell:
    """Read a cell; `sitewright.errors.CellRejectedError` lists all that is wrong.

    Paths of URDF files are relative to the cell file.
    """
    path = Path(path)
    document = _document(path)
    file = _validated(path, document)
    problems = list(fit_problems(file))
    builder = CellBuilder(file, path.parent)
    cell = builder.build()
    problems += builder.problems
    if problems or cell is None:
        raise CellRejectedError(path.name, problems)
    return cell


def cell_schema() -> dict[str, Json]:
    """Return the JSON Schema of `cell.toml`, for editors that check TOML."""
    schema = CellFile.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def _document(path: Path) -> dict[str, Json]:
    try:
        if path.stat().st_size > MAX_BYTES:
            raise _rejected(path, "E5", "The file is larger than 5 MB.", "Check the file.")
        return tomllib.loads(path.read_bytes().decode("utf-8-sig"))
    except tomllib.TOMLDecodeError as error:
        raise _rejected(path, "E5", f"Not TOML: {error}.", "Correct the text there.") from error
    except UnicodeDecodeError as error:
        message = f"Byte {error.start} is not UTF-8."
        raise _rejected(path, "E5", message, "Save the file as UTF-8.") from error
    except RecursionError as error:
        raise _rejected(path, "E5", "It is nested too deep.", "Check the file.") from error
    except OSError as error:
        reason = error.strerror or str(error)
        message = f"The file cannot be read: {reason}."
        raise _rejected(path, "E2", message, "Check the path.") from error


def _validated(path: Path, document: dict[str, Json]) -> CellFile:
    try:
        return CellFile.model_validate_json(json.dumps(document, default=str))
    except ValidationError as error:
        found = [dict(e) for e in error.errors(include_url=False)]
        raise CellRejectedError(path.name, problems_from(found, document, _keys())) from error


def _keys(model: type[FileModel] = FileModel) -> set[str]:
    own = {field.alias or name for name, field in model.model_fields.items()}
    return own.union(*(_keys(below) for below in model.__subclasses__()))


def _rejected(path: Path, code: str, message: str, fix: str) -> CellRejectedError:
    found: list[Problem] = [problem(code, path.name, message, fix)]
    return CellRejectedError(path.name, found)
