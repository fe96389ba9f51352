"""Reads and writes the native building model, `building.json`."""

from __future__ import annotations

import os
import tempfile
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from pydantic import BaseModel, ValidationError

from sitewright.building_model.formats.from_file import model_from
from sitewright.building_model.formats.json_text import parse, read_text
from sitewright.building_model.formats.native_file import (
    MAX_COMPONENTS,
    BuildingFile,
    FileModel,
    StackFile,
)
from sitewright.building_model.formats.to_file import document_of
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.validation import STRUCTURE_CODES, check_model
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.border import NUMBER_CODE, problems_from
from sitewright.foundation.canonical import Json
from sitewright.foundation.json_layout import laid_out


def read_building(path: Path | str, *, is_exported: bool = False) -> BuildingModel:
    """Read a building model; `sitewright.errors.ModelRejectedError` lists all that is wrong.

    What makes a project unbuildable but leaves the model readable (no stock, no support) is
    not raised here; ask `check_model` or the project check for it.

    Args:
        path: The file.
        is_exported: It is an exported state (`as_built.json`), so as-built records may stand
            in it; in a design they are an error.
    """
    model, problems = read_as_written(path, is_exported=is_exported)
    if any(p.severity == "E" and p.code in STRUCTURE_CODES for p in problems):
        raise ModelRejectedError(Path(path).name, problems)
    return model


def read_as_written(
    path: Path | str, *, is_exported: bool = False
) -> tuple[BuildingModel, list[Problem]]:
    """Return a model with what is wrong with it, also if it refers to what is not there.

    Args:
        path: The file.
        is_exported: As for `read_building`.

    Raises:
        ModelRejectedError: The file is no building model at all, or an id stands twice.
    """
    path = Path(path)
    text = read_text(path)
    if isinstance(text, Problem):
        raise ModelRejectedError(path.name, [text])
    document, problems = parse(text, path)
    if document is None:
        raise ModelRejectedError(path.name, problems)
    if not isinstance(document, dict):
        raise ModelRejectedError(path.name, [_not_an_object(path)])
    file, more = _validated(text, document)
    problems = _without_echo(problems, more)
    if file is None or problems:
        raise ModelRejectedError(path.name, problems)
    model = model_from(file)
    return model, [*check_model(model), *(() if is_exported else _as_built_in_design(model))]


def write_building(model: BuildingModel, path: Path | str) -> None:
    """Write a model: sorted by id, fixed order of keys, and the old file whole until the end."""
    path = Path(path)
    text = laid_out(document_of(model))
    with tempfile.NamedTemporaryFile(
        "w", encoding="utf-8", dir=path.parent, prefix=f".{path.name}.", delete=False
    ) as temporary:
        try:
            temporary.write(text)
            temporary.flush()
            os.fsync(temporary.fileno())
            Path(temporary.name).chmod(0o644)
            Path(temporary.name).replace(path)
        except BaseException:
            Path(temporary.name).unlink(missing_ok=True)
            raise


def building_schema() -> dict[str, Json]:
    """Return the JSON Schema of `building.json`."""
    schema = BuildingFile.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def _validated(text: str, document: Json) -> tuple[BuildingFile | None, list[Problem]]:
    try:
        file = BuildingFile.model_validate_json(text)
    except ValidationError as error:
        return None, problems_from(
            [dict(e) for e in error.errors(include_url=False)], document, keys_of(FileModel)
        )
    return file, _too_many_pieces(file) or _duplicate_ids(file)


def _without_echo(of_text: list[Problem], of_schema: list[Problem]) -> list[Problem]:
    """Return both lists; bad numbers only once, with their place in the model if it is known."""
    placed = sum(p.code == NUMBER_CODE for p in of_schema)
    echoes = [p for p in of_text if p.code == NUMBER_CODE][:placed]
    return [p for p in of_text if p not in echoes] + of_schema


def keys_of(base: type[BaseModel]) -> set[str]:
    """Return every key that any file model under `base` knows."""
    found: set[str] = set()
    for model in base.__subclasses__():
        found |= {f.alias or name for name, f in model.model_fields.items()} | keys_of(model)
    return found


def _too_many_pieces(file: BuildingFile) -> list[Problem]:
    """Say so before a few bytes become millions of pieces."""
    generated = sum(s.generated.count for s in file.stacks if s.generated)
    total = len(file.components) + generated
    if total <= MAX_COMPONENTS:
        return []
    message = f"It holds {total} components, more than {MAX_COMPONENTS}; "
    made = f"{generated} of them are generated by its stacks."
    fix = "Lower 'count' in 'stacks', or take only what is to be built."
    return [Problem(code="E2", severity="E", where="stacks", message=message + made, fix=fix)]


def _duplicate_ids(file: BuildingFile) -> list[Problem]:
    components = [c.id for c in file.components] + [
        piece for s in file.stacks for piece in _generated_ids(s)
    ]
    operations = [o.id for c in file.components for o in c.operations]
    stacks = [s.id for s in file.stacks]
    return [
        *_repeated("component", components),
        *_repeated("operation", operations),
        *_repeated("stack", stacks),
    ]


def _generated_ids(stack: StackFile) -> list[str]:
    count = stack.generated.count if stack.generated else 0
    return [f"{stack.id}.{n}" for n in range(1, count + 1)]


def _repeated(kind: str, ids: Iterable[str]) -> list[Problem]:
    return [
        Problem(
            code="D1",
            severity="E",
            where=identity,
            message=f"{count} {kind}s have the id {identity!r}.",
            fix="Give each its own id.",
        )
        for identity, count in sorted(Counter(ids).items())
        if count > 1
    ]


def _as_built_in_design(model: BuildingModel) -> list[Problem]:
    return [
        Problem(
            code="I2",
            severity="E",
            where=c.id,
            message="A design holds no as-built record.",
            fix="Remove 'as_built', or use the design that the state was exported from.",
        )
        for c in model.component_by_id.values()
        if c.as_built is not None
    ]


def _not_an_object(path: Path) -> Problem:
    return Problem(
        code="K1",
        severity="E",
        where=path.name,
        message="The file holds no object.",
        fix="Start it with { and the key 'schema'.",
    )
