"""What was read of a design file, kept in the project for the day when the file has changed."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from sitewright.app.project import BUILDING, ProjectError
from sitewright.building_model.component import Source
from sitewright.building_model.formats.import_map import read_map
from sitewright.building_model.formats.layer_rules import LayerNames
from sitewright.building_model.formats.native import read_building, write_building
from sitewright.building_model.formats.to_file import document_of
from sitewright.building_model.model import BuildingModel
from sitewright.foundation.canonical import Json, sha256_hex
from sitewright.foundation.json_layout import laid_out

IMPORTS = "imports"


def with_record(
    design: BuildingModel, options: Mapping[str, Json]
) -> tuple[BuildingModel, dict[str, bytes]]:
    """Return a design that names the record of its import, and the record by path.

    Args:
        design: What was read of the file, before anything is inferred.
        options: How it was taken; those at their default are left out.
    """
    data = laid_out(document_of(design)).encode()
    *others, last = design.sources
    stated = {k: v for k, v in options.items() if v not in {None, False, ""}}
    own = replace(last, import_sha256=sha256_hex(data), options=stated)
    return replace(design, sources=(*others, own)), {_path(own): data}


def imported_source(design: BuildingModel) -> Source | None:
    """Return the file that a design was imported from last; None if no record says so."""
    return next((s for s in reversed(design.sources) if s.import_sha256), None)


def sources_with(design: BuildingModel, before: Source, now: Source) -> tuple[Source, ...]:
    """Return the sources of a design with that of an import exchanged for a newer one."""
    return (*(s for s in design.sources if s != before), now)


def read_record(folder: Path, source: Source) -> BuildingModel:
    """Return what was read of a file when it was imported.

    Raises:
        ProjectError: The record is not there, or was changed.
    """
    file = folder / _path(source)
    if not file.exists():
        raise ProjectError(f"{file} is gone. Put it back, or name the old file with --base.")
    if sha256_hex(file.read_bytes()) != source.import_sha256:
        raise ProjectError(f"{file} was changed. Put the old one back, or give --base.")
    return read_building(file)


def read_back(design: BuildingModel) -> BuildingModel:
    """Return a design as it comes back from its file, rounded as there."""
    with tempfile.TemporaryDirectory(prefix="sitewright-") as scratch:
        write_building(design, Path(scratch) / BUILDING)
        return read_building(Path(scratch) / BUILDING)


def layer_names(folder: Path, design: BuildingModel) -> LayerNames:
    """Return the names that the user gave our layers when the design was imported."""
    source = imported_source(design)
    words = source.options.get("map_file") if source else None
    if not isinstance(words, str) or not (folder / words).exists():
        return LayerNames()
    return read_map(folder / words).layers


def _path(source: Source) -> str:
    return f"{IMPORTS}/{source.import_sha256}.json"
