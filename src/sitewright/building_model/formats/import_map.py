"""The user's own words: `import.toml` tells which foreign keys and layers mean ours."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from sitewright.building_model.component import Layer
from sitewright.building_model.formats.layer_rules import LayerNames, folded
from sitewright.errors import ModelRejectedError, Problem, did_you_mean
from sitewright.foundation.canonical import Json

PREFIX = "sitewright."
"""How our own keys begin in a foreign file."""
READ_KEYS = (
    "id",
    "name",
    "type",
    "layer",
    "order",
    "material",
    "parent",
    "process",
    "method",
    "group",
    "mass_kg",
    "ops",
    "stack",
    "stack_index",
    "ground",
)
WRITTEN_KEYS = frozenset(
    {
        *("status", "built_at", "robot", "material_used", "used_for"),
        *("deviation_mm", "deviation_deg"),
    }
)
"""Keys that an as-built export writes; an import passes them over."""
_TABLES = ("user_text", "layers")


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportMap:
    """What foreign words mean.

    Attributes:
        foreign_keys: For a key of ours, the foreign keys that may hold its value.
        layers: Further names of the five layers.
    """

    foreign_keys: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    layers: LayerNames = field(default_factory=LayerNames)


def read_map(path: Path) -> ImportMap:
    """Read an ``import.toml``.

    Two tables are known: ``[user_text]`` (our key = foreign key, or a list of them) and
    ``[layers]`` (layer name = one of our layers).

    Raises:
        ModelRejectedError: It cannot be read, or holds what is not known.
    """
    document = _document(path)
    problems = [
        _problem(path, table, f"There is no table [{table}].{did_you_mean(table, _TABLES)}")
        for table in document
        if table not in _TABLES
    ]
    keys = _table(document, "user_text")
    names = _table(document, "layers")
    problems += [*_key_problems(path, keys), *_layer_problems(path, names)]
    if problems:
        raise ModelRejectedError(str(path), problems)
    return ImportMap(
        foreign_keys={key: _words(value) for key, value in keys.items()},
        layers=LayerNames(
            role_by_name={folded(name): Layer(str(layer)) for name, layer in names.items()}
        ),
    )


def _document(path: Path) -> Mapping[str, Json]:
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        reason = f"It cannot be read: {error.strerror or error}."
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        reason = f"It is no TOML: {error}."
    except RecursionError:
        reason = "It is nested too deeply."
    raise ModelRejectedError(str(path), [_problem(path, path.name, reason)])


def _table(document: Mapping[str, Json], name: str) -> Mapping[str, Json]:
    table = document.get(name, {})
    return table if isinstance(table, Mapping) else {name: table}


def _words(value: Json) -> tuple[str, ...]:
    values = value if isinstance(value, list) else [value]
    words = tuple(v for v in values if isinstance(v, str) and v)
    return words if len(words) == len(values) else ()


def _key_problems(path: Path, keys: Mapping[str, Json]) -> Iterator[Problem]:
    for key, value in keys.items():
        if key not in READ_KEYS:
            hint = did_you_mean(key, READ_KEYS)
            yield _problem(path, f"user_text.{key}", f"Sitewright reads no key {key!r}.{hint}")
        elif not _words(value):
            yield _problem(path, f"user_text.{key}", "It is no key, and no list of keys.")


def _layer_problems(path: Path, names: Mapping[str, Json]) -> Iterator[Problem]:
    known = [layer.value for layer in Layer]
    for name, layer in names.items():
        if layer not in known:
            message = f"{layer!r} is no layer; there are {', '.join(known)}."
            yield _problem(path, f"layers.{name}", message)


def _problem(path: Path, where: str, message: str) -> Problem:
    fix = f"Correct {path.name}; docs/import.md shows one."
    return Problem(code="K1", severity="E", where=where, message=message, fix=fix)
