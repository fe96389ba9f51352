"""Completes a project's building model: shows what would change, and writes it if asked to."""

from __future__ import annotations

import json
import tempfile
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from sitewright.app.locks import locked
from sitewright.app.model_changes import Change, changes_between, given_facts_changed, patched
from sitewright.app.project import BUILDING, CELL, ProjectError
from sitewright.app.run import fold_of, newest_run
from sitewright.app.run_folder import chain_of
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.inference.completion import Surroundings, complete
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.site_state import site_of
from sitewright.errors import Problem, SitewrightError
from sitewright.foundation.canonical import Json
from sitewright.foundation.json_layout import laid_out
from sitewright.journal.blobs import write_whole
from sitewright.robot_team.formats.cell_toml import read_cell

BACKUP = f"{BUILDING}.bak"


class OpenRunError(SitewrightError):
    """The design cannot change while a run builds it."""

    exit_code = 9


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
        rules: A TOML or JSON file of rules to add to those of the model.
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
    _write(folder, data, found)
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
        text = file.read_text(encoding="utf-8-sig")
        document: Any = json.loads(text) if file.suffix == ".json" else tomllib.loads(text)
    except (OSError, ValueError, RecursionError) as error:
        raise ProjectError(f"{file}: {error}. Mend the file of rules.") from error
    if isinstance(document, Mapping):
        document = document.get("rules", document.get("rule"))
    if not isinstance(document, list) or not all(isinstance(r, Mapping) for r in document):
        raise ProjectError(f"{file} holds no list of rules ([[rules]] in TOML).")
    return document


def _write(folder: Path, data: bytes, found: Inference) -> None:
    """Change the file in one step, with the old one beside it, unless a run is open."""
    file = folder / BUILDING
    document = patched(json.loads(data.decode("utf-8-sig")), found.before, found.after)
    text = laid_out(document)
    _require_readable(text, found.after)
    with locked(folder / "runs" / "lock", "The project"):
        _refuse_open_run(folder, found.before)
        if file.read_bytes() != data:
            raise ProjectError(f"{file} was changed meanwhile. Infer again.")
        write_whole(folder / BACKUP, data)
        write_whole(file, text.encode())


def _require_readable(text: str, expected: BuildingModel) -> None:
    """Read the new text back before anything is written; it must mean what was inferred."""
    with tempfile.TemporaryDirectory(prefix="sitewright-") as scratch:
        trial = Path(scratch) / BUILDING
        trial.write_text(text, encoding="utf-8")
        again = read_building(trial)
    if differing := changes_between(again, expected):
        where = ", ".join(f"{c.where}.{c.key}".strip(".") for c in differing[:3])
        raise SitewrightError(f"The completed model does not survive writing: {where}.")


def _refuse_open_run(folder: Path, design: BuildingModel) -> None:
    newest = newest_run(folder / "runs")
    if newest is None:
        return
    state, _ = fold_of(chain_of(newest), site_of(design))
    if state.finished is None:
        raise OpenRunError(
            f"Run {newest.run} is open, so its design must not change. "
            f"Finish it first: sitewright run {folder}"
        )
