"""JSON files of other programs: read with suspicion, checked against the keys that we need."""

from __future__ import annotations

from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from sitewright.building_model.formats.detect import read_limited
from sitewright.building_model.formats.json_text import parse, read_text
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.border import problems_from
from sitewright.foundation.canonical import Json

_SHOWN = 20

Shape = TypeVar("Shape", bound=BaseModel)


def read_json(path: Path) -> Json:
    """Return the document of a JSON file.

    Raises:
        ModelRejectedError: It is missing, cut off, too deep, no JSON, or has numbers that are none.
    """
    read_limited(path)
    text = read_text(path)
    if isinstance(text, Problem):
        raise ModelRejectedError(str(path), [text])
    document, problems = parse(text, path)
    if problems:
        raise ModelRejectedError(str(path), problems)
    return document


def validated(shape: type[Shape], document: Json, path: Path) -> Shape:
    """Return the document as the given shape.

    Raises:
        ModelRejectedError: Keys are missing or of the wrong kind; the first twenty are told.
    """
    try:
        return shape.model_validate(document)
    except ValidationError as error:
        problems = problems_from(error.errors()[:_SHOWN], document)
        raise ModelRejectedError(str(path), problems) from None
