"""Completes a project's building model: shows what would change, and writes it if asked to."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from importlib.resources import files
from pathlib import Path
from typing import Any

from sitewright.app.model_changes import Change, changes_between, given_facts_changed
from sitewright.app.model_writing import write_changed
from sitewright.app.project import BUILDING, CELL, ProjectError
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.inference.completion import Surroundings, complete
from sitewright.building_model.model import BuildingModel
from sitewright.errors import Problem, SitewrightError, did_you_mean
from sitewright.foundation.canonical import Json
from sitewright.robot_team.formats.cell_toml import read_cell

PANEL_RULES = "builtin:timber-panel"
"""How wall panels are nailed."""
_BUILTIN = "builtin:"


@dataclass(frozen=True, slots=True, kw_only=True)
class Inference:
    """What was inferred for a project.

    Attributes:
        before: The model as its file has it.
        after: The completed model.
        changes: What differs.
        problems: What stays open, and where stated facts contradict the geometry.
        is_written: ``building.json`` was changed; the old one is ``building.json.bak``.
    """

    before: BuildingModel
    after: BuildingModel
    changes: tuple[Change, ...]
    problems: tuple[Problem, ...]
    is_written: bool = False


def infer_project(
    folder: Path, *, rules: Path | None = None, write: bool = False, cell: Path | None = None
) -> Inference:
    """Infer what a project's model leaves open.

    Args:
        folder: The project.
        rules: A TOML or JSON file of rules to add to those of the model, or ``builtin:NAME``.
        write: Change ``building.json``; nothing is written if nothing differs.
        cell: Another cell file than ``cell.toml``; it names stock places and grippers.

    Raises:
        ModelRejectedError: The model or a rule is wrong.
        OpenRunError: A run is not finished; only when writing.
        ProjectError: The folder is no project, or the rules cannot be read.
    """
    file = folder / BUILDING
    if not file.exists():
        raise ProjectError(f"{folder} has no {BUILDING}. `sitewright import` makes one.")
    data = file.read_bytes()
    before = read_building(file)
    wanted = replace(before, rules=(*before.rules, *_new_rules(before, rules)))
    after, problems = complete(wanted, surroundings_of(folder / (cell or CELL)))
    changes = tuple(changes_between(before, after))
    if wrong := given_facts_changed(changes, before):
        raise SitewrightError(f"Inference would alter stated facts: {', '.join(wrong)}.")
    found = Inference(before=before, after=after, changes=changes, problems=tuple(problems))
    if not write or not changes:
        return found
    write_changed(folder, data, before, after)
    return replace(found, is_written=True)


def surroundings_of(cell_file: Path) -> Surroundings:
    """Return stock places and grippers of a cell; nothing special without a cell file."""
    if not cell_file.exists():
        return Surroundings()
    cell = read_cell(cell_file)
    grips = tuple(e.grips_m for e in cell.end_effector_by_id.values() if e.grips_m is not None)
    return Surroundings(
        places=tuple(cell.stock_place_by_id), grips_m=grips or Surroundings().grips_m
    )


def _new_rules(model: BuildingModel, file: Path | None) -> list[Mapping[str, Json]]:
    """Return the rules of a file that the model does not have yet."""
    if file is None:
        return []
    found = _rules_in(file)
    known = {str(r.get("id")): r for r in model.rules}
    for rule in found:
        name = str(rule.get("id"))
        if name in known and known[name] != rule:
            raise ProjectError(
                f"{file}: rule {name!r} is in the model already and says something else. "
                "Rename it, or change the one in the model."
            )
    return [r for r in found if str(r.get("id")) not in known]


def _rules_in(file: Path) -> Sequence[Mapping[str, Json]]:
    try:
        text = _text_of(file)
        document: Any = json.loads(text) if file.suffix == ".json" else tomllib.loads(text)
    except (OSError, ValueError, RecursionError) as error:
        raise ProjectError(f"{file}: {error}. Mend the file of rules.") from error
    if isinstance(document, Mapping):
        document = document.get("rules", document.get("rule"))
    if not isinstance(document, list) or not all(isinstance(r, Mapping) for r in document):
        raise ProjectError(f"{file} holds no list of rules ([[rules]] in TOML).")
    return document


def _text_of(file: Path) -> str:
    """Return a file of rules; ``builtin:NAME`` is one that comes with Sitewright."""
    name = str(file)
    if not name.startswith(_BUILTIN):
        return file.read_text(encoding="utf-8-sig")
    known = {Path(f.name).stem: f for f in (files("sitewright") / "app" / "rules").iterdir()}
    own = known.get(name.removeprefix(_BUILTIN))
    if own is None:
        words = ", ".join(f"{_BUILTIN}{k}" for k in sorted(known))
        raise ProjectError(
            f"There are no rules {name}; there are {words}."
            f"{did_you_mean(name.removeprefix(_BUILTIN), known)}"
        )
    return own.read_text(encoding="utf-8")
