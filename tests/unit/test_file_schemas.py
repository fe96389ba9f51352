"""The JSON Schemas that ship with the package are current, and accept the examples."""

from __future__ import annotations

import json
import runpy
import tomllib
from pathlib import Path

import jsonschema
import pytest

from builders_building import EXAMPLES
from sitewright.building_model.codes import CODES
from sitewright.building_model.formats.native import building_schema
from sitewright.foundation.json_layout import laid_out
from sitewright.robot_team.formats.cell_toml import cell_schema

TOOL = Path(__file__).parents[2] / "tools" / "write_schemas.py"
SCHEMA_BY_PATH = runpy.run_path(str(TOOL))["SCHEMA_BY_PATH"]


@pytest.mark.parametrize("path", SCHEMA_BY_PATH, ids=lambda p: p.name)
def test_a_shipped_schema_is_current(path: Path) -> None:
    current = laid_out(SCHEMA_BY_PATH[path]())
    assert path.read_text(encoding="utf-8") == current, "run tools/write_schemas.py"


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*/building.json")), ids=str)
def test_every_example_building_is_valid(path: Path) -> None:
    jsonschema.Draft202012Validator(building_schema()).validate(json.loads(path.read_text()))


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*/cell*.toml")), ids=str)
def test_every_example_cell_is_valid(path: Path) -> None:
    jsonschema.Draft202012Validator(cell_schema()).validate(tomllib.loads(path.read_text()))


def test_a_schema_refuses_what_the_reader_refuses() -> None:
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"schema": "sitewright.building/1", "color": 1}, building_schema())


def test_every_code_has_a_meaning_in_one_sentence() -> None:
    assert list(CODES) == sorted(CODES)
    assert all(text.endswith(".") and text[0].isupper() for text in CODES.values())
