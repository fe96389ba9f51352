"""Mends what can be mended without altering anything that the author stated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from sitewright.app.checking import check, check_model_file, is_structural
from sitewright.app.inferring import surroundings_of
from sitewright.app.model_changes import Change, changes_between, given_facts_changed
from sitewright.app.model_writing import write_changed
from sitewright.app.project import BUILDING, CELL, require_project
from sitewright.building_model.check_support import fasteners_that_hold
from sitewright.building_model.component import Component, Origin
from sitewright.building_model.formats.native import read_as_written
from sitewright.building_model.inference.bare import without_inferred
from sitewright.building_model.inference.completion import complete
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.spelling import spelled_out
from sitewright.building_model.validation import check_model
from sitewright.errors import Problem, SitewrightError

_BY_SPELLING = frozenset({"N1", "D2"})
_BY_HOLDING = "F1"


@dataclass(frozen=True, slots=True, kw_only=True)
class Repair:
    """What the safe repairs of a project change.

    Attributes:
        changes: What differs in the building.
        mended: Problems that are gone after it.
        problems: Those that stay, and those that only show afterwards.
        is_written: ``building.json`` was changed; the old one is ``building.json.bak``.
    """

    changes: tuple[Change, ...]
    mended: tuple[Problem, ...]
    problems: tuple[Problem, ...]
    is_written: bool = False


def repair_project(folder: Path, *, write: bool = False, cell: Path | None = None) -> Repair:
    """Find the safe repairs of a project's building, and make them if asked to.

    Names become ids, a relation that stands twice stands once, a hanging component is held until
    it is fastened; facts that were inferred, or are missing, are inferred anew.

    Args:
        folder: The project.
        write: Change ``building.json``.
        cell: Another cell file than ``cell.toml``.

    Raises:
        ModelRejectedError: The building cannot be read at all.
        OpenRunError: A run is not finished; only when writing.
        ProjectError: The folder is no project.
    """
    file, cell_file = folder / BUILDING, folder / (cell or CELL)
    require_project(folder, cell_file)
    data = file.read_bytes()
    before, _ = read_as_written(file)
    found = check(folder, cell=cell)
    spelled = spelled_out(before)
    after = _repaired(spelled, found, cell_file)
    changes = tuple(changes_between(before, after))
    if wrong := given_facts_changed(changes_between(spelled, after), spelled):
        raise SitewrightError(f"A repair would alter stated facts: {', '.join(wrong)}.")
    left = check_model_file(folder, cell_file, after) if changes else found
    if write and changes:
        write_changed(folder, data, before, after)
    return Repair(
        changes=changes,
        mended=tuple(_gone(found, left)),
        problems=tuple(left),
        is_written=write and bool(changes),
    )


def _repaired(spelled: BuildingModel, found: Sequence[Problem], cell_file: Path) -> BuildingModel:
    """Return the mended model: inferred anew only if a problem needs that and it is possible."""
    fixable = [p for p in found if p.is_fixable]
    if any(p.code not in {*_BY_SPELLING, _BY_HOLDING} for p in fixable):
        bare = check_model(without_inferred(spelled))
        if not any(is_structural(p) for p in bare):
            return complete(spelled, surroundings_of(cell_file))[0]
    hanging = {p.where for p in fixable if p.code == _BY_HOLDING}
    held = {i: _held(c) if i in hanging else c for i, c in spelled.component_by_id.items()}
    return replace(spelled, component_by_id=held)


def _held(component: Component) -> Component:
    why = "nothing carries it from below"
    return replace(
        component,
        hold_until_fasteners=fasteners_that_hold(component),
        origins={**component.origins, "hold_until_fasteners": (Origin.INFERRED, why)},
    )


def _gone(before: Sequence[Problem], after: Sequence[Problem]) -> list[Problem]:
    stays = {(p.code, p.where, p.message) for p in after}
    return [p for p in before if (p.code, p.where, p.message) not in stays]
