# ruff: noqa: INP001
"""Writes the JSON Schemas of `building.json` and `cell.toml` beside their readers.

Run it after a change of a file model: ``python tools/write_schemas.py``.
"""

from __future__ import annotations

from pathlib import Path

from sitewright.building_model.formats import native
from sitewright.foundation.json_layout import laid_out
from sitewright.robot_team.formats import cell_toml

SCHEMA_BY_PATH = {
    Path(native.__file__).parent / "schemas" / "building.schema.json": native.building_schema,
    Path(cell_toml.__file__).parent / "schemas" / "cell.schema.json": cell_toml.cell_schema,
}
"""Where each schema is kept, and what makes it."""


def main() -> None:
    """Write every schema."""
    for path, schema in SCHEMA_BY_PATH.items():
        path.parent.mkdir(exist_ok=True)
        path.write_text(laid_out(schema()), encoding="utf-8")


if __name__ == "__main__":
    main()
